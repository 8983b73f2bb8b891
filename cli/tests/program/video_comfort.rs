//! `nullcone video comfort` and `nullcone video align`.

use std::path::Path;

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, nullcone, text};

const ROWS: [&str; 11] = [
    "brightness",
    "colour",
    "vertical",
    "asynchrony",
    "parallax_deviation",
    "stereoscopy",
    "weak_depth",
    "rich_depth",
    "over_convergence",
    "over_divergence",
    "focal_gap",
];

/// Random blocks of five pixels.
fn level(u: usize, v: usize) -> u8 {
    let block = (u / 5 + 1) * 7919 + (v / 5 + 1) * 104_729;
    (50 + block * block / 977 % 140) as u8
}

/// Random numbers on a lattice of eight pixels, and between them by interpolation.
fn smooth(u: usize, v: usize) -> u8 {
    let corner = |i: usize, j: usize| {
        let mixed = ((u / 8 + i) as u64 ^ ((v / 8 + j) as u64) << 32)
            .wrapping_add(1)
            .wrapping_mul(0x9E37_79B9_7F4A_7C15);
        ((mixed ^ (mixed >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 56) as f64
    };
    let [x, y] = [u, v].map(|place| (place % 8) as f64 / 8.0);
    let row = |j: usize| (1.0 - x) * corner(0, j) + x * corner(1, j);
    (0.7 * ((1.0 - y) * row(0) + y * row(1)) + 30.0) as u8
}

/// A view of 240 × 136 pixels that moves, lower and brighter by given amounts.
fn view(frame: usize, lower: usize, brighter: u8) -> Plane<[u8; 3]> {
    let moved = [0, 3, 8, 9, 4, 1, 2, 7][frame % 8];
    Plane::from_fn(240, 136, |column, row| {
        [level(column + 2 * moved, row + 40 - lower + moved) + brighter; 3]
    })
}

fn side_by_side(left: &Plane<[u8; 3]>, right: &Plane<[u8; 3]>) -> Plane<[u8; 3]> {
    let width = left.width();
    Plane::from_fn(2 * width, left.height(), |column, row| {
        let half = if column < width { left } else { right };
        half.row(row)[column % width]
    })
}

fn write(path: &Path, frames: usize, picture: impl Fn(usize) -> Plane<[u8; 3]>) {
    y4m::write(path, (0..frames).map(picture), Film::default()).unwrap();
}

fn lines(output: &[u8]) -> Vec<Value> {
    let text = std::str::from_utf8(output).unwrap();
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

#[test]
fn each_frame_is_a_line_with_all_rows() {
    let folder = tempdir().unwrap();
    let clip = |i| side_by_side(&view(i, 0, 0), &view(i, 3, 30));
    write(&folder.path().join("clip.y4m"), 10, clip);
    let arguments = [
        "video",
        "comfort",
        "clip.y4m",
        "--layout",
        "side-by-side",
        "--json",
        "--summary",
        "summary.json",
    ];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    let found = lines(&output.stdout);
    assert_eq!(found.len(), 10);
    for (index, line) in found.iter().enumerate() {
        assert_eq!(line["frame"], index);
        let rows = line["rows"].as_object().unwrap();
        assert_eq!(rows.len(), ROWS.len());
        for name in ROWS {
            let row = &rows[name];
            assert!(row["unit"].is_string(), "{name}");
            match row["score"].as_u64() {
                Some(score) => assert!(score <= 15 && row["raw"].is_number(), "{name}"),
                None => assert!(row["state"].is_string(), "{name}"),
            }
        }
        let close = |row: &str, key: &str, truth: f64, tolerance: f64| {
            let value = rows[row][key].as_f64().unwrap();
            assert!((value - truth).abs() < tolerance, "{row} {key} {value}");
        };
        close("vertical", "shift_px", 3.0, 0.1);
        close("vertical", "rotation_degrees", 0.0, 0.05);
        close("brightness", "offset_codes", 30.0, 1.0);
        close("parallax_deviation", "median_px", 0.0, 0.1);
        assert!(rows["brightness"]["score"].as_u64() > Some(7));
        assert!(rows["vertical"]["score"].as_u64() > Some(7));
        assert!(rows["focal_gap"].get("sharpness_log2").is_some());
        assert!(rows["asynchrony"].get("frames").is_some());
    }
    let summary = std::fs::read(folder.path().join("summary.json")).unwrap();
    let summary: Value = serde_json::from_slice(&summary).unwrap();
    assert_eq!(summary["frames"], 10);
    // 30 codes and 3 px in 136 rows are severe.
    assert_eq!(summary["verdict"], "failed");
    assert_eq!(summary["rows"]["vertical"]["frames_green"], 0);

    let one = nullcone(
        folder.path(),
        [&arguments[..6], &["--threads", "1"]].concat(),
    );
    assert_eq!(one.stdout, output.stdout);
    let table = nullcone(folder.path(), [&arguments[..5], &["--csv"]].concat());
    assert_success(&table);
    assert_eq!(text(&table.stdout).lines().count(), 11);
    let plain = nullcone(folder.path(), &arguments[..5]);
    assert!(text(&plain.stdout).contains("over convergence"));
    let checked = nullcone(folder.path(), [&arguments[..5], &["--check"]].concat());
    assert_eq!(checked.status.code(), Some(3));
    assert_eq!(checked.stdout, plain.stdout);
}

#[test]
fn two_files_are_the_same_as_two_halves() {
    let folder = tempdir().unwrap();
    write(&folder.path().join("left.y4m"), 5, |i| view(i, 0, 0));
    write(&folder.path().join("right.y4m"), 5, |i| view(i, 2, 10));
    let whole = |i| side_by_side(&view(i, 0, 0), &view(i, 2, 10));
    write(&folder.path().join("whole.y4m"), 5, whole);
    let arguments = ["video", "comfort", "left.y4m", "right.y4m", "--json"];
    let pair = nullcone(folder.path(), arguments);
    let arguments = [
        "video",
        "comfort",
        "whole.y4m",
        "--layout",
        "side-by-side",
        "--json",
    ];
    let whole = nullcone(folder.path(), arguments);
    assert_success(&pair);
    assert_eq!(pair.stdout, whole.stdout);
}

/// Two pictures are one frame, whatever other numbered pictures lie beside them.
#[test]
fn two_pictures_are_one_frame() {
    let folder = tempdir().unwrap();
    for number in 3..6 {
        for (side, lower) in [("L", 0), ("R", 2)] {
            let name = folder.path().join(format!("c{number}_{side}.png"));
            ga_image::file::write(name, &view(number, lower, 0)).unwrap();
        }
    }
    let measured = |left: &str, right: &str| {
        let arguments = ["video", "comfort", left, right, "--json"];
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        lines(&output.stdout)
    };
    let found = measured("c3_L.png", "c3_R.png");
    assert_eq!(found.len(), 1);
    let shift = &found[0]["rows"]["vertical"]["shift_px"];
    assert!((shift.as_f64().unwrap() - 2.0).abs() < 0.1, "{shift}");
    // A pattern is a row of pictures.
    assert_eq!(measured("c%d_L.png", "c%d_R.png").len(), 3);
}

/// A film of one view that begins with black frames: the frames before it is recognised have no
/// score.
#[test]
fn a_film_of_one_view_is_not_scored() {
    let folder = tempdir().unwrap();
    write(&folder.path().join("mono.y4m"), 14, |frame| {
        let share = frame.saturating_sub(4).min(6) as f64 / 6.0;
        Plane::from_fn(480, 136, |column, row| {
            [(share * f64::from(smooth(column, row))) as u8; 3]
        })
    });
    let arguments = ["video", "comfort", "mono.y4m", "--layout", "side-by-side"];
    let output = nullcone(folder.path(), arguments.iter().chain(&["--json"]));
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("shows one view"));
    let found = lines(&output.stdout);
    assert!(found.len() >= 4, "{}", found.len());
    for line in &found {
        for name in ROWS {
            let row = &line["rows"][name];
            assert!(row["score"].is_null(), "{name}: {row}");
        }
    }
}

#[test]
fn bad_input_is_named() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let clip = |i| side_by_side(&view(i, 0, 0), &view(i, 0, 0));
    write(&path("clip.y4m"), 6, clip);
    write(&path("left.y4m"), 6, |i| view(i, 0, 0));
    write(&path("short.y4m"), 4, |i| view(i, 0, 0));
    write(&path("odd.y4m"), 2, |_| Plane::filled(241, 136, [9; 3]));
    write(&path("mono.y4m"), 2, |_| {
        Plane::from_fn(480, 136, |column, row| [smooth(column, row); 3])
    });
    let mut bytes = std::fs::read(path("clip.y4m")).unwrap();
    bytes.truncate(bytes.len() - 500);
    std::fs::write(path("cut.y4m"), bytes).unwrap();
    let run = |arguments: &[&str]| {
        let all = [&["video", "comfort", "--json"], arguments].concat();
        nullcone(folder.path(), &all)
    };
    for (arguments, message, frames) in [
        (&["clip.y4m"][..], "--layout", 0),
        (&["clip.y4m", "--layout", "two-files"], "the right view", 0),
        (
            &["odd.y4m", "--layout", "side-by-side"],
            "cannot be divided",
            0,
        ),
        (&["left.y4m", "odd.y4m"], "differ in size", 0),
        (
            &["left.y4m", "short.y4m"],
            "the right video has no frame 4",
            4,
        ),
        (
            &["mono.y4m", "--layout", "side-by-side"],
            "shows one view",
            0,
        ),
        (
            &["cut.y4m", "--layout", "side-by-side"],
            "within frame 5",
            5,
        ),
        (&["none.y4m", "--layout", "side-by-side"], "none.y4m", 0),
    ] {
        let output = run(arguments);
        let error = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(
            error.starts_with("error: ") && error.contains(message),
            "{error}"
        );
        assert_eq!(lines(&output.stdout).len(), frames, "{arguments:?}");
    }
    let output = run(&[
        "clip.y4m",
        "--layout",
        "side-by-side",
        "--screen-inches",
        "0",
    ]);
    assert_failure(&output, &["0 m"]);
}

#[test]
fn aligned_video_is_green() {
    let folder = tempdir().unwrap();
    let clip = |i| side_by_side(&view(i, 0, 0), &view(i, 3, 30));
    write(&folder.path().join("clip.y4m"), 6, clip);
    let align = ["video", "align", "clip.y4m", "--out", "aligned.y4m"];
    assert_success(&nullcone(folder.path(), align));
    let arguments = [
        "video",
        "comfort",
        "aligned.y4m",
        "--layout",
        "side-by-side",
        "--json",
    ];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    let found = lines(&output.stdout);
    assert_eq!(found.len(), 6);
    for line in &found {
        for name in ["brightness", "colour", "vertical"] {
            let score = line["rows"][name]["score"].as_u64();
            assert!(score.is_some_and(|score| score <= 7), "{name} {line}");
        }
    }
    let stream = nullcone(folder.path(), ["video", "align", "-", "--out", "a.y4m"]);
    assert_failure(&stream, &["read twice"]);
}

/// Views that would be narrower than usual pictures are asked for, and squeezed ones are not.
#[test]
fn views_of_an_unusual_shape_are_asked_for() {
    let folder = tempdir().unwrap();
    let frame = Plane::from_fn(240, 136, |column, row| [level(column % 120, row); 3]);
    write(&folder.path().join("half.y4m"), 2, |_| frame.clone());
    for (layout, is_asked) in [("side-by-side", true), ("half-sbs", false)] {
        let arguments = ["video", "comfort", "half.y4m", "--layout", layout];
        let output = nullcone(folder.path(), arguments);
        assert_success(&output);
        let error = text(&output.stderr);
        assert_eq!(
            error.contains("is it half-side-by-side?"),
            is_asked,
            "{error}"
        );
        // Nothing moves, which is said in words.
        assert!(text(&output.stdout).contains("No score for delay of one eye in all 2 frames"));
    }
}
