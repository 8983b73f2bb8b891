//! Motions in step, as reports describe them.

use ga_anim::gait::Footfall;
use serde::Serialize;

/// When feet come down in motions that are in step.
#[derive(Debug, Serialize)]
pub(super) struct Phases {
    /// In the result.
    pub(super) footfalls: Vec<Footfall>,
    pub(super) phases: Vec<Phase>,
}

/// A motion that is in step with others.
#[derive(Debug, Serialize)]
pub(super) struct Phase {
    pub(super) file: String,
    /// What of it is in the result.
    pub(super) begin_seconds: f64,
    pub(super) end_seconds: f64,
    pub(super) footfalls: Vec<Footfall>,
}
