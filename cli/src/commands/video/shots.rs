//! The options by which shots are found.

use clap::ValueEnum;
use ga_video::keyframe::Options;
use ga_video::keyframe::layout::Layout;
use serde::{Deserialize, Serialize};

#[derive(Clone, Copy, Debug, Serialize, Deserialize, clap::Args)]
pub(super) struct ShotOptions {
    /// How frames are divided into blocks.
    #[arg(long, value_enum, default_value_t = Blocks::Five)]
    layout: Blocks,
    /// The least number of frames of a shot.
    #[arg(long, value_name = "FRAMES", default_value_t = 1)]
    min_shot: usize,
}

/// The blocks into which frames are divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
enum Blocks {
    /// Objects in the middle, background in the four corners.
    Five,
    /// Cui's: objects below the middle, background at the left, above and at the right.
    Paper,
}

impl ShotOptions {
    /// The options of an analysis; what is said of key frames are the defaults.
    pub(super) fn options(self) -> Options {
        Options {
            layout: match self.layout {
                Blocks::Five => Layout::Five,
                Blocks::Paper => Layout::Paper,
            },
            minimum_shot: self.min_shot,
            ..Options::default()
        }
    }
}
