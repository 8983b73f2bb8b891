//! Every kind of camera file with every command: equal cameras give equal results, and what a file
//! does not say is named.

use std::path::Path;

use ga_image::plane::Plane;
use serde_json::{Value, json as object};
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, contents, json, nullcone, number};

const SIZE: [usize; 2] = [240, 180];
const FOCAL: f64 = 200.0;
const BASELINE: f64 = 0.1;

/// One rig in every format: two pinholes side by side, which look along z.
const RIGS: [&str; 5] = ["rig.yml", "calib.txt", "views.json", "rig.xml", "cv.json"];

/// Blocks of random grey.
fn texture(u: i64, v: i64) -> u8 {
    let block = |size: i64| {
        let (a, b) = (u.div_euclid(size) as u64, v.div_euclid(size) as u64);
        let mixed = (a.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ b.wrapping_mul(0xC2B2_AE3D_27D4_EB4F))
            .wrapping_mul(0xD6E8_FEB8_6659_FD93);
        mixed >> 57
    };
    (block(7) + block(19)) as u8
}

/// The views of a wall whose disparity is 6 px, of a bright disk with that disparity, and of a
/// square of 2 m at the depth 4 m.
fn scene() -> TempDir {
    let folder = tempdir().unwrap();
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    for (side, across) in [("left", 0i64), ("right", 6)] {
        let wall = Plane::from_fn(SIZE[0], SIZE[1], |u, v| {
            texture(u as i64 + across, v as i64)
        });
        let disk = Plane::from_fn(SIZE[0], SIZE[1], |u, v| {
            let [x, y] = [(u as i64 + across - 120) as f64, v as f64 - 90.0];
            (220.0 / (1.0 + (x.hypot(y) - 40.0).exp())) as u8
        });
        for (name, picture) in [(side.to_owned(), wall), (format!("{side}-disk"), disk)] {
            ga_image::file::write(folder.path().join(format!("{name}.png")), &picture).unwrap();
        }
    }
    write(
        "square.obj",
        "v -1 -1 4\nv 1 -1 4\nv 1 1 4\nv -1 1 4\nf 4 3 2 1\n".to_owned(),
    );

    let k = "[ [ 200, 0, 119.5 ], [ 0, 200, 89.5 ], [ 0, 0, 1 ] ]";
    let size = "image_width: 240\nimage_height: 180";
    let identity = "[ [ 1, 0, 0 ], [ 0, 1, 0 ], [ 0, 0, 1 ] ]";
    write(
        "rig.yml",
        format!("%YAML:1.0\n---\n{size}\nM1: {k}\nM2: {k}\nR: {identity}\nT: [ -0.1, 0, 0 ]\n"),
    );
    for converted in &RIGS[3..] {
        run(
            folder.path(),
            &format!("camera convert rig.yml --format opencv --out {converted}"),
        );
    }
    let row = "[200 0 119.5; 0 200 89.5; 0 0 1]";
    write(
        "calib.txt",
        format!("cam0={row}\ncam1={row}\ndoffs=0\nbaseline=100\nwidth=240\nheight=180\n"),
    );
    let view = |picture: &str, x: f64| {
        object!({"picture": picture, "camera": camera(), "translation": [x, 0, 0],
            "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})
    };
    let views = |x: &[f64]| {
        let names = ["left.png", "right.png", "third.png"].into_iter().zip(x);
        let views: Vec<Value> = names.map(|(name, x)| view(name, *x)).collect();
        object!({"views": views}).to_string()
    };
    write("views.json", views(&[0.0, -BASELINE]));
    write("three.json", views(&[0.0, -BASELINE, -0.2]));
    write("same.json", views(&[0.5, 0.5]));
    write("k.yml", format!("%YAML:1.0\n---\n{size}\nK: {k}\n"));
    write("k.json", camera().to_string());
    let mut posed = camera();
    posed["rotation"] = object!([[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    posed["translation"] = object!([-BASELINE, 0, 0]);
    write("right.json", posed.to_string());
    let mut skewed = posed.clone();
    skewed["skew"] = object!(1.5);
    write("skewed.json", skewed.to_string());
    posed["distortion"] = object!([-0.1, 0, 0, 0, 0]);
    write("distorted.json", posed.to_string());
    folder
}

fn camera() -> Value {
    object!({"width": 240, "height": 180, "fx": FOCAL, "fy": FOCAL, "cx": 119.5, "cy": 89.5})
}

fn run(folder: &Path, line: &str) {
    assert_success(&nullcone(folder, line.split_whitespace()));
}

fn report(folder: &Path, line: &str) -> Value {
    let mut report = json(folder, &line.split_whitespace().collect::<Vec<_>>());
    remove_times(&mut report);
    report
}

/// What differs from run to run.
fn remove_times(value: &mut Value) {
    if let Some(fields) = value.as_object_mut() {
        fields.remove("seconds");
        fields.values_mut().for_each(remove_times);
    }
}

fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    std::fs::read(folder.join(name)).unwrap()
}

#[test]
fn rigs_of_all_formats_rectify_alike() {
    let folder = scene();
    let folder = folder.path();
    for rig in RIGS {
        let line = format!("stereo rectify left.png right.png --rig {rig} --out {rig}.d");
        let report = report(folder, &line);
        assert!((number(&report, "/baseline_metres") - BASELINE).abs() < 1e-15);
        // Views that are rectified stay as they are.
        for name in ["left.png", "right.png"] {
            let [old, new] = [name.to_owned(), format!("{rig}.d/{name}")]
                .map(|name| ga_image::file::read(folder.join(name)).unwrap());
            assert_eq!(old, new, "{rig}");
        }
        let [first, found] = [RIGS[0], rig].map(|rig| contents(&folder.join(format!("{rig}.d"))));
        assert!(first == found, "{rig}");
    }
    // The first two of three views, and the other way round.
    let line = "stereo rectify left.png right.png --rig three.json --out chosen";
    run(folder, &format!("{line} --view left --view right.png"));
    assert!(contents(&folder.join("chosen")) == contents(&folder.join("rig.yml.d")));
    let turned = format!("{line} --view 1 --view 0");
    let turned = nullcone(folder, turned.split_whitespace());
    assert_failure(&turned, &["the views are exchanged"]);
}

#[test]
fn rigs_of_all_formats_reconstruct_alike() {
    let folder = scene();
    let folder = folder.path();
    let depth = FOCAL * BASELINE / 6.0;
    for rig in RIGS {
        let line = format!(
            "stereo reconstruct left.png right.png --rig {rig} --max-disparity 16 \
             --threads 1 --out {rig}.ply"
        );
        let found = number(&report(folder, &line), "/median_metres");
        assert!((found - depth).abs() < 0.01 * depth, "{rig}: {found}");
    }
    // What is given as rectified is not rectified again.
    assert!(bytes(folder, "rig.yml.ply") == bytes(folder, "views.json.ply"));
}

#[test]
fn rigs_of_all_formats_give_one_contour() {
    let folder = scene();
    let folder = folder.path();
    let all = RIGS.map(|rig| {
        let line = format!(
            "contour left-disk.png right-disk.png --rig {rig} --fit circle --axes camera \
             --circle 120,90,50"
        );
        report(folder, &line)
    });
    let depth = FOCAL * BASELINE / 6.0;
    let found = number(&all[0], "/circle/centre_metres/2");
    assert!((found - depth).abs() < 0.02 * depth, "{found}");
    for (rig, other) in RIGS.iter().zip(&all) {
        assert!(&all[0] == other, "{rig}");
    }
}

#[test]
fn cameras_of_all_formats_undistort_and_render_alike() {
    let folder = scene();
    let folder = folder.path();
    let expected = ga_image::file::read(folder.join("left.png")).unwrap();
    let single = ["k.yml", "k.json", "right.json"].map(str::to_owned);
    let of_rigs = RIGS.map(|rig| format!("{rig} --view right"));
    let numbered = RIGS.map(|rig| format!("{rig} --view 1"));
    let mut first = None;
    for camera in single.iter().chain(&of_rigs).chain(&numbered) {
        run(
            folder,
            &format!("stereo undistort left.png --camera {camera} --out a.png --new-camera a.yml"),
        );
        assert_eq!(
            ga_image::file::read(folder.join("a.png")).unwrap(),
            expected
        );
        // The pose is that of the camera, which k.yml and k.json have not.
        let written = ga_camera::format::read(folder.join("a.yml")).unwrap();
        let [written] = written.cameras.as_slice() else {
            panic!("{camera}: {written:?}");
        };
        let place = written.pose.map(|pose| pose.translator().displacement()[0]);
        let expected = (!camera.starts_with("k.")).then_some(-BASELINE);
        let apart = place.zip(expected).map(|(a, b)| (a - b).abs());
        assert!(
            place.is_some() == expected.is_some() && apart.unwrap_or(0.0) < 1e-9,
            "{camera}"
        );
        let written = written.intrinsics().unwrap();
        assert_eq!(*first.get_or_insert(written), written, "{camera}");
    }
    run(
        folder,
        "render square.obj --camera right.json --out first.png",
    );
    // The square covers 100 px, from 119.5 − 5 − 50 to 119.5 − 5 + 50.
    let drawn = ga_image::file::read(folder.join("first.png")).unwrap();
    let drawn = drawn.to_rgb();
    let row: Vec<[u8; 3]> = (0..240).map(|u| drawn.get(u, 90).unwrap()).collect();
    let differs = |a: [u8; 3], b: [u8; 3]| a.iter().zip(b).any(|(a, b)| a.abs_diff(b) > 12);
    assert!(differs(row[63], row[67]) && differs(row[162], row[167]));
    for camera in of_rigs.iter().chain(&numbered) {
        run(
            folder,
            &format!("render square.obj --camera {camera} --out b.png"),
        );
        assert!(
            bytes(folder, "first.png") == bytes(folder, "b.png"),
            "{camera}"
        );
    }
}

#[test]
fn rigs_of_all_formats_texture_alike() {
    let folder = scene();
    let folder = folder.path();
    for rig in RIGS {
        run(
            folder,
            &format!(
                "texture square.obj --views {rig} --pictures left.png right.png --size 64 \
                 --out {rig}.glb"
            ),
        );
        assert!(
            bytes(folder, &format!("{rig}.glb")) == bytes(folder, "rig.yml.glb"),
            "{rig}"
        );
    }
    // The file of views names the same pictures.
    run(
        folder,
        "texture square.obj --views views.json --size 64 --out named.glb",
    );
    assert!(bytes(folder, "named.glb") == bytes(folder, "rig.yml.glb"));
}

/// A corner of two walls at disparities of 6 and 16 px, so that the motion is determined.
fn two_walls(folder: &Path) {
    for (name, near, far) in [("a.png", 0, 0), ("b.png", 16, 6)] {
        let view = Plane::from_fn(SIZE[0], SIZE[1], |u, v| {
            let across = if v < 90 { far } else { near };
            texture(u as i64 + across, v as i64)
        });
        ga_image::file::write(folder.join(name), &view).unwrap();
    }
}

#[test]
fn cameras_of_all_formats_give_one_motion() {
    let folder = scene();
    let folder = folder.path();
    two_walls(folder);
    let choices = [
        "k.yml",
        "k.json",
        "k.json --camera-b k.yml",
        "rig.yml",
        "calib.txt",
        "views.json",
        "rig.yml --view left",
        "views.json --view 0 --view-b right",
        "three.json --view left --view-b third.png",
        "k.yml --camera-b views.json --view-b left.png",
    ];
    let all = choices.map(|camera| {
        let line = format!("stereo pose a.png b.png --camera {camera}");
        let mut report = report(folder, &line);
        let used = report.as_object_mut().unwrap().remove("cameras").unwrap();
        if camera == "rig.yml" {
            assert_eq!(used, object!(["left", "right"]));
        }
        report
    });
    // Everything moves to the left, and the near wall more.
    let direction = [0, 1, 2].map(|k| number(&all[0], &format!("/translation_direction/{k}")));
    assert!(direction[0] < -0.99, "{direction:?}");
    for (camera, other) in choices.iter().zip(&all) {
        assert_eq!(&all[0], other, "{camera}");
    }
}

#[test]
fn what_a_file_does_not_say_is_named() {
    let folder = scene();
    let folder = folder.path();
    let before = contents(folder);
    let needs_rig = "a rig of two is needed";
    for (line, parts) in [
        (
            "stereo rectify left.png right.png --rig k.yml --out d",
            ["k.yml", needs_rig],
        ),
        (
            "stereo reconstruct left.png right.png --rig right.json --out a.ply",
            ["right.json", needs_rig],
        ),
        (
            "contour left-disk.png right-disk.png --rig k.json --out a.obj",
            ["k.json", needs_rig],
        ),
        (
            "stereo rectify left.png right.png --rig three.json --out d",
            ["3 cameras", "--view NAME"],
        ),
        (
            "stereo rectify left.png right.png --rig same.json --out d",
            ["same.json", "the same place"],
        ),
        (
            "stereo undistort left.png --camera rig.yml --out a.png",
            ["left, right", "--view NAME"],
        ),
        (
            "stereo undistort left.png --camera rig.yml --view middle --out a.png",
            ["\"middle\"", "left, right"],
        ),
        (
            "stereo undistort left.png --camera skewed.json --out a.png",
            ["skewed.json", "skew 1.5"],
        ),
        (
            "stereo pose left.png right.png --camera three.json",
            ["3 cameras", "--view NAME"],
        ),
        (
            "stereo pose left.png right.png --camera skewed.json",
            ["camera", "skew 1.5"],
        ),
        (
            "stereo pose left.png right.png --camera square.obj",
            ["square.obj", "line 1"],
        ),
        (
            "render square.obj --camera views.json --out a.png",
            ["left.png, right.png", "--view NAME"],
        ),
        (
            "render square.obj --camera k.yml --out a.png",
            ["k.yml", "no pose"],
        ),
        (
            "render square.obj --camera distorted.json --out a.png",
            ["distorted.json", "stereo undistort"],
        ),
        (
            "render square.obj --camera front --view left --out a.png",
            ["--view", "front"],
        ),
        (
            "texture square.obj --views rig.yml --out a.glb",
            ["rig.yml", "--pictures"],
        ),
        (
            "texture square.obj --views k.yml --pictures left.png --out a.glb",
            ["k.yml", "no pose"],
        ),
        (
            "texture square.obj --views rig.yml --pictures left.png --out a.glb",
            ["1 pictures", "2 cameras"],
        ),
        (
            "texture square.obj --views skewed.json --pictures left.png --out a.glb",
            ["skewed.json", "skew 1.5"],
        ),
    ] {
        let output = nullcone(folder, line.split_whitespace());
        assert!(!output.status.success(), "{line}");
        assert_failure(&output, &parts);
        assert!(contents(folder) == before, "{line}");
    }
}

/// A rig through every format, and what one of them cannot hold.
#[test]
fn rigs_are_converted_from_format_to_format() {
    let folder = scene();
    let folder = folder.path();
    let mut before = "rig.yml".to_owned();
    for (to, more) in [
        ("a.json", "--format opencv-json"),
        ("camchain.yaml", "--format kalibr"),
        ("calibration.toml", ""),
        ("model", "--format colmap"),
        ("views2.json", ""),
        ("kitti.txt", ""),
        ("middlebury.txt", "--format middlebury"),
        ("end.yml", ""),
    ] {
        let report = report(
            folder,
            &format!("camera convert {before} --out {to} {more}"),
        );
        assert_eq!(report["cameras"].as_array().unwrap().len(), 2, "{to}");
        let line = format!("stereo rectify left.png right.png --rig {to} --out d");
        let found = number(&self::report(folder, &line), "/baseline_metres");
        assert!((found - BASELINE).abs() < 1e-15, "{to}");
        before = to.to_owned();
    }
    // Lengths in a unit that is not stated.
    let line = "stereo rectify left.png right.png --rig calibration.toml --out d";
    assert_eq!(report(folder, line)["warnings"][0]["kind"], "unclear_unit");
    // One of them, and what is lost.
    let one = report(
        folder,
        "camera convert rig.yml --out ros.yaml --format ros --camera right",
    );
    assert_eq!(one["warnings"][0]["what"], "poses");
    assert_eq!(one["warnings"][0]["count"], 1);
    for (line, parts) in [
        (
            "camera convert rig.yml --out a.yaml --format ros",
            ["ROS' camera_info holds one camera", "--camera NAME"],
        ),
        (
            "camera convert three.json --out a.yml",
            ["left.png, right.png, third.png", "--camera NAME"],
        ),
        ("camera convert rig.yml --out a", ["a", "--format"]),
        (
            "camera convert skewed.json --out a.yml",
            ["skewed.json", "skew 1.5"],
        ),
        (
            "camera convert square.obj --out a.yml",
            ["square.obj", "line 1"],
        ),
    ] {
        assert_failure(&nullcone(folder, line.split_whitespace()), &parts);
    }
}

#[test]
fn a_lens_that_a_file_does_not_say_is_asked_for() {
    let folder = scene();
    let folder = folder.path();
    let k = "camera_matrix: [[95, 0, 119.5], [0, 95, 89.5], [0, 0, 1]]\n\
             distortion_coefficients: [0.003, 0.0272, -0.0268, 0.0079]\n";
    std::fs::write(folder.join("unmarked.yml"), k).unwrap();
    std::fs::write(folder.join("marked.yml"), format!("fisheye_model: 1\n{k}")).unwrap();
    let line = "stereo undistort left.png --camera unmarked.yml --out a.png";
    let refused = nullcone(folder, line.split_whitespace());
    assert_failure(
        &refused,
        &[
            "unmarked.yml: line 2: `distortion_coefficients`",
            "--lens fisheye",
        ],
    );
    run(folder, &format!("{line} --lens fisheye"));
    run(
        folder,
        "stereo undistort left.png --camera marked.yml --out b.png",
    );
    assert!(bytes(folder, "a.png") == bytes(folder, "b.png"));
    run(folder, &format!("{line} --lens radial-tangential"));
    assert!(bytes(folder, "a.png") != bytes(folder, "b.png"));
    run(
        folder,
        "camera convert unmarked.yml --lens fisheye --out c.yml",
    );
    run(
        folder,
        "stereo undistort left.png --camera c.yml --out a.png",
    );
    assert!(bytes(folder, "a.png") == bytes(folder, "b.png"));
    let other =
        "stereo undistort left.png --camera marked.yml --lens radial-tangential --out a.png";
    assert_failure(
        &nullcone(folder, other.split_whitespace()),
        &["marked.yml", "has the lens fisheye in the file"],
    );
}
