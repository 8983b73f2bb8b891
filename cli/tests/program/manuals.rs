//! Help, manual pages and completions of all commands.

use std::fs;
use std::path::Path;

use tempfile::tempdir;

use crate::common::{assert_success, names, nullcone, text};

/// The paths of all commands, by the help of each.
pub(crate) fn commands() -> Vec<Vec<String>> {
    let mut all = vec![Vec::new()];
    let mut next = 0;
    while let Some(path) = all.get(next).cloned() {
        for name in below(&path) {
            all.push([&path[..], &[name]].concat());
        }
        next += 1;
    }
    all.split_off(1)
}

fn help(path: &[String]) -> String {
    let all = path.iter().map(String::as_str).chain(["--help"]);
    let output = nullcone(Path::new("."), all);
    assert_success(&output);
    text(&output.stdout).to_owned()
}

/// The names of the commands below one.
pub(crate) fn below(path: &[String]) -> Vec<String> {
    let help = help(path);
    let Some((_, list)) = help.split_once("\nCommands:\n") else {
        return Vec::new();
    };
    let lines = list.lines().take_while(|line| !line.is_empty());
    let starts = lines.filter_map(|line| {
        line.strip_prefix("  ")
            .filter(|rest| !rest.starts_with(' '))
    });
    let names = starts.filter_map(|line| line.split_whitespace().next());
    let names = names.filter(|name| *name != "help");
    names.map(str::to_owned).collect()
}

#[test]
fn every_shell_completes_every_command() {
    let commands = commands();
    assert!(commands.len() > 40, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = nullcone(Path::new("."), ["completions", shell]);
        assert_success(&output);
        assert!(output.stderr.is_empty());
        let script = text(&output.stdout);
        for command in &commands {
            for name in command {
                assert!(script.contains(name), "{shell}: {command:?}");
            }
        }
    }
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = tempdir().unwrap();
    let output = nullcone(folder.path(), ["man", "--out", "man1"]);
    assert_success(&output);
    let pages = folder.path().join("man1");
    let mut expected: Vec<String> = commands()
        .into_iter()
        .map(|path| format!("nullcone-{}.1", path.join("-")))
        .chain(["nullcone.1".to_owned()])
        .collect();
    expected.sort();
    assert_eq!(names(&pages), expected);
    let fit = std::fs::read_to_string(pages.join("nullcone-body-fit.1")).unwrap();
    assert!(fit.starts_with(".") || fit.contains(".TH nullcone-body-fit 1"));
    assert!(fit.contains("character"));

    let top = nullcone(folder.path(), ["man"]);
    assert_eq!(top.stdout, std::fs::read(pages.join("nullcone.1")).unwrap());
    for command in commands().iter().filter(|path| path.len() == 1) {
        let name = format!("nullcone\\-{}", command[0]);
        assert!(text(&top.stdout).contains(&name), "{name}");
    }
}

/// The words of the example at the end of a help.
fn example(help: &str) -> Vec<String> {
    let (_, example) = help.rsplit_once("\nExample:\n  nullcone ").expect(help);
    assert_eq!(example.trim_end().lines().count(), 1, "{example}");
    let pieces = example.trim_end().split('\'').enumerate();
    // What is quoted is one word.
    let words = pieces.flat_map(|(index, piece)| match index % 2 {
        0 => piece.split_whitespace().map(str::to_owned).collect(),
        _ => vec![piece.to_owned()],
    });
    words.collect()
}

/// Those whose inputs do not exist are understood, and miss the inputs.
#[test]
fn the_help_of_every_command_ends_with_an_example_that_is_understood() {
    let folder = tempdir().unwrap();
    for command in commands() {
        let words = example(&help(&command));
        assert!(words.starts_with(&command), "{words:?}");
        if command == ["demo"] {
            // It needs nothing and takes a minute, unless it is refused where it writes.
            fs::write(folder.path().join("file"), "").unwrap();
            let words = [words, vec!["--out".into(), "file/below".into()]].concat();
            let error = nullcone(folder.path(), &words).stderr;
            assert!(text(&error).contains("file/below"), "{}", text(&error));
            continue;
        }
        let output = nullcone(folder.path(), &words);
        let needs_nothing = ["expand", "completions", "man"].contains(&&*command[0])
            || command == ["body", "paint"];
        let status = if needs_nothing { 0 } else { 1 };
        let error = text(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{words:?}: {error}");
        assert!(needs_nothing || is_about_a_missing_file(error), "{error}");
    }
    let files = ["dotted.glb", "file", "man1"];
    assert_eq!(names(folder.path()), files);
}

fn is_about_a_missing_file(error: &str) -> bool {
    error.contains("No such file") || error.contains("matches no file")
}

#[test]
fn the_help_says_what_the_status_means() {
    let help = help(&[]);
    for part in ["replaces one of its name", "0    success", "130  ended by"] {
        assert!(help.contains(part), "{part}");
    }
}
