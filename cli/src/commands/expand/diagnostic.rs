//! Errors in a text, printed with the lines that they are in.

use std::fmt;
use std::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::SimpleFile;
use codespan_reporting::term::{Chars, Config, emit_into_string};
use proc_macro2::Span;

/// Errors in a text.
#[derive(Debug)]
pub(crate) struct SourceError {
    name: String,
    text: String,
    faults: Vec<Fault>,
}

/// One error.
#[derive(Debug)]
struct Fault {
    message: String,
    /// The bytes at fault; none for an error of the text as a whole.
    place: Option<Range<usize>>,
}

impl SourceError {
    /// Errors in the text of that name.
    pub(super) fn new(name: &str, text: &str, errors: &syn::Error) -> Self {
        let faults = errors.into_iter().map(|error| Fault {
            message: error.to_string(),
            place: place(error.span(), text),
        });
        Self {
            name: name.to_owned(),
            text: text.to_owned(),
            faults: faults.collect(),
        }
    }
}

fn place(span: Span, text: &str) -> Option<Range<usize>> {
    // A span without text stands for the whole.
    span.source_text()?;
    let place = span.byte_range();
    text.get(place.clone()).map(|_| place)
}

impl fmt::Display for SourceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = SimpleFile::new(&self.name, &self.text);
        let config = Config {
            chars: Chars::ascii(),
            ..Config::default()
        };
        for (number, fault) in self.faults.iter().enumerate() {
            let diagnostic = Diagnostic::error().with_message(&fault.message);
            let diagnostic = match &fault.place {
                Some(place) => diagnostic.with_label(Label::primary((), place.clone())),
                None => diagnostic.with_note(format!("in {}", self.name)),
            };
            let text = emit_into_string(&config, &file, &diagnostic).map_err(|_| fmt::Error)?;
            if number > 0 {
                f.write_str("\n\n")?;
            }
            f.write_str(text.trim_end())?;
        }
        Ok(())
    }
}

impl std::error::Error for SourceError {}
