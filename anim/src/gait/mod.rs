//! Steps: when feet come down to the ground, and motions in step with each other.
//!
//! [`footfalls`] finds the steps of a motion from the paths of its ankles. [`Aligned`] plays
//! motions so that their steps coincide, each on a clock of its own, for
//! [`blend_played`](crate::recording::blend_played).

mod aligned;
mod error;
mod foot;
mod footfalls;

pub use aligned::{Aligned, InStep};
pub use error::{GaitError, GaitProblem};
pub use foot::Foot;
pub use footfalls::{Footfall, footfalls, vertical};
