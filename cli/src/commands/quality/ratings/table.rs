//! Ratings as CSV: a row for each rater, a column for each question.

use csv::{ReaderBuilder, Trim};
use ga_video::opinion::OpinionError;
use ga_video::opinion::ratings::{Rater, Ratings};

/// What is wrong with a table.
#[derive(Debug, thiserror::Error)]
pub(super) enum TableError {
    #[error("{0}")]
    Csv(#[from] csv::Error),
    #[error("line {line}, column {column}: {text:?} is not a finite number")]
    Number {
        line: u64,
        column: String,
        text: String,
    },
    #[error("{0}")]
    Ratings(#[from] OpinionError),
}

/// Where the columns of the table are.
struct Layout {
    names: Option<usize>,
    groups: Option<usize>,
    questions: Vec<usize>,
}

/// Reads a table. The columns `rater` and `group` have names; without a column `rater`, the first
/// column has the names of the raters where it is not all numbers, and otherwise raters are
/// numbered from 1. All other columns are questions. A field without text is a missing rating.
pub(super) fn parse(bytes: &[u8]) -> Result<Ratings, TableError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
    let headers: Vec<String> = reader.headers()?.iter().map(str::to_owned).collect();
    let records: Vec<_> = reader.records().collect::<Result<_, _>>()?;
    let column = |name: &str| headers.iter().position(|h| h.eq_ignore_ascii_case(name));
    let groups = column("group");
    let first_is_text = groups != Some(0)
        && records
            .iter()
            .any(|record| record[0].parse::<f64>().is_err() && !record[0].is_empty());
    let names = column("rater").or(first_is_text.then_some(0));
    let layout = Layout {
        names,
        groups,
        questions: (0..headers.len())
            .filter(|place| Some(*place) != names && Some(*place) != groups)
            .collect(),
    };
    let raters = records
        .iter()
        .enumerate()
        .map(|(row, record)| rater(record, row, &layout, &headers))
        .collect::<Result<_, _>>()?;
    let questions = layout.questions.iter().map(|q| headers[*q].clone());
    Ok(Ratings::new(questions.collect(), raters)?)
}

fn rater(
    record: &csv::StringRecord,
    row: usize,
    layout: &Layout,
    headers: &[String],
) -> Result<Rater, TableError> {
    let rating = |column: &usize| {
        let text = &record[*column];
        if text.is_empty() {
            return Ok(None);
        }
        let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
        number.map(Some).ok_or_else(|| TableError::Number {
            line: record.position().map_or(1, csv::Position::line),
            column: headers[*column].clone(),
            text: text.to_owned(),
        })
    };
    let group = layout.groups.map(|column| record[column].to_owned());
    Ok(Rater {
        name: layout
            .names
            .map_or_else(|| (row + 1).to_string(), |name| record[name].to_owned()),
        group: group.filter(|group| !group.is_empty()),
        ratings: layout
            .questions
            .iter()
            .map(rating)
            .collect::<Result<_, _>>()?,
    })
}
