//! `nullcone stereo pose`: the motion between two views.

use std::path::Path;

use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number, text};

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// A smooth texture without a period.
fn texture(x: f64, y: f64) -> f64 {
    let mut sum = 128.0;
    for k in 1..24 {
        let k = f64::from(k);
        let (angle, wave) = (2.4 * k, 0.09 + 0.019 * k);
        sum += 14.0 * (wave * (x * angle.cos() + y * angle.sin()) + 1.7 * k * k).sin();
    }
    sum.round().clamp(0.0, 255.0)
}

fn pgm(value: impl Fn(usize, usize) -> f64) -> Vec<u8> {
    let mut bytes = format!("P5 {WIDTH} {HEIGHT} 255\n").into_bytes();
    for row in 0..HEIGHT {
        bytes.extend((0..WIDTH).map(|column| value(column, row) as u8));
    }
    bytes
}

/// Shelves at six depths, seen from two places side by side: each band of rows has a disparity.
fn views() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("a.pgm", &pgm(|u, v| texture(u as f64, v as f64)));
    let disparity = |v: usize| 4.0 + 3.0 * (v / 40) as f64;
    write(
        "b.pgm",
        &pgm(|u, v| texture(u as f64 + disparity(v), v as f64)),
    );
    write("grey.pgm", &pgm(|_, _| 90.0));
    let camera =
        |cx: f64| format!("%YAML:1.0\n---\nK: [[300, 0, {cx}], [0, 300, 119.5], [0, 0, 1]]\n");
    write("k.yml", camera(159.5).as_bytes());
    folder
}

fn pose(folder: &Path, arguments: &[&str]) -> std::process::Output {
    nullcone(folder, [&["stereo", "pose"], arguments].concat())
}

#[test]
fn a_step_to_the_right_is_a_translation_to_the_left() {
    let folder = views();
    let arguments = ["a.pgm", "b.pgm", "--camera", "k.yml", "--json"];
    let output = pose(folder.path(), &arguments);
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(number(&report, "/rotation_degrees") < 0.1, "{report}");
    assert!(
        number(&report, "/translation_direction/0") < -0.999,
        "{report}"
    );
    for k in 0..3 {
        assert!(number(&report, &format!("/rotation_matrix/{k}/{k}")) > 0.9999);
    }
    let (pairs, inliers) = (number(&report, "/pairs"), number(&report, "/inliers"));
    assert!(inliers > 50.0 && inliers <= pairs, "{report}");
    assert!(number(&report, "/rms_px") < 0.5 && number(&report, "/in_front") > 0.5 * inliers);
    // The same seed gives the same result, and the second camera may be named.
    let again = pose(
        folder.path(),
        &[&arguments[..], &["--camera-b", "k.yml", "--seed", "1"]].concat(),
    );
    let again: Value = serde_json::from_slice(&again.stdout).unwrap();
    assert_eq!(report["rotation_matrix"], again["rotation_matrix"]);
    assert_eq!(
        report["translation_direction"],
        again["translation_direction"]
    );
    let lines = pose(folder.path(), &arguments[..4]);
    assert_success(&lines);
    assert!(
        text(&lines.stdout).contains("translation along (-"),
        "{}",
        text(&lines.stdout)
    );
    assert_eq!(
        names(folder.path()),
        ["a.pgm", "b.pgm", "grey.pgm", "k.yml"]
    );
}

#[test]
fn views_that_show_no_motion_are_refused() {
    let folder = views();
    let find =
        |arguments: &[&str]| pose(folder.path(), &[arguments, &["--camera", "k.yml"]].concat());
    assert_failure(&find(&["a.pgm", "a.pgm"]), &["a.pgm", "rotation alone"]);
    assert_failure(
        &find(&["a.pgm", "grey.pgm"]),
        &["grey.pgm", "6 pairs of pixels are needed"],
    );
    assert_failure(&find(&["a.pgm", "c.pgm"]), &["c.pgm"]);
    assert_failure(
        &find(&["a.pgm", "b.pgm", "--threshold", "0"]),
        &["--threshold"],
    );
    let output = pose(folder.path(), &["a.pgm", "b.pgm", "--camera", "a.pgm"]);
    assert_failure(&output, &["a.pgm"]);
    let other = "%YAML:1.0\n---\nimage_width: 100\nimage_height: 90\n\
                 K: [[300, 0, 50], [0, 300, 45], [0, 0, 1]]\n";
    std::fs::write(folder.path().join("size.yml"), other).unwrap();
    let output = pose(folder.path(), &["a.pgm", "b.pgm", "--camera", "size.yml"]);
    assert_failure(&output, &["size.yml", "320 × 240"]);
}
