//! Tables of text: rows of cells, as spreadsheets and statistics programs write them.
//!
//! Cells are separated by commas, tabs or semicolons; after semicolons numbers may have a decimal
//! comma. The first row says which: a tab there is the separator, otherwise a semicolon, otherwise
//! the comma. Lines that begin with `#` are comments unless they have as many cells as the first
//! row, two at least; empty lines do not count. A cell in quotation marks may hold separators, line
//! ends and, doubled, quotation marks. A cell that is empty, `NA`, `N/A`, `#N/A`, `NaN` or `null`,
//! in small or capital letters, is missing. A byte order mark and `\r\n` are allowed.
//!
//! ```
//! use ga_files::table::{Table, TableError};
//!
//! let table = Table::with_names(b"objective;subjective\n1,5;3\n2;NA\n")?;
//! assert_eq!(table.number(0, 0)?, Some(1.5));
//! assert_eq!(table.number(1, 1)?, None);
//! # Ok::<(), TableError>(())
//! ```

mod cell;
mod error;
mod scanner;
mod separator;

use scanner::{Row, Scanner};

pub use cell::{Cell, row};
pub use error::TableError;
pub use separator::Separator;

/// Rows of cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    names: Vec<String>,
    /// The line of the names; 0 where there are none.
    names_line: usize,
    rows: Vec<Row>,
    separator: Separator,
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
    /// it one of names or not. Separators at the ends of rows, behind which no row has anything,
    /// do not count.
    ///
    /// # Errors
    /// [`TableError::Columns`], and where the bytes are no such table.
    ///
    /// ```
    /// use ga_files::table::Table;
    ///
    /// let message = |bytes| Table::rectangular(bytes).err().map(|error| error.to_string());
    /// assert_eq!(message(b"0,1\n2,3\n"), None);
    /// assert_eq!(message(b"0,1\n2,3,\n"), None);
    /// let ragged = message(b"0,1\n\n2,3,4\n").ok_or("no error")?;
    /// assert_eq!(ragged, "line 3: 3 columns, but line 1 has 2");
    /// # Ok::<(), &str>(())
    /// ```
    pub fn rectangular(bytes: &[u8]) -> Result<Self, TableError> {
        let mut table = Self::perhaps_named(bytes)?;
        table.drop_empty_ends();
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

    /// Takes away the last columns that have neither a name nor anything in any row.
    fn drop_empty_ends(&mut self) {
        let filled = |cells: &[String]| {
            let last = cells.iter().rposition(|cell| !cell.is_empty());
            last.map_or(1, |last| last + 1)
        };
        let rows = self.rows.iter().map(|row| filled(&row.cells));
        let width = rows.fold(filled(&self.names), usize::max);
        self.names.truncate(width);
        for row in &mut self.rows {
            row.cells.truncate(width);
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

    /// All rows, whatever their numbers of cells, of which none names the columns.
    ///
    /// # Errors
    /// [`TableError::Encoding`] and [`TableError::Quotation`].
    pub fn without_names(bytes: &[u8]) -> Result<Self, TableError> {
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
    ["", "na", "n/a", "#n/a", "nan", "null"]
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
        // A row of one cell is a comment in a table of one column as well.
        let table = Table::with_names(b"a\n# note\n1\n")?;
        assert_eq!(cells(&table), [["1"]]);
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
