//! A person made by formulas: a closed mesh, a skeleton, skin weights and a walk.
//!
//! Nothing is read from a file, so that there is always a figure to animate. The person is an adult
//! without sex or age, like an artist's mannequin, with clothes that are only painted: 1.75 m tall,
//! facing +z with y up and the left side at +x, in metres. At rest it stands with its feet on the
//! plane y = 0 and its arms half way down.
//!
//! The figure is made in five steps:
//!
//! - *Shape*: a signed distance. Trunk, limbs and head are lofts through cross-sections given by
//!   breadth and depth, smoothly joined.
//! - *Surface*: marching tetrahedra over the left half, remeshed to even triangles and completed by
//!   its mirror image. It is closed, oriented, connected and without handles.
//! - *Skin*: an atlas of charts, and a texture of formulas of the place: face, hair, clothes.
//! - *Weights*: inverse distance to the bones (Cui, eq. 33, see
//!   [`distance_weights`](ga_anim::distance_weights)) within the part of the body that a point
//!   belongs to.
//! - *Markers*: coloured discs round the bones, painted on the skin where cameras are to find the
//!   body (see [`Human::markers`]), and dots all over, also on other characters ([`dots_on`]).
//! - *Walk*: gait curves of the textbooks at eight moments of the stride, put on the ground by
//!   forward and inverse kinematics.
//!
//! The result is the same on every run.

mod frame;
mod landmarks;
mod markers;
mod shape;
mod skeleton;
mod skin;
mod surface;
mod vector;
mod walk;
mod weights;

use ga_anim::character::Character;
use ga_anim::skeleton::Skeleton;
use ga_anim::weights::SkinWeights;
use ga_mesh::{Faces, Mesh, Position};

use vector::{Vector, mirror};

pub use markers::{DISC_LIFT, Marker, dots_on, with_discs};
pub use walk::{KEY_NAMES, KEY_TIME, KEYS_PER_STRIDE, walk};

/// The person's height in metres.
pub const STATURE: f64 = landmarks::STATURE;

/// A person at rest, ready to be moved.
///
/// # Examples
///
/// ```
/// use ga_mannequin::{Human, STATURE, walk};
///
/// let human = Human::new();
/// let [low, high] = human.mesh.bounds().ok_or("no vertices")?;
/// assert!((high[1] - low[1] - STATURE).abs() < 1e-3);
///
/// let step = walk(1).sample(0.3);
/// let bones = step.bones(&human.skeleton)?;
/// let foot = human.skeleton.index("LeftFoot").ok_or("no left foot")?;
/// let [ankle, ball] = bones[foot];
/// assert!(ankle[1] > ball[1] && ball[1] > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Human {
    /// The skin, about 18,000 vertices in triangles with texture coordinates. The left half comes
    /// first.
    pub mesh: Mesh,
    /// 21 joints: `Hips`, `Spine`, `Chest`, `Neck` and `Head`, and on either side, after `Left` or
    /// `Right`, `Shoulder`, `UpperArm`, `LowerArm` and `Hand`, `UpperLeg`, `LowerLeg`, `Foot` and
    /// `Toe`.
    pub skeleton: Skeleton,
    /// Up to four joints for each vertex.
    pub weights: SkinWeights,
}

impl Human {
    /// Makes the person.
    #[must_use]
    pub fn new() -> Self {
        let landmarks = landmarks::Landmarks::new();
        let body = shape::Body::new(&landmarks);
        let skeleton = skeleton();
        let surface = surface::surface(&body, &landmarks);
        let weights = weights::weights(&body, &landmarks, &skeleton, &surface.positions);
        let positions = surface.positions.into_iter().map(Position::from).collect();
        let mesh =
            Faces::from_polygons(surface.triangles).and_then(|faces| Mesh::new(positions, faces));
        let mesh =
            mesh.expect("the triangles of a surface refer to its vertices, which are finite");
        Human {
            mesh: skin::coordinates::with_texture_coordinates(mesh),
            skeleton,
            weights,
        }
    }
}

/// The [skeleton](Human::skeleton) alone, which is made in no time.
///
/// # Examples
///
/// ```
/// let skeleton = ga_mannequin::skeleton();
/// assert_eq!(skeleton.len(), 21);
/// assert_eq!(skeleton.joints()[0].name, "Hips");
/// ```
#[must_use]
pub fn skeleton() -> Skeleton {
    skeleton::skeleton(&landmarks::Landmarks::new())
}

impl From<Human> for Character {
    fn from(human: Human) -> Self {
        Self {
            mesh: human.mesh,
            skeleton: human.skeleton,
            weights: human.weights,
        }
    }
}

impl Default for Human {
    fn default() -> Self {
        Self::new()
    }
}
