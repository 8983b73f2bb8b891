//! Lists of files as arguments: names and patterns, and the order of their names.

use std::path::{Component, Path, PathBuf};

use glob::{GlobError, Pattern, PatternError};

/// Why an argument stands for no files.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ListError {
    /// It is neither a name of a file nor a pattern.
    #[error("{argument:?}: {source}")]
    Pattern {
        /// The argument.
        argument: String,
        /// What is wrong with it.
        source: PatternError,
    },
    /// A folder cannot be read.
    #[error("{argument:?}: {source}")]
    Folder {
        /// The argument.
        argument: String,
        /// What the operating system said.
        source: GlobError,
    },
    /// The pattern matches nothing.
    #[error("{argument:?} matches no file")]
    NoMatch {
        /// The argument.
        argument: String,
    },
}

/// The files that arguments stand for, in the order of the arguments.
///
/// An argument is the name of a file or a folder where one has that name, and where it has none of
/// the symbols `*`, `?` and `[` in it. Any other is a pattern: `*` stands for any text, `?` for a
/// character, `[abc]` for one of several, and `**` for any folders. Folders with which it begins
/// are names, with any symbols, where they exist. It stands for the files that it matches, or,
/// where it matches none, for the folders, in [natural order](natural_order).
///
/// # Errors
///
/// [`ListError`]: an argument is not a pattern, or matches nothing, or a folder cannot be read.
///
/// # Examples
///
/// ```
/// let folder = tempfile::tempdir()?;
/// for name in ["left 9.jpg", "left 10.jpg", "left [8].jpg"] {
///     std::fs::write(folder.path().join(name), b"")?;
/// }
/// let names = |argument: &str| -> Vec<String> {
///     let files = ga_files::expand([folder.path().join(argument)]).unwrap_or_default();
///     let names = files.iter().filter_map(|file| file.file_name()?.to_str());
///     names.map(str::to_owned).collect()
/// };
/// assert_eq!(names("left [8].jpg"), ["left [8].jpg"]);
/// assert_eq!(names("left [89].jpg"), ["left 9.jpg"]);
/// assert_eq!(names("left ?*.jpg"), ["left 9.jpg", "left 10.jpg", "left [8].jpg"]);
/// assert!(ga_files::expand([folder.path().join("right*")]).is_err());
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn expand<P: AsRef<Path>>(
    arguments: impl IntoIterator<Item = P>,
) -> Result<Vec<PathBuf>, ListError> {
    let mut all = Vec::new();
    for path in arguments {
        let path = path.as_ref();
        match path.to_str() {
            Some(text) if !path.exists() && split(text).1.contains(['*', '?', '[']) => {
                all.extend(matches(text)?);
            }
            _ => all.push(path.to_path_buf()),
        }
    }
    Ok(all)
}

/// The files, or else the folders, that a pattern matches.
fn matches(argument: &str) -> Result<Vec<PathBuf>, ListError> {
    let (folders, rest) = split(argument);
    let pattern = Pattern::escape(folders) + rest;
    let argument = argument.to_owned();
    let paths = match glob::glob(&pattern) {
        Ok(paths) => paths.collect::<Result<Vec<_>, _>>(),
        Err(source) => return Err(ListError::Pattern { argument, source }),
    };
    let paths = match paths {
        Ok(paths) => paths,
        Err(source) => return Err(ListError::Folder { argument, source }),
    };
    let (mut files, folders): (Vec<_>, Vec<_>) = paths.into_iter().partition(|path| path.is_file());
    if files.is_empty() {
        files = folders;
    }
    if files.is_empty() {
        return Err(ListError::NoMatch { argument });
    }
    natural_order(&mut files);
    Ok(files)
}

/// An argument in two parts: the folders with which it begins that exist, and the rest.
fn split(argument: &str) -> (&str, &str) {
    let folders = argument.match_indices(std::path::is_separator);
    let ends = folders.map(|(index, separator)| index + separator.len());
    let mut existing = ends.filter(|&end| Path::new(&argument[..end]).is_dir());
    argument.split_at(existing.next_back().unwrap_or(0))
}

/// Sorts paths by their names, where numbers count as numbers: 2 comes before 10.
pub fn natural_order(paths: &mut [PathBuf]) {
    paths.sort_by_cached_key(|path| (key(path), path.clone()));
}

/// A number in a name: how many digits without leading zeros there are, and these.
pub(crate) type Number = (usize, String);

/// A piece of a name.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Piece {
    Number(Number),
    Text(String),
}

/// What the natural order goes by.
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
                Piece::Number((digits.len(), digits))
            }
            false => Piece::Text(text.into_owned()),
        }
    };
    runs.map(piece).collect()
}

/// The numbers in the name of a file.
pub(crate) fn numbers(path: &Path) -> Vec<Number> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let number = |piece| match piece {
        Piece::Number(number) => Some(number),
        Piece::Text(_) => None,
    };
    pieces(&name).into_iter().filter_map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sorted<const N: usize>(names: [&str; N]) -> Vec<PathBuf> {
        let mut paths = names.map(PathBuf::from).to_vec();
        natural_order(&mut paths);
        paths
    }

    fn paths<const N: usize>(names: [&str; N]) -> [PathBuf; N] {
        names.map(PathBuf::from)
    }

    #[test]
    fn numbers_in_names_count_as_numbers() {
        assert_eq!(
            sorted(["10.jpg", "9.jpg", "2.jpg"]),
            paths(["2.jpg", "9.jpg", "10.jpg"])
        );
        let padded = ["a010.png", "a9.png", "a09b.png"];
        assert_eq!(sorted(padded), paths(["a9.png", "a09b.png", "a010.png"]));
        assert_eq!(
            sorted(["s10/1", "s2/30", "s2/4"]),
            paths(["s2/4", "s2/30", "s10/1"])
        );
        // More digits than any integer has.
        let long = ["100000000000000000000000", "99999999999999999999999"];
        assert_eq!(sorted(long), paths([long[1], long[0]]));
    }

    #[test]
    fn a_name_comes_before_a_pattern() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().join("br[1]");
        std::fs::create_dir(&folder).unwrap();
        for name in ["left [8].jpg", "left 8.jpg", "left 10.jpg", "left 9.jpg"] {
            std::fs::write(folder.join(name), b"").unwrap();
        }
        for name in ["view 2", "view 10"] {
            std::fs::create_dir(folder.join(name)).unwrap();
        }
        let expanded = |names: &[&str]| -> Vec<String> {
            let arguments = names.iter().map(|name| folder.join(name));
            let files = expand(arguments).unwrap();
            let names = files.iter().map(|file| file.file_name().unwrap());
            names
                .map(|name| name.to_string_lossy().into_owned())
                .collect()
        };
        assert_eq!(expanded(&["left [8].jpg"]), ["left [8].jpg"]);
        assert_eq!(expanded(&["left [9].jpg"]), ["left 9.jpg"]);
        assert_eq!(
            expanded(&["left 9.jpg", "left [18]*.jpg", "missing.jpg"]),
            ["left 9.jpg", "left 8.jpg", "left 10.jpg", "missing.jpg"]
        );
        // Folders count where no file matches.
        assert_eq!(expanded(&["view*"]), ["view 2", "view 10"]);
        assert_eq!(expanded(&["*2", "*9*"]), ["view 2", "left 9.jpg"]);
        let none = expand([folder.join("none*.jpg")]).unwrap_err();
        assert!(none.to_string().ends_with("none*.jpg\" matches no file"));
        let wrong = expand([folder.join("left[")]).unwrap_err();
        assert!(matches!(wrong, ListError::Pattern { .. }));
    }
}
