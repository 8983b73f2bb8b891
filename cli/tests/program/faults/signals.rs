//! Ends of the program midway: what is left is earlier, or complete and new.

use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use tempfile::tempdir;

use super::left::{EARLIER, Files, files, write_earlier};
use super::table::{Row, working};
use super::{for_each, inputs};

/// The program with outputs in `out`; the process that runs the tests may ignore signals.
fn start(folder: &Path, row: &Row) -> Child {
    let mut command = Command::new("env");
    command.args(["--default-signal=INT", env!("CARGO_BIN_EXE_nullcone")]);
    command.args(row.words(inputs::folder(), "out"));
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command.current_dir(folder).spawn().unwrap()
}

/// Ends the program by a signal at moments spread over the time that it takes, each with earlier
/// files in the places of its outputs, and looks at what is left.
fn end_midway(row: &Row, signal: &str, moments: u32, judge: impl Fn(ExitStatus, &Files, &Files)) {
    let folder = tempdir().unwrap();
    let path = folder.path();
    let out = path.join("out");
    let begin = Instant::now();
    assert!(start(path, row).wait().unwrap().success(), "{}", row.line);
    let time = begin.elapsed();
    // Slow commands at fewer moments.
    let moments = if time > Duration::from_secs(1) {
        3
    } else {
        moments
    };
    let made = files(&out);
    for moment in 1..=moments {
        std::fs::remove_dir_all(&out).unwrap();
        write_earlier(&out, &made);
        let mut child = start(path, row);
        std::thread::sleep(time * moment / moments);
        // It may have ended.
        let mut kill = Command::new("kill");
        kill.args([signal, &child.id().to_string()]);
        kill.stderr(Stdio::null()).status().unwrap();
        let status = child.wait().unwrap();
        judge(status, &made, &files(&out));
    }
}

/// Pages and one plot hold measured times, so that only others have the same bytes again.
fn is_new(name: &str, contents: &[u8], made: &Files) -> bool {
    let endings = [".html", "report.json", "plot.svg"];
    match endings.iter().any(|ending| name.ends_with(ending)) {
        true => contents.len().abs_diff(made[name].len()) < 100,
        false => contents == made[name],
    }
}

#[test]
fn ctrl_c_leaves_all_files_earlier_or_new() {
    for_each(&working(), |row| {
        end_midway(row, "-INT", 10, |status, made, left| {
            // Before the program has begun, the system ends it.
            let is_ended = status.code() == Some(130) || status.signal() == Some(2);
            assert!(is_ended || status.success(), "{}: {status}", row.line);
            assert!(
                left.keys().eq(made.keys()),
                "{}: {:?}",
                row.line,
                left.keys()
            );
            let is_earlier = left.values().all(|contents| contents == EARLIER);
            let mut new = left.iter();
            let is_new = new.all(|(name, contents)| is_new(name, contents, made));
            assert!(is_new || is_earlier && is_ended, "{}", row.line);
        });
    });
}

/// Nothing can be removed then, but what is left beside the files has a name that says so.
#[test]
fn a_killed_program_leaves_no_half_written_file() {
    for_each(&working(), |row| {
        end_midway(row, "-KILL", 4, |status, made, left| {
            assert!(
                status.signal() == Some(9) || status.success(),
                "{}",
                row.line
            );
            for (name, contents) in left {
                if name.split('/').any(|part| part.starts_with(".nullcone-")) {
                    continue;
                }
                assert!(made.contains_key(name), "{}: {name}", row.line);
                let is_whole = contents == EARLIER || is_new(name, contents, made);
                assert!(is_whole, "{}: {name}", row.line);
            }
            assert!(
                made.keys().all(|name| left.contains_key(name)),
                "{}",
                row.line
            );
        });
    });
}
