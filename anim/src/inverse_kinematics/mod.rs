//! Inverse kinematics: from where joints should be to how they rotate.
//!
//! | job | for | method |
//! | --- | --- | --- |
//! | [`TwoBone`] | arms and legs | closed form: two spheres and a plane meet |
//! | [`Fabrik`] | chains of any length | each bone in turn is drawn to its sphere, with limits |
//! | [`Aim`] | heads, eyes, cameras | closed form: an axis to a direction, another upwards |
//! | [`PoseFit`] | whole bodies, from markers or cameras | least squares over all motors |
//!
//! Each takes plain points and gives points, rotors or a pose. [`TwoBone`], [`Fabrik`] and [`Aim`]
//! know no skeleton; [`bend_limb`], [`reach_with_chain`] and [`aim_joint`] apply them to the joints
//! of a [`Pose`](crate::pose::Pose). The first three allocate nothing; a [`PoseFit`] is prepared
//! once for many frames.
//!
//! A target out of reach is not an error: the result is the nearest pose or one near it, and it
//! says how far it is from the target. Where the input does not determine a result, such as a pole
//! on the line from shoulder to hand, there is a typed error.

mod aim;
mod check;
mod fabrik;
mod limb;
mod motion;
mod normal_equations;
mod rotation;
mod two_bone;
mod whole_pose;

pub use aim::{Aim, aim_joint};
pub use fabrik::{Fabrik, FabrikOptions, FabrikReport, reach_with_chain};
pub use limb::bend_limb;
pub use two_bone::{Bent, Reach, TwoBone};
pub use whole_pose::{Marker, PoseFit, PoseFitOptions, PoseFitReport, Target};

pub(crate) use limb::place_limb;
pub(crate) use two_bone::middle_joint;
