//! A model as plain data.

use ga_runtime::cga3::Motor;

/// A mesh, and what moves it.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    /// The name of the mesh and of its node.
    pub name: &'a str,
    /// One point for each vertex, in metres.
    pub positions: &'a [[f64; 3]],
    /// One direction for each vertex, of any length. A zero vector, as for a vertex that no
    /// triangle uses, is written as straight up.
    pub normals: &'a [[f64; 3]],
    /// Three vertex indices for each triangle, counter-clockwise seen from outside. Triangles that
    /// name a vertex twice are left out.
    pub triangles: &'a [[u32; 3]],
    /// The appearance of the whole surface.
    pub material: Dielectric<'a>,
    /// The joints that carry the mesh, if any.
    pub skin: Option<Skin<'a>>,
    /// Motions of the joints.
    pub animations: &'a [Animation],
}

/// A dielectric surface of one colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric<'a> {
    /// Its name.
    pub name: &'a str,
    /// Red, green, blue as linear light, 0 to 1.
    pub base_colour: [f64; 3],
    /// 0 for a mirror, 1 for chalk.
    pub roughness: f64,
}

impl Default for Dielectric<'_> {
    /// Warm grey plaster, (214, 203, 190) in sRGB.
    fn default() -> Self {
        Self {
            name: "plaster",
            base_colour: [0.6724431569576875, 0.5972017883637634, 0.5149176653765214],
            roughness: 0.8,
        }
    }
}

/// Joints at rest, and their influence on the vertices.
#[derive(Clone, Copy, Debug)]
pub struct Skin<'a> {
    /// The joints, parents before children.
    pub joints: &'a [JointNode],
    /// For each vertex of the mesh, the joints that move it, as indices into `joints`, with their
    /// weights, which sum to 1.
    pub weights: &'a [Vec<(u32, f64)>],
}

/// A joint as a node of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct JointNode {
    /// Its name.
    pub name: String,
    /// The joint above it, or `None` for a root.
    pub parent: Option<usize>,
    /// Its frame at rest relative to its parent's frame.
    pub rest: Motor<f64>,
}

/// A motion: for some joints, their frames relative to their parents at each of some times.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// Its name.
    pub name: String,
    /// The times of the keys in seconds, not negative and strictly increasing.
    pub times: Vec<f64>,
    /// The joints that move; at most one track for each.
    pub tracks: Vec<Track>,
}

/// The motion of one joint. Viewers interpolate between keys, translations linearly and rotations
/// by slerp.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The joint, as an index into the skin's joints.
    pub joint: usize,
    /// Its frame relative to its parent's frame at each time of the animation.
    pub keys: Vec<Motor<f64>>,
}
