//! Readers that close the pipe, as `head` does.

use std::process::Stdio;

use tempfile::tempdir;

use super::table::working;
use super::{for_each, inputs};
use crate::common::{program, text};

#[test]
fn a_closed_pipe_is_no_error() {
    for_each(&working(), |row| {
        let folder = tempdir().unwrap();
        let mut command = program(folder.path());
        command.args(row.words(inputs::folder(), "out"));
        command.args(["--json", "--quiet"]);
        let mut child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let message = text(&output.stderr);
        assert!(output.status.success(), "{}: {message}", row.line);
        assert_eq!(message, "", "{}", row.line);
        assert!(folder.path().join("out").exists(), "{}", row.line);
    });
}
