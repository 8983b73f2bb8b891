//! What is left where a signal ends the program.

#![cfg(unix)]

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::tempdir;

use crate::common::names;

/// The program while it waits for somebody who reads the pipe, with another output complete beside
/// its place.
fn waiting(folder: &Path, signals: &str) -> Child {
    // The process that runs the tests may ignore signals.
    let mut command = Command::new("env");
    command.args(["--default-signal=INT,TERM,HUP", signals]);
    command
        .arg(env!("CARGO_BIN_EXE_nullcone"))
        .current_dir(folder);
    command.args("curve k.csv --out pipe --plot new/deep/plot.svg".split(' '));
    command.stdout(Stdio::null()).stderr(Stdio::null());
    let child = command.spawn().unwrap();
    let begin = Instant::now();
    let deep = folder.join("new/deep");
    while !deep.is_dir() || names(&deep).is_empty() {
        assert!(
            begin.elapsed() < Duration::from_secs(60),
            "nothing is written"
        );
        std::thread::sleep(Duration::from_millis(5));
    }
    child
}

fn send(signal: &str, child: &Child) {
    let mut kill = Command::new("kill");
    let status = kill.args([signal, &child.id().to_string()]).status();
    assert!(status.unwrap().success());
}

#[test]
fn nothing_is_left_after_a_signal() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("k.csv"), "t,x\n0,0\n1,1\n").unwrap();
    let mut mkfifo = Command::new("mkfifo");
    assert!(
        mkfifo
            .arg(folder.path().join("pipe"))
            .status()
            .unwrap()
            .success()
    );
    for (signal, status) in [("-INT", 130), ("-TERM", 143), ("-HUP", 129)] {
        let mut child = waiting(folder.path(), "--default-signal=INT");
        send(signal, &child);
        assert_eq!(child.wait().unwrap().code(), Some(status));
        assert_eq!(names(folder.path()), ["k.csv", "pipe"]);
    }
    // As with nohup.
    let mut child = waiting(folder.path(), "--ignore-signal=HUP");
    send("-HUP", &child);
    send("-TERM", &child);
    assert_eq!(child.wait().unwrap().code(), Some(143));
    assert_eq!(names(folder.path()), ["k.csv", "pipe"]);
}
