//! `nullcone camera calibrate`: one camera from pictures of a chessboard.

use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, json, nullcone, number};

#[test]
fn the_pictures_of_opencv_give_its_camera() {
    let Some(pictures) = shared("data/vision/opencv") else {
        return;
    };
    let pattern = pictures.join("left[01]*.jpg").display().to_string();
    let folder = tempdir().unwrap();
    let fixed = [
        "camera",
        "calibrate",
        &pattern,
        "--board",
        "9x6",
        "--square",
        "0.025",
    ];
    let run = |more: &[&str]| {
        let output = nullcone(folder.path(), [&fixed, more].concat());
        assert_success(&output);
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    let report = run(&["--out", "camera.yml", "--json", "--report", "page.html"]);
    assert_eq!(number(&report, "/boards_used"), 13.0);
    assert_eq!(report["lens"], "radial-tangential");
    let rms = number(&report, "/rms_px");
    assert!(rms < 0.2, "{rms}");
    // Values and standard deviations by OpenCV's `findChessboardCornersSB` and
    // `calibrateCameraExtended`, whose corners leave 0.235108 px.
    for (index, (name, value, deviation)) in [
        ("fx", 532.313_086, 0.524_612),
        ("fy", 532.283_532, 0.549_641),
        ("cx", 342.374_109, 0.555_637),
        ("cy", 233.192_474, 0.615_212),
        ("k1", -0.308_794, 0.006_458_98),
        ("k2", 0.162_975, 0.049_167_6),
        ("p1", 0.000_876_1, 0.000_133_434),
        ("p2", 0.000_366_46, 0.000_167_307),
        ("k3", -0.040_879_6, 0.104_167),
    ]
    .into_iter()
    .enumerate()
    {
        let found = &report["parameters"][index];
        assert_eq!(found["name"], name);
        let [found, own] = ["/value", "/deviation"].map(|key| number(found, key));
        let apart = (found - value).abs() / deviation;
        assert!(apart < 5.0, "{name}: {found}, not {value}");
        // Deviations are as large as what remains.
        let ratio = own / rms * 0.235_108 / deviation;
        assert!((ratio - 1.0).abs() < 0.05, "{name}: ± {own}, {ratio}");
    }
    assert_eq!(report["verdict"], "good");
    let views = report["views"].as_array().unwrap();
    let all = views.iter().map(|view| number(view, "/rms_px"));
    assert!(all.is_sorted_by(|a, b| a >= b));
    let worst = views[0]["picture"].as_str().unwrap();
    let worst = worst.rsplit_once('/').unwrap().1;
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    for part in [
        "Residuals over the picture",
        "Coverage",
        "The worst boards",
        "<svg",
        "data:image/png",
        worst,
    ] {
        assert!(page.contains(part), "{part}");
    }
    let fisheye = run(&["--out", "f.yml", "--json", "--lens", "fisheye"]);
    assert_eq!(fisheye["lens"], "fisheye");
    // The camera is one that other commands read.
    let line = ["camera", "convert", "camera.yml", "--out", "camera.xml"];
    let camera = json(folder.path(), &line);
    assert_eq!(
        camera["cameras"][0]["focal_px"],
        report["camera"]["focal_px"]
    );
    assert_eq!(camera["cameras"][0]["width_px"], 640);
}

#[test]
fn pictures_that_do_not_belong_together_are_refused() {
    let folder = tempdir().unwrap();
    for (name, size) in [("a.pgm", "32 24"), ("b.pgm", "24 32"), ("c.pgm", "32 24")] {
        let mut bytes = format!("P5 {size} 255\n").into_bytes();
        bytes.extend([128; 32 * 24]);
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    let run = |pictures: &str, more: &str| {
        let line = format!("camera calibrate {pictures} --square 0.02 {more}");
        nullcone(folder.path(), line.split_whitespace())
    };
    let usual = "--board 9x6 --out camera.yml";
    assert_failure(
        &run("*.pgm", usual),
        &["32 × 24 pixels have a.pgm, c.pgm; 24 × 32 pixels have b.pgm"],
    );
    assert_failure(
        &run("a.pgm c.pgm", usual),
        &["in 0 of 2 pictures", "a.pgm: board not found"],
    );
    for pattern in ["circles", "asymmetric-circles"] {
        assert_failure(
            &run("a.pgm c.pgm", &format!("{usual} --pattern {pattern}")),
            &[
                "in 0 of 2 pictures",
                "a.pgm: board not found: no grid of 9 × 6 circles",
            ],
        );
    }
    let pattern = run("a.pgm", &format!("{usual} --pattern hexagons"));
    assert_eq!(pattern.status.code(), Some(2));
    assert_failure(
        &run("a.pgm", "--board 9x6 --out camera.png"),
        &["camera.png", ".yml"],
    );
    let lens = run("a.pgm", "--board 9x6 --out camera.yml --lens wide");
    assert_eq!(lens.status.code(), Some(2));
}

/// Options of one kind of board are refused with another, and what a board with tags needs is asked
/// for.
#[test]
fn options_belong_to_their_boards() {
    let folder = tempdir().unwrap();
    let bytes = [b"P5 32 24 255\n".as_slice(), &[128; 32 * 24]].concat();
    for name in ["a.pgm", "b.pgm", "c.pgm"] {
        std::fs::write(folder.path().join(name), &bytes).unwrap();
    }
    let run = |options: &str| {
        let line = "camera calibrate *.pgm --board 6x5 --square 0.04 --out camera.yml --pattern";
        nullcone(
            folder.path(),
            format!("{line} {options}").split_whitespace(),
        )
    };
    for (options, reason) in [
        (
            "chessboard --marker 0.03",
            "--marker is not about boards of --pattern chessboard",
        ),
        (
            "april-grid --dictionary 4X4_50",
            "--dictionary is not about",
        ),
        ("circles --legacy-pattern", "--legacy-pattern is not about"),
        ("charuco --border 1", "--border is not about"),
        (
            "charuco --marker 0.03",
            "--pattern charuco needs --dictionary",
        ),
        (
            "charuco --dictionary 4X4_50",
            "--pattern charuco needs --marker",
        ),
        ("april-grid", "--pattern april-grid needs --marker"),
        (
            "charuco --dictionary 4X4_50 --marker 0.05",
            "tags of 0.05 m do not fit",
        ),
        ("april-grid --marker 0.04", "the gap between tags of 0 m"),
        (
            "april-grid --marker 0.03 --border 3",
            "no tag has a border of 3 modules",
        ),
        (
            "charuco --dictionary 4X4_50 --marker 0.03",
            "a.pgm: board not found: 0 of its 20 points are seen",
        ),
        (
            "aprilgrid --marker 0.03",
            "a.pgm: board not found: 0 of its 120 points are seen",
        ),
    ] {
        assert_failure(&run(options), &[reason]);
    }
    let unknown = run("charuco --marker 0.03 --dictionary 7X7_50");
    assert_eq!(unknown.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&unknown.stderr).contains("6X6_250"));
}

/// A board that OpenCV drew in its older way is that of `--legacy-pattern` alone.
#[test]
fn older_charuco_boards_are_told_by_an_option() {
    let folder = tempdir().unwrap();
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/../vision/tests/data");
    let run = |picture: &str, options: &str| {
        let line = format!(
            "camera calibrate {data}/{picture}.png --pattern charuco --board 7x6 --square 0.04 \
             --marker 0.03 --dictionary 5X5_100 --out camera.yml {options}"
        );
        nullcone(folder.path(), line.split_whitespace())
    };
    for (picture, options, found) in [
        ("charuco", "", 1),
        ("charuco", "--legacy-pattern", 0),
        ("charuco_legacy", "", 0),
        ("charuco_legacy", "--legacy-pattern", 1),
    ] {
        let message = format!("the board was found in {found} of 1 pictures");
        assert_failure(&run(picture, options), &[&message]);
    }
}
