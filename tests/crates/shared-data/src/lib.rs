//! Finds the test data that is too large for the repository. It is looked for in the folder
//! `shared` beside the repository, that is in `../shared` seen from its root. [`json`] reads the
//! numbers of truths.

pub mod json;

use std::env;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The environment variable that makes the absence of shared data a failure. Continuous integration
/// sets it to 1; unset, empty and 0 allow tests to be skipped.
pub const REQUIRE_SHARED: &str = "NULLCONE_REQUIRE_SHARED";

/// The file or folder `path` of the shared data.
///
/// Where it is absent this says on standard error that the test is skipped, and returns `None`:
///
/// ```
/// let Some(path) = nullcone_shared_data::shared("oracle/ga/cga3_seed1.json") else {
///     return;
/// };
/// assert!(path.exists());
/// ```
///
/// # Panics
///
/// When it is absent although [`REQUIRE_SHARED`] demands it.
#[track_caller]
pub fn shared(path: &str) -> Option<PathBuf> {
    find(folder().join(path), is_required())
}

/// A path that may be absent from a checkout, such as that of an installed tool, treated as by
/// [`shared`].
///
/// # Panics
///
/// As [`shared`].
#[track_caller]
pub fn present(path: &Path) -> Option<PathBuf> {
    find(path.to_path_buf(), is_required())
}

fn is_required() -> bool {
    env::var_os(REQUIRE_SHARED).is_some_and(|value| !value.is_empty() && value != "0")
}

/// The folder beside the repository.
fn folder() -> PathBuf {
    let this_crate = Path::new(env!("CARGO_MANIFEST_DIR"));
    let parent = this_crate.ancestors().nth(4);
    parent.unwrap_or(this_crate).join("shared")
}

#[track_caller]
fn find(file: PathBuf, required: bool) -> Option<PathBuf> {
    if file.exists() {
        return Some(file);
    }
    let place = file.display();
    assert!(
        !required,
        "{place} is absent, and {REQUIRE_SHARED} demands it"
    );
    // `eprintln!` would be hidden for a test that passes. A closed standard error is not a failure.
    let _ = writeln!(io::stderr(), "skipped a test: {place} is absent");
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_exists_is_found() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
        assert_eq!(find(file.clone(), true), Some(file));
    }

    #[test]
    fn an_absent_file_is_none_where_none_is_required() {
        assert_eq!(find("nowhere/data.json".into(), false), None);
    }

    #[test]
    #[should_panic(expected = "NULLCONE_REQUIRE_SHARED demands it")]
    fn an_absent_file_is_a_failure_where_it_is_required() {
        find("nowhere/data.json".into(), true);
    }

    #[test]
    fn the_folder_lies_beside_the_repository() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(3);
        assert!(root.is_some_and(|root| root.join("Cargo.lock").exists()));
        assert_eq!(root.and_then(Path::parent), folder().parent());
    }
}
