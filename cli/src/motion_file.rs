//! Motions in BVH, with what is unusual about their files.

use std::path::Path;

use anyhow::Result;
use ga_anim::bvh::{self, Bvh, BvhWarning};

use crate::frame::{Warning, keep_for_failure};

/// Reads a motion and adds what is unusual about the file to the warnings.
pub(crate) fn read(path: &Path, warnings: &mut Vec<Warning>) -> Result<Bvh> {
    let motion = bvh::read(path)?;
    let found = motion.warnings().iter().map(|warning| {
        let (kind, line) = match warning {
            BvhWarning::FrameCount { line, .. } => ("frame_count", Some(*line)),
            BvhWarning::PositionsBelowRoot { .. } => ("positions_below_root", None),
        };
        Warning {
            line,
            ..Warning::new(kind, warning).in_file(path)
        }
    });
    let found: Vec<Warning> = found.collect();
    keep_for_failure(&found);
    warnings.extend(found);
    Ok(motion)
}
