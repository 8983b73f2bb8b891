//! The two views.

use std::path::Path;

use anyhow::{Result, bail};
use clap::ValueEnum;
use ga_video::VideoError;
use ga_video::stereo::{Layout, StereoSource, shape};
use serde::{Deserialize, Serialize};

use crate::frame::Warning;

/// How the two views are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub(in crate::commands::video) enum LayoutName {
    /// The left view in the left half of each frame (SBS).
    #[value(alias = "sbs")]
    SideBySide,
    /// The left view in the upper half of each frame (TAB, over-under).
    #[value(alias = "tab")]
    TopBottom,
    /// Side by side, each view squeezed to half of its width (half SBS).
    #[value(alias = "half-sbs")]
    HalfSideBySide,
    /// The left view above, each view squeezed to half of its height (half TAB, half over-under).
    #[value(alias = "half-tab")]
    HalfTopBottom,
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
            (Some(name), true) if name != Self::TwoFiles => bail!(
                "--layout {} is for one file that has both views, and two are given",
                name.word()
            ),
            (Some(name), _) => Ok(name),
            (None, true) => Ok(Self::TwoFiles),
            (None, false) => bail!(
                "say with --layout where the two views lie in the video: side-by-side, \
                 top-bottom, half-side-by-side or half-top-bottom"
            ),
        }
    }

    /// The name of a layout of both views in one frame.
    pub(super) fn of_halves(layout: Layout) -> Self {
        match layout {
            Layout::SideBySide => Self::SideBySide,
            Layout::TopBottom => Self::TopBottom,
            Layout::HalfSideBySide => Self::HalfSideBySide,
            Layout::HalfTopBottom => Self::HalfTopBottom,
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
            Self::HalfSideBySide => Some(Layout::HalfSideBySide),
            Self::HalfTopBottom => Some(Layout::HalfTopBottom),
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

    /// A warning where the shape of the views looks as if they were stored in another layout.
    pub(super) fn doubt(self, source: &StereoSource) -> Option<Warning> {
        let properties = source.properties();
        let other = self.halves()?.likelier(properties)?;
        Some(Warning::new(
            "unusual_shape",
            format!(
                "with --layout {}, each view is {:.2} times as wide as high: is it {}?",
                self.word(),
                shape(properties),
                Self::of_halves(other).word()
            ),
        ))
    }
}
