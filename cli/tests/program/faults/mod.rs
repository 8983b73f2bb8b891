//! What every command leaves where something fails from outside: folders that cannot be written,
//! full disks, signals, closed pipes, and files that claim too much or end too early.

#![cfg(target_os = "linux")]

mod closed_pipe;
mod cut;
mod full_disk;
mod headers;
mod inputs;
mod left;
mod signals;
mod table;
mod unwritable;

use std::num::NonZero;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::common::text;

/// Does something for all items on as many threads as the machine can run; where it panics for one,
/// that is said at the end, so that all are known.
fn for_each<T: Sync>(items: &[T], act: impl Fn(&T) + Sync) {
    let threads = std::thread::available_parallelism().map_or(2, NonZero::get);
    let [next, failures] = [0, 0].map(AtomicUsize::new);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(item) = items.get(next.fetch_add(1, Ordering::Relaxed)) {
                    if catch_unwind(AssertUnwindSafe(|| act(item))).is_err() {
                        failures.fetch_add(1, Ordering::Relaxed);
                    }
                }
            });
        }
    });
    let failures = failures.into_inner();
    assert_eq!(failures, 0, "of {} cases", items.len());
}

/// The program in a folder, with memory and time that bad input must not exhaust: it fails instead
/// of taking the machine's.
fn limited(folder: &Path, words: &[String]) -> Output {
    let mut command = Command::new("sh");
    let script = "ulimit -v 4194304; exec timeout 60 \"$@\"";
    command.args(["-c", script, "sh", env!("CARGO_BIN_EXE_nullcone")]);
    command.args(words).current_dir(folder).output().unwrap()
}

/// Fails unless the program ended by itself: with a status that the help lists, one line of error
/// where it failed, and without a panic.
#[track_caller]
fn assert_orderly(output: &Output, what: &str) {
    let message = text(&output.stderr);
    assert!(!message.contains("panicked"), "{what}: {message}");
    let status = output.status.code();
    assert!(
        matches!(status, Some(0 | 1 | 3)),
        "{what}: {status:?} {message}"
    );
    if status == Some(1) {
        let error = error(message);
        assert!(error.is_some(), "{what}: {message}");
    }
}

/// The line of the error, if it is the only one beside warnings and the place in the source of a
/// function, which an error of syntax shows below its line.
fn error(message: &str) -> Option<&str> {
    let lines = message.lines().filter(|line| {
        let rest = line.trim_start_matches(|c: char| c.is_ascii_digit());
        let is_place = rest.is_empty() || rest.starts_with(' ');
        !line.starts_with("warning: ") && !is_place
    });
    match lines.collect::<Vec<_>>()[..] {
        [error] if error.starts_with("error: ") => Some(error),
        _ => None,
    }
}
