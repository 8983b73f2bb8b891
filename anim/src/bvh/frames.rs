//! The numbers of the frames.

use ga_files::Reading;

use super::BvhProblem;
use super::words::{Words, number};
use crate::file_error::MotionFileError;

/// A line with numbers: where it is, and how many numbers it has.
struct Row {
    line: usize,
    numbers: usize,
}

/// The numbers of all frames up to the end of the text.
///
/// A line is a frame. In a tolerant reading a frame may also fill several lines, and a line may
/// have several frames; frames begin and end anywhere in lines only where all lines are filled
/// alike and have together just the numbers of the frames that are announced, since otherwise a
/// number that is missing would shift all that follow.
pub(super) fn frames(
    words: &mut Words,
    channels: usize,
    announced: usize,
) -> Result<Vec<f64>, MotionFileError> {
    let mut values = Vec::new();
    let mut rows = Vec::new();
    // Text behind the frames, and the error that it is where frames follow.
    let mut text: Option<(usize, String, MotionFileError)> = None;
    while let Some(line) = words.next_line()? {
        let before = values.len();
        for word in line.clone() {
            match number(word) {
                Ok(value) => values.push(value),
                Err(problem) => {
                    let is_text = values.len() == before
                        && matches!(problem, BvhProblem::NotANumber { .. })
                        && line.clone().count() != channels
                        && values.len() >= channels.saturating_mul(announced);
                    let error = words.error(problem);
                    if !is_text || words.reading() == Reading::Strict {
                        return Err(error);
                    }
                    text.get_or_insert((words.line(), word.to_owned(), error));
                    break;
                }
            }
        }
        let numbers = values.len() - before;
        if numbers == 0 {
            continue;
        }
        if let Some((.., error)) = text {
            return Err(error);
        }
        let line = words.line();
        let row = Row { line, numbers };
        if words.reading() == Reading::Strict {
            if numbers != channels {
                return Err(length(channels, &row));
            }
            too_many(words, rows.len() + 1, announced)?;
        }
        rows.push(row);
    }
    if let Some((line, word, _)) = text {
        words.tolerate_at(line, 1, BvhProblem::ExtraText { word })?;
    }
    wrapped(words, &rows, channels, announced)?;
    Ok(values)
}

/// A strict reading ends with the first frame that is two too many.
fn too_many(words: &Words, found: usize, announced: usize) -> Result<(), MotionFileError> {
    if found <= announced.saturating_add(1) {
        return Ok(());
    }
    Err(words.error(BvhProblem::FrameCount {
        expected: announced,
        found,
    }))
}

fn length(channels: usize, row: &Row) -> MotionFileError {
    MotionFileError::Bvh {
        line: row.line,
        problem: BvhProblem::FrameLength {
            expected: channels,
            found: row.numbers,
        },
    }
}

/// Whether lines are filled regardless of where frames begin: all have as many numbers as the
/// first, only the last may have fewer, and together they have those of the announced frames.
fn is_stream(rows: &[Row], channels: usize, announced: usize) -> bool {
    let Some((last, others)) = rows.split_last() else {
        return false;
    };
    let width = others.first().unwrap_or(last).numbers;
    let is_even = last.numbers <= width && others.iter().all(|row| row.numbers == width);
    let total: usize = rows.iter().map(|row| row.numbers).sum();
    is_even && Some(total) == channels.checked_mul(announced)
}

/// Adds a warning where lines are not frames. The error is the first line that does not fit.
fn wrapped(
    words: &mut Words,
    rows: &[Row],
    channels: usize,
    announced: usize,
) -> Result<(), MotionFileError> {
    let mut others = rows.iter().filter(|row| row.numbers != channels);
    let Some(first) = others.next() else {
        return Ok(());
    };
    let count = 1 + others.count();
    if !is_stream(rows, channels, announced) {
        // The lines of a frame that fills several, and how many numbers they have.
        let (mut begin, mut filled) = (0, 0);
        for (index, row) in rows.iter().enumerate() {
            if filled == 0 {
                begin = index;
            }
            filled += row.numbers;
            match filled {
                _ if filled == channels || (begin == index && filled % channels == 0) => filled = 0,
                _ if filled > channels => return Err(length(channels, &rows[begin])),
                _ => {}
            }
        }
        if filled > 0 {
            return Err(length(channels, &rows[begin]));
        }
    }
    let problem = BvhProblem::FrameLength {
        expected: channels,
        found: first.numbers,
    };
    words.tolerate_at(first.line, count, problem)
}
