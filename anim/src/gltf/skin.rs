//! Joints as nodes, their places at rest, and the influences on each vertex.

use serde_json::{Value, json};

use super::buffer::{Buffer, Elements, Target, single, unit};
use super::{GltfError, JointNode, RigidTransform, Skin};
use crate::weights::Influence;

/// The nodes of a skin, numbered as its joints; one more node follows where the joints have several
/// roots.
pub(super) struct Joints {
    pub(super) nodes: Vec<Value>,
    /// The node above all joints.
    pub(super) root: usize,
    pub(super) skin: Value,
}

pub(super) fn joints(
    skin: &Skin,
    vertices: usize,
    buffer: &mut Buffer,
) -> Result<Joints, GltfError> {
    check(skin, vertices)?;
    let mut nodes = Vec::with_capacity(skin.joints.len() + 1);
    let mut inverse_bind = Vec::with_capacity(skin.joints.len());
    let mut globals: Vec<RigidTransform> = Vec::with_capacity(skin.joints.len());
    for (index, joint) in skin.joints.iter().enumerate() {
        let local = RigidTransform {
            rotation: unit(joint.rest.rotation).ok_or_else(|| GltfError::RestRotation {
                joint: joint.name.clone(),
            })?,
            ..joint.rest
        };
        let global = joint
            .parent
            .map_or(local, |parent| globals[parent].then_inner(&local));
        globals.push(global);
        inverse_bind.push(single(global.inverse_matrix(), "joint", index)?);
        let mut node = json!({ "name": joint.name });
        let translation = single(local.translation, "joint", index)?;
        if translation != [0.0; 3] {
            node["translation"] = json!(translation);
        }
        let rotation = single(local.rotation, "joint", index)?;
        if rotation != [0.0, 0.0, 0.0, 1.0] {
            node["rotation"] = json!(rotation);
        }
        nodes.push(node);
    }
    let root = link(skin.joints, &mut nodes);
    Ok(Joints {
        nodes,
        root,
        skin: json!({
            "joints": (0..skin.joints.len()).collect::<Vec<_>>(),
            "skeleton": root,
            "inverseBindMatrices": buffer.add(None, Elements::floats(&inverse_bind)),
        }),
    })
}

/// `JOINTS_n` and `WEIGHTS_n` for as many `n` as the vertex with the most influences needs.
pub(super) fn add_attributes(
    skin: &Skin,
    vertices: usize,
    buffer: &mut Buffer,
    attributes: &mut Value,
) -> Result<(), GltfError> {
    check(skin, vertices)?;
    let rows: Vec<Vec<(u16, f32)>> = skin.weights.iter().map(single_influences).collect();
    let sets = rows.iter().map(Vec::len).max().unwrap_or(0).div_ceil(4);
    for set in 0..sets {
        let mut joints = vec![[0u16; 4]; rows.len()];
        let mut weights = vec![[0f32; 4]; rows.len()];
        for (vertex, row) in rows.iter().enumerate() {
            for (slot, &(joint, weight)) in row.iter().skip(4 * set).take(4).enumerate() {
                joints[vertex][slot] = joint;
                weights[vertex][slot] = weight;
            }
        }
        let joints = Elements::joints(&joints, skin.joints.len());
        let weights = Elements::floats(&weights);
        attributes[format!("JOINTS_{set}")] = json!(buffer.add(Some(Target::Array), joints));
        attributes[format!("WEIGHTS_{set}")] = json!(buffer.add(Some(Target::Array), weights));
    }
    Ok(())
}

fn check(skin: &Skin, vertices: usize) -> Result<(), GltfError> {
    let joints = skin.joints.len();
    if joints == 0 || joints > 1 << 16 {
        return Err(GltfError::JointCount(joints));
    }
    for (index, joint) in skin.joints.iter().enumerate() {
        if let Some(parent) = joint.parent.filter(|&parent| parent >= index) {
            return Err(GltfError::ParentNotBefore {
                joint: joint.name.clone(),
                parent,
            });
        }
    }
    let counts = [
        (
            "vertices with weights",
            vertices,
            skin.weights.vertex_count(),
        ),
        ("joints with weights", joints, skin.weights.joint_count()),
    ];
    for (what, expected, found) in counts {
        if expected != found {
            return Err(GltfError::Count {
                what,
                expected,
                found,
            });
        }
    }
    Ok(())
}

/// Enters each node's children; the root, which is a new node when there are several.
fn link(joints: &[JointNode], nodes: &mut Vec<Value>) -> usize {
    let mut children = vec![Vec::new(); joints.len()];
    let mut roots = Vec::new();
    for (index, joint) in joints.iter().enumerate() {
        match joint.parent {
            Some(parent) => children[parent].push(index),
            None => roots.push(index),
        }
    }
    for (node, children) in nodes.iter_mut().zip(children) {
        if !children.is_empty() {
            node["children"] = json!(children);
        }
    }
    if let [root] = roots[..] {
        return root;
    }
    nodes.push(json!({ "name": "skeleton", "children": roots }));
    nodes.len() - 1
}

/// A vertex's influences in single precision, the greatest first, with a sum of 1 as nearly as
/// there is a number.
fn single_influences(influences: &[Influence]) -> Vec<(u16, f32)> {
    let mut row: Vec<(u16, f32)> = influences
        .iter()
        .map(|influence| (influence.joint as u16, influence.weight as f32))
        .filter(|&(_, weight)| weight > 0.0)
        .collect();
    row.sort_by(|a, b| b.1.total_cmp(&a.1));
    let sum: f64 = row.iter().map(|&(_, weight)| f64::from(weight)).sum();
    if let Some((_, greatest)) = row.first_mut() {
        *greatest = (f64::from(*greatest) + (1.0 - sum)) as f32;
    }
    row
}

impl RigidTransform {
    /// This transform after `inner`: what `inner` gives in this one's frame, in the frame outside.
    fn then_inner(&self, inner: &Self) -> Self {
        let [x1, y1, z1, w1] = self.rotation;
        let [x2, y2, z2, w2] = inner.rotation;
        let turned = rotate(self.rotation, inner.translation);
        Self {
            rotation: [
                w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
                w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
                w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
                w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
            ],
            translation: std::array::from_fn(|i| self.translation[i] + turned[i]),
        }
    }

    /// The 4 × 4 matrix of the inverse, column by column.
    fn inverse_matrix(&self) -> [f64; 16] {
        let [x, y, z, w] = self.rotation;
        let back = [-x, -y, -z, w];
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| rotate(back, e));
        let place = rotate(back, self.translation.map(|c| -c));
        let mut matrix = [0.0; 16];
        for (column, vector) in columns.into_iter().chain([place]).enumerate() {
            matrix[4 * column..4 * column + 3].copy_from_slice(&vector);
        }
        matrix[15] = 1.0;
        matrix
    }
}

/// Turns a vector by a unit quaternion: v + 2 q × (q × v + w v).
fn rotate([x, y, z, w]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    let q = [x, y, z];
    let once = cross(q, v);
    let twice = cross(q, std::array::from_fn(|i| once[i] + w * v[i]));
    std::array::from_fn(|i| v[i] + 2.0 * twice[i])
}
