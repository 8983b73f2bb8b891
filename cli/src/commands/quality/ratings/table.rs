//! Ratings as a table: a row for each rater, a column for each question.

use ga_files::table::{Table, TableError};
use ga_video::opinion::OpinionError;
use ga_video::opinion::ratings::{Rater, Ratings};

/// What is wrong with ratings.
#[derive(Debug, thiserror::Error)]
pub(super) enum RatingsError {
    #[error(transparent)]
    Table(#[from] TableError),
    #[error(transparent)]
    Ratings(#[from] OpinionError),
}

/// Reads a table. The columns `rater` and `group` have names; without a column `rater`, the first
/// column has the names of the raters where it is not all numbers, and otherwise raters are
/// numbered from 1. All other columns are questions. A rating may be missing.
pub(super) fn parse(bytes: &[u8]) -> Result<Ratings, RatingsError> {
    let table = Table::with_names(bytes)?;
    let groups = table.column("group");
    let is_text = |row: usize| table.number(row, 0).is_err();
    let first_is_text = groups != Some(0) && (0..table.len()).any(is_text);
    let names = table.column("rater").or(first_is_text.then_some(0));
    let columns = 0..table.names().len();
    let questions: Vec<usize> = columns
        .filter(|place| Some(*place) != names && Some(*place) != groups)
        .collect();
    let raters = (0..table.len()).map(|row| {
        let text = |column: usize| table.text(row, column).to_owned();
        let ratings = questions.iter().map(|column| table.number(row, *column));
        Ok::<Rater, TableError>(Rater {
            name: names.map_or_else(|| (row + 1).to_string(), text),
            group: groups.map(text).filter(|group| !group.is_empty()),
            ratings: ratings.collect::<Result<_, _>>()?,
        })
    });
    let raters = raters.collect::<Result<_, _>>()?;
    let questions = questions.iter().map(|place| table.names()[*place].clone());
    Ok(Ratings::new(questions.collect(), raters)?)
}
