//! Three-dimensional animation on conformal geometric algebra, after Y. Cui, "Geometric
//! algebra-based modeling techniques for 3D animation and their application to visual
//! communication", which the modules cite as "Cui".
//!
//! A skeleton is a tree of joints, a pose one motor for each joint, and skinning moves the vertices
//! of a mesh, which are conformal points, with the joints. Every motion here is a
//! [`Motor`](ga_runtime::cga3::Motor): of a joint, of a bone as a line, of a vertex as a point.
//!
//! | module | what it does |
//! | --- | --- |
//! | [`skeleton`], [`weights`] | the data: joints with parents first, influences without a limit |
//! | [`rig`], [`bvh`] | read rigs with painted weights, and motion capture |
//! | [`transform`], [`recording`] | motion as files have it: local transforms, frame by frame |
//! | [`motion_file`] | motions in files of any format, chosen by the endings of their names |
//! | [`curve`] | curves through keys: splines, lengths, few vertices within a proven bound |
//! | [`pose`], [`clip`] | motors of joints, and interpolation between frames along screws |
//! | [`kinematics`] | forward kinematics and layers of poses, over slices and in lanes |
//! | [`clip::compressed`] | recordings in few bytes, with a bound that holds on every frame |
//! | [`skin`] | moves a mesh, by the mean of matrices or of motors |
//! | [`weights::distance`], [`weights::geodesic`] | weights by distance, in space and in the body |
//! | [`character`] | mesh, skeleton and weights together, measured in motion |
//! | [`retarget`] | transfers a recording to another body |
//! | [`gait`] | steps: when feet come down, and motions in step with each other |
//! | [`leg`] | the leg of hip, knee and ankle (Cui, §2.3.3): from angles to positions and back |
//! | [`inverse_kinematics`] | from where joints should be to how they rotate |
//! | [`gltf`] | plays documents; skeletons and clips as [`ga_mesh::gltf::model`] writes them |
//! | [`unit`](mod@unit) | the length of a unit of a recording that does not state it |
//!
//! # Conventions
//!
//! Coordinates are right-handed with y up, and a person looks along z. Lengths are in metres unless
//! a file has another unit: readers keep the file's, and [`Mesh::scaled`](ga_mesh::Mesh::scaled)
//! and [`Skeleton::scaled`](skeleton::Skeleton::scaled) convert. Angles are in radians, times in
//! seconds, and indices count from 0; in messages lines count from 1. A motor takes a point at rest
//! to the pose, x' = G x ~G, and in a product of motors the right one comes first.
//!
//! Readers are strict and their errors name file, line and element; see [`ga_files`], through which
//! they read and write.
//!
//! # A joint bends
//!
//! ```
//! use ga_anim::pose::Pose;
//! use ga_anim::skeleton::{Joint, Skeleton};
//! use ga_anim::skin::{self, Method};
//! use ga_anim::weights::SkinWeights;
//! use ga_runtime::cga3::{Motor, Rotor};
//!
//! let mesh = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")?;
//! let joint = |name: &str, parent, x| Joint {
//!     name: name.into(),
//!     parent,
//!     head: [x, 0.0, 0.0],
//!     tail: [x + 1.0, 0.0, 0.0],
//! };
//! let arm = Skeleton::new(vec![
//!     joint("upper arm", None, 0.0),
//!     joint("forearm", Some(0), 1.0),
//! ])?;
//! let weights = SkinWeights::new(2, [[(0, 1.0)], [(1, 1.0)], [(1, 1.0)]])?;
//!
//! let bend =
//!     Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).ok_or("no axis")?;
//! let pose = Pose::from_rotors(&arm, Motor::default(), &[Rotor::default(), bend])?;
//! let moved = skin::skin(
//!     mesh.positions(),
//!     &weights,
//!     &pose.motions(&arm)?,
//!     Method::Motor,
//! )?;
//! let [x, y, _] = moved[2].coordinates();
//! assert!((x - 1.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod bvh;
pub mod character;
pub mod clip;
pub mod curve;
mod file_error;
mod frame_position;
pub mod gait;
pub mod gltf;
pub mod inverse_kinematics;
pub mod kinematics;
pub mod leg;
pub mod motion_file;
pub mod pose;
pub mod recording;
pub mod retarget;
pub mod rig;
pub mod skeleton;
pub mod skin;
pub mod transform;
pub mod unit;
pub mod weights;

pub use file_error::MotionFileError;

/// An alias of [`weights::distance`].
#[doc(no_inline)]
pub use weights::distance as distance_weights;
