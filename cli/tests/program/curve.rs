//! `nullcone curve`: what it writes, and how it tells what is wrong.

use std::path::Path;

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, text};

/// The natural spline of its first channel is (3t − t³)/2 and the mirror image of that.
const TENT: &str = "time,height,other\n0,0,1\n1,1,-1\n\n2,0,1\n";

fn run(folder: &Path, arguments: &[&str]) -> std::process::Output {
    nullcone(folder, ["curve"].iter().chain(arguments))
}

/// The numbers of a table below its names.
fn numbers(csv: &str) -> Vec<Vec<f64>> {
    let rows = csv.lines().skip(1);
    rows.map(|row| row.split(',').map(|x| x.parse().unwrap()).collect())
        .collect()
}

#[test]
fn rows_at_equal_steps() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("keys.csv"), TENT).unwrap();
    let output = run(
        folder.path(),
        &[
            "keys.csv",
            "--ends",
            "natural",
            "--samples",
            "5",
            "--out",
            "curve.csv",
        ],
    );
    assert_success(&output);
    assert_eq!(text(&output.stdout), "wrote curve.csv: 5 rows\n");
    let written = std::fs::read_to_string(folder.path().join("curve.csv")).unwrap();
    assert_eq!(
        written,
        "time,height,other\n0.0,0.0,1.0\n0.5,0.6875,-0.375\n1.0,1.0,-1.0\n1.5,0.6875,-0.375\n\
         2.0,0.0,1.0\n"
    );
    // The other ends of the same keys, at half a second.
    for (ends, height) in [
        // y″ = −2: the parabola through three keys.
        ("not-a-knot", 0.75),
        ("clamped", 0.5),
        ("slopes:2,-2", 0.75),
        ("slopes:3,0,-3,0", 0.875),
        ("periodic", 0.5),
    ] {
        let arguments = [
            "keys.csv",
            "--ends",
            ends,
            "--samples",
            "5",
            "--out",
            "curve.csv",
        ];
        assert_success(&run(folder.path(), &arguments));
        let written = std::fs::read_to_string(folder.path().join("curve.csv")).unwrap();
        let found = numbers(&written)[1][1];
        assert!((found - height).abs() < 1e-15, "{ends}: {found}");
    }
}

#[test]
fn vertices_within_a_tolerance() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("keys.csv"), TENT).unwrap();
    let report = |more: &[&str]| -> Value {
        let basic = [
            "keys.csv",
            "--tolerance",
            "0.001",
            "--json",
            "--out",
            "curve.csv",
        ];
        let output = run(folder.path(), &[&basic, more].concat());
        assert_success(&output);
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let path = report(&[]);
    assert_eq!(path["distance"], "geometric");
    assert_eq!(
        (&path["keys"], &path["channels"][1]),
        (&3.into(), &"other".into())
    );
    let timed = report(&["--distance", "equal-time"]);
    let rows = numbers(&std::fs::read_to_string(folder.path().join("curve.csv")).unwrap());
    assert_eq!(rows.len() as u64, timed["rows"].as_u64().unwrap());
    assert!(timed["rows"].as_u64() > path["rows"].as_u64());
    assert!(timed["max_deviation"].as_f64().unwrap() <= 0.001);
    let curve = |t: f64| (3.0 * t - t.powi(3)) / 2.0;
    for pair in rows.windows(2) {
        for step in 0..=20 {
            let part = f64::from(step) / 20.0;
            let [t, y] = [0, 1].map(|k| pair[0][k] + part * (pair[1][k] - pair[0][k]));
            assert!((curve(t.min(2.0 - t)) - y).abs() <= 0.001);
        }
    }
}

#[test]
fn a_picture_names_the_channels() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("keys.csv"), TENT).unwrap();
    let arguments = ["keys.csv", "--tolerance", "0.01", "--plot", "curve.svg"];
    let output = run(folder.path(), &arguments);
    assert_success(&output);
    assert_eq!(text(&output.stdout), "wrote curve.svg\n");
    let svg = std::fs::read_to_string(folder.path().join("curve.svg")).unwrap();
    assert!(
        svg.starts_with("<svg width=\"1000\" height=\"560\" "),
        "{}",
        &svg[..80]
    );
    for word in [
        "time",
        "height",
        "other",
        "key",
        "vertex",
        "keys.csv: cubic spline through 3 keys",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    assert!(svg.matches("<polyline").count() >= 2 && svg.matches("<circle").count() > 6);
}

#[test]
fn bad_input_leaves_nothing() {
    let folder = tempdir().unwrap();
    let fails = |table: &str, more: &[&str], parts: &[&str]| {
        std::fs::write(folder.path().join("keys.csv"), table).unwrap();
        let basic = [
            "keys.csv",
            "--out",
            "new/curve.csv",
            "--plot",
            "new/curve.svg",
        ];
        assert_failure(&run(folder.path(), &[&basic, more].concat()), parts);
        assert_eq!(names(folder.path()), ["keys.csv"]);
    };
    fails("", &[], &["keys.csv: there are no keys"]);
    fails("t,x\n", &[], &["keys.csv: there are no keys"]);
    fails(
        "t,x\n0,1\n",
        &[],
        &["1 keys, but this curve needs at least 2"],
    );
    fails(
        "t\n0\n1\n",
        &[],
        &["line 1: a column of times and at least one channel"],
    );
    fails(
        "t,x\n0,1\n1,two\n",
        &[],
        &["keys.csv: line 3, column 2 (x): \"two\""],
    );
    fails(
        "0,1\n1,NaN\n",
        &[],
        &["line 2, column 2 (channel 1): \"NaN\" is not a finite number"],
    );
    fails("t,x\n0,1\n1,inf\n", &[], &["line 3, column 2 (x): \"inf\""]);
    fails(
        "t,x\n0,1\n\n1,2\n1,3\n",
        &[],
        &["line 5, column 1 (t): key 2 at 1 is not after"],
    );
    fails(
        "t,x\n0,1\n1,2,3\n",
        &[],
        &["line 3: 3 columns, but line 1 has 2"],
    );
    fails(
        "t,x\n0,1e308\n1e-9,-1e308\n",
        &[],
        &["line 2, column 2 (x)", "beyond the range"],
    );
    fails(
        "t,x\n0,1\n1,2\n",
        &["--ends", "periodic"],
        &["line 3, column 2 (x)", "at 1, not at 2"],
    );
    fails(
        "t,x\n0,1\n1,2\n",
        &["--ends", "slopes:1,2,3,4"],
        &["4 slopes"],
    );
    fails("t,x\n0,1\n1,2\n", &["--samples", "1"], &["--samples 1"]);
    fails("t,x\n0,1\n1,2\n", &["--tolerance", "0"], &["--tolerance 0"]);
    fails(
        "t,x\n0,1\n1,2\n",
        &["--tolerance", "nan"],
        &["--tolerance NaN"],
    );
    fails(
        "t,x\n0,1\n1,2\n",
        &["--tolerance", "1e-18"],
        &["keys.csv: a tolerance of", "is below"],
    );
    let output = run(folder.path(), &["nowhere.csv", "--out", "new/curve.csv"]);
    assert_failure(&output, &["cannot read nowhere.csv: "]);
    let output = run(folder.path(), &["keys.csv", "--plot", "curve.png"]);
    assert_failure(&output, &["--plot curve.png: its name must end in .svg"]);
    // Of two results that one call writes, none stays where the other cannot be written.
    for results in [
        ["--plot", "curve.svg", "--out", "keys.csv/curve.csv"],
        ["--plot", "keys.csv/curve.svg", "--out", "curve.csv"],
    ] {
        let output = run(folder.path(), &[&["keys.csv"], &results[..]].concat());
        assert_failure(&output, &["cannot write keys.csv/curve."]);
        assert_eq!(names(folder.path()), ["keys.csv"]);
    }
    let output = run(folder.path(), &["keys.csv", "--ends", "square", "--json"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("expected natural, clamped, slopes:A,B"));
    assert_eq!(names(folder.path()), ["keys.csv"]);
}
