//! How two rectified views are matched.

use anyhow::{Result, ensure};
use clap::ValueEnum;
use ga_vision::diagnosis::of_match::MatchFault;
use ga_vision::matcher::Mode as MatcherMode;
use serde::Serialize;

use crate::frame::Warning;

/// What the commands that match views take.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct MatchingArguments {
    /// Disparities are less than this number of pixels.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(super) max_disparity: Option<i32>,
    /// The least disparity in pixels. Cameras that are turned towards each other see negative ones.
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        default_value_t = 0
    )]
    pub(super) min_disparity: i32,
    /// Leave disparities unknown that are less certain, from 0 to 1.
    #[arg(long, value_name = "C", default_value_t = 0.0)]
    pub(super) min_confidence: f32,
    /// How much work is done.
    #[arg(long, value_enum, default_value_t = Mode::Balanced)]
    pub(super) mode: Mode,
}

impl MatchingArguments {
    /// Fails where the least confidence is none.
    pub(super) fn check(&self) -> Result<()> {
        let least = self.min_confidence;
        ensure!(
            (0.0..=1.0).contains(&least),
            "--min-confidence {least} is not from 0 to 1"
        );
        Ok(())
    }
}

/// How much work is done.
#[derive(Clone, Copy, Debug, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Mode {
    /// The least time.
    Fast,
    /// More accurate on flat surfaces.
    Balanced,
    /// Also more accurate beside near objects.
    Best,
}

impl From<Mode> for MatcherMode {
    fn from(mode: Mode) -> Self {
        match mode {
            Mode::Fast => Self::Fast,
            Mode::Balanced => Self::Balanced,
            Mode::Best => Self::Best,
        }
    }
}

/// The warnings of a pair that was matched badly.
pub(super) fn warnings(faults: &[MatchFault]) -> Vec<Warning> {
    let faults = faults.iter();
    faults
        .map(|fault| Warning::new(fault.kind(), fault))
        .collect()
}
