//! Each example of ga-runtime has a test of its own; this checks that none is left out.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn runtime() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../ga-runtime"))
}

/// The names of the programs in a folder of ga-runtime.
fn programs(folder: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(runtime().join(folder)).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let programs = paths.filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let name = |path: &Path| {
        path.file_stem()
            .and_then(|name| name.to_str())
            .map(String::from)
    };
    programs.filter_map(|path| name(&path)).collect()
}

#[test]
fn every_program_is_run() {
    let manifest = fs::read_to_string(runtime().join("Cargo.toml")).expect("a manifest");
    for (kind, folder) in [("example", "examples"), ("bench", "benches")] {
        let heading = format!("[[{kind}]]\n");
        let sections = manifest.split(&heading).skip(1);
        let run: BTreeSet<String> = sections
            .map(|section| section.split("\n[").next().unwrap_or(section))
            .filter(|section| section.lines().any(|line| line == "test = true"))
            .filter_map(|section| section.lines().next())
            .map(|line| {
                line.trim_start_matches("name = ")
                    .trim_matches('"')
                    .to_owned()
            })
            .collect();
        assert_eq!(
            run,
            programs(folder),
            "programs that `cargo test` runs, and those there are"
        );
    }
}

#[test]
fn every_example_has_a_test() {
    for name in programs("examples") {
        let path = runtime().join(format!("examples/{name}.rs"));
        let program = fs::read_to_string(path).expect("a program");
        let tests = ["\n#[test]\nfn it_runs() {\n", "\n#[cfg_attr(test, test)]\n"];
        assert!(
            tests.iter().any(|test| program.contains(test)),
            "{name} has no test"
        );
    }
}

#[test]
fn every_program_is_listed() {
    let list = fs::read_to_string(runtime().join("examples/README.md")).expect("a list");
    assert!(programs("examples").len() >= 7);
    for (folder, prefix) in [("examples", ""), ("benches", "../benches/")] {
        for name in programs(folder) {
            let link = format!("[{name}]({prefix}{name}.rs)");
            assert!(list.contains(&link), "{link} is not in the list");
        }
    }
}
