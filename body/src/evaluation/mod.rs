//! How far reconstructed bodies are from true ones: the observations that cameras would make of a
//! known motion, and the errors of what is found from them.
//!
//! | score | formula for the joints p and the reconstructed q of a frame |
//! | --- | --- |
//! | mean per joint position error | mean of `\|q − p\|` |
//! | relative to the root | mean of `\|(q − q₀) − (p − p₀)\|` with the first joint as the root |
//! | aligned (Procrustes) | mean of `\|S q ~S − p\|` for the similarity S of least squares |
//! | 2-D joint error | mean of `\|π(q) − π(p)\|` over all views |
//!
//! Scores are means over frames, in metres and in pixels. The joints that were not found are left
//! out, so scores of methods that find other joints are to be read with the part that each found.
//!
//! An [`Evaluation`] compares three [methods](Method) on a recorded [`Motion`], for each [`Case`]
//! of noise, number of cameras and missing joints. Its tables and its plot have the shapes of Cui's
//! tables 2 and 3 and figs 9 and 10.

mod case;
mod error;
mod evaluated;
mod motion;
mod plot;
mod rows;
mod scores;
mod simulation;
mod table;

pub use case::Case;
pub use error::EvaluationError;
pub use evaluated::Evaluation;
pub use motion::{Motion, MotionOptions};
pub use rows::{Method, Row};
pub use scores::{Scores, score};
pub use simulation::{Disturbance, simulate, triangulated_points};
