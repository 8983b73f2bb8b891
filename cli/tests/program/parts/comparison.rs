//! Comparisons of films in parts.

use std::path::Path;

use proptest::prelude::*;
use tempfile::tempdir;

use super::{divisions, few_cases, run, write_film};

const FRAMES: usize = 8;

/// What the program writes of a comparison, in one process or of parts: the values, the table, the
/// chart and the page.
fn outputs(folder: &Path, command: &str) -> Vec<Vec<u8>> {
    let values = run(folder, &format!("{command} --report p.html --json"));
    let files = ["t.csv", "c.svg", "p.html"].map(|name| std::fs::read(folder.join(name)).unwrap());
    [values].into_iter().chain(files).collect()
}

/// Compares two films in one process and in parts.
fn compare(folder: &Path, command: &str, parts: &[[usize; 2]]) {
    let whole = outputs(folder, &format!("{command} --csv t.csv --plot c.svg"));
    let names: Vec<String> = (0..parts.len())
        .map(|part| format!("{part}.json"))
        .collect();
    for ([first, end], name) in parts.iter().zip(&names) {
        run(
            folder,
            &format!("{command} --frames {first}..{end} --part {name}"),
        );
    }
    let merge = format!(
        "merge {} --out t.csv --out c.svg --out v.json",
        names.join(" ")
    );
    let merged = outputs(folder, &merge);
    let names = ["values", "table", "chart", "page"];
    for ((name, whole), merged) in names.iter().zip(&whole).zip(&merged) {
        assert!(whole == merged, "{name}: {parts:?}");
    }
    assert!(whole[0] == std::fs::read(folder.join("v.json")).unwrap());
}

proptest! {
    #![proptest_config(few_cases())]

    /// Two frames are identical: their PSNR is infinite.
    #[test]
    fn measures_in_parts_are_the_measures(parts in divisions(FRAMES)) {
        let folder = tempdir().unwrap();
        write_film(&folder.path().join("a.y4m"), [56, 40], &[0; FRAMES]);
        write_film(&folder.path().join("b.y4m"), [56, 40], &[1, 0, 2, 3, 0, 1, 2, 5]);
        compare(folder.path(), "quality compare a.y4m b.y4m", &parts);
    }
}

#[test]
fn other_sizes_and_times_are_the_same_in_parts() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    write_film(&path("a.y4m"), [56, 40], &[0; FRAMES]);
    write_film(&path("small.y4m"), [28, 20], &[1; FRAMES]);
    compare(
        folder.path(),
        "quality compare a.y4m small.y4m --scale",
        &[[5, 8], [0, 5]],
    );
    // The same moments at another rate: the measures say in which properties the films differ.
    let bytes = std::fs::read(path("a.y4m")).unwrap();
    let text = b"F25:1";
    let place = bytes.windows(5).position(|found| found == text).unwrap();
    let slower = [&bytes[..place], b"F24:1", &bytes[place + 5..]].concat();
    std::fs::write(path("slow.y4m"), slower).unwrap();
    compare(
        folder.path(),
        "quality compare a.y4m slow.y4m",
        &[[0, 3], [3, 8]],
    );
    let command = "quality compare a.y4m slow.y4m --align-times";
    compare(folder.path(), command, &[[0, 2], [2, 99]]);
}
