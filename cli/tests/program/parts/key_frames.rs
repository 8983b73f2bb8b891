//! Key frames of films in parts.

use std::path::Path;

use proptest::prelude::*;
use tempfile::tempdir;

use super::{divisions, few_cases, run, write_film};
use crate::common::contents;

const FRAMES: usize = 20;

const FILES: [&str; 4] = ["c.svg", "s.csv", "s.edl", "sheet.png"];

/// What the program writes of a film: the values, the page, the key frames and the other files.
fn outputs(folder: &Path, command: &str) -> Vec<(String, Vec<u8>)> {
    let values = run(folder, &format!("{command} --report p.html --json"));
    let page = std::fs::read(folder.join("p.html")).unwrap();
    let keys = contents(&folder.join("keys"));
    std::fs::remove_dir_all(folder.join("keys")).unwrap();
    assert!(!keys.is_empty());
    let files = FILES.map(|name| (name.to_owned(), std::fs::read(folder.join(name)).unwrap()));
    let first = [("values".to_owned(), values), ("page".to_owned(), page)];
    first.into_iter().chain(keys).chain(files).collect()
}

proptest! {
    #![proptest_config(few_cases())]

    #[test]
    fn key_frames_in_parts_are_the_key_frames(parts in divisions(FRAMES)) {
        let folder = tempdir().unwrap();
        let folder = folder.path();
        // Another scene in the second half.
        let noise: Vec<usize> = (0..FRAMES).map(|frame| if frame < 11 { 0 } else { 20 }).collect();
        write_film(&folder.join("a.y4m"), [96, 64], &noise);
        let command = "video keyframes a.y4m --threshold 0.2 --start-timecode 01:00:00:00";
        let whole = outputs(folder, &format!(
            "{command} --out keys --plot c.svg --scenes s.csv --scenes s.edl --contact-sheet sheet.png"
        ));
        let names: Vec<String> = (0..parts.len()).map(|part| format!("{part}.json")).collect();
        for ([first, end], name) in parts.iter().zip(&names) {
            run(folder, &format!("{command} --frames {first}..{end} --part {name}"));
        }
        let merge = format!(
            "merge {} --out keys --out c.svg --out s.csv --out s.edl --out sheet.png --out v.json",
            names.join(" ")
        );
        let merged = outputs(folder, &merge);
        prop_assert_eq!(whole.len(), merged.len());
        for (whole, merged) in whole.iter().zip(&merged) {
            prop_assert!(whole == merged, "{}: {parts:?}", whole.0);
        }
        prop_assert!(whole[0].1 == std::fs::read(folder.join("v.json")).unwrap());
    }
}
