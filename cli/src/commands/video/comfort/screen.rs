//! The screen.

use anyhow::Result;
use ga_video::comfort::Viewing;
use serde::{Deserialize, Serialize};

/// The screen on which a video is seen.
#[derive(Clone, Copy, Debug, Serialize, Deserialize, clap::Args)]
pub(super) struct Screen {
    /// The diagonal of the screen, which has 16:9.
    #[arg(long, value_name = "INCHES", default_value_t = 55.0)]
    screen_inches: f64,
    /// The distance of the eyes from the screen; three heights of the screen if it is not given.
    #[arg(long, value_name = "METRES")]
    distance_metres: Option<f64>,
}

impl Screen {
    /// The eyes before it.
    pub(super) fn viewing(self) -> Result<Viewing> {
        Ok(Viewing::of_screen(
            self.screen_inches,
            self.distance_metres,
        )?)
    }

    /// The options that say the same, each after a space.
    pub(super) fn words(self) -> String {
        let distance = self.distance_metres;
        let distance = distance.map(|metres| format!(" --distance-metres {metres}"));
        format!(
            " --screen-inches {}{}",
            self.screen_inches,
            distance.unwrap_or_default()
        )
    }
}
