//! The two views.

use std::path::Path;

use anyhow::{Result, bail};
use clap::ValueEnum;
use ga_video::VideoError;
use ga_video::stereo::{Layout, StereoSource};

/// How the two views are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::commands::video) enum LayoutName {
    /// The left view in the left half of each frame.
    SideBySide,
    /// The left view in the upper half of each frame.
    TopBottom,
    /// One file for each view.
    TwoFiles,
}

impl LayoutName {
    /// The layout that was asked for, or the one that the number of files says.
    pub(super) fn of(name: Option<Self>, right: Option<&Path>) -> Result<Self> {
        match (name, right.is_some()) {
            (Some(Self::TwoFiles), false) => {
                bail!("one file shows one view: name the video of the right view as well")
            }
            (Some(name @ (Self::SideBySide | Self::TopBottom)), true) => bail!(
                "--layout {} is for one file that has both views, and two are given",
                name.word()
            ),
            (Some(name), _) => Ok(name),
            (None, true) => Ok(Self::TwoFiles),
            (None, false) => bail!(
                "say with --layout where the two views lie in the video: side-by-side or top-bottom"
            ),
        }
    }

    /// The word that stands for it in a command.
    pub(super) fn word(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// The layout of both views in one frame.
    pub(super) fn halves(self) -> Option<Layout> {
        match self {
            Self::SideBySide => Some(Layout::SideBySide),
            Self::TopBottom => Some(Layout::TopBottom),
            Self::TwoFiles => None,
        }
    }

    /// Opens the views; without a second file, both are in the first.
    pub(super) fn open(
        self,
        first: &Path,
        right: Option<&Path>,
    ) -> Result<StereoSource, VideoError> {
        let first = ga_video::open_with_stills(first)?;
        match (self.halves(), right) {
            (None, Some(right)) => StereoSource::pair(first, ga_video::open_with_stills(right)?),
            (layout, _) => StereoSource::halves(first, layout.unwrap_or(Layout::SideBySide)),
        }
    }
}
