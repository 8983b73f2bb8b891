//! A document at one moment, as a mesh.

use ga_mesh::gltf::{Animation, Document};
use ga_mesh::{Bounds, Mesh};
use serde::Serialize;

use super::placement::Placement;
use super::player::Player;
use crate::file_error::MotionFileError;
use crate::skin::Method;

/// All meshes of a document in the world at one moment, and what they were made of. See
/// [`Placement`].
#[derive(Clone, Debug, Serialize)]
pub struct Moment {
    /// The animation; `None` for the pose of the nodes alone.
    pub animation: Option<usize>,
    /// Its name.
    pub animation_name: Option<String>,
    /// How many animations the document has.
    pub animations: usize,
    /// The time of the animation's last key.
    pub duration_seconds: Option<f64>,
    /// The moment.
    pub time_seconds: f64,
    /// How the joints that move a vertex are combined.
    pub method: Method,
    /// How many vertices there are.
    pub vertices: usize,
    /// How many faces there are.
    pub faces: usize,
    /// The least and the greatest coordinates of the vertices, in the unit of the document; `None`
    /// without vertices.
    pub bounds: Option<Bounds>,
    /// The primitives of the meshes of the nodes, in rising index of the nodes.
    pub parts: Vec<MomentPart>,
    /// The vertices and faces.
    #[serde(skip)]
    pub mesh: Mesh,
}

/// The vertices of a primitive of the mesh of a node.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MomentPart {
    /// The node.
    pub node: usize,
    /// Its name.
    pub node_name: Option<String>,
    /// The mesh.
    pub mesh: usize,
    /// The primitive of the mesh.
    pub primitive: usize,
    /// The skin of the node.
    pub skin: Option<usize>,
    /// The place of its first vertex among all vertices.
    pub first_vertex: usize,
    /// How many vertices it has: as many as its `POSITION` has items.
    pub vertices: usize,
}

impl Moment {
    /// A document at a time in seconds of an animation, or in the pose of its nodes alone.
    ///
    /// # Errors
    ///
    /// Those of [`Player::new`], [`Player::pose`], [`Placement::new`], [`Placement::place`] and
    /// [`Placement::mesh`]; [`MotionFileError::NoMesh`].
    pub fn new(
        document: &Document,
        animation: Option<usize>,
        seconds: f64,
        method: Method,
    ) -> Result<Self, MotionFileError> {
        let player = Player::new(document)?;
        let pose = player.pose(animation, seconds)?;
        let placement = Placement::new(&player)?;
        let placed = placement.place(&pose, method)?;
        if placement.parts().is_empty() {
            return Err(MotionFileError::NoMesh);
        }
        let mesh = placement.mesh(&placed, |_| true)?;
        let played = animation.and_then(|index| document.animations.get(index));
        let parts = placement.parts().iter().map(|part| {
            let node = &document.nodes[part.node];
            MomentPart {
                node: part.node,
                node_name: node.name.clone(),
                mesh: part.mesh,
                primitive: part.primitive,
                skin: node.skin,
                first_vertex: part.vertices.start,
                vertices: part.vertices.len(),
            }
        });
        Ok(Self {
            animation,
            animation_name: played.and_then(|animation| animation.name.clone()),
            animations: document.animations.len(),
            duration_seconds: played.map(Animation::duration),
            time_seconds: seconds,
            method,
            vertices: mesh.vertex_count(),
            faces: mesh.faces().len(),
            bounds: mesh.bounds().map(|[min, max]| Bounds { min, max }),
            parts: parts.collect(),
            mesh,
        })
    }
}
