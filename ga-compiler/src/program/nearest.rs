//! Known names that were probably meant.

/// A known name that differs by a letter or two, as a question.
pub(crate) fn nearest(name: &str, known: impl Iterator<Item = String>) -> String {
    let near = known
        .map(|other| (distance(name, &other), other))
        .filter(|(distance, other)| {
            let shorter = other.len().min(name.len());
            *distance < shorter && *distance <= 1 + shorter / 4
        })
        .min();
    near.map_or_else(String::new, |(_, other)| {
        format!("; did you mean `{other}`?")
    })
}

/// The number of letters to change, add or drop (Levenshtein 1966).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, other) in b.iter().enumerate() {
            let change = diagonal + usize::from(letter != *other);
            diagonal = row[j + 1];
            row[j + 1] = change.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
