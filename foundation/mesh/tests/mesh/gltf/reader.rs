//! A reader and player of files that shares nothing with the writer.

use glam::{DMat4, DVec3, Mat4};
use gltf::animation::util::ReadOutputs;

use super::source::{Rigid, Vector};

/// `JOINTS_n` and `WEIGHTS_n`.
pub(crate) type InfluenceSet = (Vec<[u16; 4]>, Vec<[f32; 4]>);

/// What a reader that knows nothing of the source sees.
pub(crate) struct Read {
    pub(crate) document: gltf::Document,
    pub(crate) buffers: Vec<gltf::buffer::Data>,
}

impl Read {
    pub(crate) fn new(file: &[u8]) -> Self {
        let (document, buffers, _) = gltf::import_slice(file).unwrap();
        Self { document, buffers }
    }

    pub(crate) fn primitive(&self) -> gltf::Primitive<'_> {
        self.document
            .meshes()
            .next()
            .unwrap()
            .primitives()
            .next()
            .unwrap()
    }

    pub(crate) fn data(&self, buffer: gltf::Buffer) -> Option<&[u8]> {
        Some(&self.buffers[buffer.index()])
    }

    /// Positions of the vertices at one key of an animation, or at rest.
    pub(crate) fn skinned(&self, animation: Option<(usize, usize)>) -> Vec<Vector> {
        let nodes = self.document.nodes().len();
        let mut locals: Vec<Rigid> = self
            .document
            .nodes()
            .map(|node| {
                let (translation, rotation, scale) = node.transform().decomposed();
                assert_eq!(scale, [1.0; 3]);
                Rigid {
                    rotation: rotation.map(f64::from),
                    translation: translation.map(f64::from),
                }
            })
            .collect();
        if let Some((animation, key)) = animation {
            for channel in self
                .document
                .animations()
                .nth(animation)
                .unwrap()
                .channels()
            {
                let node = channel.target().node().index();
                match channel.reader(|b| self.data(b)).read_outputs().unwrap() {
                    ReadOutputs::Rotations(outputs) => {
                        locals[node].rotation = outputs.into_f32().nth(key).unwrap().map(f64::from);
                    }
                    ReadOutputs::Translations(mut outputs) => {
                        locals[node].translation = outputs.nth(key).unwrap().map(f64::from);
                    }
                    _ => panic!("no such channel was asked for"),
                }
            }
        }
        let mut parents = vec![None; nodes];
        for node in self.document.nodes() {
            for child in node.children() {
                parents[child.index()] = Some(node.index());
            }
        }
        let global = |mut node: usize| {
            let mut global = locals[node].matrix();
            while let Some(parent) = parents[node] {
                global = locals[parent].matrix() * global;
                node = parent;
            }
            global
        };
        let skin = self.document.skins().next().unwrap();
        let inverse_bind = skin
            .reader(|b| self.data(b))
            .read_inverse_bind_matrices()
            .unwrap();
        let matrices: Vec<DMat4> = skin
            .joints()
            .zip(inverse_bind)
            .map(|(joint, columns)| {
                let bind = Mat4::from_cols_array_2d(&columns).as_dmat4();
                global(joint.index()) * bind
            })
            .collect();

        let primitive = self.primitive();
        let reader = primitive.reader(|b| self.data(b));
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let mut skinned = vec![DVec3::ZERO; positions.len()];
        for (joints, weights) in self.influence_sets() {
            for (vertex, (joints, weights)) in joints.iter().zip(&weights).enumerate() {
                for (&joint, &weight) in joints.iter().zip(weights) {
                    let position = DVec3::from(positions[vertex].map(f64::from));
                    let moved = matrices[usize::from(joint)].transform_point3(position);
                    skinned[vertex] += moved * f64::from(weight);
                }
            }
        }
        skinned.into_iter().map(|place| place.to_array()).collect()
    }

    pub(crate) fn influence_sets(&self) -> Vec<InfluenceSet> {
        let primitive = self.primitive();
        let reader = primitive.reader(|b| self.data(b));
        (0..)
            .map_while(|set| {
                let joints = reader.read_joints(set)?.into_u16().collect();
                Some((
                    joints,
                    reader.read_weights(set).unwrap().into_f32().collect(),
                ))
            })
            .collect()
    }
}
