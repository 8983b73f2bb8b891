//! The comfort of films in parts.

use std::path::Path;

use proptest::prelude::*;
use tempfile::tempdir;

use super::{divisions, few_cases, run, write_views};

const FRAMES: usize = 7;

/// What the program writes of a film: lines for each frame, the page, the summary and the table.
fn outputs(folder: &Path, command: &str, last: [&str; 2]) -> Vec<Vec<u8>> {
    let lines = run(
        folder,
        &format!("{command} --report p.html --json {}", last[0]),
    );
    let table = run(folder, &format!("{command} {}", last[1]));
    let files = ["p.html", "s.json"].map(|name| std::fs::read(folder.join(name)).unwrap());
    let [page, summary] = files;
    // Of parts the table is a file.
    let table = match folder.join("t.csv").exists() {
        true => std::fs::read(folder.join("t.csv")).unwrap(),
        false => table,
    };
    vec![lines, page, summary, table]
}

fn compare(folder: &Path, command: &str, parts: &[[usize; 2]]) {
    let whole = outputs(folder, command, ["--summary s.json", "--csv"]);
    assert_eq!(
        whole[0].iter().filter(|byte| **byte == b'\n').count(),
        FRAMES
    );
    let names: Vec<String> = (0..parts.len())
        .map(|part| format!("{part}.json"))
        .collect();
    for ([first, end], name) in parts.iter().zip(&names) {
        run(
            folder,
            &format!("{command} --frames {first}..{end} --part {name}"),
        );
    }
    let merge = format!("merge {}", names.join(" "));
    let merged = outputs(folder, &merge, ["--out s.json", "--out t.csv"]);
    for ((name, whole), merged) in ["lines", "page", "summary", "table"]
        .iter()
        .zip(&whole)
        .zip(&merged)
    {
        assert!(whole == merged, "{name}: {parts:?}");
    }
}

proptest! {
    #![proptest_config(few_cases())]

    #[test]
    fn comfort_in_parts_is_the_comfort(parts in divisions(FRAMES)) {
        let folder = tempdir().unwrap();
        write_views(folder.path(), FRAMES);
        compare(folder.path(), "video comfort left.y4m right.y4m --screen-inches 50", &parts);
    }
}

#[test]
fn a_film_that_has_changed_is_refused() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    write_views(folder, 3);
    run(
        folder,
        "video comfort left.y4m right.y4m --frames 0..2 --part 0.json",
    );
    run(
        folder,
        "video comfort left.y4m right.y4m --frames 2..9 --part 1.json",
    );
    run(folder, "merge 0.json 1.json --out s.json");
    std::fs::copy(folder.join("left.y4m"), folder.join("right.y4m")).unwrap();
    let output = crate::common::nullcone(folder, ["merge", "0.json", "1.json", "--out", "t.csv"]);
    crate::common::assert_failure(&output, &["right.y4m", "has changed"]);
}
