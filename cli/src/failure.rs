//! Errors as a person reads them.

use anyhow::Error;

use crate::commands::expand::SourceError;

/// An error in source text with the line that it is in; any other in one line.
pub(crate) fn text(error: &Error) -> String {
    match error.downcast_ref::<SourceError>() {
        Some(error) => error.to_string(),
        None => one_line(error),
    }
}

/// What went wrong and why, outermost first, in one line. A cause that the message before it has
/// told already is left out.
fn one_line(error: &Error) -> String {
    let mut line = String::new();
    for cause in error.chain().map(ToString::to_string) {
        if line.is_empty() {
            line = cause;
        } else if !line.ends_with(&cause) {
            line.push_str(": ");
            line.push_str(&cause);
        }
    }
    line.replace(['\r', '\n'], " ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cause_told_already_is_not_repeated() {
        let cause = std::io::Error::other("the disk is full");
        let error = Error::new(cause).context("cannot write a: the disk is full");
        assert_eq!(
            one_line(&error.context("no model")),
            "no model: cannot write a: the disk is full"
        );
    }
}
