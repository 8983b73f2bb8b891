//! Files that end too early.

use tempfile::tempdir;

use super::table::{ROWS, Row, words};
use super::{assert_orderly, for_each, inputs, limited};

/// The places of the cuts in a file of this length.
fn cuts(length: usize, most: usize) -> Vec<usize> {
    if length <= most {
        return (0..length).collect();
    }
    (0..most).map(|k| k * (length - 1) / (most - 1)).collect()
}

/// The commands that report what the frames of a film before its end show.
const REPORTING: [&str; 4] = [
    "quality compare",
    "video comfort",
    "video keyframes",
    "video statistics",
];

/// Rows with an input, and where that is cut.
type Case = (&'static Row, &'static str, usize);

/// Cuts of all inputs of a row.
fn cases(row: &'static Row, most: usize, is_taken: impl Fn(&str) -> bool) -> Vec<Case> {
    let mut cases = Vec::new();
    for input in row.inputs().into_iter().filter(|input| is_taken(input)) {
        let length = inputs::folder().join(input).metadata().unwrap().len() as usize;
        cases.extend(cuts(length, most).into_iter().map(|cut| (row, input, cut)));
    }
    cases
}

fn run(cases: &[Case]) {
    for_each(cases, |(row, input, cut)| {
        let folder = tempdir().unwrap();
        let whole = std::fs::read(inputs::folder().join(input)).unwrap();
        let name = input.rsplit('/').next().unwrap();
        std::fs::write(folder.path().join(name), &whole[..*cut]).unwrap();
        let line = row.line.replace(&format!("DATA/{input}"), name);
        let output = limited(folder.path(), &words(&line, inputs::folder(), "out"));
        let what = format!("{line}: {input} of {cut} bytes");
        assert_orderly(&output, &what);
        // Of films, what was found before the end is reported, beside the error.
        let is_film = REPORTING.iter().any(|command| line.starts_with(command));
        if output.status.code() == Some(1) && !is_film {
            assert!(!folder.path().join("out").exists(), "{what}");
        }
    });
}

/// For each kind of file the quick command that reads most of it.
#[test]
fn files_of_each_kind_may_end_anywhere() {
    let mut all = Vec::new();
    for (command, input, most) in [
        ("draw", "scene.json", 200),
        ("curve", "keys.csv", 200),
        ("mesh info", "cube.obj", 200),
        ("mesh convert DATA/cube.ply", "cube.ply", 60),
        ("clip info", "motion.bvh", 60),
        ("clip convert", "walk.clip", 60),
        ("clip retarget", "hero.glb", 60),
        ("camera convert", "rig.yml", 60),
        ("contour", "blob.png", 200),
        ("stereo evaluate", "d.pfm", 60),
        ("video keyframes", "a.y4m", 40),
        ("quality ratings", "ratings.csv", 60),
        ("video score", "found.json", 60),
        ("capture", "points.csv", 60),
        ("merge", "0.json", 60),
    ] {
        let rows = ROWS.iter().filter(|row| row.line.starts_with(command));
        let row = rows.min_by_key(|row| row.line.len()).unwrap();
        let cases = cases(row, most, |name| name == input);
        assert!(!cases.is_empty(), "{command} does not read {input}");
        all.extend(cases);
    }
    run(&all);
}

/// Empty, cut in the middle, and without the last byte.
#[test]
fn every_command_bears_inputs_that_end_too_early() {
    let rows = ROWS.iter().flat_map(|row| cases(row, 3, |_| true));
    run(&rows.collect::<Vec<_>>());
}
