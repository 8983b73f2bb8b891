//! `nullcone stereo calibrate`: a rig from pictures of a chessboard.

use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, number};

/// The bytes of a picture in grey.
fn pgm(width: usize, height: usize, value: impl Fn(usize, usize) -> u8) -> Vec<u8> {
    let mut bytes = format!("P5 {width} {height} 255\n").into_bytes();
    bytes.extend((0..width * height).map(|k| value(k % width, k / width)));
    bytes
}

/// The arguments for the views of a folder, with the rig written into the folder of the program.
fn arguments(left: &str, right: &str) -> Vec<String> {
    let fixed = "stereo calibrate --board 9x6 --square 0.025 --out rig.yml --json";
    let mut arguments: Vec<String> = fixed.split(' ').map(String::from).collect();
    arguments.extend(["--left", left, "--right", right].map(String::from));
    arguments
}

#[test]
fn the_pairs_of_opencv_give_a_rig() {
    let Some(pictures) = shared("data/vision/opencv") else {
        return;
    };
    let pattern = |side: &str| {
        pictures
            .join(format!("{side}[01]*.jpg"))
            .display()
            .to_string()
    };
    let folder = tempdir().unwrap();
    let mut all = arguments(&pattern("left"), &pattern("right"));
    all.extend(["--pictures".into(), "found".into()]);
    let output = nullcone(folder.path(), &all);
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(number(&report, "/pairs_used"), 13.0);
    for pair in report["pairs"].as_array().unwrap() {
        let [left, right] = ["left", "right"].map(|side| pair[side].as_str().unwrap());
        let right = right.rsplit_once("right").unwrap().1;
        assert_eq!(left.rsplit_once("left").unwrap().1, right);
    }
    assert!(output.stderr.is_empty());
    assert_eq!(report["pairs_rejected"], Value::Array(Vec::new()));
    let rms = number(&report, "/rms_px");
    assert!(rms < 0.46, "{rms}");
    let [left, right] = ["/rms_left_px", "/rms_right_px"].map(|key| number(&report, key));
    assert!((0.5 * (left * left + right * right) - rms * rms).abs() < 1e-9);
    let baseline = number(&report, "/baseline_metres");
    assert!((baseline - 0.0836).abs() < 0.0015, "{baseline}");
    let edge = number(&report, "/square_edge_mean_metres");
    assert!((edge / 0.025 - 1.0).abs() < 0.02, "{edge}");
    let rig = std::fs::read_to_string(folder.path().join("rig.yml")).unwrap();
    for name in ["%YAML:1.0", "M1:", "D1:", "M2:", "D2:", "R:", "T:"] {
        assert!(rig.contains(name), "{rig}");
    }
    assert_eq!(names(&folder.path().join("found")).len(), 13);
}

/// Pictures that are missing on each side leave the pairs of the others as they are.
#[test]
fn pairs_are_made_by_the_numbers_in_the_names() {
    let Some(pictures) = shared("data/vision/opencv") else {
        return;
    };
    let folder = tempdir().unwrap();
    for (side, missing) in [("left", 3), ("right", 9)] {
        for number in (1..=14).filter(|number| ![missing, 10].contains(number)) {
            let from = pictures.join(format!("{side}{number:02}.jpg"));
            // The right names have no zeros before the number.
            let to = match side {
                "left" => format!("left{number:02}.jpg"),
                _ => format!("right{number}.jpg"),
            };
            std::fs::copy(from, folder.path().join(to)).unwrap();
        }
    }
    let output = nullcone(folder.path(), arguments("left*.jpg", "right*.jpg"));
    assert_success(&output);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(number(&report, "/pairs_used"), 11.0);
    let rms = number(&report, "/rms_px");
    assert!(rms < 0.5, "{rms}");
    assert_eq!(report["warnings"][0]["kind"], "no_partner");
    let text = report["warnings"][0]["message"].as_str().unwrap();
    assert!(text.ends_with(": right3.jpg, left09.jpg"), "{text}");
}

/// What is found wrong after the boards were found.
#[test]
fn nothing_is_written_where_the_rig_cannot_be() {
    let Some(pictures) = shared("data/vision/opencv") else {
        return;
    };
    let pattern = |side: &str| {
        let pattern = pictures.join(format!("{side}0[1-4].jpg"));
        pattern.display().to_string()
    };
    let folder = tempdir().unwrap();
    std::fs::create_dir(folder.path().join("rig.yml")).unwrap();
    let refused = |left: &str, right: &str, parts: &[&str]| {
        let mut all = arguments(&pattern(left), &pattern(right));
        all.extend(["--pictures".into(), "found".into()]);
        assert_failure(&nullcone(folder.path(), &all), parts);
        names(folder.path())
    };
    let left = refused("left", "right", &["cannot write rig.yml"]);
    assert_eq!(left, ["rig.yml"]);
    std::fs::remove_dir(folder.path().join("rig.yml")).unwrap();
    let left = refused("left", "left", &["baseline", "cannot be told from 0"]);
    assert!(left.is_empty());
}

#[test]
fn bad_input_is_named_and_nothing_is_written() {
    let folder = tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    for k in 0..4 {
        write(&format!("left{k}.pgm"), &pgm(200, 150, |x, _| x as u8));
        write(&format!("right{k}.pgm"), &pgm(200, 150, |_, y| y as u8));
    }
    write("other0.pgm", &pgm(200, 151, |_, y| y as u8));
    write("broken0.pgm", b"P5 200 150 255\nshort");
    write("k.yml", b"%YAML:1.0\n---\nK: 7\n");
    let before = names(folder.path());
    let refused = |arguments: &[String], parts: &[&str]| {
        let output = nullcone(folder.path(), arguments);
        assert_failure(&output, parts);
        assert_eq!(names(folder.path()), before);
    };
    let with = |left: &str, right: &str, more: &[&str]| {
        let mut all = arguments(left, right);
        all.extend(more.iter().map(|word| (*word).to_owned()));
        all
    };
    refused(
        &with("none*.pgm", "right*.pgm", &[]),
        &["--left", "none*.pgm", "matches no file"],
    );
    refused(&with("left*.pgm", "right[", &[]), &["--right", "right["]);
    std::fs::rename(
        folder.path().join("right0.pgm"),
        folder.path().join("right7.pgm"),
    )
    .unwrap();
    std::fs::rename(
        folder.path().join("right1.pgm"),
        folder.path().join("right8.pgm"),
    )
    .unwrap();
    let output = nullcone(folder.path(), with("left[012].pgm", "right[78].pgm", &[]));
    assert_failure(
        &output,
        &["--left and --right: 3 and 2 files do not belong together"],
    );
    std::fs::rename(
        folder.path().join("right7.pgm"),
        folder.path().join("right0.pgm"),
    )
    .unwrap();
    std::fs::rename(
        folder.path().join("right8.pgm"),
        folder.path().join("right1.pgm"),
    )
    .unwrap();
    refused(
        &with("left0.pgm", "other0.pgm", &[]),
        &["differ in size", "200 × 151"],
    );
    refused(&with("left0.pgm", "broken0.pgm", &[]), &["broken0.pgm"]);
    // A view is missing on each side.
    let output = nullcone(folder.path(), with("left[012].pgm", "right[013].pgm", &[]));
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(
        error.starts_with("warning: views without a partner are left out: left2.pgm, right3.pgm"),
        "{error}"
    );
    assert!(error.contains("found in 0 of 2 pairs"), "{error}");
    let none = ["found in 0 of 4 pairs", "board not found", "left0.pgm"];
    refused(&with("left*.pgm", "right*.pgm", &[]), &none);
    let known = ["--intrinsics", "known"];
    refused(&with("left*.pgm", "right*.pgm", &known), &["--left-camera"]);
    let camera = ["--left-camera", "k.yml"];
    refused(&with("left*.pgm", "right*.pgm", &camera), &["k.yml"]);
    let square = |value: &str| {
        let mut all = with("left*.pgm", "right*.pgm", &[]);
        let place = all.iter().position(|word| word == "0.025").unwrap();
        all[place] = value.into();
        all
    };
    for value in ["0", "NaN", "inf"] {
        refused(&square(value), &["--square"]);
    }
}

/// What a shell makes of a pattern, and names that are patterns as well.
#[test]
fn views_are_named_one_by_one_and_in_the_order_of_their_numbers() {
    let folder = tempdir().unwrap();
    let lists = ["left", "right"].map(|side| {
        let names: Vec<String> = ["10", "2", "9", "[8]"]
            .map(|number| format!("{side}{number}.pgm"))
            .to_vec();
        for name in &names {
            let bytes = pgm(200, 150, |x, _| x as u8);
            std::fs::write(folder.path().join(name), bytes).unwrap();
        }
        names
    });
    let run = |left: &[String], right: &[String]| {
        let mut all = arguments("", "");
        all.truncate(all.len() - 4);
        all.extend([&["--left".to_owned()], left, &["--right".to_owned()], right].concat());
        let output = nullcone(folder.path(), all);
        assert_failure(&output, &["the board was found in 0 of"]);
        String::from_utf8(output.stderr).unwrap()
    };
    // There is no board: the first pair is named.
    let [left, right] = &lists;
    let all = run(left, right);
    assert!(
        all.contains("0 of 4 pairs") && all.contains("first: left2.pgm"),
        "{all}"
    );
    let late = run(&left[..1], &right[..1]);
    assert!(
        late.contains("0 of 1 pairs") && late.contains("left10.pgm"),
        "{late}"
    );
    let brackets = run(&left[3..], &right[3..]);
    assert!(
        brackets.contains("0 of 1 pairs") && brackets.contains("left[8].pgm"),
        "{brackets}"
    );
}

/// Boards that are all parallel to the pictures show no focal length.
#[test]
fn boards_at_one_angle_are_refused() {
    let folder = tempdir().unwrap();
    let board = |x: f64, y: f64, square: f64| {
        pgm(320, 240, |u, v| {
            let (column, row) = ((u as f64 - x) / square, (v as f64 - y) / square);
            let is_board = (-1.0..9.0).contains(&column) && (-1.0..6.0).contains(&row);
            let is_dark = (column.floor() + row.floor()).rem_euclid(2.0) == 0.0;
            if is_board && is_dark { 30 } else { 230 }
        })
    };
    for (k, [x, y, square]) in [
        [40.0, 40.0, 22.0],
        [60.0, 50.0, 20.0],
        [70.0, 60.0, 18.0],
        [50.0, 45.0, 24.0],
    ]
    .into_iter()
    .enumerate()
    {
        // The disparity is that of the depth, on which the size of a square depends.
        for (side, x) in [("left", x), ("right", x - 0.5 * square)] {
            let path = folder.path().join(format!("{side}{k}.pgm"));
            std::fs::write(path, board(x, y, square)).unwrap();
        }
    }
    let before = names(folder.path());
    let output = nullcone(folder.path(), arguments("left*.pgm", "right*.pgm"));
    let parts = ["the views do not determine f", "at more angles"];
    assert_failure(&output, &parts);
    assert_eq!(names(folder.path()), before);
}
