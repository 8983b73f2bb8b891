//! Commands as a shell reads them.

use std::path::{Path, is_separator};

/// A path, or another word of a command, as a shell reads it.
pub(crate) fn quoted(word: impl AsRef<Path>) -> String {
    let text = word.as_ref().to_string_lossy();
    let is_plain = |c: char| c.is_alphanumeric() || "._-/+:,@=%".contains(c) || is_separator(c);
    match !text.is_empty() && text.chars().all(is_plain) {
        true => text.into_owned(),
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}
