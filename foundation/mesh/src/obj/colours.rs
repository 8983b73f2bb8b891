//! The colours of vertices as parts of 1.

use ga_files::Deviations;

use super::ObjProblem;
use super::statements::Statements;
use crate::FormatError;
use crate::colour_range::{ColourOutOfRange, part};

/// Makes the colours parts of 1. Where they are bytes, that is a deviation from the format.
pub(super) fn scale_colours(
    read: &mut Statements,
    deviations: &mut Deviations<ObjProblem>,
) -> Result<(), FormatError> {
    let out_of_range = |ColourOutOfRange { place, value }| FormatError::Obj {
        line: place,
        problem: ObjProblem::ColourOutOfRange { value },
    };
    let ranges = [&mut read.colour_range, &mut read.alpha_range].map(std::mem::take);
    let [of_colour, of_alpha] = ranges.map(|range| range.bytes().map_err(out_of_range));
    let bytes = [of_colour?, of_alpha?];
    let are_bytes = [0, 1].map(|part| bytes[part].is_some());
    let names = ["colours", "opacities"];
    let mut found: Vec<_> = names.into_iter().zip(bytes).collect();
    found.sort_by_key(|(_, bytes)| bytes.as_ref().map(|first| first.place));
    for (what, first) in found {
        let Some(first) = first else { continue };
        let (line, value) = (first.place, first.value);
        let problem = ObjProblem::ByteColours { what, value };
        let tolerated = deviations.tolerate_times(line, first.places, problem);
        tolerated.map_err(|problem| FormatError::Obj { line, problem })?;
    }
    for [red, green, blue, alpha] in &mut read.colours {
        for number in [red, green, blue] {
            *number = part(*number, are_bytes[0]);
        }
        *alpha = part(*alpha, are_bytes[1]);
    }
    Ok(())
}
