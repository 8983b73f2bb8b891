//! What is reported of an evaluation.

use serde::Serialize;

use super::rows::Row;
use crate::frame::Warning;

#[derive(Serialize)]
pub(crate) struct Report {
    pub(super) motion: String,
    /// What the numbers were measured on.
    pub(super) data: &'static str,
    pub(super) metres_per_unit: f64,
    pub(super) joints: usize,
    pub(super) frames: usize,
    pub(super) frames_per_second: f64,
    pub(super) distance_metres: f64,
    pub(super) baseline_metres: f64,
    pub(super) focal_length_px: f64,
    pub(super) seed: u64,
    pub(super) rows: Vec<Row>,
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
}
