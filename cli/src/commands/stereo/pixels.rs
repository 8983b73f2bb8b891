//! Sizes of pictures, as arguments and in the files of cameras.

use std::path::Path;

use anyhow::{Result, ensure};

/// A size such as `800x600`.
pub(super) fn size(text: &str) -> Result<[usize; 2], String> {
    let parse = |word: &str| word.parse::<u16>().ok().filter(|count| *count > 1);
    let parts = text.split_once(['x', '×']);
    match parts.map(|(width, height)| (parse(width), parse(height))) {
        Some((Some(width), Some(height))) => Ok([width.into(), height.into()]),
        _ => Err("a size is two numbers from 2 to 65535 such as 800x600".to_owned()),
    }
}

/// Fails where a picture does not have the size that a file of cameras is for.
pub(in crate::commands) fn check(
    expected: Option<[usize; 2]>,
    found: [usize; 2],
    picture: &Path,
    cameras: &Path,
) -> Result<()> {
    let Some(expected) = expected else {
        return Ok(());
    };
    ensure!(
        found == expected,
        "{} has {} × {} pixels, and {} is for {} × {}",
        picture.display(),
        found[0],
        found[1],
        cameras.display(),
        expected[0],
        expected[1]
    );
    Ok(())
}
