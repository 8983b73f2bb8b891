//! What is reported of a fit.

use serde::Serialize;

/// A curve in the result.
#[derive(Serialize)]
pub(super) struct CurveReport {
    pub(super) parameters: Vec<f64>,
    pub(super) sse: f64,
    pub(super) plcc: f64,
    pub(super) rmse: f64,
    pub(super) outlier_ratio: f64,
}

/// The result. Numbers of the prediction are those of the curve with five parameters.
#[derive(Serialize)]
pub(crate) struct Report {
    pub(super) scores: usize,
    pub(super) logistic4: CurveReport,
    pub(super) logistic5: CurveReport,
    pub(super) plcc: f64,
    pub(super) plcc_interval: [f64; 2],
    pub(super) srocc: f64,
    pub(super) srocc_interval: [f64; 2],
    pub(super) krocc: f64,
    pub(super) krocc_interval: [f64; 2],
    pub(super) rmse: f64,
    pub(super) rmse_interval: [f64; 2],
    pub(super) outlier_ratio: f64,
    pub(super) outlier_ratio_interval: [f64; 2],
    pub(super) confidence: f64,
    pub(super) draws: u32,
    pub(super) seed: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) against: Option<AgainstReport>,
}

impl Report {
    /// What the measure is worth: names, numbers and intervals.
    pub(super) fn measures(&self) -> [(&'static str, f64, [f64; 2]); 5] {
        [
            ("PLCC", self.plcc, self.plcc_interval),
            ("SROCC", self.srocc, self.srocc_interval),
            ("KROCC", self.krocc, self.krocc_interval),
            ("RMSE", self.rmse, self.rmse_interval),
            (
                "outlier ratio",
                self.outlier_ratio,
                self.outlier_ratio_interval,
            ),
        ]
    }
}

/// The difference to another measure: this one's number minus the other's.
#[derive(Serialize)]
pub(super) struct AgainstReport {
    pub(super) column: String,
    pub(super) plcc: f64,
    pub(super) plcc_difference: f64,
    pub(super) plcc_difference_interval: [f64; 2],
    pub(super) srocc_difference: f64,
    pub(super) srocc_difference_interval: [f64; 2],
    /// Meng, Rosenthal and Rubin's test of the correlations, and the F test of the errors.
    pub(super) correlation_p_value: f64,
    pub(super) error_p_value: f64,
}
