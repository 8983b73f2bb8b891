//! Rows of a text.

use super::error::TableError;
use super::separator::{is_empty, is_marked};

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Row {
    pub(super) line: usize,
    pub(super) cells: Vec<String>,
    /// Whether it begins as a comment does.
    pub(super) is_marked: bool,
}

impl Row {
    /// Whether it is a comment in a table whose rows have this number of cells. A row such as
    /// `#1,0.5` is none.
    pub(super) fn is_comment(&self, width: usize) -> bool {
        self.is_marked && (self.cells.len() < 2 || self.cells.len() != width)
    }
}

/// Takes rows from the beginning of a text.
pub(super) struct Scanner<'a> {
    pub(super) rest: &'a str,
    pub(super) line: usize,
    pub(super) separator: char,
}

impl Scanner<'_> {
    /// The next row that is not empty.
    pub(super) fn row(&mut self) -> Result<Option<Row>, TableError> {
        loop {
            let (line, _) = self.rest.split_once('\n').unwrap_or((self.rest, ""));
            if self.rest.is_empty() {
                return Ok(None);
            }
            if !is_empty(line) {
                break;
            }
            self.skip(line.len() + 1);
        }
        let is_marked = is_marked(self.rest);
        let (line, mut cells) = (self.line, Vec::new());
        loop {
            let (cell, is_last) = self.cell(cells.len() + 1)?;
            cells.push(cell);
            if is_last {
                return Ok(Some(Row {
                    line,
                    cells,
                    is_marked,
                }));
            }
        }
    }

    /// The next cell, and whether the row ends behind it.
    fn cell(&mut self, column: usize) -> Result<(String, bool), TableError> {
        let ends = [self.separator, '\n'];
        let start = self.rest.len() - self.rest.trim_start_matches([' ', '\r']).len();
        let mut text = String::new();
        if self.rest[start..].starts_with('"') {
            let line = self.line;
            self.skip(start + 1);
            loop {
                let Some(end) = self.rest.find('"') else {
                    return Err(TableError::Quotation { line, column });
                };
                text += &self.rest[..end];
                self.skip(end + 1);
                if !self.rest.starts_with('"') {
                    break;
                }
                text.push('"');
                self.skip(1);
            }
        }
        let end = self.rest.find(ends).unwrap_or(self.rest.len());
        text += self.rest[..end].trim_matches([' ', '\t', '\r']);
        let is_last = !self.rest[end..].starts_with(self.separator);
        self.skip(end + 1);
        Ok((text, is_last))
    }

    /// Goes on by a number of bytes, or to the end.
    fn skip(&mut self, bytes: usize) {
        let (done, rest) = self.rest.split_at_checked(bytes).unwrap_or((self.rest, ""));
        self.line += done.matches('\n').count();
        self.rest = rest;
    }
}
