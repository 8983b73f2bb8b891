//! What is said of two videos that were compared in parts.

use anyhow::{Context as _, Result, bail};

use super::arguments::Arguments;
use super::found::Found;
use super::measures::Measures;
use crate::format::Format;
use crate::frame::{Context, Shown};
use crate::part::{Outputs, Parts};

/// What may be made of the parts.
pub(crate) const FORMATS: [Format; 3] = [Format::Json, Format::Csv, Format::Svg];

/// What the command says that compares all frames.
pub(crate) fn merged(
    parts: &Parts,
    outputs: &Outputs,
    context: &Context,
) -> Result<Shown<Measures>> {
    let arguments = Arguments {
        csv: outputs.of(Format::Csv),
        plot: outputs.of(Format::Svg),
        ..parts.arguments()?
    };
    let mut all: Option<Found> = None;
    for part in parts.contents() {
        let (path, next) = part?;
        match &mut all {
            None => all = Some(next),
            Some(all) => {
                let added = all.append(next);
                added.with_context(|| path.display().to_string())?;
            }
        }
    }
    let Some(found) = all else {
        bail!("no part is given");
    };
    Ok(arguments
        .report(found, None, context)?
        .map(Measures::Videos))
}
