//! `nullcone capture`: a synthetic face that moves by known motions and expressions.

mod bad_input;
mod face;
mod surface;
mod tables;

use crate::common::{assert_success, names, nullcone, number, text};
use face::{
    FRAMES, NAMES, assert_near, capture, expression, folder, json, keys, plain, pose, rows,
    strength, table, vertices,
};

#[test]
fn pose_and_expression_are_separated() {
    let folder = folder(&table(plain));
    let output = "--out e.csv --pose pose.csv --matrix matrix.csv --json";
    let report = json(&capture(folder.path(), output));
    assert_eq!(number(&report, "/frames"), FRAMES as f64);
    assert_eq!(report["reference_frame"], "f0");
    for frame in 0..FRAMES {
        let (angle, by) = pose(frame);
        let found = &report["poses"][frame];
        assert_eq!(found["frame"], format!("f{frame}"));
        assert_near(&found["translation_metres"], &by, 1e-9);
        let (s, c) = (0.5 * angle).sin_cos();
        assert_near(&found["rotation_quaternion"], &[0.0, s, 0.0, c], 1e-9);
        assert!((number(found, "/rotation_degrees") - angle.to_degrees()).abs() < 1e-7);
        assert!(number(found, "/rms_metres") < 1e-12 && number(found, "/inliers") == 5.0);
    }
    assert_eq!(report["expression"]["max_point"], "chin");
    assert_eq!(report["expression"]["max_frame"], "f2");
    assert!((number(&report, "/expression/max_metres") - 0.012).abs() < 1e-12);
    let table = rows(folder.path(), "e.csv");
    assert_eq!(table[0][..4], ["frame", "brow_x", "brow_y", "brow_z"]);
    let poses = rows(folder.path(), "pose.csv");
    let matrix = rows(folder.path(), "matrix.csv");
    assert_eq!(matrix.len(), 1 + 4 * FRAMES);
    for frame in 0..FRAMES {
        let parse = |text: &String| text.parse::<f64>().unwrap();
        for (point, name) in NAMES.iter().enumerate() {
            for axis in 0..3 {
                let expected = expression(name)[axis] * strength(frame);
                let found = parse(&table[1 + frame][1 + 3 * point + axis]);
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{name} {found} {expected}"
                );
                // The capture matrix has the point at rest with the expression.
                let still = vertices()[keys()[point]][axis] + expected;
                let found = parse(&matrix[1 + 4 * frame + axis][2 + point]);
                assert!((found - still).abs() < 1e-12);
            }
            assert_eq!(matrix[4 + 4 * frame][2 + point], "1.0");
        }
        assert!((parse(&poses[1 + frame][2]) - pose(frame).1[1]).abs() < 1e-12);
    }
}

#[test]
fn missing_points_stay_missing() {
    // The left temple and the lip are not seen in frame 2.
    let folder = folder(&table(|frame, point, place| match (frame, NAMES[point]) {
        (2, "left" | "lip") => ",,".to_owned(),
        _ => plain(frame, point, place),
    }));
    let arguments = "--mesh face.obj --keys keys.csv --out e.csv --json";
    let report = json(&capture(folder.path(), arguments));
    assert_eq!(report["poses"][2]["missing"][0], "left");
    assert_near(&report["poses"][2]["translation_metres"], &pose(2).1, 1e-9);
    assert_eq!(number(&report, "/surface/keys_filled"), 2.0);
    assert_eq!(number(&report, "/expression/points/5/frames_seen"), 4.0);
    let table = rows(folder.path(), "e.csv");
    assert_eq!(table[3][16..19], ["", "", ""]);
    assert!(!table[2][16].is_empty());
}

#[test]
fn gross_errors_are_named() {
    let folder = folder(&table(|frame, point, place| match (frame, NAMES[point]) {
        (3, "left") => "0.5,0.5,0.5".to_owned(),
        _ => plain(frame, point, place),
    }));
    let wrong = json(&capture(folder.path(), "--json"));
    assert!(number(&wrong, "/poses/3/rms_metres") > 0.1);
    let report = json(&capture(folder.path(), "--threshold 0.002 --json"));
    assert_eq!(report["poses"][3]["outliers"], serde_json::json!(["left"]));
    assert_near(&report["poses"][3]["translation_metres"], &pose(3).1, 1e-9);
    assert_eq!(names(folder.path()), ["face.obj", "keys.csv", "points.csv"]);
}

/// A table without names and with the columns of a frame and a time.
#[test]
fn tables_have_several_forms() {
    let bare: String = table(plain)
        .lines()
        .skip(1)
        .map(|line| line.split_once(',').unwrap().1.to_owned() + "\n")
        .collect();
    let folder = folder(&bare);
    let run = |arguments: &[&str]| {
        nullcone(
            folder.path(),
            [&["capture", "points.csv"], arguments].concat(),
        )
    };
    let report = json(&run(&[
        "--calibrated",
        "0,1,2,3,7",
        "--reference",
        "2",
        "--json",
    ]));
    assert_eq!(
        (&report["reference_frame"], &report["calibrated"][4]),
        (&"2".into(), &"7".into())
    );
    assert_near(&report["poses"][2]["translation_metres"], &[0.0; 3], 1e-9);
    let timed = table(plain)
        .replace("frame,", "FRAME,Time,")
        .replace("_x", ".X")
        .replace("_y", ".Y");
    let timed = (0..FRAMES).fold(timed, |text, k| {
        text.replace(&format!("f{k},"), &format!("f{k},{}.5,", 10 + k))
    });
    std::fs::write(folder.path().join("points.csv"), timed.replace("_z", ".z")).unwrap();
    let report = json(&run(&[
        "--calibrated",
        "brow,nose,left,right",
        "--out",
        "e.csv",
        "--json",
    ]));
    assert_eq!(report["expression"]["max_point"], "chin");
    assert_eq!(rows(folder.path(), "e.csv")[3][..2], ["f2", "12.5"]);
    let lines = run(&["--calibrated", "brow,nose,left,right", "--out", "e.csv"]);
    assert_success(&lines);
    assert!(
        text(&lines.stdout).contains("5 frames of 8 points"),
        "{}",
        text(&lines.stdout)
    );
    assert!(text(&lines.stdout).contains("wrote e.csv"));
}
