//! Sizes of pictures as arguments.

/// A size such as `800x600`.
pub(super) fn size(text: &str) -> Result<[usize; 2], String> {
    let parse = |word: &str| word.parse::<u16>().ok().filter(|count| *count > 1);
    let parts = text.split_once(['x', '×']);
    match parts.map(|(width, height)| (parse(width), parse(height))) {
        Some((Some(width), Some(height))) => Ok([width.into(), height.into()]),
        _ => Err("a size is two numbers from 2 to 65535 such as 800x600".to_owned()),
    }
}
