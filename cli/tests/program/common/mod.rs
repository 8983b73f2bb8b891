//! Runs the program as a user does, in a folder of its own.

pub(crate) mod figure;

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// Runs the program in a folder and waits for its end.
pub(crate) fn nullcone<S: AsRef<std::ffi::OsStr>>(
    folder: &Path,
    arguments: impl IntoIterator<Item = S>,
) -> Output {
    program(folder).args(arguments).output().unwrap()
}

/// The program, ready to be run in a folder.
pub(crate) fn program(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_nullcone"));
    command.current_dir(folder);
    command
}

pub(crate) fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// Fails, with what the program said, unless it succeeded.
#[track_caller]
pub(crate) fn assert_success(output: &Output) {
    assert!(output.status.success(), "{}", text(&output.stderr));
}

/// Fails unless the program ended with status 1 and one line on standard error that begins with
/// `error: ` and holds all `parts`.
#[track_caller]
pub(crate) fn assert_failure(output: &Output, parts: &[&str]) {
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(output.stdout.is_empty());
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(message.starts_with("error: "), "{message}");
    for part in parts {
        assert!(message.contains(part), "{part:?} is not in {message:?}");
    }
}

/// What the program prints with `--json`.
#[track_caller]
pub(crate) fn json(folder: &Path, arguments: &[&str]) -> Value {
    let output = nullcone(folder, arguments.iter().chain(&["--json"]));
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The names in a folder in their order.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// What the program writes, in the order of [`names`].
pub(crate) const FILES: [&str; 4] = ["model.glb", "model.obj", "report.json", "sheet.png"];

/// The contents of the files in a folder.
pub(crate) fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    names(folder)
        .into_iter()
        .map(|name| {
            let bytes = std::fs::read(folder.join(&name)).unwrap();
            (name, bytes)
        })
        .collect()
}

pub(crate) fn report(folder: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(folder.join("report.json")).unwrap()).unwrap()
}

/// A number of a report, by the names on the way to it.
#[track_caller]
pub(crate) fn number(report: &Value, path: &str) -> f64 {
    let value = report.pointer(path);
    value
        .and_then(Value::as_f64)
        .unwrap_or_else(|| panic!("{path} is {value:?}"))
}

/// The y coordinates of the vertices in the text of an OBJ file, read without the program's own
/// reader.
pub(crate) fn heights(obj: &str) -> Vec<f64> {
    let lines = obj.lines().filter_map(|line| line.strip_prefix("v "));
    lines
        .map(|line| line.split_whitespace().nth(1).unwrap().parse().unwrap())
        .collect()
}

/// The greatest of some numbers minus the least.
pub(crate) fn extent(numbers: &[f64]) -> f64 {
    let (low, high) = numbers
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &x| {
            (low.min(x), high.max(x))
        });
    high - low
}
