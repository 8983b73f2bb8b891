//! Errors in a text, printed with the lines that they are in.

use std::fmt;
use std::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::SimpleFile;
use codespan_reporting::term::{Chars, Config, emit_into_string};
use proc_macro2::Span;

/// Why a text gives no algebra or no functions.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SourceError {
    /// Something is wrong in the text.
    #[error(transparent)]
    Faulty(#[from] Faults),
    /// The text declares several algebras, and none of them has the name that is asked for.
    #[error("{name} declares several algebras")]
    SeveralAlgebras {
        /// The name of the text.
        name: String,
    },
}

/// Everything that is wrong in a text. Shown as text it has several lines, which begin with
/// `error: ` and have the lines at fault in them.
#[derive(Debug)]
pub struct Faults {
    name: String,
    text: String,
    faults: Vec<Fault>,
}

/// Something that is wrong in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What is wrong.
    pub message: String,
    /// The bytes at fault; none where it is the text as a whole.
    pub place: Option<Range<usize>>,
}

impl Faults {
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

    /// What is wrong, in the order of the text's items.
    #[must_use]
    pub fn list(&self) -> &[Fault] {
        &self.faults
    }
}

fn place(span: Span, text: &str) -> Option<Range<usize>> {
    // A span without text stands for the whole.
    span.source_text()?;
    let place = span.byte_range();
    text.get(place.clone()).map(|_| place)
}

impl fmt::Display for Faults {
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

impl std::error::Error for Faults {}
