//! Models to write, and where their vertices belong.

use ga_anim::gltf::{Animation, JointNode, Material, Model, RigidTransform, Skin, Track};
use ga_anim::weights::SkinWeights;
use proptest::prelude::*;

use crate::matrix::{IDENTITY, Matrix, Vector, apply, inverse, matrix, product};

/// A model with everything owned.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub(crate) positions: Vec<Vector>,
    pub(crate) normals: Vec<Vector>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) joints: Vec<JointNode>,
    pub(crate) weights: SkinWeights,
    pub(crate) animations: Vec<Animation>,
}

impl Source {
    pub(crate) fn model(&self) -> Model<'_> {
        Model {
            name: "source",
            positions: &self.positions,
            normals: &self.normals,
            triangles: &self.triangles,
            material: Material::default(),
            skin: Some(Skin {
                joints: &self.joints,
                weights: &self.weights,
            }),
            animations: &self.animations,
        }
    }

    /// Skinned positions with the joints at the given local transforms: Σ w G(pose) G(rest)⁻¹ v.
    pub(crate) fn skinned(&self, pose: &[RigidTransform]) -> Vec<Vector> {
        let rest: Vec<_> = self.joints.iter().map(|joint| joint.rest).collect();
        let (rest, pose) = (self.globals(&rest), self.globals(pose));
        let skin: Vec<_> = rest
            .iter()
            .zip(&pose)
            .map(|(r, p)| product(p, &inverse(r)))
            .collect();
        let rows = self.positions.iter().zip(self.weights.iter());
        rows.map(|(&position, row)| {
            let mut sum = [0.0; 3];
            for influence in row {
                let moved = apply(&skin[influence.joint as usize], position);
                for axis in 0..3 {
                    sum[axis] += influence.weight * moved[axis];
                }
            }
            sum
        })
        .collect()
    }

    pub(crate) fn globals(&self, locals: &[RigidTransform]) -> Vec<Matrix> {
        let mut globals: Vec<Matrix> = Vec::new();
        for (joint, local) in self.joints.iter().zip(locals) {
            let above = joint.parent.map_or(IDENTITY, |parent| globals[parent]);
            globals.push(product(&above, &matrix(local)));
        }
        globals
    }

    pub(crate) fn pose(&self, animation: usize, key: usize) -> Vec<RigidTransform> {
        let mut pose: Vec<_> = self.joints.iter().map(|joint| joint.rest).collect();
        for track in &self.animations[animation].tracks {
            pose[track.joint] = track.keys[key];
        }
        pose
    }
}

/// A strip of triangles along x with one joint a vertex pair, each bending its part.
pub(crate) fn strip(joints: usize, vertices: usize, influences: usize, keys: usize) -> Source {
    let place = |joint: usize| joint as f64 * 0.1;
    Source {
        positions: (0..vertices)
            .map(|v| [v as f64 * 0.05, (v % 2) as f64 * 0.1, 0.0])
            .collect(),
        normals: vec![[0.0, 0.0, 2.0]; vertices],
        triangles: (2..vertices as u32)
            .map(|v| {
                if v % 2 == 0 {
                    [v - 2, v, v - 1]
                } else {
                    [v - 2, v - 1, v]
                }
            })
            .collect(),
        joints: (0..joints)
            .map(|joint| JointNode {
                name: format!("joint {joint}"),
                parent: joint.checked_sub(1),
                rest: RigidTransform {
                    translation: if joint == 0 {
                        [place(1), 0.0, 0.0]
                    } else {
                        [0.1, 0.0, 0.0]
                    },
                    ..RigidTransform::default()
                },
            })
            .collect(),
        weights: SkinWeights::new(
            joints,
            (0..vertices).map(|vertex| {
                (0..influences)
                    .map(|i| (((vertex / 2 + i) % joints) as u32, 1.0 / (1 + i) as f64))
                    .collect::<Vec<_>>()
            }),
        )
        .unwrap(),
        animations: vec![Animation {
            name: "bend".into(),
            times: (0..keys).map(|key| key as f64 / 30.0).collect(),
            tracks: (0..joints)
                .map(|joint| Track {
                    joint,
                    keys: (0..keys)
                        .map(|key| {
                            let half = 0.02 * key as f64;
                            RigidTransform {
                                rotation: [0.0, 0.0, half.sin(), half.cos()],
                                translation: if joint == 0 {
                                    [0.1, 0.01 * key as f64, 0.0]
                                } else {
                                    [0.1, 0.0, 0.0]
                                },
                            }
                        })
                        .collect(),
                })
                .collect(),
        }],
    }
}

pub(crate) fn vector() -> impl Strategy<Value = Vector> {
    prop::array::uniform3(-1f64..1.0)
}

pub(crate) fn transform() -> impl Strategy<Value = RigidTransform> {
    let quaternion = prop::array::uniform4(-1f64..1.0);
    let long_enough = |q: &[f64; 4]| q.iter().map(|c| c * c).sum::<f64>() > 0.01;
    (quaternion.prop_filter("a direction", long_enough), vector()).prop_map(
        |(rotation, translation)| RigidTransform {
            rotation,
            translation,
        },
    )
}

pub(crate) fn source(joints: std::ops::Range<usize>) -> impl Strategy<Value = Source> {
    let sizes = (3usize..30, joints, 1usize..6);
    sizes.prop_flat_map(|(vertices, joints, keys)| {
        let skeleton =
            prop::collection::vec((any::<Option<prop::sample::Index>>(), transform()), joints);
        let row =
            prop::collection::btree_map(0..joints as u32, 1e-9f64..1.0, 1..11.min(joints + 1));
        let weights = prop::collection::vec(row, vertices);
        let triangle = prop::array::uniform3(0..vertices as u32);
        let tracks = prop::collection::btree_map(
            0..joints,
            prop::collection::vec(transform(), keys),
            1..=joints,
        );
        let times = prop::collection::vec(0.01f64..1.0, keys);
        (
            prop::collection::vec((vector(), vector()), vertices),
            prop::collection::vec(triangle, 0..20),
            skeleton,
            weights,
            prop::collection::vec((tracks, times), 0..3),
        )
            .prop_map(
                move |(points, mut triangles, skeleton, weights, animations)| {
                    triangles.push([0, 1, 2]);
                    let rows = weights
                        .into_iter()
                        .map(|row| row.into_iter().collect::<Vec<_>>());
                    Source {
                        positions: points.iter().map(|p| p.0).collect(),
                        normals: points.iter().map(|p| p.1).collect(),
                        triangles,
                        joints: skeleton
                            .into_iter()
                            .enumerate()
                            .map(|(index, (parent, rest))| JointNode {
                                name: format!("joint {index}"),
                                parent: parent.filter(|_| index > 0).map(|p| p.index(index)),
                                rest,
                            })
                            .collect(),
                        weights: SkinWeights::new(joints, rows).unwrap(),
                        animations: animations
                            .into_iter()
                            .map(|(tracks, steps)| Animation {
                                name: "motion".into(),
                                times: steps
                                    .iter()
                                    .scan(0.0, |time, step| {
                                        *time += step;
                                        Some(*time)
                                    })
                                    .collect(),
                                tracks: tracks
                                    .into_iter()
                                    .map(|(joint, keys)| Track { joint, keys })
                                    .collect(),
                            })
                            .collect(),
                    }
                },
            )
    })
}
