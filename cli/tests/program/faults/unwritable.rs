//! Places where no file can be written.

use std::path::Path;

use tempfile::tempdir;

use super::table::{ROWS, words, working};
use super::{error, for_each, inputs, left};
use crate::common::{names, nullcone, text};

/// The program fails in one line that names the place.
#[track_caller]
fn assert_refused(folder: &Path, words: &[String], place: &str) {
    let output = nullcone(folder, words);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{words:?}: {message}");
    let is_named = error(message).is_some_and(|error| error.contains(place));
    assert!(is_named, "{words:?}: {message}");
}

/// The superuser may write to any folder, whatever its permissions are, but cannot make a folder
/// below a file, or a file in `/proc`.
#[test]
fn a_folder_below_a_file_and_one_of_the_system_are_refused() {
    for_each(&working(), |row| {
        let folder = tempdir().unwrap();
        std::fs::write(folder.path().join("file"), "the only copy").unwrap();
        for place in ["file/out", "/proc/out"] {
            let words = row.words(inputs::folder(), place);
            assert_refused(folder.path(), &words, place);
            assert_eq!(names(folder.path()), ["file"]);
        }
        let kept = std::fs::read(folder.path().join("file")).unwrap();
        assert_eq!(kept, b"the only copy");
    });
}

/// Of several outputs each in turn; the others are not written either.
#[test]
fn a_folder_in_the_place_of_a_file_is_refused() {
    for_each(ROWS, |row| {
        let outputs = row.line.split(' ').filter(|word| word.starts_with("OUT/"));
        for output in outputs.filter(|output| output.contains('.') && !output.contains('%')) {
            let folder = tempdir().unwrap();
            let place = output.replace("OUT", "out");
            std::fs::create_dir_all(folder.path().join(&place)).unwrap();
            let words = words(row.line, inputs::folder(), "out");
            assert_refused(folder.path(), &words, &place);
            let out = folder.path().join("out");
            assert_eq!(names(&out).len(), 1, "{}", row.line);
            assert!(left::files(&out).is_empty(), "{}", row.line);
        }
    });
}

/// A file in the place of a folder of outputs stays.
#[test]
fn a_file_in_the_place_of_a_folder_is_refused() {
    for_each(&working(), |row| {
        let outputs = row.line.split(' ').filter(|word| word.starts_with("OUT/"));
        for output in outputs.filter(|output| !output.contains('.')) {
            let folder = tempdir().unwrap();
            let place = output.replace("OUT", "out");
            std::fs::create_dir(folder.path().join("out")).unwrap();
            std::fs::write(folder.path().join(&place), left::EARLIER).unwrap();
            let words = row.words(inputs::folder(), "out");
            assert_refused(folder.path(), &words, &place);
            let left = left::files(&folder.path().join("out"));
            assert_eq!(left.len(), 1, "{}", row.line);
            assert_eq!(left.values().next().unwrap(), left::EARLIER);
        }
    });
}

/// The page comes after all other files, and what is wrong with this one is not found before.
#[test]
fn a_page_that_cannot_be_written_leaves_no_other_file() {
    for_each(&working(), |row| {
        let folder = tempdir().unwrap();
        let page = "/proc/page.html";
        let line = row.line.replace("--report OUT/page.html", "");
        let words = words(&format!("{line} --report {page}"), inputs::folder(), "out");
        assert_refused(folder.path(), &words, page);
        assert!(names(folder.path()).is_empty(), "{}", row.line);
    });
}
