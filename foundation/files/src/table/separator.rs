//! What stands between cells, and the lines that are no rows.

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
    pub(super) fn of(text: &str) -> Self {
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

pub(super) fn is_empty(line: &str) -> bool {
    line.trim_matches(['\r', ' ']).is_empty()
}

/// Whether a line begins as a comment does.
pub(super) fn is_marked(line: &str) -> bool {
    line.trim_start_matches(' ').starts_with('#')
}
