//! Motions in files, with what is unusual about them.

use std::path::Path;

use anyhow::{Result, ensure};
use ga_anim::bvh::{self, Bvh, BvhWarning};
use ga_anim::motion_file::{Loss, MotionFile, Options};
use ga_anim::unit::LikelyUnit;

use crate::frame::{Warning, keep_for_failure};
use crate::reading::reading;

/// Reads a motion in BVH and adds what is unusual about the file to the warnings.
pub(crate) fn read(path: &Path, warnings: &mut Vec<Warning>) -> Result<Bvh> {
    let motion = bvh::read_as(path, reading())?;
    warn(path, motion.warnings(), warnings);
    Ok(motion)
}

/// As [`read`], for a file of any format; `option` gives the length of a unit.
pub(crate) fn read_any(
    path: &Path,
    options: Options,
    option: &str,
    warnings: &mut Vec<Warning>,
) -> Result<MotionFile> {
    let options = Options {
        reading: reading(),
        ..options
    };
    let motion = MotionFile::read(path, options)?;
    warn(path, motion.warnings(), warnings);
    if let Some(unit) = motion.likely_unit() {
        warn_of_unit(path, unit, option, warnings);
    }
    Ok(motion)
}

/// The length of one unit in metres, where it is given.
pub(crate) fn checked_unit(option: &str, metres: Option<f64>) -> Result<Option<f64>> {
    if let Some(metres) = metres {
        ensure!(
            metres > 0.0 && metres.is_finite(),
            "{option} {metres}: the length of a unit must be greater than 0 and finite"
        );
    }
    Ok(metres)
}

/// Adds what is not clear about a unit that was found to the warnings; `option` gives it.
pub(crate) fn warn_of_unit(
    path: &Path,
    unit: LikelyUnit,
    option: &str,
    warnings: &mut Vec<Warning>,
) {
    if let Some(doubt) = unit.doubt() {
        let message = format!("{doubt}; {option} gives it");
        warnings.push(Warning::new("unclear_unit", message).in_file(path));
    }
}

/// The warning of what is not in a file that is written.
pub(crate) fn lost(loss: &Loss, out: &Path) -> Warning {
    Warning {
        joint: loss.joint().map(ToOwned::to_owned),
        frame: loss.frame(),
        ..Warning::new(loss.kind(), loss).in_file(out)
    }
}

fn warn(path: &Path, found: &[BvhWarning], warnings: &mut Vec<Warning>) {
    let found = found.iter().map(|warning| Warning {
        line: warning.line(),
        ..Warning::new(warning.kind(), warning).in_file(path)
    });
    let found: Vec<Warning> = found.collect();
    keep_for_failure(&found);
    warnings.extend(found);
}
