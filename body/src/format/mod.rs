//! Files of joints in pictures.
//!
//! | file | what it holds | read by |
//! | --- | --- | --- |
//! | [joints of views](JointViews), JSON | one person in all views | [`JointViews::decode`] |
//! | COCO, also AlphaPose, JSON | people in pictures of one view | [`coco::decode`] |
//! | OpenPose, JSON, one file a frame | people in one frame of one view | [`openpose::decode`] |
//! | AlphaPose's `cmu` and `open`, JSON | people in pictures of one view | [`alphapose::decode`] |
//! | MMPose, JSON | people in a film or a picture | [`mmpose::decode`] |
//! | a film with MediaPipe, JSON | one person in a film | [`film::decode`] |
//! | DeepLabCut, CSV | people in a film | [`deeplabcut::decode`] |
//!
//! [`JointViews::read`] takes one file of the first kind, or a file or folder of the others for
//! each view. Which joint is which follows from the file or from the number of joints, see
//! [`models`]. [`correspondence`](mod@correspondence) says which joint of a skeleton a detector
//! means.
//!
//! # Confidence and standard deviation
//!
//! Detectors state a confidence c from 0 to 1 for each joint. In a fit, a joint's squared residual
//! counts c times (F. Bogo et al., "Keep it SMPL", ECCV 2016, eq. 2), so that its standard
//! deviation is `σ / √c` with that of a joint of confidence 1. A joint of confidence 0 or
//! less is missing.

pub mod alphapose;
mod cameras;
pub mod coco;
pub mod correspondence;
pub mod deeplabcut;
mod detections;
mod error;
pub mod film;
mod input;
mod keys;
pub mod mmpose;
pub mod models;
pub(crate) mod names;
mod notes;
pub mod openpose;
mod timeline;
mod views;

pub use cameras::match_named;
pub use detections::{DetectedFrame, DetectedJoint, Detections, DetectorOptions, Person};
pub use error::{JointProblem, JointsError};
pub use input::JointsReadError;
pub use keys::FrameKey;
pub use models::{Model, UnknownModel};
pub use notes::JointsNote;
pub use views::{JointView, JointViews};
