//! Ratings as a table: a row for each rater, a column for each question.

use ga_files::table::{Table, TableError};

use super::super::OpinionError;
use super::{Rater, Ratings};

impl Ratings {
    /// Reads a table. The columns `rater` and `group` have names; without a column `rater`, the
    /// first column has the names of the raters where it is not all numbers, and otherwise raters
    /// are numbered from 1. All other columns are questions. A rating may be missing.
    ///
    /// ```
    /// use ga_video::opinion::OpinionError;
    /// use ga_video::opinion::ratings::Ratings;
    ///
    /// let ratings = Ratings::from_table(b"rater,group,clarity\nAda,expert,4\nBob,,5\n")?;
    /// assert_eq!(ratings.questions(), ["clarity"]);
    /// assert_eq!(ratings.groups(), ["expert"]);
    /// # Ok::<(), OpinionError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`OpinionError::Table`], and those of [`new`](Self::new).
    pub fn from_table(bytes: &[u8]) -> Result<Self, OpinionError> {
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
        Self::new(questions.collect(), raters)
    }
}
