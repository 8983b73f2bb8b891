//! What tells pictures of a view from each other: their numbers or their names.

use std::collections::BTreeSet;
use std::fmt;
use std::path::{Path, PathBuf};

/// The number or the name of a picture.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum FrameKey {
    /// A number.
    Number(i64),
    /// A name.
    Name(String),
}

impl fmt::Display for FrameKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "picture {number}"),
            Self::Name(name) => write!(f, "picture {name:?}"),
        }
    }
}

/// The keys of pictures with these names, which all differ: the last of the numbers in the names
/// that no two have in common, such as 12 in `walk_000000000012_keypoints.json` and `12.jpg`, where
/// there are several names and such numbers; otherwise the names.
pub(super) fn keys(names: &[&str]) -> Vec<FrameKey> {
    let found: Vec<Vec<Option<i64>>> = names.iter().map(|name| numbers(name)).collect();
    let places = found.iter().map(Vec::len).min().unwrap_or(0);
    let at = |place: usize| -> Option<Vec<i64>> {
        let numbers: Option<Vec<i64>> = found.iter().map(|numbers| numbers[place]).collect();
        let numbers = numbers?;
        let distinct: BTreeSet<i64> = numbers.iter().copied().collect();
        (distinct.len() == names.len()).then_some(numbers)
    };
    let numbers = (0..places).find_map(at).filter(|_| names.len() > 1);
    match numbers {
        Some(numbers) => numbers.into_iter().map(FrameKey::Number).collect(),
        None => {
            let names = names.iter().map(|&name| FrameKey::Name(name.to_owned()));
            names.collect()
        }
    }
}

/// The numbers in the name of a file without its ending, from the last; `None` for one that is too
/// large.
fn numbers(name: &str) -> Vec<Option<i64>> {
    let stem = ga_files::stem(Path::new(name));
    let digits = stem.rsplit(|character: char| !character.is_ascii_digit());
    let digits = digits.filter(|digits| !digits.is_empty());
    digits.map(|digits| digits.parse().ok()).collect()
}

/// Different keys in their order: numbers before names, in which numbers count as numbers.
pub(super) fn sorted<'a>(keys: impl Iterator<Item = &'a FrameKey>) -> Vec<FrameKey> {
    let mut numbers = BTreeSet::new();
    let mut names = BTreeSet::new();
    for key in keys {
        match key {
            FrameKey::Number(number) => {
                numbers.insert(*number);
            }
            FrameKey::Name(name) => {
                names.insert(name);
            }
        }
    }
    let mut paths: Vec<PathBuf> = names.into_iter().map(PathBuf::from).collect();
    ga_files::natural_order(&mut paths);
    // They were made of text.
    let names = paths.iter().map(|path| path.to_string_lossy().into_owned());
    let numbers = numbers.into_iter().map(FrameKey::Number);
    numbers.chain(names.map(FrameKey::Name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_number_that_differs_is_the_number_of_a_picture() {
        let numbers = |numbers: &[i64]| -> Vec<FrameKey> {
            numbers.iter().copied().map(FrameKey::Number).collect()
        };
        let openpose = ["a_000000000012_keypoints.json", "a_3_keypoints.json"];
        assert_eq!(keys(&openpose), numbers(&[12, 3]));
        // Numbers of cameras and of formats are not those of pictures.
        assert_eq!(keys(&["2_cam1.jp2", "10_cam1.jp2"]), numbers(&[2, 10]));
        assert_eq!(keys(&["a-5.png", "b-6.png"]), numbers(&[5, 6]));
        // One name, names without numbers, and numbers that are too large.
        for names in [
            &["a5.png"][..],
            &["a.png", "b.png"],
            &["1.png", "a.png"],
            &["1.png", "99999999999999999999.png"],
        ] {
            let wanted: Vec<FrameKey> = names
                .iter()
                .map(|&name| FrameKey::Name(name.to_owned()))
                .collect();
            assert_eq!(keys(names), wanted);
        }
    }

    #[test]
    fn names_are_in_natural_order_after_numbers() {
        let name = |name: &str| FrameKey::Name(name.to_owned());
        let found = [name("a10"), name("a9"), FrameKey::Number(7), name("a9")];
        let wanted = [FrameKey::Number(7), name("a9"), name("a10")];
        assert_eq!(sorted(found.iter()), wanted);
    }
}
