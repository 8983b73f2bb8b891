//! Models to write, and where their vertices belong.

use ga_mesh::FormatError;
use ga_mesh::gltf::model::{Animation, Dielectric, JointNode, Model, Skin, Track, encode};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use glam::{DMat4, DQuat, DVec3};
use proptest::prelude::*;

pub(crate) type Vector = [f64; 3];

/// A rotation about the origin followed by a translation. The quaternion (x, y, z, w) may have any
/// length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rigid {
    pub(crate) rotation: [f64; 4],
    pub(crate) translation: Vector,
}

impl Default for Rigid {
    fn default() -> Self {
        Self {
            rotation: [0.0, 0.0, 0.0, 1.0],
            translation: [0.0; 3],
        }
    }
}

impl Rigid {
    pub(crate) fn matrix(&self) -> DMat4 {
        let rotation = DQuat::from_array(self.rotation).normalize();
        DMat4::from_rotation_translation(rotation, DVec3::from(self.translation))
    }

    /// The motor by axis and angle, as long as the quaternion.
    fn motor(&self) -> Motor<f64> {
        let quaternion = DQuat::from_array(self.rotation);
        let length = quaternion.length();
        let (axis, angle) = if length > 0.0 {
            (quaternion / length).to_axis_angle()
        } else {
            (DVec3::X, 0.0)
        };
        let rotor = Rotor::from_axis_angle(axis.to_array(), angle).unwrap() * length;
        let rotor = Rotor::new_unchecked(rotor.scalar, rotor.e12, rotor.e13, rotor.e23);
        Translator::from_displacement(self.translation) * rotor
    }
}

/// A joint whose rest may not be a rigid motion.
#[derive(Clone, Debug)]
pub(crate) struct SourceJoint {
    pub(crate) name: String,
    pub(crate) parent: Option<usize>,
    pub(crate) rest: Rigid,
}

#[derive(Clone, Debug)]
pub(crate) struct SourceAnimation {
    pub(crate) name: String,
    pub(crate) times: Vec<f64>,
    pub(crate) tracks: Vec<SourceTrack>,
}

#[derive(Clone, Debug)]
pub(crate) struct SourceTrack {
    pub(crate) joint: usize,
    pub(crate) keys: Vec<Rigid>,
}

/// A model whose motions are quaternions and translations.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub(crate) positions: Vec<Vector>,
    pub(crate) normals: Vec<Vector>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) joints: Vec<SourceJoint>,
    pub(crate) weights: Vec<Vec<(u32, f64)>>,
    pub(crate) animations: Vec<SourceAnimation>,
}

/// A source with its motors.
pub(crate) struct Built<'a> {
    source: &'a Source,
    joints: Vec<JointNode>,
    animations: Vec<Animation>,
}

impl Built<'_> {
    pub(crate) fn model(&self) -> Model<'_> {
        Model {
            name: "source",
            positions: &self.source.positions,
            normals: &self.source.normals,
            triangles: &self.source.triangles,
            material: Dielectric::default(),
            skin: Some(Skin {
                joints: &self.joints,
                weights: &self.source.weights,
            }),
            animations: &self.animations,
        }
    }
}

impl Source {
    pub(crate) fn build(&self) -> Built<'_> {
        let joint = |joint: &SourceJoint| JointNode {
            name: joint.name.clone(),
            parent: joint.parent,
            rest: joint.rest.motor(),
        };
        let track = |track: &SourceTrack| Track {
            joint: track.joint,
            keys: track.keys.iter().map(Rigid::motor).collect(),
        };
        let animation = |animation: &SourceAnimation| Animation {
            name: animation.name.clone(),
            times: animation.times.clone(),
            tracks: animation.tracks.iter().map(track).collect(),
        };
        Built {
            source: self,
            joints: self.joints.iter().map(joint).collect(),
            animations: self.animations.iter().map(animation).collect(),
        }
    }

    pub(crate) fn write(&self) -> Result<Vec<u8>, FormatError> {
        encode(&self.build().model())
    }

    /// Skinned positions with the joints at the given local transforms: Σ w G(pose) G(rest)⁻¹ v.
    pub(crate) fn skinned(&self, pose: &[Rigid]) -> Vec<Vector> {
        let rest: Vec<_> = self.joints.iter().map(|joint| joint.rest).collect();
        let (rest, pose) = (self.globals(&rest), self.globals(pose));
        let skin: Vec<DMat4> = rest
            .iter()
            .zip(&pose)
            .map(|(rest, pose)| *pose * rest.inverse())
            .collect();
        let rows = self.positions.iter().zip(&self.weights);
        rows.map(|(&position, row)| {
            let moved = |&(joint, weight): &(u32, f64)| {
                skin[joint as usize].transform_point3(position.into()) * weight
            };
            row.iter().map(moved).sum::<DVec3>().to_array()
        })
        .collect()
    }

    fn globals(&self, locals: &[Rigid]) -> Vec<DMat4> {
        let mut globals: Vec<DMat4> = Vec::new();
        for (joint, local) in self.joints.iter().zip(locals) {
            let above = joint
                .parent
                .map_or(DMat4::IDENTITY, |parent| globals[parent]);
            globals.push(above * local.matrix());
        }
        globals
    }

    pub(crate) fn pose(&self, animation: usize, key: usize) -> Vec<Rigid> {
        let mut pose: Vec<_> = self.joints.iter().map(|joint| joint.rest).collect();
        for track in &self.animations[animation].tracks {
            pose[track.joint] = track.keys[key];
        }
        pose
    }
}

/// Weights divided by their sum.
fn normalized(row: Vec<(u32, f64)>) -> Vec<(u32, f64)> {
    let sum: f64 = row.iter().map(|(_, weight)| weight).sum();
    row.into_iter()
        .map(|(joint, weight)| (joint, weight / sum))
        .collect()
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
            .map(|joint| SourceJoint {
                name: format!("joint {joint}"),
                parent: joint.checked_sub(1),
                rest: Rigid {
                    translation: if joint == 0 {
                        [place(1), 0.0, 0.0]
                    } else {
                        [0.1, 0.0, 0.0]
                    },
                    ..Rigid::default()
                },
            })
            .collect(),
        weights: (0..vertices)
            .map(|vertex| {
                let influence =
                    |i: usize| (((vertex / 2 + i) % joints) as u32, 1.0 / (1 + i) as f64);
                normalized((0..influences).map(influence).collect())
            })
            .collect(),
        animations: vec![SourceAnimation {
            name: "bend".into(),
            times: (0..keys).map(|key| key as f64 / 30.0).collect(),
            tracks: (0..joints)
                .map(|joint| SourceTrack {
                    joint,
                    keys: (0..keys)
                        .map(|key| {
                            let half = 0.02 * key as f64;
                            Rigid {
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

pub(crate) fn transform() -> impl Strategy<Value = Rigid> {
    let quaternion = prop::array::uniform4(-1f64..1.0);
    let long_enough = |q: &[f64; 4]| q.iter().map(|c| c * c).sum::<f64>() > 0.01;
    (quaternion.prop_filter("a direction", long_enough), vector()).prop_map(
        |(rotation, translation)| Rigid {
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
                    Source {
                        positions: points.iter().map(|p| p.0).collect(),
                        normals: points.iter().map(|p| p.1).collect(),
                        triangles,
                        joints: skeleton
                            .into_iter()
                            .enumerate()
                            .map(|(index, (parent, rest))| SourceJoint {
                                name: format!("joint {index}"),
                                parent: parent.filter(|_| index > 0).map(|p| p.index(index)),
                                rest,
                            })
                            .collect(),
                        weights: weights
                            .into_iter()
                            .map(|row| normalized(row.into_iter().collect()))
                            .collect(),
                        animations: animations
                            .into_iter()
                            .map(|(tracks, steps)| SourceAnimation {
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
                                    .map(|(joint, keys)| SourceTrack { joint, keys })
                                    .collect(),
                            })
                            .collect(),
                    }
                },
            )
    })
}
