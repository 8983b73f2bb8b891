//! `docs/paper.md`, the paper in code: all of the paper is on it, and all that it names exists.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::sources::Sources;
use crate::{crates, links, prose, root};

/// The sections with methods and results.
const SECTIONS: [&str; 17] = [
    "2.1.1", "2.1.2", "2.1.3", "2.1.4", "2.2.1", "2.2.2", "2.3.1", "2.3.2", "2.3.3", "3.1.1",
    "3.1.2", "3.2", "3.3.1", "3.3.2", "3.4.1", "3.4.2", "3.4.3",
];

/// A row of a table of the page.
struct Row {
    paper: String,
    files: Vec<PathBuf>,
    names: Vec<String>,
    commands: String,
    holds: String,
}

fn page() -> PathBuf {
    root().join("docs/paper.md")
}

fn rows() -> Vec<Row> {
    let text = prose(&page());
    let lines = text.lines().filter(|line| line.starts_with("| "));
    let rows: Vec<Row> = lines
        .filter(|line| !line.starts_with("| paper ") && !line.starts_with("| --- "))
        .map(|line| {
            let cells: Vec<&str> = line.trim_matches(['|', ' ']).split(" | ").collect();
            let [paper, _, file, names, commands, holds] = cells[..] else {
                panic!("{} cells: {line}", cells.len());
            };
            let files = links(file).map(|link| root().join(link.trim_start_matches("../")));
            Row {
                paper: paper.to_owned(),
                files: files.collect(),
                names: code(names).map(str::to_owned).collect(),
                commands: commands.to_owned(),
                holds: holds.to_owned(),
            }
        })
        .collect();
    assert!(rows.len() > 50, "{} rows", rows.len());
    rows
}

/// The parts of a text between backticks.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

/// The numbers of a list such as `18–20, 22`, also `3 and 4` and `18 to 22`, up to the first word
/// that does not belong to it.
fn numbers(list: &str) -> BTreeSet<u32> {
    let apart = list.replace('–', " to ").replace(',', " ");
    let words = apart
        .split_whitespace()
        .map(|word| word.trim_end_matches([')', '.', ';', ':']));
    let (mut found, mut is_range) = (BTreeSet::new(), false);
    for word in words {
        match word.parse::<u32>() {
            Ok(number) => {
                let start = found
                    .last()
                    .filter(|_| is_range)
                    .map_or(number, |last| last + 1);
                found.extend(start..=number);
                is_range = false;
            }
            Err(_) if word == "to" => is_range = true,
            Err(_) if word == "and" => {}
            Err(_) => break,
        }
    }
    found
}

/// The numbers after a word or its plural, such as `eq.` and `eqs.`, wherever it is in a text.
fn numbered(text: &str, word: &str) -> BTreeSet<u32> {
    let plural = format!("{word}s");
    let places = [word, &plural].into_iter().flat_map(|word| {
        let dotted = format!("{word}. ");
        let plain = format!("{word} ");
        let after = |pattern: String| {
            let ends = text
                .match_indices(&pattern)
                .map(|(at, _)| at + pattern.len());
            ends.collect::<Vec<_>>()
        };
        [after(dotted), after(plain)].concat()
    });
    places.flat_map(|start| numbers(&text[start..])).collect()
}

/// A file without the marks of comments and line ends, in which a citation may be on two lines.
fn words_of(file: &Path) -> String {
    let text = fs::read_to_string(file).expect("a file");
    let lines = text
        .lines()
        .map(|line| line.trim_start().trim_start_matches(['/', '!']));
    let words: Vec<&str> = lines.flat_map(str::split_whitespace).collect();
    words.join(" ")
}

#[test]
fn nothing_of_the_paper_is_left_out() {
    let text = prose(&page());
    let headings = text.lines().filter_map(|line| line.strip_prefix("## "));
    let sections: Vec<&str> = headings.filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(sections, SECTIONS);
    let rows = rows();
    for (word, last) in [("eq", 33), ("fig", 12), ("table", 6)] {
        let found: BTreeSet<u32> = rows
            .iter()
            .flat_map(|row| numbered(&row.paper, word))
            .collect();
        assert_eq!(found, (1..=last).collect(), "{word}");
    }
}

/// Each name is a public item of a file beside it, and each file has one of the names.
#[test]
fn names_are_public_items_of_the_files_beside_them() {
    let sources = Sources::new(&crates());
    for row in rows() {
        assert!(
            !row.files.is_empty() && !row.names.is_empty(),
            "{}",
            row.paper
        );
        let mut used = BTreeSet::new();
        for name in &row.names {
            let defining = sources.defining(name, &row.files);
            let beside: Vec<&PathBuf> = defining
                .iter()
                .filter(|file| row.files.contains(file))
                .collect();
            assert!(
                !beside.is_empty(),
                "{}: {name} is not in {:?}, but in {defining:?}",
                row.paper,
                row.files
            );
            used.extend(beside.into_iter().cloned());
        }
        let all: BTreeSet<PathBuf> = row.files.iter().cloned().collect();
        assert_eq!(used, all, "{}", row.paper);
    }
    for missing in [
        "ga_anim::leg::Leg::kick",
        "ga_anim::curve::spline::SplineSystem",
        "ga_anim::distance::distance_weights",
        "ga_runtime::cga3::Ellipsoid",
        "ga_video::keyframe::layout::GRID",
    ] {
        let files =
            ["anim/src/leg/mod.rs", "anim/src/curve/spline.rs"].map(|file| root().join(file));
        assert!(sources.defining(missing, &files).is_empty(), "{missing}");
    }
}

/// The documentation in the file of each equation says which one it is.
#[test]
fn equations_are_cited_where_they_are() {
    let mut count = 0;
    for row in rows() {
        let equations = numbered(&row.paper, "eq");
        let cited: BTreeSet<u32> = row
            .files
            .iter()
            .flat_map(|file| {
                let text = words_of(file);
                let citations = text.match_indices("Cui, ").map(|(at, _)| at);
                let numbers = citations.flat_map(|at| {
                    let rest = &text[at + "Cui, ".len()..];
                    let (word, list) = rest.split_once(' ').unwrap_or_default();
                    let is_equation = word.starts_with("eq");
                    numbers(if is_equation { list } else { "" })
                });
                numbers.collect::<Vec<_>>()
            })
            .collect();
        let missing: Vec<&u32> = equations.difference(&cited).collect();
        assert!(
            missing.is_empty(),
            "{:?} does not cite {missing:?}",
            row.files
        );
        count += equations.len();
    }
    assert!(count >= 33, "{count} equations");
}

/// The commands of the program, each with its group before it.
fn commands() -> BTreeSet<String> {
    let source = root().join("cli/src");
    let files = fs::read_dir(&source).expect("a folder");
    let texts = files.map(|entry| entry.expect("an entry").path());
    let texts = texts.filter(|path| path.is_file());
    let texts = texts.map(|path| fs::read_to_string(path).expect("a file"));
    let opened = "#[derive(Subcommand)]";
    let list = texts.filter_map(|text| Some(text.split_once(opened)?.1.to_owned()));
    let list: Vec<String> = list.collect();
    let [list] = &list[..] else {
        panic!("{} lists of commands", list.len());
    };
    let list = list.split_once("\n}").expect("the end of the commands").0;
    let mut found = BTreeSet::new();
    for line in list.lines() {
        let Some((name, _)) = line
            .trim()
            .split_once('(')
            .filter(|(_, rest)| rest.ends_with("::Arguments),"))
        else {
            continue;
        };
        let group = name.to_lowercase();
        let file = source.join("commands").join(&group).join("mod.rs");
        let text = fs::read_to_string(file).unwrap_or_default();
        let inner = text.lines().filter_map(|line| {
            let (name, arguments) = line.trim().split_once(": ")?;
            let is_command = arguments.ends_with("::Arguments,") && line.starts_with("    ");
            is_command.then(|| format!("{group} {}", dashed(name)))
        });
        let inner: Vec<String> = match text.contains("\ngroup! {") {
            true => inner.collect(),
            false => vec![group.clone()],
        };
        found.extend(inner);
    }
    assert!(found.len() > 30, "{found:?}");
    found
}

/// The name of a command: `CalibrateRig` is `calibrate-rig`.
fn dashed(name: &str) -> String {
    let mut dashed = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !dashed.is_empty() {
            dashed.push('-');
        }
        dashed.extend(letter.to_lowercase());
    }
    dashed
}

/// All sources of the program below a folder.
fn sources_below(folder: &Path, text: &mut String) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources_below(&path, text);
        } else {
            text.push_str(&fs::read_to_string(path).expect("a file"));
        }
    }
}

#[test]
fn commands_are_those_of_the_program() {
    let known = commands();
    let mut program = String::new();
    sources_below(&root().join("cli/src"), &mut program);
    let mut named = BTreeSet::new();
    for row in rows() {
        let given: Vec<&str> = code(&row.commands).collect();
        assert!(!given.is_empty() || row.commands == "none", "{}", row.paper);
        for line in given {
            let words = line.strip_prefix("nullcone ").expect("a command");
            let (options, words): (Vec<&str>, Vec<&str>) =
                words.split(' ').partition(|word| word.starts_with("--"));
            let command = words.join(" ");
            assert!(known.contains(&command), "{}: {line}", row.paper);
            for option in options {
                let field = option.trim_start_matches('-').replace('-', "_");
                let is_field = program.contains(&format!(" {field}: "));
                assert!(is_field, "{}: {line} has no {option}", row.paper);
            }
            named.insert(command);
        }
    }
    assert!(named.len() > 20, "{named:?}");
}

/// Times are those of the results, which are measured anew.
#[test]
fn times_are_those_of_the_results() {
    let results = prose(&root().join("benches/RESULTS.md"));
    let times: BTreeSet<&str> = results
        .lines()
        .flat_map(|line| line.split(" | ").skip(2).step_by(2).take(2))
        .collect();
    let mut count = 0;
    for row in rows() {
        let words: Vec<&str> = row.holds.split([' ', '[', ']']).collect();
        for pair in words.windows(2).filter(|pair| pair[1] == "ns") {
            count += 1;
            assert!(times.contains(pair[0]), "{}", row.holds);
        }
    }
    assert!(count > 4, "{count} times");
}

#[test]
fn lists_of_numbers_are_read() {
    let read = |text: &str| numbers(text).into_iter().collect::<Vec<_>>();
    assert_eq!(read("18–20, 22, fig. 4"), [18, 19, 20, 22]);
    assert_eq!(read("3 and 4). A number"), [3, 4]);
    assert_eq!(read("18 to 22, `(sin"), [18, 19, 20, 21, 22]);
    let found: Vec<u32> = numbered("eqs. 14–16, fig. 3", "eq").into_iter().collect();
    assert_eq!(found, [14, 15, 16]);
    assert_eq!(numbered("figs. 7, 8", "fig").len(), 2);
}
