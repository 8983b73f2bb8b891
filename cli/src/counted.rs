//! Numbers of things in sentences.

/// A number with what is counted, in the plural unless there is one: `1 frame`, `2 frames`.
pub(crate) fn counted(count: usize, of: &str) -> String {
    match count {
        1 => format!("1 {of}"),
        count => format!("{count} {of}s"),
    }
}
