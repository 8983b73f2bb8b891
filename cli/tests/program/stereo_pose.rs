//! `nullcone stereo pose`: the motion between two views.

use std::path::Path;

use ga_camera::{Intrinsics, RadialTangential};
use ga_image::file;
use ga_image::plane::Plane;
use ga_runtime::cga3::Point;
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

/// Corners outside the field of a wide lens are left out and counted.
#[test]
fn corners_whose_distortion_cannot_be_inverted_are_left_out() {
    let folder = views();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    let lens = RadialTangential::new(&[0.0, 0.0, 0.0, 0.0, -4.0]).unwrap();
    let camera = Intrinsics::new([300.0; 2], [159.5, 119.5]).unwrap();
    let wide = camera.with_lens(lens);
    // What a pinhole sees, through the lens; what lies outside its field has texture too.
    let view = |moved: bool| {
        pgm(|u, v| {
            let pixel = [u as f64, v as f64];
            let direction = wide.direction(pixel);
            let [x, y] = direction.map_or(pixel, |direction| {
                let [x, y, z] = direction.vector();
                camera.project(Point::new(x, y, z)).unwrap()
            });
            let disparity = 4.0 + 3.0 * (y / 40.0).floor();
            texture(if moved { x + disparity } else { x }, y)
        })
    };
    write("a.pgm", &view(false));
    write("b.pgm", &view(true));
    let file = "%YAML:1.0\n---\nK: [[300, 0, 159.5], [0, 300, 119.5], [0, 0, 1]]\n\
                D: [0, 0, 0, 0, -4.0]\n";
    write("wide.yml", file.as_bytes());
    let arguments = ["a.pgm", "b.pgm", "--camera", "wide.yml"];
    let output = pose(folder.path(), &[&arguments[..], &["--json"]].concat());
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let outside = number(&report, "/pairs_outside_field");
    assert!(
        outside > 0.0 && outside < 0.5 * number(&report, "/pairs"),
        "{report}"
    );
    assert!(number(&report, "/rotation_degrees") < 0.5, "{report}");
    assert!(
        number(&report, "/translation_direction/0") < -0.99,
        "{report}"
    );
    let output = pose(folder.path(), &arguments);
    assert_success(&output);
    let line = format!("{outside} pairs of corners are outside the field");
    assert!(
        text(&output.stdout).contains(&line),
        "{}",
        text(&output.stdout)
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
        &[
            "grey.pgm has too little texture: 0 corners",
            "6 pairs of pixels are needed",
        ],
    );
    assert_failure(&find(&["a.pgm", "c.pgm"]), &["c.pgm"]);
    let small = Plane::filled(90, 63, 7u8);
    file::write(folder.path().join("small.png"), &small).unwrap();
    let parts = ["small.png has 90 × 63 pixels", "at least 64 × 64"];
    assert_failure(&find(&["a.pgm", "small.png"]), &parts);
    let diagnose = ["stereo", "diagnose", "small.png", "small.png"];
    assert_failure(&nullcone(folder.path(), diagnose), &parts);
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

/// Without corners there is nothing to match: a view of one grey, and stripes, along which every
/// place looks like the next.
#[test]
fn views_with_too_little_texture_are_named() {
    let folder = views();
    let stripes = pgm(|u, _| texture(u as f64, 0.0));
    std::fs::write(folder.path().join("stripes.pgm"), stripes).unwrap();
    for (left, right, faulty) in [
        ("grey.pgm", "grey.pgm", "grey.pgm"),
        ("a.pgm", "grey.pgm", "grey.pgm"),
        ("stripes.pgm", "a.pgm", "stripes.pgm"),
    ] {
        let parts = format!("{faulty} has too little texture: 0 corners are found in it");
        let output = nullcone(folder.path(), ["stereo", "diagnose", left, right]);
        assert_failure(&output, &[&parts, "0 pairs of points are given"]);
        let output = pose(folder.path(), &[left, right, "--camera", "k.yml"]);
        assert_failure(&output, &[&parts, "6 pairs of pixels are needed"]);
    }
}

/// Two views of a plane with two motions: the camera moves towards an inclined wall. The second
/// motion follows from the first: with H = R (I + τ nᵀ) and w = τ + |τ|²/2 n, the other normal is
/// along w, and the other τ is |w| n − |τ|²/2 w/|w|; both change their signs where w points
/// backwards, since the wall is in front of the camera.
#[test]
fn a_wall_that_two_motions_explain_is_ambiguous() {
    let folder = views();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    // The wall n · x = 1, and a translation t in units of its distance, without a rotation.
    let length = (0.3_f64 * 0.3 + 0.2 * 0.2 + 1.0).sqrt();
    let n = [0.3, 0.2, 1.0].map(|x| x / length);
    let t = [0.03, -0.02, -0.2];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let wall = |u: usize, v: usize, t: [f64; 3]| {
        let ray = [(u as f64 - 159.5) / 300.0, (v as f64 - 119.5) / 300.0, 1.0];
        // A point x + t of the ray, with x on the wall.
        let depth = (1.0 + dot(n, t)) / dot(n, ray);
        texture(
            300.0 * (depth * ray[0] - t[0]),
            300.0 * (depth * ray[1] - t[1]),
        )
    };
    write("a.pgm", &pgm(|u, v| wall(u, v, [0.0; 3])));
    write("b.pgm", &pgm(|u, v| wall(u, v, t)));
    let arguments = ["a.pgm", "b.pgm", "--camera", "k.yml"];
    let output = pose(folder.path(), &[&arguments[..], &["--json"]].concat());
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["ambiguous"], true, "{report}");
    assert_eq!(
        report["alternatives"].as_array().unwrap().len(),
        1,
        "{report}"
    );
    assert_eq!(report["warnings"][0]["kind"], "ambiguous_motion");
    let square = dot(t, t);
    let w: [f64; 3] = std::array::from_fn(|k| t[k] + 0.5 * square * n[k]);
    let size = dot(w, w).sqrt();
    let size = size * w[2].signum();
    let in_left: [f64; 3] = std::array::from_fn(|k| size * n[k] - 0.5 * square * w[k] / size);
    // Its direction in the frame of the right camera is H/(1 + τ'·n') of the left one.
    let other = std::array::from_fn(|k| in_left[k] + t[k] * dot(n, in_left));
    let is_found = |expected: [f64; 3]| {
        let length = dot(expected, expected).sqrt();
        let near = |found: &Value| {
            let found = [0, 1, 2].map(|k| found[k].as_f64().unwrap());
            dot(found, expected) > 0.9995 * length
        };
        near(&report["translation_direction"]) || near(&report["alternatives"][0]["direction"])
    };
    assert!(is_found(t) && is_found(other), "{other:?} {report}");
    let output = pose(folder.path(), &arguments);
    assert!(text(&output.stdout).contains("or translation along"));
    assert!(text(&output.stderr).contains("another motion explains the views as well"));
}

/// Two views of one plane, whose second motion has a third of the points behind a camera.
#[test]
fn the_motion_with_all_points_in_front_is_taken() {
    let case = "cases/vision/pose-planar-twofold";
    let Some(path) = nullcone_shared_data::shared(case) else {
        return;
    };
    let truth = std::fs::read_to_string(path.join("truth.json")).unwrap();
    let truth: Value = serde_json::from_str(&truth).unwrap();
    let output = pose(&path, &["a.png", "b.png", "--camera", "K.yml", "--json"]);
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let cosine: f64 = (0..3)
        .map(|k| {
            let found = number(&report, &format!("/translation_direction/{k}"));
            found * number(&truth, &format!("/t_direction/{k}"))
        })
        .sum();
    // A quarter of a degree.
    assert!(cosine > 0.99999, "{report}");
    assert_eq!(report["in_front"], report["inliers"]);
    assert_eq!(report["ambiguous"], false);
}
