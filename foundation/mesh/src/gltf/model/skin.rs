//! Joints as nodes, their motors at rest, and the influences on each vertex.

use ga_runtime::cga3::Motor;

use super::super::{self as gltf, Document, Node, Primitive, Transform};
use super::precision::single;
use super::rigid::{inverse_matrix, normalized, rotation, translation};
use super::{JointNode, ModelProblem, Skin};

/// Appends the nodes of a skin, numbered as its joints, and the skin; one more node follows if the
/// joints have several roots. Returns the node above all joints.
pub(super) fn add(
    skin: &Skin,
    vertices: usize,
    document: &mut Document,
) -> Result<usize, ModelProblem> {
    check(skin, vertices)?;
    let mut inverse_bind_matrices = Vec::with_capacity(skin.joints.len());
    let mut globals: Vec<Motor<f64>> = Vec::with_capacity(skin.joints.len());
    for (index, joint) in skin.joints.iter().enumerate() {
        let local = normalized(joint.rest).ok_or_else(|| ModelProblem::Rest {
            joint: joint.name.clone(),
        })?;
        let global = joint.parent.map_or(local, |parent| globals[parent] * local);
        globals.push(global);
        inverse_bind_matrices.push(single(inverse_matrix(global), "joint", index)?);
        document.nodes.push(Node {
            name: Some(joint.name.clone()),
            transform: Transform::Decomposed {
                translation: single(translation(local), "joint", index)?,
                rotation: single(rotation(local), "joint", index)?,
                scale: [1.0; 3],
            },
            ..Node::default()
        });
    }
    let root = link(skin.joints, document);
    document.skins.push(gltf::Skin {
        joints: (0..skin.joints.len()).collect(),
        inverse_bind_matrices,
        skeleton: Some(root),
        ..gltf::Skin::default()
    });
    Ok(root)
}

/// `JOINTS_n` and `WEIGHTS_n` for as many `n` as the vertex with the most influences needs.
pub(super) fn add_influences(
    skin: &Skin,
    vertices: usize,
    primitive: &mut Primitive,
) -> Result<(), ModelProblem> {
    check(skin, vertices)?;
    let rows = skin
        .weights
        .iter()
        .enumerate()
        .map(|(vertex, row)| single_influences(vertex, row, skin.joints.len()))
        .collect::<Result<Vec<_>, _>>()?;
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
        primitive.joints.push(joints);
        primitive.weights.push(weights);
    }
    Ok(())
}

fn check(skin: &Skin, vertices: usize) -> Result<(), ModelProblem> {
    let joints = skin.joints.len();
    if joints == 0 || joints > 1 << 16 {
        return Err(ModelProblem::JointCount(joints));
    }
    for (index, joint) in skin.joints.iter().enumerate() {
        if let Some(parent) = joint.parent.filter(|&parent| parent >= index) {
            return Err(ModelProblem::ParentNotBefore {
                joint: joint.name.clone(),
                parent,
            });
        }
    }
    if skin.weights.len() != vertices {
        return Err(ModelProblem::Count {
            what: "vertices with weights",
            expected: vertices,
            found: skin.weights.len(),
        });
    }
    Ok(())
}

/// Adds each joint to its parent's children; returns the root, which is a new node when there are
/// several.
fn link(joints: &[JointNode], document: &mut Document) -> usize {
    let mut roots = Vec::new();
    for (node, joint) in joints.iter().enumerate() {
        match joint.parent {
            Some(parent) => document.nodes[parent].children.push(node),
            None => roots.push(node),
        }
    }
    if let [root] = roots[..] {
        return root;
    }
    document.nodes.push(Node {
        name: Some("skeleton".to_owned()),
        children: roots,
        ..Node::default()
    });
    document.nodes.len() - 1
}

/// A vertex's influences in single precision, the greatest first. Their sum is as near to 1 as
/// single precision allows.
fn single_influences(
    vertex: usize,
    influences: &[(u32, f64)],
    joints: usize,
) -> Result<Vec<(u16, f32)>, ModelProblem> {
    /// How far from 1 the sum of weights may be.
    const TOLERANCE: f64 = 1e-6;
    let sum: f64 = influences.iter().map(|&(_, weight)| weight).sum();
    let are_positive = influences.iter().all(|&(_, weight)| weight >= 0.0);
    // False for a sum that is not a number.
    let sum_to_one = (sum - 1.0).abs() <= TOLERANCE;
    if !(are_positive && sum_to_one) {
        return Err(ModelProblem::Weights { vertex, sum });
    }
    if let Some(&(joint, _)) = influences.iter().find(|(j, _)| *j as usize >= joints) {
        return Err(ModelProblem::Influence {
            vertex,
            joint,
            joints,
        });
    }
    let mut row: Vec<(u16, f32)> = influences
        .iter()
        .map(|&(joint, weight)| (joint as u16, weight as f32))
        .filter(|&(_, weight)| weight > 0.0)
        .collect();
    row.sort_by(|a, b| b.1.total_cmp(&a.1));
    let sum: f64 = row.iter().map(|&(_, weight)| f64::from(weight)).sum();
    if let Some((_, greatest)) = row.first_mut() {
        *greatest = (f64::from(*greatest) + (1.0 - sum)) as f32;
    }
    Ok(row)
}
