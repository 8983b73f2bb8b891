//! Forward kinematics and layers of poses, as jobs over slices of motors that allocate nothing.
//!
//! A pose in these jobs is a slice of one motor for each joint, in the order of
//! [`Skeleton::joints`](crate::skeleton::Skeleton::joints), and several poses follow each other in
//! one slice. The motors may be of any scalar. With `f32` or `f64` a motor is one of one pose. With
//! [`Lanes<f32, 8>`](ga_runtime::scalar::Lanes) it holds the motors of eight frames side by side,
//! and the same loop computes all eight in vector instructions, which are chosen when the program
//! runs ([`Batch`](ga_runtime::batch::Batch)): that is the way for whole clips and for crowds.
//! [`Motor::from_lanes`](ga_runtime::cga3::Motor::from_lanes) puts motors side by side.
//!
//! ```
//! use ga_anim::kinematics::Hierarchy;
//! use ga_runtime::cga3::{Motor, Rotor, Translator};
//! use ga_runtime::scalar::Lanes;
//!
//! // A shoulder and an elbow; eight frames in which the shoulder rises by a metre a frame.
//! let arm = Hierarchy::new(&[None, Some(0)])?;
//! let raised =
//!     |frame: usize| Motor::from(Translator::from_displacement([0.0, frame as f32, 0.0]));
//! let shoulder = Motor::from_lanes(&std::array::from_fn::<_, 8, _>(raised));
//! let mut total = [Motor::<Lanes<f32, 8>>::default(); 2];
//! arm.forward(Motor::default(), &[shoulder, Motor::default()], &mut total)?;
//! assert_eq!(total[1].lane(5).translator().displacement(), [0.0, 5.0, 0.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod forward;
mod layers;

pub use error::KinematicsError;
pub use forward::Hierarchy;
pub(crate) use forward::forward_pose;
pub use layers::blend_layers;
