//! Known names that are probably meant by an unknown one.

/// A known name that differs from a name by few letters, as a question; empty if there is none.
pub(crate) fn nearest(name: &str, known: impl Iterator<Item = String>) -> String {
    let near = known
        .map(|other| (strsim::levenshtein(name, &other), other))
        .filter(|(distance, other)| {
            let shorter = other.len().min(name.len());
            *distance < shorter && *distance <= 1 + shorter / 4
        })
        .min();
    near.map_or_else(String::new, |(_, other)| {
        format!("; did you mean `{other}`?")
    })
}
