//! The words of a command, as a shell reads them.

use std::ffi::OsStr;

use crate::shell::quoted;

/// A command as one line. Words of file names that a shell would read otherwise are in quotes; the
/// first word may be several, and is taken as it is.
pub(crate) fn command_line<'a>(words: impl IntoIterator<Item = &'a OsStr>) -> String {
    let words = words.into_iter().enumerate();
    let words = words.map(|(place, word)| match place {
        0 => word.to_string_lossy().into_owned(),
        _ => quoted(word),
    });
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::command_line;

    #[test]
    fn names_with_spaces_are_in_quotes() {
        let words = ["nullcone mesh info", "a/b-1.obj", "my mesh.obj", "it's"];
        assert_eq!(
            command_line(words.map(AsRef::as_ref)),
            r"nullcone mesh info a/b-1.obj 'my mesh.obj' 'it'\''s'"
        );
    }
}
