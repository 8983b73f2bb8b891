//! Files are replaced whole or not at all.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::path::Path;

use ga_files::{Staged, write, write_together};

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn replaces_a_file_and_leaves_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.bin");
    write(&path, b"first, and longer").unwrap();
    write(&path, b"second").unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), b"second");
    assert_eq!(names(folder.path()), ["a.bin"]);
}

#[test]
fn a_failed_write_names_the_file_and_leaves_the_folder_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("taken");
    std::fs::create_dir(&taken).unwrap();
    std::fs::write(taken.join("inside"), b"kept").unwrap();
    let error = write(&taken, b"x").unwrap_err();
    assert_eq!(error.path, taken);
    assert!(
        error
            .to_string()
            .starts_with(&format!("cannot write {}: ", taken.display()))
    );
    assert_eq!(names(folder.path()), ["taken"]);
    assert_eq!(names(&taken), ["inside"]);
}

#[test]
fn when_one_of_several_fails_the_others_stay_as_they_were() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["a", "b"].map(|name| folder.path().join(name));
    std::fs::write(&first, b"kept").unwrap();
    std::fs::create_dir(&second).unwrap();
    let error = write_together([(&first, &b"new"[..]), (&second, b"new")]).unwrap_err();
    assert_eq!(error.path, second);
    assert_eq!(std::fs::read(&first).unwrap(), b"kept");
    assert_eq!(names(folder.path()), ["a", "b"]);
}

#[test]
fn when_one_of_several_fails_created_folders_are_removed() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["new/deep/a", "taken"].map(|name| folder.path().join(name));
    std::fs::create_dir(&second).unwrap();
    write_together([(&first, &b"new"[..]), (&second, b"new")]).unwrap_err();
    assert_eq!(names(folder.path()), ["taken"]);
}

#[test]
fn files_that_are_not_finished_leave_nothing() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("kept"), b"kept").unwrap();
    let mut files = Staged::default();
    files.add(folder.path().join("new/deep/a"), b"a").unwrap();
    files.add(folder.path().join("kept"), b"other").unwrap();
    drop(files);
    assert_eq!(names(folder.path()), ["kept"]);
    let kept = std::fs::read(folder.path().join("kept")).unwrap();
    assert_eq!(kept, b"kept");
}

/// More than the files that a process may have open by default.
#[test]
fn many_files_are_not_open_at_the_same_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = |number: usize| folder.path().join(format!("{number}.txt"));
    let mut files = Staged::default();
    for number in 0..1100 {
        files
            .add(path(number), number.to_string().as_bytes())
            .unwrap();
    }
    files.finish().unwrap();
    assert_eq!(names(folder.path()).len(), 1100);
    assert_eq!(std::fs::read(path(1099)).unwrap(), b"1099");
}

#[test]
fn two_files_of_one_path_are_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let [first, same] = ["a", "./a"].map(|name| folder.path().join(name));
    std::fs::write(&first, b"kept").unwrap();
    let files = [(&first, &b"picture"[..]), (&same, b"camera")];
    let error = write_together(files).unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("another output has the same path")
    );
    assert_eq!(std::fs::read(&first).unwrap(), b"kept");
    assert_eq!(names(folder.path()), ["a"]);
    write_together([(&first, &b"new"[..]), (&same, b"new")]).unwrap();
    assert_eq!(std::fs::read(&first).unwrap(), b"new");
}

#[test]
fn a_file_in_place_of_a_folder_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("file"), b"kept").unwrap();
    assert!(write(folder.path().join("file/below"), b"x").is_err());
    assert_eq!(std::fs::read(folder.path().join("file")).unwrap(), b"kept");
}

#[cfg(unix)]
#[test]
fn the_file_has_the_permissions_of_any_new_file() {
    let folder = tempfile::tempdir().unwrap();
    let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
    write(&ours, b"x").unwrap();
    std::fs::write(&plain, b"x").unwrap();
    let permissions = |path: &Path| std::fs::metadata(path).unwrap().permissions();
    assert_eq!(permissions(&ours), permissions(&plain));
}
