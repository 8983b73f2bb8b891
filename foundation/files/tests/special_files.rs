//! Targets that are more than a name for bytes: pipes, links, files with an owner and a mode.

#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::fs::{self, File, Permissions};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

use ga_files::Staged;
use tempfile::tempdir;

fn mode(path: &Path) -> u32 {
    path.metadata().unwrap().mode() & 0o7777
}

fn with_mode(path: &Path, mode: u32) {
    fs::set_permissions(path, Permissions::from_mode(mode)).unwrap();
}

fn count(folder: &Path) -> usize {
    fs::read_dir(folder).unwrap().count()
}

#[test]
fn a_pipe_is_written_to() {
    let folder = tempdir().unwrap();
    let pipe = folder.path().join("pipe");
    assert!(
        Command::new("mkfifo")
            .arg(&pipe)
            .status()
            .unwrap()
            .success()
    );
    assert!(ga_files::is_stream(&pipe));
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::read(pipe).unwrap()
    });
    ga_files::write(&pipe, b"through the pipe").unwrap();
    assert_eq!(reader.join().unwrap(), b"through the pipe");
    assert!(!pipe.metadata().unwrap().is_file());
    assert_eq!(count(folder.path()), 1);
}

#[test]
fn links_are_followed_even_to_what_does_not_exist() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("deep")).unwrap();
    fs::write(path("deep/target"), b"old").unwrap();
    symlink("deep/target", path("link")).unwrap();
    symlink("link", path("link of a link")).unwrap();
    symlink("deep/new", path("dangling")).unwrap();
    ga_files::write(path("link of a link"), b"new").unwrap();
    ga_files::write(path("dangling"), b"made").unwrap();
    assert_eq!(fs::read(path("deep/target")).unwrap(), b"new");
    assert_eq!(fs::read(path("deep/new")).unwrap(), b"made");
    for link in ["link", "link of a link", "dangling"] {
        assert!(path(link).symlink_metadata().unwrap().is_symlink());
    }
    assert_eq!([count(folder.path()), count(&path("deep"))], [4, 2]);
}

#[test]
fn two_links_to_one_file_are_one_output() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("file"), b"old").unwrap();
    symlink("file", path("link")).unwrap();
    let files = [(path("file"), &b"a"[..]), (path("link"), b"b")];
    let error = ga_files::write_together(files).unwrap_err();
    assert!(error.to_string().contains("another output"), "{error}");
    assert_eq!(fs::read(path("file")).unwrap(), b"old");
}

#[test]
fn the_other_names_of_a_file_show_the_new_contents() {
    let folder = tempdir().unwrap();
    let [first, second] = ["first", "second"].map(|name| folder.path().join(name));
    fs::write(&first, b"old, and longer than the new contents").unwrap();
    fs::hard_link(&first, &second).unwrap();
    ga_files::write(&second, b"new").unwrap();
    assert_eq!(fs::read(&first).unwrap(), b"new");
    assert!(ga_files::is_same_file(&first, &second));
    assert_eq!(count(folder.path()), 2);
}

#[test]
fn a_file_with_several_names_is_not_touched_before_the_end() {
    let folder = tempdir().unwrap();
    let [first, second] = ["first", "second"].map(|name| folder.path().join(name));
    fs::write(&first, b"old").unwrap();
    fs::hard_link(&first, &second).unwrap();
    let mut files = Staged::default();
    files.add(&first, b"new").unwrap();
    assert_eq!(fs::read(&first).unwrap(), b"old");
    drop(files);
    assert_eq!(fs::read(&first).unwrap(), b"old");
}

#[test]
fn the_mode_of_an_earlier_file_stays_and_a_new_one_follows_the_umask() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    File::create(path("ordinary")).unwrap();
    for bits in [0o600, 0o640, 0o755, 0o666] {
        fs::write(path("file"), b"old").unwrap();
        with_mode(&path("file"), bits);
        ga_files::write(path("file"), b"new").unwrap();
        assert_eq!(mode(&path("file")), bits);
        assert_eq!(fs::read(path("file")).unwrap(), b"new");
    }
    let mut files = Staged::default();
    let written = files.add_with(path("large"), |file| {
        let done = file.write_all(b"piece by piece");
        done.map_err(|source| ga_files::WriteError {
            path: path("large"),
            source,
        })
    });
    written.unwrap();
    files.finish().unwrap();
    assert_eq!(mode(&path("large")), mode(&path("ordinary")));
}

/// Only the administrator can give files away, so that others skip the change of owner.
#[test]
fn the_owner_of_an_earlier_file_stays() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, b"old").unwrap();
    let _ = std::os::unix::fs::chown(&file, Some(12_345), Some(12_346));
    let owner = |path: &Path| {
        let metadata = path.metadata().unwrap();
        (metadata.uid(), metadata.gid())
    };
    let before = owner(&file);
    ga_files::write(&file, b"new").unwrap();
    assert_eq!(owner(&file), before);
    assert_eq!(fs::read(&file).unwrap(), b"new");
}

/// The bits count for the administrator too.
#[test]
fn a_file_that_is_read_only_is_an_error() {
    let folder = tempdir().unwrap();
    let [first, second] = ["first", "master"].map(|name| folder.path().join(name));
    fs::write(&second, b"kept").unwrap();
    with_mode(&second, 0o444);
    let error = ga_files::write_together([(&first, &b"a"[..]), (&second, b"b")]).unwrap_err();
    assert_eq!(error.path, second);
    assert_eq!(error.source.kind(), std::io::ErrorKind::PermissionDenied);
    assert!(error.to_string().ends_with("master: the file is read-only"));
    assert!(ga_files::check(&second).is_err() && ga_files::check(&first).is_ok());
    assert_eq!(fs::read(&second).unwrap(), b"kept");
    assert_eq!(count(folder.path()), 1);
}

#[test]
fn an_open_descriptor_is_written_to() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("file");
    fs::write(&path, b"before ").unwrap();
    let file = File::options().append(true).open(&path).unwrap();
    let descriptor = format!("/dev/fd/{}", std::os::fd::AsRawFd::as_raw_fd(&file));
    assert!(ga_files::is_stream(&descriptor));
    ga_files::write(&descriptor, b"after").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"before after");
}

#[test]
fn different_files_are_not_one() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("a"), b"same").unwrap();
    fs::write(path("b"), b"same").unwrap();
    assert!(!ga_files::is_same_file(path("a"), path("b")));
    assert!(!ga_files::is_same_file(path("none"), path("none")));
    assert!(ga_files::is_same_file(path("a"), path("./a")));
}
