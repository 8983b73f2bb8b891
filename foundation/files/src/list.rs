//! Lists of files, as names and patterns, in the order of the numbers in their names.

use std::path::{Component, Path, PathBuf};

use glob::{GlobError, Pattern, PatternError};

/// Why a name or a pattern stands for no files.
#[derive(Debug, thiserror::Error)]
pub enum ListError {
    /// It is not a pattern, and no file has this name.
    #[error("{pattern:?}: {error}")]
    Pattern {
        /// The text.
        pattern: String,
        /// What is wrong with it.
        error: PatternError,
    },
    /// A folder cannot be read.
    #[error("{pattern:?}: {error}")]
    Folder {
        /// The pattern.
        pattern: String,
        /// What the operating system said.
        error: GlobError,
    },
    /// It matches no file.
    #[error("{0:?} matches no file")]
    NoMatch(String),
}

/// The files that names and patterns stand for, each once, in the order of their names, where
/// numbers count as numbers: 2 comes before 10.
///
/// A text is the name of a file, or a pattern where no file has that name. Folders with which it
/// begins are names, not patterns, where they exist.
///
/// # Errors
/// [`ListError`] for the first text that stands for none.
///
/// ```
/// let folder = tempfile::tempdir()?;
/// for name in ["view10.png", "view9.png", "other.png"] {
///     std::fs::write(folder.path().join(name), b"")?;
/// }
/// let pattern = folder.path().join("view*.png").display().to_string();
/// let files = ga_files::list::expand(&[pattern])?;
/// assert_eq!(files.len(), 2);
/// assert!(files[0].ends_with("view9.png"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn expand(texts: &[String]) -> Result<Vec<PathBuf>, ListError> {
    let mut files = Vec::new();
    for text in texts {
        if Path::new(text).is_file() {
            files.push(PathBuf::from(text));
            continue;
        }
        let before = files.len();
        let found = glob::glob(&pattern(text)).map_err(|error| ListError::Pattern {
            pattern: text.clone(),
            error,
        })?;
        for path in found {
            let path = path.map_err(|error| ListError::Folder {
                pattern: text.clone(),
                error,
            })?;
            if path.is_file() {
                files.push(path);
            }
        }
        if files.len() == before {
            return Err(ListError::NoMatch(text.clone()));
        }
    }
    files.sort_by_cached_key(|path| (key(path), path.clone()));
    files.dedup();
    Ok(files)
}

/// The first pair of files whose names do not belong together by their numbers: where a number of
/// the left name differs from that of the right one, it does so as in the first pair, as 0 and 1 in
/// `0-07.png` and `1-07.png`. Names with different counts of numbers are not compared.
///
/// ```
/// use ga_files::list::first_unlike_pair;
/// let pairs = [["l1.png", "r1.png"], ["l2.png", "r3.png"]].map(|pair| pair.map(Into::into));
/// assert_eq!(first_unlike_pair(&pairs), Some(&pairs[1]));
/// assert_eq!(first_unlike_pair(&pairs[..1]), None);
/// ```
#[must_use]
pub fn first_unlike_pair(pairs: &[[PathBuf; 2]]) -> Option<&[PathBuf; 2]> {
    let changes = |pair: &[PathBuf; 2]| {
        let [left, right] = pair.each_ref().map(|path| numbers(path));
        let is_comparable = left.len() == right.len();
        let both = left.into_iter().zip(right).filter(|_| is_comparable);
        both.map(|(left, right)| (left != right).then_some((left, right)))
            .collect::<Vec<_>>()
    };
    let first = pairs.first().map(changes);
    pairs.iter().find(|pair| Some(changes(pair)) != first)
}

/// A text with the special symbols of existing folders escaped.
fn pattern(text: &str) -> String {
    let folders = text.match_indices(std::path::is_separator);
    let ends = folders.map(|(index, separator)| index + separator.len());
    let mut existing = ends.filter(|&end| Path::new(&text[..end]).is_dir());
    let end = existing.next_back().unwrap_or(0);
    Pattern::escape(&text[..end]) + &text[end..]
}

/// A piece of a name.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Piece {
    /// How many digits without leading zeros there are, and these.
    Number(usize, String),
    Text(String),
}

/// What the order of paths goes by.
fn key(path: &Path) -> Vec<Vec<Piece>> {
    let component = |part: Component<'_>| pieces(&part.as_os_str().to_string_lossy());
    path.components().map(component).collect()
}

fn pieces(name: &str) -> Vec<Piece> {
    let runs = name
        .as_bytes()
        .chunk_by(|a, b| a.is_ascii_digit() == b.is_ascii_digit());
    let piece = |run: &[u8]| {
        let text = String::from_utf8_lossy(run);
        match run.first().is_some_and(u8::is_ascii_digit) {
            true => {
                let digits = text.trim_start_matches('0').to_owned();
                Piece::Number(digits.len(), digits)
            }
            false => Piece::Text(text.into_owned()),
        }
    };
    runs.map(piece).collect()
}

/// The numbers in the name of a file, without leading zeros.
fn numbers(path: &Path) -> Vec<String> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let number = |piece| match piece {
        Piece::Number(_, digits) => Some(digits),
        Piece::Text(_) => None,
    };
    pieces(&name).into_iter().filter_map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sorted<const N: usize>(names: [&str; N]) -> [&str; N] {
        let mut names = names;
        names.sort_by_cached_key(|name| (key(Path::new(name)), *name));
        names
    }

    #[test]
    fn numbers_in_names_count_as_numbers() {
        assert_eq!(
            sorted(["10.jpg", "9.jpg", "2.jpg"]),
            ["2.jpg", "9.jpg", "10.jpg"]
        );
        let padded = ["a010.png", "a9.png", "a09b.png"];
        assert_eq!(sorted(padded), ["a9.png", "a09b.png", "a010.png"]);
        assert_eq!(
            sorted(["s10/1", "s2/30", "s2/4"]),
            ["s2/4", "s2/30", "s10/1"]
        );
        // More digits than any integer has.
        let long = ["100000000000000000000000", "99999999999999999999999"];
        assert_eq!(sorted(long), [long[1], long[0]]);
    }

    #[test]
    fn a_name_comes_before_a_pattern() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().join("br[1]");
        std::fs::create_dir(&folder).unwrap();
        for name in ["left [8].jpg", "left 8.jpg", "left 10.jpg", "left 9.jpg"] {
            std::fs::write(folder.join(name), b"").unwrap();
        }
        let path = |name: &str| folder.join(name).display().to_string();
        let expand = |names: &[&str]| -> Vec<String> {
            let texts: Vec<String> = names.iter().map(|name| path(name)).collect();
            let files = super::expand(&texts).unwrap();
            let names = files.iter().map(|file| file.file_name().unwrap());
            names
                .map(|name| name.to_string_lossy().into_owned())
                .collect()
        };
        assert_eq!(expand(&["left [8].jpg"]), ["left [8].jpg"]);
        assert_eq!(expand(&["left [9].jpg"]), ["left 9.jpg"]);
        assert_eq!(
            expand(&["left ?.jpg", "left 9.jpg", "left 10.jpg"]),
            ["left 8.jpg", "left 9.jpg", "left 10.jpg"]
        );
        let none = super::expand(&[path("none*.jpg")]).unwrap_err();
        assert!(none.to_string().ends_with("matches no file"));
    }
}
