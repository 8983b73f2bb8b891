//! Files of joints in pictures.
//!
//! | file | what it holds | read by |
//! | --- | --- | --- |
//! | [joints of views](JointViews), JSON | one person in all views | [`JointViews::decode`] |
//! | COCO, JSON | people in pictures of one view, 17 joints or those it names | [`coco::decode`] |
//! | OpenPose, JSON, one file a frame | people in one frame of one view | [`openpose::decode`] |
//!
//! [`JointViews::read`] takes one file of the first kind, or a file or folder of the others for
//! each view. [`correspondence`](mod@correspondence) says which joint of a skeleton a detector
//! means.
//!
//! # Confidence and standard deviation
//!
//! Detectors state a confidence c from 0 to 1 for each joint. In a fit, a joint's squared residual
//! counts c times (F. Bogo et al., "Keep it SMPL", ECCV 2016, eq. 2), so that its standard
//! deviation is `σ / √c` with that of a joint of confidence 1. A joint of confidence 0 is missing.

mod cameras;
pub mod coco;
pub mod correspondence;
mod detections;
mod error;
mod input;
pub mod openpose;
mod views;

pub use detections::{DetectedFrame, DetectedJoint, Detections, DetectorOptions, FrameKey, Person};
pub use error::{JointProblem, JointsError};
pub use input::JointsReadError;
pub use views::{JointView, JointViews};
