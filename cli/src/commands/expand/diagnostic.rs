//! Errors that show where in a text they are.

use std::fmt;

use proc_macro2::Span;

/// Errors in a text.
#[derive(Debug)]
pub(crate) struct SourceError {
    faults: Vec<Fault>,
}

/// One error.
#[derive(Debug)]
struct Fault {
    message: String,
    /// None for an error of the text as a whole.
    place: Option<Place>,
    source: String,
}

#[derive(Debug)]
struct Place {
    /// From 1.
    line: usize,
    /// From 1, in characters.
    column: usize,
    /// How many characters are marked.
    width: usize,
    text: String,
}

impl SourceError {
    /// Finds the places of errors in the text that they are in.
    pub(super) fn new(source: &str, text: &str, error: &syn::Error) -> Self {
        let faults = error
            .into_iter()
            .map(|error| Fault {
                message: error.to_string(),
                place: place(error.span(), text),
                source: source.to_owned(),
            })
            .collect();
        Self { faults }
    }
}

fn place(span: Span, text: &str) -> Option<Place> {
    // A span without text is that of the whole.
    span.source_text()?;
    let (start, end) = (span.start(), span.end());
    let line = text.lines().nth(start.line.checked_sub(1)?)?;
    let length = line.chars().count();
    if start.column > length {
        return None;
    }
    let end = if end.line == start.line {
        end.column.min(length)
    } else {
        length
    };
    Some(Place {
        line: start.line,
        column: start.column + 1,
        width: end.saturating_sub(start.column).max(1),
        text: line.replace('\t', " "),
    })
}

impl fmt::Display for SourceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, fault) in self.faults.iter().enumerate() {
            if number > 0 {
                f.write_str("\nerror: ")?;
            }
            write!(f, "{fault}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        let source = &self.source;
        let Some(place) = &self.place else {
            return write!(f, "\n --> {source}");
        };
        let Place {
            line,
            column,
            width,
            text,
        } = place;
        let margin = " ".repeat(line.to_string().len());
        let marks = "^".repeat(*width);
        let indent = " ".repeat(column - 1);
        write!(
            f,
            "\n{margin}--> {source}:{line}:{column}\n{margin} |\n{line} | {text}\n{margin} | {indent}{marks}"
        )
    }
}

impl std::error::Error for SourceError {}
