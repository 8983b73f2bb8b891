//! Ratings as a table: a row for each rater and a column for each stimulus, or the other way round.

use ga_files::table::{Table, TableError};
use serde::Serialize;

use super::super::OpinionError;
use super::{Rater, Ratings};

/// What the rows of a table of ratings are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Rows {
    /// A row has the ratings of a person.
    Raters,
    /// A row has the ratings of a stimulus, such as a clip, and a column those of a person.
    Stimuli,
}

/// Names of a first column that say so, also in the plural and with `id`, `name`, `no` or `number`
/// behind.
const RATERS: [&str; 12] = [
    "rater",
    "observer",
    "subject",
    "participant",
    "person",
    "viewer",
    "assessor",
    "evaluator",
    "judge",
    "respondent",
    "user",
    "worker",
];
const STIMULI: [&str; 14] = [
    "stimulus", "stimuli", "clip", "video", "film", "image", "picture", "sequence", "pvs", "src",
    "file", "question", "item", "content",
];

impl Rows {
    /// What the name of the first column says, or of the second where the first is `group`.
    ///
    /// # Errors
    ///
    /// [`OpinionError::Orientation`] where it says nothing.
    pub fn of(table: &Table) -> Result<Self, OpinionError> {
        let mut names = table.names().iter();
        let first = names.find(|name| !name.eq_ignore_ascii_case(GROUP));
        let name = first.map_or("", String::as_str);
        match (is_one_of(name, &RATERS), is_one_of(name, &STIMULI)) {
            (true, _) => Ok(Self::Raters),
            (_, true) => Ok(Self::Stimuli),
            _ => Err(OpinionError::Orientation { name: name.into() }),
        }
    }
}

/// The column of the raters' groups.
const GROUP: &str = "group";

fn is_one_of(name: &str, words: &[&str]) -> bool {
    let letters = name.chars().filter(|letter| letter.is_alphanumeric());
    let letters: String = letters.flat_map(char::to_lowercase).collect();
    let endings = ["", "s", "id", "name", "no", "number"];
    let mut rests = words.iter().filter_map(|word| letters.strip_prefix(word));
    rests.any(|rest| endings.contains(&rest))
}

impl Ratings {
    /// The ratings of a table. A column whose name is that of [raters](Rows::of) where rows are
    /// raters, and of stimuli where they are stimuli, has the names of the rows; without one, the
    /// first column has them where it is not all numbers, and otherwise rows are numbered from 1.
    /// Where rows are raters, a column `group` has their groups. All other columns are ratings, of
    /// which some may be missing.
    ///
    /// ```
    /// use ga_files::table::Table;
    /// use ga_video::opinion::OpinionError;
    /// use ga_video::opinion::ratings::{Ratings, Rows};
    ///
    /// let table = Table::with_names(b"rater,group,clarity\nAda,expert,4\nBob,,5\n")?;
    /// let ratings = Ratings::of_table(&table, Rows::of(&table)?)?;
    /// assert_eq!(ratings.questions(), ["clarity"]);
    /// assert_eq!(ratings.groups(), ["expert"]);
    ///
    /// let table = Table::with_names(b"clip,Ada,Bob\nwalk,4,5\nrun,,3\n")?;
    /// let ratings = Ratings::of_table(&table, Rows::of(&table)?)?;
    /// assert_eq!(ratings.questions(), ["walk", "run"]);
    /// assert_eq!(ratings.raters()[0].ratings, [Some(4.0), None]);
    /// # Ok::<(), OpinionError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`OpinionError::Table`], those of [`new`](Self::new), and [`OpinionError::Groups`].
    pub fn of_table(table: &Table, rows: Rows) -> Result<Self, OpinionError> {
        let groups = table.column(GROUP);
        let words = match (rows, groups) {
            (Rows::Raters, _) => &RATERS[..],
            (Rows::Stimuli, None) => &STIMULI[..],
            (Rows::Stimuli, Some(_)) => return Err(OpinionError::Groups),
        };
        let is_text = |row: usize| table.number(row, 0).is_err();
        let first_is_text = groups != Some(0) && (0..table.len()).any(is_text);
        let mut columns = table.names().iter();
        let names = columns.position(|name| is_one_of(name, words));
        let names = names.or(first_is_text.then_some(0));
        let columns = 0..table.names().len();
        let columns: Vec<usize> = columns
            .filter(|place| Some(*place) != names && Some(*place) != groups)
            .collect();
        let text = |row: usize, column: usize| table.text(row, column).to_owned();
        let name = |row: usize| names.map_or_else(|| (row + 1).to_string(), |name| text(row, name));
        let heads = columns.iter().map(|place| table.names()[*place].clone());
        let rating = |row: usize, column: &usize| table.number(row, *column);
        match rows {
            Rows::Raters => {
                let raters = (0..table.len()).map(|row| {
                    let ratings = columns.iter().map(|column| rating(row, column));
                    Ok::<Rater, TableError>(Rater {
                        name: name(row),
                        group: groups
                            .map(|column| text(row, column))
                            .filter(|group| !group.is_empty()),
                        ratings: ratings.collect::<Result<_, _>>()?,
                    })
                });
                Self::new(heads.collect(), raters.collect::<Result<_, _>>()?)
            }
            Rows::Stimuli => {
                let raters = heads.zip(&columns).map(|(head, column)| {
                    let ratings = (0..table.len()).map(|row| rating(row, column));
                    Ok::<Rater, TableError>(Rater {
                        name: head,
                        group: None,
                        ratings: ratings.collect::<Result<_, _>>()?,
                    })
                });
                let questions = (0..table.len()).map(name).collect();
                Self::new(questions, raters.collect::<Result<_, _>>()?)
            }
        }
    }
}
