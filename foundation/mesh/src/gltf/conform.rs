//! Mends what the Khronos validator reports although a document can be shown.

use super::{Document, Keys, Node, Primitive, Transform, hierarchy};
use crate::FormatError;

impl Document {
    /// The same motion without what the Khronos validator reports in many files:
    ///
    /// - Weights of a vertex that do not sum to 1 are divided by their sum, as every viewer does.
    /// - Joints of weight 0 become joint 0.
    /// - A skinned mesh below other nodes, whose frames it ignores, moves to a new node at the top
    ///   of the scenes that show it. The new nodes come last; the others keep their numbers.
    ///
    /// # Errors
    ///
    /// As [`Document::validate`].
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_mesh::gltf::{Document, Mesh, Primitive};
    ///
    /// let vertex = Primitive {
    ///     positions: vec![[0.0; 3]],
    ///     joints: vec![vec![[2, 1, 0, 3]]],
    ///     weights: vec![vec![[1.0, 3.0, 0.0, 0.0]]],
    ///     ..Primitive::default()
    /// };
    /// let document = Document {
    ///     meshes: vec![Mesh { primitives: vec![vertex], ..Mesh::default() }],
    ///     ..Document::default()
    /// };
    /// let mended = &document.conformed()?.meshes[0].primitives[0];
    /// assert_eq!(mended.joints[0], [[2, 1, 0, 0]]);
    /// assert_eq!(mended.weights[0], [[0.25, 0.75, 0.0, 0.0]]);
    /// # Ok::<(), ga_mesh::FormatError>(())
    /// ```
    pub fn conformed(&self) -> Result<Self, FormatError> {
        self.validate()?;
        let mut document = self.clone();
        for mesh in &mut document.meshes {
            mesh.primitives.iter_mut().for_each(influences);
        }
        let parents = hierarchy::parents(&document.nodes)?;
        for node in 0..self.nodes.len() {
            let is_moved =
                parents[node].is_some() || document.nodes[node].transform != Transform::IDENTITY;
            if document.nodes[node].skin.is_some() && is_moved {
                move_to_top(node, &parents, &mut document);
            }
        }
        Ok(document)
    }
}

/// Moves the mesh and the skin of a node to a new node at the top of its scenes.
fn move_to_top(node: usize, parents: &[Option<usize>], document: &mut Document) {
    let new = document.nodes.len();
    let old = &mut document.nodes[node];
    let moved = Node {
        name: old.name.clone(),
        mesh: old.mesh.take(),
        skin: old.skin.take(),
        weights: old.weights.take(),
        ..Node::default()
    };
    document.nodes.push(moved);
    let mut root = node;
    while let Some(parent) = parents[root] {
        root = parent;
    }
    for scene in &mut document.scenes {
        if scene.nodes.contains(&root) {
            scene.nodes.push(new);
        }
    }
    let channels = document.animations.iter_mut().flat_map(|a| &mut a.channels);
    for channel in channels {
        if channel.node == node && matches!(channel.keys, Keys::Weights(_)) {
            channel.node = new;
        }
    }
}

/// Makes the weights of each vertex sum to 1 and the joints without influence 0.
fn influences(primitive: &mut Primitive) {
    // As exact as a sum of numbers in single precision can be.
    const TOLERANCE: f64 = 1e-7;
    let vertices = primitive.joints.first().map_or(0, Vec::len);
    for vertex in 0..vertices {
        let weights = || primitive.weights.iter().flat_map(|set| set[vertex]);
        let sum: f64 = weights().map(f64::from).sum();
        let is_one = (sum - 1.0).abs() <= TOLERANCE;
        for (joints, weights) in primitive.joints.iter_mut().zip(&mut primitive.weights) {
            for (joint, weight) in joints[vertex].iter_mut().zip(&mut weights[vertex]) {
                if !is_one && sum > 0.0 {
                    *weight = (f64::from(*weight) / sum) as f32;
                }
                if *weight == 0.0 {
                    *joint = 0;
                }
            }
        }
    }
}
