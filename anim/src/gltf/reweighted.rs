//! Documents whose vertices have other weights.

use std::collections::HashMap;

use ga_mesh::gltf::{Document, Primitive};

use super::character::Followed;
use super::{Placement, Player};
use crate::file_error::MotionFileError;
use crate::weights::SkinWeights;
use crate::weights::error::SkinError;

/// The document with other weights of its skinned vertices, numbered as by
/// [`character`](super::character) and for its joints. A vertex has weights for joints of its own
/// skin alone; others are left out. A mesh that several skins move becomes one for each of them;
/// the new meshes come last.
///
/// # Errors
///
/// Those of [`character`](super::character), and [`MotionFileError::Skin`] for weights of another
/// number of vertices.
///
/// # Examples
///
/// ```
/// use ga_anim::gltf::{character, with_weights};
/// use ga_anim::weights::SkinWeights;
/// use ga_mesh::gltf::{Document, Mesh, Node, Primitive, Skin};
///
/// let vertex = Primitive {
///     positions: vec![[1.0, 0.0, 0.0]],
///     joints: vec![vec![[0; 4]]],
///     weights: vec![vec![[1.0, 0.0, 0.0, 0.0]]],
///     ..Primitive::default()
/// };
/// let document = Document {
///     nodes: vec![
///         Node { mesh: Some(0), skin: Some(0), ..Node::default() },
///         Node { children: vec![2], ..Node::default() },
///         Node::default(),
///     ],
///     meshes: vec![Mesh { primitives: vec![vertex], ..Mesh::default() }],
///     skins: vec![Skin { joints: vec![1, 2], ..Skin::default() }],
///     ..Document::default()
/// };
/// let weights = SkinWeights::new(2, [[(1, 0.75), (0, 0.25)]])?;
/// let changed = with_weights(&document, &weights)?;
/// assert_eq!(changed.meshes[0].primitives[0].joints[0][0], [1, 0, 0, 0]);
/// assert_eq!(character(&changed)?.weights, weights);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn with_weights(
    document: &Document,
    weights: &SkinWeights,
) -> Result<Document, MotionFileError> {
    let followed = Followed::new(document, &Player::new(document)?)?;
    let player = Player::new(&followed.document)?;
    let placement = Placement::new(&player)?;
    let (expected, found) = (placement.vertex_count(), weights.vertex_count());
    if expected != found {
        return Err(SkinError::VertexCount { expected, found }.into());
    }
    let mut changed = document.clone();
    // The mesh of each pair of mesh and skin.
    let mut meshes: HashMap<(usize, usize), usize> = HashMap::new();
    for part in placement.parts() {
        let Some(skin) = document.nodes[part.node].skin else {
            continue;
        };
        let is_known = meshes.keys().any(|&(mesh, _)| mesh == part.mesh);
        let mesh = *meshes.entry((part.mesh, skin)).or_insert_with(|| {
            if !is_known {
                return part.mesh;
            }
            changed.meshes.push(document.meshes[part.mesh].clone());
            changed.meshes.len() - 1
        });
        changed.nodes[part.node].mesh = Some(mesh);
        let joints = &document.skins[skin].joints;
        // For each joint of the character that of the skin.
        let mut of_skin = vec![None; followed.joint_nodes.len()];
        for (number, &node) in joints.iter().enumerate() {
            if let Some(joint) = followed.joint_of[node] {
                of_skin[joint as usize] = u16::try_from(number).ok();
            }
        }
        let rows = part.vertices.clone().map(|vertex| {
            let influences = weights.influences(vertex).iter();
            let row = influences.filter_map(|influence| {
                Some((of_skin[influence.joint as usize]?, influence.weight))
            });
            row.collect()
        });
        set(
            &mut changed.meshes[mesh].primitives[part.primitive],
            rows.collect(),
        );
    }
    Ok(changed)
}

/// Gives the vertices of a primitive these joints and weights, the greatest first.
fn set(primitive: &mut Primitive, mut rows: Vec<Vec<(u16, f64)>>) {
    for row in &mut rows {
        row.sort_by(|a, b| b.1.total_cmp(&a.1));
        let sum: f64 = row.iter().map(|(_, weight)| weight).sum();
        row.iter_mut().for_each(|(_, weight)| *weight /= sum);
    }
    let most = rows.iter().map(Vec::len).max().unwrap_or(0);
    let sets = 0..most.div_ceil(4);
    let slot = |row: &[(u16, f64)], set: usize, slot: usize| {
        row.get(4 * set + slot).copied().unwrap_or((0, 0.0))
    };
    let of_sets = |set: usize| {
        rows.iter()
            .map(move |row| [0, 1, 2, 3].map(|k| slot(row, set, k)))
    };
    primitive.joints = sets
        .clone()
        .map(|set| {
            of_sets(set)
                .map(|four| four.map(|(joint, _)| joint))
                .collect()
        })
        .collect();
    primitive.weights = sets
        .map(|set| {
            of_sets(set)
                .map(|four| four.map(|(_, weight)| weight as f32))
                .collect()
        })
        .collect();
}
