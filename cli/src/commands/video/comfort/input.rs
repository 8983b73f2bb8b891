//! The two views.

use std::path::Path;

use anyhow::{Result, bail};
use ga_video::VideoError;
use ga_video::stereo::{Layout, StereoSource};

/// How the two views are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(in crate::commands::video) enum LayoutName {
    /// The left view in the left half of each frame.
    SideBySide,
    /// The left view in the upper half of each frame.
    TopBottom,
    /// One file for each view.
    TwoFiles,
}

/// The layout that was asked for, or the one that the number of files says.
pub(super) fn layout(name: Option<LayoutName>, right: Option<&Path>) -> Result<LayoutName> {
    match (name, right.is_some()) {
        (Some(LayoutName::TwoFiles), false) => {
            bail!("one file shows one view: name the video of the right view as well")
        }
        (Some(name @ (LayoutName::SideBySide | LayoutName::TopBottom)), true) => {
            let name = match name {
                LayoutName::TopBottom => "top-bottom",
                _ => "side-by-side",
            };
            bail!("--layout {name} is for one file that has both views, and two are given")
        }
        (Some(name), _) => Ok(name),
        (None, true) => Ok(LayoutName::TwoFiles),
        (None, false) => bail!(
            "say with --layout where the two views lie in the video: side-by-side or top-bottom"
        ),
    }
}

/// The layout of both views in one frame.
pub(super) fn halves(layout: LayoutName) -> Option<Layout> {
    match layout {
        LayoutName::SideBySide => Some(Layout::SideBySide),
        LayoutName::TopBottom => Some(Layout::TopBottom),
        LayoutName::TwoFiles => None,
    }
}

pub(super) fn open(
    first: &Path,
    right: Option<&Path>,
    layout: LayoutName,
) -> Result<StereoSource, VideoError> {
    let first = ga_video::open_with_stills(first)?;
    match (halves(layout), right) {
        (Some(layout), _) => StereoSource::halves(first, layout),
        (None, Some(right)) => StereoSource::pair(first, ga_video::open_with_stills(right)?),
        (None, None) => StereoSource::halves(first, Layout::SideBySide),
    }
}
