//! The options of commands whose parts are files of what was measured.

use std::path::{Path, PathBuf};

use anyhow::Result;

use super::Frames;
use crate::files::Files;
use crate::format::Format;

#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct PartArguments {
    /// Measure these frames alone, the first included and the last not, as A.. and ..B too, for
    /// `nullcone merge`.
    #[arg(long, value_name = "A..B", requires = "part")]
    frames: Option<Frames>,
    /// Write what was measured of --frames, which `nullcone merge` joins.
    #[arg(long, value_name = "PART.json", requires = "frames")]
    part: Option<PathBuf>,
}

impl PartArguments {
    /// Whether all frames are asked for.
    pub(crate) fn are_all(&self) -> bool {
        self.frames.is_none()
    }

    /// The frames, and where the part is written.
    pub(crate) fn asked(&self) -> Option<(Frames, &Path)> {
        Some((self.frames?, self.part.as_deref()?))
    }

    pub(crate) fn check(&self, files: &mut Files) -> Result<()> {
        files.write_if_given("--part", self.part.as_ref(), &[Format::Json])?;
        Ok(())
    }
}
