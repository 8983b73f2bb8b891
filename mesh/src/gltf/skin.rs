//! Joints as nodes, their motors at rest, and the influences on each vertex.

use ga_runtime::cga3::Motor;
use gltf_json as json;
use gltf_json::Index;
use gltf_json::buffer::Target;
use gltf_json::mesh::Semantic;
use gltf_json::scene::UnitQuaternion;
use gltf_json::validation::Checked;

use super::document::{Attributes, Document, Elements, single};
use super::rigid::{inverse_matrix, normalized, rotation, translation};
use super::{GltfError, JointNode, Skin};

/// Appends the nodes of a skin, numbered as its joints, and the skin; one more node follows if the
/// joints have several roots. Returns the skin and the node above all joints.
pub(super) fn add(
    skin: &Skin,
    vertices: usize,
    document: &mut Document,
) -> Result<(Index<json::Skin>, Index<json::Node>), GltfError> {
    check(skin, vertices)?;
    let mut inverse_bind = Vec::with_capacity(skin.joints.len());
    let mut globals: Vec<Motor<f64>> = Vec::with_capacity(skin.joints.len());
    for (index, joint) in skin.joints.iter().enumerate() {
        let local = normalized(joint.rest).ok_or_else(|| GltfError::Rest {
            joint: joint.name.clone(),
        })?;
        let global = joint.parent.map_or(local, |parent| globals[parent] * local);
        globals.push(global);
        inverse_bind.push(single(inverse_matrix(global), "joint", index)?);
        let translation = single(translation(local), "joint", index)?;
        let rotation = single(rotation(local), "joint", index)?;
        document.root.push(json::Node {
            name: Some(joint.name.clone()),
            translation: Some(translation).filter(|t| *t != [0.0; 3]),
            rotation: Some(rotation)
                .filter(|r| *r != [0.0, 0.0, 0.0, 1.0])
                .map(UnitQuaternion),
            ..json::Node::default()
        });
    }
    let root = link(skin.joints, document);
    let inverse_bind = document.add(None, Elements::floats(&inverse_bind));
    let skin = document.root.push(json::Skin {
        joints: (0..skin.joints.len() as u32).map(Index::new).collect(),
        skeleton: Some(root),
        inverse_bind_matrices: Some(inverse_bind),
        name: None,
        extensions: None,
        extras: Default::default(),
    });
    Ok((skin, root))
}

/// `JOINTS_n` and `WEIGHTS_n` for as many `n` as the vertex with the most influences needs.
pub(super) fn add_attributes(
    skin: &Skin,
    vertices: usize,
    document: &mut Document,
    attributes: &mut Attributes,
) -> Result<(), GltfError> {
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
        let target = Some(Target::ArrayBuffer);
        let joints = document.add(target, Elements::joints(&joints, skin.joints.len()));
        let weights = document.add(target, Elements::floats(&weights));
        let set = set as u32;
        attributes.insert(Checked::Valid(Semantic::Joints(set)), joints);
        attributes.insert(Checked::Valid(Semantic::Weights(set)), weights);
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
    if skin.weights.len() != vertices {
        return Err(GltfError::Count {
            what: "vertices with weights",
            expected: vertices,
            found: skin.weights.len(),
        });
    }
    Ok(())
}

/// Adds each joint to its parent's children; returns the root, which is a new node when there are
/// several.
fn link(joints: &[JointNode], document: &mut Document) -> Index<json::Node> {
    let mut roots = Vec::new();
    for (index, joint) in joints.iter().enumerate() {
        let node = Index::new(index as u32);
        match joint.parent {
            Some(parent) => document.root.nodes[parent]
                .children
                .get_or_insert_default()
                .push(node),
            None => roots.push(node),
        }
    }
    if let [root] = roots[..] {
        return root;
    }
    document.root.push(json::Node {
        name: Some("skeleton".to_owned()),
        children: Some(roots),
        ..json::Node::default()
    })
}

/// A vertex's influences in single precision, the greatest first. Their sum is as near to 1 as
/// single precision allows.
fn single_influences(
    vertex: usize,
    influences: &[(u32, f64)],
    joints: usize,
) -> Result<Vec<(u16, f32)>, GltfError> {
    /// How far from 1 the sum of weights may be.
    const TOLERANCE: f64 = 1e-6;
    let sum: f64 = influences.iter().map(|&(_, weight)| weight).sum();
    let are_positive = influences.iter().all(|&(_, weight)| weight >= 0.0);
    // False for a sum that is not a number.
    let sum_to_one = (sum - 1.0).abs() <= TOLERANCE;
    if !(are_positive && sum_to_one) {
        return Err(GltfError::Weights { vertex, sum });
    }
    if let Some(&(joint, _)) = influences.iter().find(|(j, _)| *j as usize >= joints) {
        return Err(GltfError::Influence {
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
