//! `nullcone stereo`: disparities of two views, and how far they are from the truth.

use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number, text};

/// The bytes of a PFM file with these numbers, whose first is that of the top left pixel.
fn pfm(width: usize, values: &[f32]) -> Vec<u8> {
    let mut bytes = format!("Pf\n{width} {}\n-1.0\n", values.len() / width).into_bytes();
    let rows = values.chunks(width).rev().flatten();
    bytes.extend(rows.flat_map(|value| value.to_le_bytes()));
    bytes
}

/// A map of six pixels, and truths as PFM and as PGM with four times the disparity.
fn maps() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("d.pfm", &pfm(3, &[5.0, 5.0, 5.0, f32::INFINITY, 5.0, 5.0]));
    write(
        "truth.pfm",
        &pfm(3, &[4.5, 7.0, 8.25, 5.0, 0.0, f32::INFINITY]),
    );
    write("truth.pgm", b"P5 3 2 255\n\x12\x1c\x21\x14\0\0");
    folder
}

#[test]
fn evaluate_prints_the_measures() {
    let folder = maps();
    for truth in [&["truth.pfm"][..], &["truth.pgm", "--scale", "4"]] {
        let arguments = [&["stereo", "evaluate", "d.pfm", "--json"], truth].concat();
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        for (key, expected) in [
            ("/bad_0_5", 75.0),
            ("/bad_1", 75.0),
            ("/bad_2", 50.0),
            ("/bad_3", 50.0),
            ("/average_px", (0.5 + 2.0 + 3.25) / 3.0),
            ("/density", 75.0),
            ("/truth_pixels", 4.0),
        ] {
            assert_eq!(number(&report, key), expected, "{key}");
        }
    }
    let output = nullcone(folder.path(), ["stereo", "evaluate", "d.pfm", "truth.pfm"]);
    assert_success(&output);
    let table = text(&output.stdout);
    assert!(table.contains("bad 2      50.000 %\n"), "{table}");
    assert!(table.contains("75.000 % of 4 pixels with truth"), "{table}");
}

#[test]
fn evaluate_draws_map_truth_and_errors() {
    let folder = maps();
    let arguments = [
        "stereo",
        "evaluate",
        "d.pfm",
        "truth.pfm",
        "--picture",
        "new/e.png",
        "-q",
    ];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    assert!(output.stdout.is_empty());
    let picture = image::open(folder.path().join("new/e.png"))
        .unwrap()
        .to_rgb8();
    assert!(picture.width() > 900 && picture.height() > 60);
}

#[test]
fn evaluate_says_what_is_wrong() {
    let folder = maps();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("wide.pfm", &pfm(6, &[1.0; 6]));
    write("zero.pfm", &pfm(3, &[0.0; 6]));
    write("short.pfm", &pfm(3, &[1.0; 6])[..30]);
    write("colour.ppm", b"P6 1 1 255\nabc");
    write("text.pfm", b"five");
    let before = names(folder.path());
    for (arguments, parts) in [
        (
            &["nowhere.pfm", "truth.pfm"][..],
            &["cannot read nowhere.pfm: "][..],
        ),
        (&["d.pfm", "nowhere.png"], &["cannot read nowhere.png: "]),
        (&["text.pfm", "truth.pfm"], &["text.pfm: PFM"]),
        (&["truth.pgm", "truth.pfm"], &["truth.pgm: PFM"]),
        (
            &["short.pfm", "truth.pfm"],
            &["short.pfm: PFM", "3 × 2 pixels"],
        ),
        (&["d.pfm", "colour.ppm"], &["colour.ppm: ", "8-bit RGB"]),
        (&["d.pfm", "text.pfm"], &["text.pfm: not a picture"]),
        (
            &["d.pfm", "wide.pfm"],
            &["d.pfm and wide.pfm: ", "3 × 2 and 6 × 1"],
        ),
        (&["d.pfm", "zero.pfm"], &["d.pfm and zero.pfm: ", "not 0"]),
        (&["d.pfm", "truth.pfm", "--scale", "0"], &["--scale 0"]),
        (&["d.pfm", "truth.pfm", "--scale", "-4"], &["--scale -4"]),
        (&["d.pfm", "truth.pfm", "--scale", "nan"], &["--scale NaN"]),
        (
            &["d.pfm", "truth.pfm", "--picture", "e.pfm"],
            &["e.pfm", "png"],
        ),
    ] {
        let all = [&["stereo", "evaluate", "--picture", "e.png"], arguments].concat();
        let picture = arguments.contains(&"--picture");
        let all = if picture {
            [&["stereo", "evaluate"], arguments].concat()
        } else {
            all
        };
        assert_failure(&nullcone(folder.path(), all), parts);
        assert_eq!(names(folder.path()), before);
    }
}
