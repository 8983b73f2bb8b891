use std::collections::HashSet;

use ga_mesh::gltf::{Document, Node};
use ga_runtime::vga3::Vector;

use super::bind_pose::bind_pose;
use super::{Placement, Player};
use crate::character::Character;
use crate::file_error::MotionFileError;
use crate::skeleton::{Joint, Skeleton, SkeletonError};
use crate::skin::Method;
use crate::weights::SkinWeights;

/// The character of a document: all meshes that its skins move, in the pose in which they were
/// bound, with the joints of all skins in one skeleton.
///
/// A mesh without a skin follows the joint above it, such as a hat below the head; one that has no
/// joint above it is left out. The joints have the names of their nodes; a node without a name, or
/// with that of an earlier joint, adds its number. A bone ends at the mean place of the joints
/// below it. One without such joints is half as long as the bone above it and continues it.
///
/// # Errors
///
/// Those of [`Player::new`](super::Player::new), and [`MotionFileError::NoSkin`],
/// [`MotionFileError::Mesh`], [`MotionFileError::Skeleton`] and [`MotionFileError::Skin`].
///
/// # Examples
///
/// ```
/// use ga_anim::gltf::character;
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
///         Node { name: Some("hip".into()), ..Node::default() },
///     ],
///     meshes: vec![Mesh { primitives: vec![vertex], ..Mesh::default() }],
///     skins: vec![Skin { joints: vec![1], ..Skin::default() }],
///     ..Document::default()
/// };
/// let body = character(&document)?;
/// assert_eq!(body.skeleton.index("hip"), Some(0));
/// assert_eq!(body.weights.influences(0)[0].weight, 1.0);
/// # Ok::<(), ga_anim::MotionFileError>(())
/// ```
pub fn character(document: &Document) -> Result<Character, MotionFileError> {
    document.validate().map_err(MotionFileError::Document)?;
    let whole = Player::new(document)?;
    let Followed {
        document: followed,
        joint_nodes,
        joint_of,
        nearest,
    } = Followed::new(document, &whole)?;
    let player = Player::new(&followed)?;
    let placement = Placement::new(&player)?;
    let pose = bind_pose(&player)?;
    let placed = placement.place(&pose, Method::Linear)?;
    let mut rows: Vec<Vec<(u32, f64)>> = Vec::with_capacity(placement.vertex_count());
    for (index, part) in placement.parts().iter().enumerate() {
        let joints = followed.nodes[part.node]
            .skin
            .map(|skin| &followed.skins[skin].joints);
        match (placement.weights(index), joints) {
            (Some(weights), Some(joints)) => rows.extend(weights.iter().map(|influences| {
                let joint = |joint: u32| joint_of[joints[joint as usize]].unwrap_or_default();
                let row = influences.iter();
                row.map(|influence| (joint(influence.joint), influence.weight))
                    .collect()
            })),
            _ => {
                let joint = nearest[part.node].unwrap_or_default();
                rows.extend(part.vertices.clone().map(|_| vec![(joint, 1.0)]));
            }
        }
    }
    let heads = joint_nodes
        .iter()
        .map(|&node| pose.world[node].translation.into());
    // The pictures of materials lie beside the file, which a character does not know.
    let mesh = placement.mesh(&placed, |_| true)?;
    let faces = mesh.faces().len();
    Ok(Character {
        mesh: mesh.with_materials(Vec::new(), vec![None; faces])?,
        skeleton: skeleton(document, &whole, &joint_nodes, &joint_of, heads.collect())?,
        weights: SkinWeights::new(joint_nodes.len(), rows)?,
    })
}

/// A document without the meshes that no joint moves and without animations, and the joints.
pub(super) struct Followed {
    pub(super) document: Document,
    pub(super) joint_nodes: Vec<usize>,
    /// The joint that each node is.
    pub(super) joint_of: Vec<Option<u32>>,
    /// That joint, or that of the nearest node above.
    nearest: Vec<Option<u32>>,
}

impl Followed {
    pub(super) fn new(document: &Document, whole: &Player) -> Result<Self, MotionFileError> {
        let joint_nodes = joint_nodes(document, whole);
        if joint_nodes.is_empty() {
            return Err(MotionFileError::NoSkin);
        }
        let mut joint_of = vec![None; document.nodes.len()];
        for (joint, &node) in joint_nodes.iter().enumerate() {
            joint_of[node] = Some(joint as u32);
        }
        let mut nearest = joint_of.clone();
        for &node in whole.parents_before_children() {
            let above = whole.parents()[node].and_then(|parent| nearest[parent]);
            nearest[node] = nearest[node].or(above);
        }
        let mut followed = document.clone();
        for (node, nearest) in followed.nodes.iter_mut().zip(&nearest) {
            if node.skin.is_none() && nearest.is_none() {
                (node.mesh, node.weights) = (None, None);
            }
        }
        // Their animations may move the weights of meshes that are left out.
        followed.animations.clear();
        Ok(Self {
            document: followed,
            joint_nodes,
            joint_of,
            nearest,
        })
    }
}

/// How many nodes of a document have a mesh that no joint moves, which its [`character`] lacks.
///
/// # Errors
///
/// As [`character`].
pub fn meshes_without_joint(document: &Document) -> Result<usize, MotionFileError> {
    let followed = Followed::new(document, &Player::new(document)?)?;
    let pairs = document.nodes.iter().zip(&followed.document.nodes);
    Ok(pairs
        .filter(|(before, after)| before.mesh != after.mesh)
        .count())
}

/// The joints of all skins that nodes use, and the nodes between them, parents first.
fn joint_nodes(document: &Document, player: &Player) -> Vec<usize> {
    let mut is_joint = vec![false; document.nodes.len()];
    let skins = document.nodes.iter().filter_map(|node| node.skin);
    for skin in skins {
        let joints = &document.skins[skin].joints;
        joints.iter().for_each(|&node| is_joint[node] = true);
    }
    let (parents, order) = (player.parents(), player.parents_before_children());
    let mut is_below = vec![false; document.nodes.len()];
    for &node in order {
        is_below[node] = parents[node].is_some_and(|p| is_joint[p] || is_below[p]);
    }
    // From the leaves up, what lies between two joints.
    for &node in order.iter().rev() {
        if let (true, true, Some(parent)) = (is_joint[node], is_below[node], parents[node]) {
            is_joint[parent] = true;
        }
    }
    order
        .iter()
        .copied()
        .filter(|&node| is_joint[node])
        .collect()
}

/// The joints of a document: those of its skins, or all nodes where there is no skin.
pub(crate) fn all_joints(document: &Document, player: &Player) -> Vec<usize> {
    match joint_nodes(document, player) {
        none if none.is_empty() => player.parents_before_children().to_vec(),
        joints => joints,
    }
}

/// These nodes, parents first, as joints in the pose in which the skins were bound.
pub(super) fn skeleton_of(
    document: &Document,
    player: &Player,
    joint_nodes: &[usize],
) -> Result<Result<Skeleton, SkeletonError>, MotionFileError> {
    let mut joint_of = vec![None; document.nodes.len()];
    for (joint, &node) in joint_nodes.iter().enumerate() {
        joint_of[node] = Some(joint as u32);
    }
    let pose = bind_pose(player)?;
    let heads = joint_nodes
        .iter()
        .map(|&node| pose.world[node].translation.into());
    let heads = heads.collect();
    Ok(skeleton(document, player, joint_nodes, &joint_of, heads))
}

fn skeleton(
    document: &Document,
    player: &Player,
    joint_nodes: &[usize],
    joint_of: &[Option<u32>],
    heads: Vec<Vector<f64>>,
) -> Result<Skeleton, SkeletonError> {
    let parent = |node: usize| player.parents()[node].and_then(|parent| joint_of[parent]);
    let mut below = vec![(Vector::default(), 0u32); heads.len()];
    for (&node, &head) in joint_nodes.iter().zip(&heads) {
        if let Some(parent) = parent(node) {
            let (sum, count) = &mut below[parent as usize];
            *sum += head;
            *count += 1;
        }
    }
    let mut joints: Vec<Joint> = Vec::with_capacity(heads.len());
    let mut names = HashSet::new();
    for (index, &node) in joint_nodes.iter().enumerate() {
        let (head, (sum, count)) = (heads[index], below[index]);
        let parent = parent(node).map(|parent| parent as usize);
        let tail = match (count, parent) {
            (0, Some(parent)) => head + (head - heads[parent]) * 0.5,
            (0, None) => head,
            _ => sum * f64::from(count).recip(),
        };
        joints.push(Joint {
            name: name(node, &document.nodes[node], &mut names),
            parent,
            head: head.coordinates(),
            tail: tail.coordinates(),
        });
    }
    Skeleton::new(joints)
}

/// The name of a node, with its number where an earlier one has the same or it has none.
fn name(index: usize, node: &Node, taken: &mut HashSet<String>) -> String {
    let own = node.name.clone().filter(|name| !taken.contains(name));
    let mut name = own.unwrap_or_else(|| match &node.name {
        Some(name) => format!("{name} (node {index})"),
        None => format!("node {index}"),
    });
    // An earlier node may have just this name.
    while taken.contains(&name) {
        name.push('_');
    }
    taken.insert(name.clone());
    name
}
