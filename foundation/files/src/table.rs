//! Tables of text: rows of cells, as spreadsheets and statistics programs write them.
//!
//! Cells are separated by commas, tabs or semicolons; after semicolons numbers may have a decimal
//! comma. The first row says which: a tab there is the separator, otherwise a semicolon, otherwise
//! the comma. Lines that begin with `#` are comments unless they have as many cells as the first
//! row, two at least; empty lines do not count. A cell in
//! quotation marks may hold separators, line ends and, doubled, quotation marks. A cell that is
//! empty, `NA` or `NaN`, in small or capital letters, is missing. A byte order mark and `\r\n` are
//! allowed.
//!
//! ```
//! use ga_files::table::{Table, TableError};
//!
//! let table = Table::with_names(b"objective;subjective\n1,5;3\n2;NA\n")?;
//! assert_eq!(table.number(0, 0)?, Some(1.5));
//! assert_eq!(table.number(1, 1)?, None);
//! # Ok::<(), TableError>(())
//! ```

use std::fmt::Write;

/// What is wrong with a table. Lines and columns count from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TableError {
    /// The bytes are not UTF-8.
    #[error("line {line}: the text is not UTF-8")]
    Encoding {
        /// The line.
        line: usize,
    },
    /// A cell begins with a quotation mark and does not end with one.
    #[error("line {line}, column {column}: a quotation mark is not closed")]
    Quotation {
        /// The line where the cell begins.
        line: usize,
        /// The column.
        column: usize,
    },
    /// A row has another number of cells than the names.
    #[error("line {line} has {found} cells, and the first line names {expected} columns")]
    Cells {
        /// The line.
        line: usize,
        /// The line of the names.
        first: usize,
        /// How many cells it has.
        found: usize,
        /// How many columns have names.
        expected: usize,
    },
    /// A row of a [rectangular](Table::rectangular) table has another number of columns than the
    /// first line.
    #[error("line {line}: {found} columns, but line {first} has {expected}")]
    Columns {
        /// The line.
        line: usize,
        /// The first line.
        first: usize,
        /// How many columns it has.
        found: usize,
        /// How many columns the first line has.
        expected: usize,
    },
    /// The table has no rows, so that no line names its columns.
    #[error("the table is empty")]
    Empty,
    /// A column is not there.
    #[error("there is no column {wanted}; the first line names {names}")]
    Column {
        /// The name that was looked for.
        wanted: String,
        /// The names that are there.
        names: String,
    },
    /// A cell is not a finite number.
    #[error("line {line}, column {column}: {text:?} is not a finite number")]
    Number {
        /// The line.
        line: usize,
        /// The name of the column, or its number where it has none.
        column: String,
        /// What the cell says.
        text: String,
    },
}

/// What stands between cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// `,`
    Comma,
    /// `;`, with decimal commas in numbers.
    Semicolon,
    /// A tab.
    Tab,
}

impl Separator {
    /// The character.
    #[must_use]
    pub fn character(self) -> char {
        match self {
            Self::Comma => ',',
            Self::Semicolon => ';',
            Self::Tab => '\t',
        }
    }

    /// The one that the first row of a text has outside of quotation marks.
    fn of(text: &str) -> Self {
        let mut row = text;
        while let Some((line, rest)) = row.split_once('\n')
            && !begins_row(line)
        {
            row = rest;
        }
        let (mut is_quoted, mut found) = (false, Self::Comma);
        for character in row.chars() {
            match character {
                '"' => is_quoted = !is_quoted,
                _ if is_quoted => {}
                '\n' => break,
                '\t' => return Self::Tab,
                ';' => found = Self::Semicolon,
                _ => {}
            }
        }
        found
    }
}

/// Whether a line is neither empty nor begins as a comment does.
fn begins_row(line: &str) -> bool {
    !is_empty(line) && !is_marked(line)
}

fn is_empty(line: &str) -> bool {
    line.trim_matches(['\r', ' ']).is_empty()
}

/// Whether a line begins as a comment does.
fn is_marked(line: &str) -> bool {
    line.trim_start_matches(' ').starts_with('#')
}

/// Rows of cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    names: Vec<String>,
    /// The line of the names; 0 where there are none.
    names_line: usize,
    rows: Vec<Row>,
    separator: Separator,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Row {
    line: usize,
    cells: Vec<String>,
    /// Whether it begins as a comment does.
    is_marked: bool,
}

impl Row {
    /// Whether it is a comment in a table whose rows have this number of cells. A row such as
    /// `#1,0.5` is none.
    fn is_comment(&self, width: usize) -> bool {
        self.is_marked && (self.cells.len() < 2 || self.cells.len() != width)
    }
}

impl Table {
    /// A table whose first row names its columns. All rows have as many cells as there are names.
    ///
    /// # Errors
    /// The bytes are no such table.
    pub fn with_names(bytes: &[u8]) -> Result<Self, TableError> {
        Self::without_names(bytes)?.named()?.checked()
    }

    /// A table whose first row names its columns where none of its cells is a number, also one that
    /// is not finite, and the first cell does not begin with a digit. Without names, rows may have
    /// different numbers of cells; those that a row lacks are missing.
    ///
    /// # Errors
    /// The bytes are no such table.
    pub fn parse(bytes: &[u8]) -> Result<Self, TableError> {
        let table = Self::perhaps_named(bytes)?;
        match table.names.is_empty() {
            true => Ok(table),
            false => table.checked(),
        }
    }

    /// A table as of [`parse`](Self::parse) whose rows all have as many cells as the first line, be
    /// it one of names or not.
    ///
    /// # Errors
    /// [`TableError::Columns`], and where the bytes are no such table.
    ///
    /// ```
    /// use ga_files::table::Table;
    ///
    /// let message = |bytes| Table::rectangular(bytes).err().map(|error| error.to_string());
    /// assert_eq!(message(b"0,1\n2,3\n"), None);
    /// let ragged = message(b"0,1\n\n2,3,4\n").ok_or("no error")?;
    /// assert_eq!(ragged, "line 3: 3 columns, but line 1 has 2");
    /// # Ok::<(), &str>(())
    /// ```
    pub fn rectangular(bytes: &[u8]) -> Result<Self, TableError> {
        let table = Self::perhaps_named(bytes)?;
        let (first, expected) = table.first_line();
        match table.row_unlike(expected) {
            None => Ok(table),
            Some(Row { line, cells, .. }) => Err(TableError::Columns {
                line: *line,
                first,
                found: cells.len(),
                expected,
            }),
        }
    }

    /// A table with names where its first row seems to be one of names.
    fn perhaps_named(bytes: &[u8]) -> Result<Self, TableError> {
        let table = Self::without_names(bytes)?;
        let Some(first) = table.rows.first() else {
            return Ok(table);
        };
        let is_number = |cell: &String| {
            cell.parse::<f64>().is_ok() || matches!(number(cell, table.separator), Ok(Some(_)))
        };
        let mut letters = first.cells.first().map_or("", String::as_str).chars();
        let begins_as_number = letters.next().is_some_and(|letter| letter.is_ascii_digit());
        match begins_as_number || first.cells.iter().any(is_number) {
            true => Ok(table),
            false => table.named(),
        }
    }

    /// The same with the first row as names.
    fn named(mut self) -> Result<Self, TableError> {
        if self.rows.is_empty() {
            return Err(TableError::Empty);
        }
        let first = self.rows.remove(0);
        (self.names, self.names_line) = (first.cells, first.line);
        Ok(self)
    }

    /// The same, unless a row has another number of cells than there are names.
    fn checked(self) -> Result<Self, TableError> {
        let (first, expected) = self.first_line();
        match self.row_unlike(expected) {
            None => Ok(self),
            Some(Row { line, cells, .. }) => Err(TableError::Cells {
                line: *line,
                first,
                found: cells.len(),
                expected,
            }),
        }
    }

    /// The first row that has another number of cells.
    fn row_unlike(&self, width: usize) -> Option<&Row> {
        self.rows.iter().find(|row| row.cells.len() != width)
    }

    /// The line of the names, or of the first row where there are none, from 1, and how many cells
    /// it has; zeros for an empty table.
    #[must_use]
    pub fn first_line(&self) -> (usize, usize) {
        match self.names.len() {
            0 => (self.line(0), self.width(0)),
            width => (self.names_line, width),
        }
    }

    fn without_names(bytes: &[u8]) -> Result<Self, TableError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let text = std::str::from_utf8(bytes).map_err(|error| TableError::Encoding {
            line: 1 + bytes[..error.valid_up_to()]
                .iter()
                .filter(|byte| **byte == b'\n')
                .count(),
        })?;
        let separator = Separator::of(text);
        let mut scanner = Scanner {
            rest: text,
            line: 1,
            separator: separator.character(),
        };
        let mut rows = Vec::new();
        while let Some(row) = scanner.row()? {
            rows.push(row);
        }
        let first = rows.iter().find(|row: &&Row| !row.is_marked);
        let width = first.map_or(0, |row| row.cells.len());
        rows.retain(|row| !row.is_comment(width));
        Ok(Self {
            names: Vec::new(),
            names_line: 0,
            rows,
            separator,
        })
    }

    /// The names of the columns; none where the table has no line of names.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The number of cells of a row; 0 for a row that is not there.
    #[must_use]
    pub fn width(&self, row: usize) -> usize {
        self.rows.get(row).map_or(0, |row| row.cells.len())
    }

    /// The number of rows under the names.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is no row under the names.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The line in which a row begins, from 1; 0 for a row that is not there.
    #[must_use]
    pub fn line(&self, row: usize) -> usize {
        self.rows.get(row).map_or(0, |row| row.line)
    }

    /// The place of the column of a name, in small or capital letters, from 0.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<usize> {
        let mut names = self.names.iter();
        names.position(|other| other.eq_ignore_ascii_case(name))
    }

    /// What a cell says, also where that means that it is missing; nothing where there is no cell.
    #[must_use]
    pub fn text(&self, row: usize, column: usize) -> &str {
        let cell = self.rows.get(row).and_then(|row| row.cells.get(column));
        cell.map_or("", String::as_str)
    }

    /// The number in a cell; `None` where it is missing.
    ///
    /// # Errors
    /// The cell says something else than a finite number.
    pub fn number(&self, row: usize, column: usize) -> Result<Option<f64>, TableError> {
        let text = self.text(row, column);
        number(text, self.separator).map_err(|NotANumber| self.not_a_number(row, column))
    }

    /// The numbers of a column of this name.
    ///
    /// # Errors
    /// There is no such column, or a number is missing or not finite.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, TableError> {
        let column = self.column(name).ok_or_else(|| TableError::Column {
            wanted: name.to_owned(),
            names: self.names.join(", "),
        })?;
        let numbers = (0..self.len()).map(|row| {
            let number = self.number(row, column)?;
            number.ok_or_else(|| self.not_a_number(row, column))
        });
        numbers.collect()
    }

    /// The error for a cell that should have been a number.
    #[must_use]
    pub fn not_a_number(&self, row: usize, column: usize) -> TableError {
        let name = self.names.get(column).cloned();
        TableError::Number {
            line: self.line(row),
            column: name.unwrap_or_else(|| (column + 1).to_string()),
            text: self.text(row, column).to_owned(),
        }
    }
}

struct NotANumber;

fn is_missing(cell: &str) -> bool {
    ["", "na", "nan"]
        .iter()
        .any(|word| cell.eq_ignore_ascii_case(word))
}

fn number(cell: &str, separator: Separator) -> Result<Option<f64>, NotANumber> {
    let cell = cell.trim();
    if is_missing(cell) {
        return Ok(None);
    }
    let parsed = match separator {
        Separator::Semicolon => cell.replacen(',', ".", 1).parse::<f64>(),
        Separator::Comma | Separator::Tab => cell.parse(),
    };
    let finite = parsed.ok().filter(|number| number.is_finite());
    finite.map(Some).ok_or(NotANumber)
}

/// Takes rows from the beginning of a text.
struct Scanner<'a> {
    rest: &'a str,
    line: usize,
    separator: char,
}

impl Scanner<'_> {
    /// The next row that is not empty.
    fn row(&mut self) -> Result<Option<Row>, TableError> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(table: &Table) -> Vec<Vec<&str>> {
        let row = |row: usize| (0..table.names().len()).map(move |column| table.text(row, column));
        (0..table.len()).map(|index| row(index).collect()).collect()
    }

    #[test]
    fn what_programs_write_is_read() -> Result<(), TableError> {
        let bytes = b"\xef\xbb\xbf# made by hand\r\nname, \"a \"\"b\"\"\" ,c\r\n\r\n\"x,\ny\",na,1e3\r\nz,,NaN\r\n";
        let table = Table::with_names(bytes)?;
        assert_eq!(table.names(), ["name", "a \"b\"", "c"]);
        assert_eq!(cells(&table), [["x,\ny", "na", "1e3"], ["z", "", "NaN"]]);
        assert_eq!([table.line(0), table.line(1)], [4, 6]);
        assert_eq!(table.number(0, 2)?, Some(1000.0));
        assert_eq!(
            [(0, 1), (1, 1), (1, 2)].map(|(row, column)| table.number(row, column)),
            [Ok(None), Ok(None), Ok(None)]
        );
        Ok(())
    }

    #[test]
    fn names_are_optional_where_they_are_not_asked_for() -> Result<(), TableError> {
        let plain = Table::parse(b"10\n20, cut\n")?;
        assert_eq!((plain.names().len(), plain.len()), (0, 2));
        assert_eq!(plain.number(1, 0)?, Some(20.0));
        assert_eq!(plain.text(0, 1), "");
        for first in ["nan,nan", "120O,340", "1;5"] {
            let table = Table::parse(format!("{first}\n0,1\n").as_bytes())?;
            assert_eq!((table.names().len(), table.len()), (0, 2), "{first}");
        }
        // A row with a number is not one of names, whatever else it says.
        let kinds = Table::parse(b"10,cut\n20,dissolve\n")?;
        assert_eq!((kinds.names().len(), kinds.len()), (0, 2));
        assert_eq!(kinds.text(0, 1), "cut");
        let named = Table::parse(b"cut\n10\n")?;
        assert_eq!((named.column("CUT"), named.len()), (Some(0), 1));
        Ok(())
    }

    #[test]
    fn a_row_that_begins_as_a_comment_does_is_not_lost() -> Result<(), TableError> {
        let text = b"# by hand\n#,a,b\n# two, cells\n#1,3,4\nx,5,6\n#end\n";
        let table = Table::with_names(text)?;
        assert_eq!(table.names(), ["#", "a", "b"]);
        assert_eq!(cells(&table), [["#1", "3", "4"], ["x", "5", "6"]]);
        Ok(())
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        let message = |bytes: &[u8]| {
            let found = Table::with_names(bytes).and_then(|table| table.numbers("b"));
            found.err().map(|error| error.to_string())
        };
        for (bytes, expected) in [
            (
                &b"a,b\n1,2\n3\n"[..],
                "line 3 has 1 cells, and the first line names 2 columns",
            ),
            (b"a\n1\n", "there is no column b; the first line names a"),
            (b"", "the table is empty"),
            (b"# only\n", "the table is empty"),
            (
                b"a,b\n1,inf\n",
                "line 2, column b: \"inf\" is not a finite number",
            ),
            (
                b"a,b\n1,\n",
                "line 2, column b: \"\" is not a finite number",
            ),
            (
                b"a\tb\n1\t1,5\n",
                "line 2, column b: \"1,5\" is not a finite number",
            ),
            (
                b"a;b\n1;1,5,0\n",
                "line 2, column b: \"1,5,0\" is not a finite number",
            ),
            (
                b"a,b\n1,\"2\n",
                "line 2, column 2: a quotation mark is not closed",
            ),
            (b"a,b\n1,\xff\n", "line 2: the text is not UTF-8"),
        ] {
            assert_eq!(message(bytes).as_deref(), Some(expected));
        }
    }
}
