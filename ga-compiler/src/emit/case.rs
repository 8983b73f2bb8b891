//! Names in another case.

/// `move_point` as `MovePoint`.
pub(super) fn pascal_case(name: &str) -> String {
    let mut text = String::new();
    for part in name.split('_') {
        let mut letters = part.chars();
        text.extend(letters.next().into_iter().flat_map(char::to_uppercase));
        text.extend(letters);
    }
    text
}

/// `RoundVector` as `round_vector`.
pub(super) fn snake_case(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() {
            if !text.is_empty() {
                text.push('_');
            }
            text.extend(letter.to_lowercase());
        } else {
            text.push(letter);
        }
    }
    text
}
