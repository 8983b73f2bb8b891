//! A disk without space: a file system in memory that is full.

use std::path::Path;
use std::process::{Command, Output};

use tempfile::tempdir;

use super::table::working;
use super::{error, for_each, inputs, left};
use crate::common::{assert_success, nullcone, text};

/// Runs a script with the program's words in a namespace of its own, where it may mount.
fn apart(folder: &Path, script: &str, words: &[String]) -> Output {
    let mut command = Command::new("unshare");
    command.args(["-rm", "sh", "-c", script, "sh"]);
    command.arg(env!("CARGO_BIN_EXE_nullcone")).args(words);
    command.current_dir(folder).output().unwrap()
}

/// A file system of 1 MiB with earlier files, filled but for `$FREE` bytes. What is left after the
/// program ended is copied out, as the file system ends with the namespace.
const SCRIPT: &str = "set -e
mount -t tmpfs -o size=1m none full
cp -r earlier/. full
dd if=/dev/zero of=full/filler bs=4096 2>/dev/null || true
truncate -s -FREE full/filler
set +e
\"$@\"
status=$?
rm full/filler
cp -r full/. after
exit $status";

/// Whether a tmpfs can be mounted; otherwise it says that the test is skipped.
fn can_mount() -> bool {
    let folder = tempdir().unwrap();
    std::fs::create_dir(folder.path().join("full")).unwrap();
    let mut command = Command::new("unshare");
    command.args(["-rm", "mount", "-t", "tmpfs", "none", "full"]);
    let output = command.current_dir(folder.path()).output();
    let can = output.is_ok_and(|output| output.status.success());
    if !can {
        eprintln!("skipped: no file system can be mounted here");
    }
    can
}

#[test]
fn a_full_disk_is_named_and_earlier_files_stay() {
    if !can_mount() {
        return;
    }
    for_each(&working(), |row| {
        let folder = tempdir().unwrap();
        let path = folder.path();
        let words = row.words(inputs::folder(), "full");
        assert_success(&nullcone(path, &words));
        let made = left::files(&path.join("full"));
        left::write_earlier(&path.join("earlier"), &made);
        std::fs::remove_dir_all(path.join("full")).unwrap();
        std::fs::create_dir(path.join("full")).unwrap();
        // Nothing is free, and a block, on which the first of several files may fit.
        for free in ["0", "4096"] {
            let after = path.join("after");
            std::fs::create_dir(&after).unwrap();
            let output = apart(path, &SCRIPT.replace("FREE", free), &words);
            let message = text(&output.stderr);
            let left = left::files(&after);
            if free == "0" || !output.status.success() {
                assert_eq!(output.status.code(), Some(1), "{}: {message}", row.line);
                let is_named = error(message)
                    .is_some_and(|error| error.contains("full") && error.contains("No space left"));
                assert!(is_named, "{}: {message}", row.line);
                assert!(left.keys().eq(made.keys()), "{}", row.line);
                let mut contents = left.values();
                assert!(contents.all(|file| file == left::EARLIER), "{}", row.line);
            } else {
                assert!(left.keys().eq(made.keys()), "{}", row.line);
                let mut contents = left.values();
                assert!(contents.all(|file| file != left::EARLIER), "{}", row.line);
            }
            std::fs::remove_dir_all(after).unwrap();
        }
    });
}
