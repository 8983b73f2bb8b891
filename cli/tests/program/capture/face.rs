//! A synthetic face that moves by known motions and expressions.

use std::fmt::Write;
use std::path::Path;
use std::process::Output;

use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_success, nullcone};

const RINGS: usize = 23;
const COLUMNS: usize = 36;

/// The vertices of a face: an ellipsoid whose poles are at the top and the bottom of the head.
pub(super) fn vertices() -> Vec<[f64; 3]> {
    let mut places = Vec::new();
    for ring in 0..=RINGS + 1 {
        let count = if ring % (RINGS + 1) == 0 { 1 } else { COLUMNS };
        for column in 0..count {
            let (s, c) = (std::f64::consts::PI * ring as f64 / (RINGS + 1) as f64).sin_cos();
            let (sine, cosine) =
                (2.0 * std::f64::consts::PI * column as f64 / COLUMNS as f64).sin_cos();
            places.push([0.075 * s * sine, 0.11 * c, 0.095 * s * cosine]);
        }
    }
    places
}

pub(super) fn obj(vertices: &[[f64; 3]]) -> String {
    let mut text = String::new();
    for [x, y, z] in vertices {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    // Vertices count from 1.
    let at = |ring: usize, column: usize| match ring {
        0 => 1,
        ring if ring > RINGS => 2 + RINGS * COLUMNS,
        ring => 2 + (ring - 1) * COLUMNS + column % COLUMNS,
    };
    for ring in 0..=RINGS {
        for column in 0..COLUMNS {
            let [a, b] = [at(ring, column), at(ring, column + 1)];
            let [c, d] = [at(ring + 1, column), at(ring + 1, column + 1)];
            if ring < RINGS {
                writeln!(text, "f {a} {c} {d}").unwrap();
            }
            if ring > 0 {
                writeln!(text, "f {a} {d} {b}").unwrap();
            }
        }
    }
    text
}

/// The vertex in this ring and column, from 0. Column 0 is the middle of the face.
pub(super) fn vertex(ring: usize, column: usize) -> usize {
    1 + (ring - 1) * COLUMNS + column
}

pub(super) const NAMES: [&str; 8] = [
    "brow", "nose", "left", "right", "chin", "lip", "corner", "nape",
];

pub(super) fn keys() -> [usize; 8] {
    [
        vertex(6, 0),
        vertex(10, 0),
        vertex(10, 9),
        vertex(10, 27),
        vertex(20, 0),
        vertex(16, 0),
        vertex(15, 4),
        vertex(12, 18),
    ]
}

/// The rotation by an angle about y, then a translation.
pub(super) fn moved([x, y, z]: [f64; 3], angle: f64, by: [f64; 3]) -> [f64; 3] {
    let (s, c) = angle.sin_cos();
    [c * x + s * z + by[0], y + by[1], c * z - s * x + by[2]]
}

pub(super) const FRAMES: usize = 5;

/// The pose of a frame: angle and translation.
pub(super) fn pose(frame: usize) -> (f64, [f64; 3]) {
    let t = frame as f64;
    (0.2 * t, [0.01 * t, 1.6 * t.min(1.0), -0.05 * t])
}

/// How far the expression has gone in a frame.
pub(super) fn strength(frame: usize) -> f64 {
    [0.0, 0.25, 1.0, 0.5, 0.0][frame]
}

/// The displacement of each point where the expression is strongest.
pub(super) fn expression(name: &str) -> [f64; 3] {
    match name {
        "chin" => [0.0, -0.012, 0.0],
        "lip" => [0.0, -0.006, 0.002],
        "corner" => [0.004, 0.003, -0.001],
        _ => [0.0; 3],
    }
}

/// The points of a frame.
pub(super) fn seen(frame: usize) -> Vec<[f64; 3]> {
    let rest = vertices();
    let (angle, by) = pose(frame);
    let place = |(name, vertex): (&&str, usize)| {
        let d = expression(name).map(|d| d * strength(frame));
        let place = std::array::from_fn(|k| rest[vertex][k] + d[k]);
        moved(place, angle, by)
    };
    NAMES.iter().zip(keys()).map(place).collect()
}

pub(super) fn table(mut change: impl FnMut(usize, usize, [f64; 3]) -> String) -> String {
    let columns = |name: &&str| format!("{name}_x,{name}_y,{name}_z");
    let header: Vec<_> = NAMES.iter().map(columns).collect();
    let mut lines = format!("frame,{}\n", header.join(","));
    for frame in 0..FRAMES {
        let places = seen(frame).into_iter().enumerate();
        let fields: Vec<_> = places
            .map(|(point, place)| change(frame, point, place))
            .collect();
        writeln!(lines, "f{frame},{}", fields.join(",")).unwrap();
    }
    lines
}

pub(super) fn plain(_: usize, _: usize, [x, y, z]: [f64; 3]) -> String {
    format!("{x},{y},{z}")
}

/// A folder with the points, the face and the places of the points on it.
pub(super) fn folder(points: &str) -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("points.csv", points);
    write("face.obj", &obj(&vertices()));
    let rows: String = NAMES
        .iter()
        .zip(keys())
        .map(|(name, k)| format!("{name},{k}\n"))
        .collect();
    write("keys.csv", &format!("point,vertex\n{rows}"));
    folder
}

pub(super) const CALIBRATED: [&str; 2] = ["--calibrated", "brow,nose,left,right,nape"];

pub(super) fn capture(folder: &Path, arguments: &str) -> Output {
    let arguments: Vec<_> = arguments.split_whitespace().collect();
    let start = [&["capture", "points.csv"], &CALIBRATED[..]].concat();
    nullcone(folder, [start, arguments].concat())
}

pub(super) fn json(output: &Output) -> Value {
    assert_success(output);
    serde_json::from_slice(&output.stdout).unwrap()
}

#[track_caller]
pub(super) fn assert_near(found: &Value, expected: &[f64], tolerance: f64) {
    let found: Vec<_> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect();
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < tolerance, "{found:?} {expected:?}");
    }
}

pub(super) fn rows(folder: &Path, name: &str) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(folder.join(name)).unwrap();
    let fields = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(fields).collect()
}
