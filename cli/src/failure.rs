//! Errors as they are printed.

use anyhow::Error;
use ga_compiler::source::SourceError;

/// The text of an error, which starts with `error: `. Errors in source text show the lines that
/// they are in; any other error is one line.
pub(crate) fn text(error: &Error) -> String {
    match error.downcast_ref::<SourceError>() {
        Some(SourceError::Faulty(faults)) => faults.to_string(),
        _ => format!("error: {}", one_line(error)),
    }
}

/// The error and its causes, outermost first, in one line. A cause is left out where the message
/// before it ends with it.
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
    fn a_cause_is_not_repeated() {
        let cause = std::io::Error::other("the disk is full");
        let error = Error::new(cause).context("cannot write a: the disk is full");
        assert_eq!(
            one_line(&error.context("no model")),
            "no model: cannot write a: the disk is full"
        );
    }
}
