//! Frames that show no pose, lost markers, and tables of other programs.

use std::path::Path;
use std::process::Output;

use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::tempdir;

use super::face::{FRAMES, NAMES, assert_near, capture, folder, json, plain, pose, rows, table};
use crate::common::{assert_failure, nullcone, number, text};

/// The warnings of a kind in a report.
fn warnings<'a>(report: &'a Value, kind: &str) -> Vec<&'a str> {
    let warnings = report["warnings"].as_array().unwrap().iter();
    let of_kind = warnings.filter(|warning| warning["kind"] == kind);
    of_kind
        .map(|warning| warning["message"].as_str().unwrap())
        .collect()
}

/// Frame 1 shows two calibrated points, and frame 3 none.
fn with_gaps() -> String {
    table(|frame, point, place| match (frame, NAMES[point]) {
        (1, "brow" | "nose" | "left") | (3, _) => ",,".to_owned(),
        _ => plain(frame, point, place),
    })
}

#[test]
fn frames_without_a_pose_are_left_empty() {
    let folder = folder(&with_gaps());
    let outputs = "--out e.csv --pose p.csv --matrix m.csv --mesh face.obj --keys keys.csv \
                   --out face.glb --json";
    let report = json(&capture(folder.path(), outputs));
    assert_eq!(number(&report, "/frames_without_pose"), 2.0);
    let warned = warnings(&report, "frames_without_pose");
    assert!(
        warned[0].starts_with("2 of 5 frames have no pose")
            && warned[0].contains("line 3, frame f1: 2 calibrated points are seen")
            && warned[0].contains("line 5, frame f3: 0 calibrated points are seen"),
        "{warned:?}"
    );
    for frame in 0..FRAMES {
        let found = &report["poses"][frame];
        assert_eq!(found["frame"], format!("f{frame}"));
        if frame % 2 == 0 {
            assert_near(&found["translation_metres"], &pose(frame).1, 1e-9);
            assert!(found.get("pose_reason").is_none());
        } else {
            assert!(found["translation_metres"].is_null() && found["rms_metres"].is_null());
            assert!(found["rotation_quaternion"].is_null() && found["inliers"].is_null());
            let reason = found["pose_reason"].as_str().unwrap();
            assert!(
                reason.contains("3 are needed; missing: brow, nose, left"),
                "{reason}"
            );
        }
    }
    let moved = &report["surface"]["area"]["centre_displacement_metres"];
    assert!(moved[1].is_null() && moved[3].is_null() && moved[2].is_array());
    assert_eq!(number(&report, "/expression/points/4/frames_seen"), 3.0);
    let expressions = rows(folder.path(), "e.csv");
    let poses = rows(folder.path(), "p.csv");
    let matrices = rows(folder.path(), "m.csv");
    for frame in [1, 3] {
        for row in [&expressions[1 + frame], &poses[1 + frame]] {
            assert_eq!(row[0], format!("f{frame}"));
            assert!(row[1..].iter().all(String::is_empty), "{row:?}");
        }
        assert_eq!(poses[1 + frame].len(), poses[0].len());
        assert_eq!(expressions[1 + frame].len(), expressions[0].len());
        let matrix = &matrices[1 + 4 * frame..][..4];
        assert!(
            matrix
                .iter()
                .all(|row| row[2..].iter().all(String::is_empty))
        );
    }
    // The animation has keys at the times of the other frames.
    let (document, buffers, _) = gltf::import(folder.path().join("face.glb")).unwrap();
    let mut channels = 0;
    for channel in document.animations().next().unwrap().channels() {
        let reader = channel.reader(|buffer| Some(&buffers[buffer.index()]));
        let times: Vec<_> = reader.read_inputs().unwrap().collect();
        assert_eq!(
            times,
            [0.0, 2.0 / 30.0, 4.0 / 30.0].map(|time: f64| time as f32)
        );
        channels += 1;
    }
    assert_eq!(channels, 3);
}

#[test]
fn lost_markers_are_not_seen() {
    let zeros = table(|frame, point, place| match (frame, NAMES[point]) {
        (2, "brow" | "chin") => "0,0,0".to_owned(),
        _ => plain(frame, point, place),
    });
    let folder = folder(&zeros);
    let report = json(&capture(folder.path(), "--json"));
    let warned = warnings(&report, "lost_at_origin");
    assert_eq!(warned.len(), 2);
    assert!(
        warned[0].contains("point brow is 0,0,0 in 1 of the frames (f2)"),
        "{warned:?}"
    );
    assert_eq!(report["poses"][2]["missing"], serde_json::json!(["brow"]));
    assert_near(&report["poses"][2]["translation_metres"], &pose(2).1, 1e-9);
    assert!(number(&report, "/expression/max_metres") < 0.0121);
    let kept = json(&capture(folder.path(), "--keep-zeros --json"));
    assert!(warnings(&kept, "lost_at_origin").is_empty());
    assert!(number(&kept, "/expression/max_metres") > 0.1);
}

#[test]
fn exports_of_other_programs_are_read() {
    let mut text = "PathFileType\t4\t(X/Y/Z)\tface.trc\nDataRate\tNumFrames\tUnits\n".to_owned();
    text += &format!("60\t{FRAMES}\tmm\nFrame#\tTime");
    text.extend(NAMES.map(|name| format!("\tface:{name}\t\t")));
    text += "\n\t";
    text.extend((1..=NAMES.len()).map(|k| format!("\tX{k}\tY{k}\tZ{k}")));
    text += "\n";
    for (frame, line) in table(|_, _, place| {
        let [x, y, z] = place.map(|x| 1000.0 * x);
        format!("{x},{y},{z}")
    })
    .lines()
    .skip(1)
    .enumerate()
    {
        let (_, places) = line.split_once(',').unwrap();
        text += &format!(
            "{}\t{}\t{}\n",
            frame + 1,
            frame as f64 / 60.0,
            places.replace(',', "\t")
        );
    }
    let folder = folder(&text);
    let report = json(&capture(folder.path(), "--out e.csv --json"));
    for frame in 0..FRAMES {
        assert_near(
            &report["poses"][frame]["translation_metres"],
            &pose(frame).1,
            1e-9,
        );
    }
    assert_eq!(report["calibrated"][0], "face:brow");
    assert_eq!(report["expression"]["max_point"], "face:chin");
    assert!((number(&report, "/expression/max_metres") - 0.012).abs() < 1e-9);
    // The same numbers without a unit are taken as metres, with doubt.
    std::fs::write(folder.path().join("points.csv"), text.replace("mm", "")).unwrap();
    let report = json(&capture(folder.path(), "--json"));
    let doubts = warnings(&report, "unclear_unit");
    assert!(doubts[0].contains("does not say its unit"), "{doubts:?}");
    assert!(doubts[1].contains("may be in millimetres"), "{doubts:?}");
    std::fs::write(
        folder.path().join("points.csv"),
        [b"\x02\x50".as_slice(), &[0; 600]].concat(),
    )
    .unwrap();
    assert_failure(
        &capture(folder.path(), "--json"),
        &["points.csv", "C3D", "TRC or CSV"],
    );
}

fn of_case(folder: &Path, file: &Path) -> Output {
    let file = file.to_str().unwrap();
    let calibrated = "brow,nose,left,right";
    let arguments = [
        "capture",
        file,
        "--calibrated",
        calibrated,
        "--out",
        "e.csv",
    ];
    nullcone(folder, [&arguments[..], &["--json"]].concat())
}

#[test]
fn a_take_in_several_forms_has_one_expression() {
    let Some(files) = shared("cases/people/capture-tables") else {
        return;
    };
    let folder = tempdir().unwrap();
    let clean = json(&of_case(folder.path(), &files.join("ts.csv")));
    assert!(clean["warnings"].as_array().unwrap().is_empty());
    let truth = rows(folder.path(), "e.csv");
    for (name, frames, kinds) in [
        ("g1.csv", 15, &[][..]),
        ("g3.csv", 15, &["frames_without_pose"]),
        ("motive.csv", 9, &[]),
        ("semi.csv", 15, &[]),
        ("zero.csv", 15, &["lost_at_origin"]),
    ] {
        let output = of_case(folder.path(), &files.join(name));
        let report = json(&output);
        let warnings = report["warnings"].as_array().unwrap().iter();
        let found: Vec<_> = warnings
            .map(|warning| warning["kind"].as_str().unwrap())
            .collect();
        assert_eq!(found, kinds, "{name}: {}", text(&output.stdout));
        // The chin moves by 20 mm, and nothing by more.
        assert!(number(&report, "/expression/max_metres") < 0.021, "{name}");
        let table = rows(folder.path(), "e.csv");
        assert_eq!(table.len(), 1 + frames, "{name}");
        for (row, truth) in table.iter().zip(&truth).skip(1) {
            for (found, truth) in row.iter().zip(truth).filter(|(found, _)| !found.is_empty()) {
                let [a, b] = [found, truth].map(|number| number.parse::<f64>().unwrap());
                assert!((a - b).abs() < 5e-6, "{name}: {a} {b}");
            }
        }
    }
}
