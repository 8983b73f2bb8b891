//! Cells as they are written.

use std::fmt::Write;

use super::separator::Separator;

/// A cell that is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A text, in quotation marks where it needs them.
    Text(String),
    /// A number in as many digits as say it exactly.
    Number(f64),
    /// Nothing.
    Missing,
}

impl From<Option<f64>> for Cell {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Missing, Self::Number)
    }
}

/// A row as a line of text with its end.
#[must_use]
pub fn row(cells: impl IntoIterator<Item = Cell>, separator: Separator) -> String {
    let mut line = String::new();
    for (index, cell) in cells.into_iter().enumerate() {
        if index > 0 {
            line.push(separator.character());
        }
        match cell {
            Cell::Missing => {}
            Cell::Text(text) if needs_quotation_marks(&text) => {
                // Writing to a string does not fail.
                let _ = write!(line, "\"{}\"", text.replace('"', "\"\""));
            }
            Cell::Text(text) => line += &text,
            Cell::Number(number) => {
                let number = number.to_string();
                line += &match separator {
                    Separator::Semicolon => number.replace('.', ","),
                    Separator::Comma | Separator::Tab => number,
                };
            }
        }
    }
    // An empty line would be no row.
    if line.is_empty() {
        line += "NA";
    }
    line.push('\n');
    line
}

impl Cell {
    /// A number in as many digits as say it exactly, with an exponent where it is very large or
    /// very small.
    #[must_use]
    pub fn exact(number: f64) -> Self {
        Self::Text(format!("{number:?}"))
    }
}

/// Whether a text would be read as something else without quotation marks.
fn needs_quotation_marks(text: &str) -> bool {
    text.contains([',', ';', '\t', '"', '\n', '\r'])
        || text.starts_with(['#', ' '])
        || text.ends_with(' ')
}
