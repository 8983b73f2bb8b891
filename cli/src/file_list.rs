//! Lists of files as arguments: names and patterns.

use std::path::{Component, Path, PathBuf};

use anyhow::{Context, Result, ensure};
use glob::Pattern;

/// The files that arguments of an option stand for, each once, in the order of their names, where
/// numbers count as numbers: 2 comes before 10.
///
/// An argument is the name of a file, or a pattern where no file has that name. Folders with
/// which it begins are names, not patterns, where they exist.
///
/// # Errors
///
/// An argument is not a pattern, or matches no file, or a folder cannot be read.
pub(crate) fn expand(option: &str, arguments: &[String]) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for argument in arguments {
        if Path::new(argument).is_file() {
            files.push(PathBuf::from(argument));
            continue;
        }
        let named = || format!("{option} {argument:?}");
        let before = files.len();
        for path in glob::glob(&pattern(argument)).with_context(named)? {
            let path = path.with_context(named)?;
            if path.is_file() {
                files.push(path);
            }
        }
        ensure!(
            files.len() > before,
            "{option} {argument:?} matches no file"
        );
    }
    files.sort_by_cached_key(|path| (key(path), path.clone()));
    files.dedup();
    Ok(files)
}

/// An argument with the special symbols of existing folders escaped.
fn pattern(argument: &str) -> String {
    let folders = argument.match_indices(std::path::is_separator);
    let ends = folders.map(|(index, separator)| index + separator.len());
    let mut existing = ends.filter(|&end| Path::new(&argument[..end]).is_dir());
    let end = existing.next_back().unwrap_or(0);
    Pattern::escape(&argument[..end]) + &argument[end..]
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
pub(crate) fn numbers(path: &Path) -> Vec<String> {
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
            let arguments: Vec<String> = names.iter().map(|name| path(name)).collect();
            let files = super::expand("--left", &arguments).unwrap();
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
        let none = super::expand("--left", &[path("none*.jpg")]).unwrap_err();
        assert!(none.to_string().ends_with("matches no file"));
    }
}
