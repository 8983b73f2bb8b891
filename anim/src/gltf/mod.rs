//! glTF: evaluates the motion in a document, and turns skeletons and clips into what is written.
//!
//! # Evaluation
//!
//! A [`Player`] evaluates an animation of a [`Document`](ga_mesh::gltf::Document) at a time: the
//! frame of every node and the weights of the morph targets. A [`Placement`] then places the
//! vertices of all meshes in the world: first the morph targets, then the skin, or the frame of the
//! node where there is no skin. Both keep to the text of glTF 2.0:
//!
//! | what | how |
//! | --- | --- |
//! | `STEP`, `LINEAR` | the earlier key; a straight line, for rotations slerp by the shorter arc |
//! | `CUBICSPLINE` | Hermite's cubic with tangents times the interval; rotations are normalised |
//! | before the first key, after the last | that key |
//! | frames | T R S, or a matrix; that of the parent comes after that of the node |
//! | skins | every ancestor of a joint counts, the frame of the skinned node does not |
//! | inverse bind matrices | the identity where absent |
//! | weights of joints | all sets `WEIGHTS_0`, `WEIGHTS_1`, …, divided by their sum |
//!
//! The numbers of the file are single precision, and everything is computed in double precision.
//!
//! A [`Moment`] is all that at one time as a mesh.
//!
//! A [`character`] is what the skins of a document move: a mesh, a skeleton and weights.
//!
//! # Written files
//!
//! [`joint_nodes`] and [`vertex_weights`] are the data that [`ga_mesh::gltf::model`] writes. A
//! joint's node stands at the joint's position, with the axes of the mesh: with h the joint's
//! position at rest and p its parent's, its frame relative to its parent's node is T(h − p).
//!
//! A [`Rigged`] document takes a clip as its first animation and keeps all that it has.
//! Its bones can be given [other lengths](Rigged::with_lengths).

mod bind_pose;
mod character;
mod export;
mod lengths;
mod moment;
mod parts;
mod placement;
mod player;
mod reweighted;
mod rigged;
mod sampler;

pub(crate) use bind_pose::bind_pose;
pub(crate) use character::all_joints;
pub use character::{character, meshes_without_joint};
pub use export::{joint_nodes, vertex_weights};
pub use moment::{Moment, MomentPart};
pub(crate) use parts::{parts, quaternion, to_node, uniform, uniform_parts, uniform_within};
pub use placement::{Part, Placed, Placement};
pub use player::{LocalFrame, NodePose, Player};
pub use reweighted::with_weights;
pub use rigged::Rigged;
