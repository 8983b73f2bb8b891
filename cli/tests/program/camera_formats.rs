//! Files of cameras of other programs: which lens and which cameras are asked for, what is said of
//! a file, and what of one that is wrong.

use std::path::Path;

use ga_image::plane::Plane;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, json, nullcone, text};

const K: &str = "[[500, 0, 320], [0, 500, 240], [0, 0, 1]]";

fn write(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

/// One camera whose lens is not stated beside a fisheye.
fn mixed() -> TempDir {
    let folder = tempdir().unwrap();
    let d = "[0.1, 0.02, 0.001, 0.002]";
    let text = format!(
        "{{\"cameras\": [{{\"name\": \"a\", \"K\": {K}, \"D\": {d}}},\n\
         {{\"name\": \"b\", \"fisheye\": true, \"K\": {K}, \"D\": {d}}}]}}"
    );
    write(folder.path(), "mixed.json", &text);
    folder
}

#[test]
fn a_lens_is_that_of_the_chosen_camera() {
    let folder = mixed();
    let convert = |words: &str| {
        let line = format!("camera convert mixed.json --out out.yml {words}");
        nullcone(folder.path(), line.split_whitespace())
    };
    assert_success(&convert("--camera a --lens radial-tangential"));
    assert_success(&convert("--camera b"));
    assert_failure(
        &convert("--camera a"),
        &[
            "mixed.json: line 1: `cameras[0].D` has 4 numbers",
            "--lens radial-tangential or --lens fisheye",
        ],
    );
    assert_failure(
        &convert("--camera b --lens radial-tangential"),
        &["mixed.json", "\"b\" has the lens fisheye in the file"],
    );
}

/// KITTI's files say nothing of the pictures, which JSON must state.
#[test]
fn sizes_that_a_file_does_not_state_are_asked_for() {
    let folder = tempdir().unwrap();
    let matrix = "700 0 600 0 0 700 170 0 0 0 1 0";
    write(folder.path(), "calib.txt", &format!("P0: {matrix}\n"));
    let convert = |words: &str| {
        let line = format!("camera convert {words}");
        nullcone(folder.path(), line.split_whitespace())
    };
    assert_failure(
        &convert("calib.txt --out camera.json"),
        &["calib.txt", "\"P0\" has no `width` and `height`", "--size"],
    );
    assert!(!folder.path().join("camera.json").exists());
    assert_success(&convert("calib.txt --out camera.json --size 1241x376"));
    let file = std::fs::read_to_string(folder.path().join("camera.json")).unwrap();
    assert!(file.contains("1241") && file.contains("376"), "{file}");
    assert_success(&convert("camera.json --out same.yml --size 1241x376"));
    assert_failure(
        &convert("camera.json --out other.yml --size 640x480"),
        &["camera.json", "has pictures of 1241 x 376 pixels"],
    );
}

#[test]
fn a_lens_without_a_file_of_cameras_is_refused() {
    let folder = tempdir().unwrap();
    let disk = Plane::from_fn(60, 60, |u, v| {
        let [x, y] = [u, v].map(|w| w as f64 - 30.0);
        (220.0 / (1.0 + (x.hypot(y) - 15.0).exp())) as u8
    });
    ga_image::file::write(folder.path().join("disk.png"), &disk).unwrap();
    write(
        folder.path(),
        "square.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
    );
    for (line, parts) in [
        (
            "contour disk.png --snake --circle 30,30,20 --lens fisheye",
            ["--lens fisheye", "--rig"],
        ),
        (
            "render square.obj --camera front --lens fisheye --out a.png",
            ["--lens fisheye", "--camera front is not a file"],
        ),
    ] {
        assert_failure(&nullcone(folder.path(), line.split_whitespace()), &parts);
    }
}

/// What is said of a file stands before the error of a command that fails later.
#[test]
fn what_is_said_of_a_file_is_not_lost_where_the_command_fails() {
    let folder = tempdir().unwrap();
    let camera = |x: f64| {
        format!(
            "size = [64, 48]\nmatrix = {K}\ndistortions = [0, 0, 0, 0, 0]\nrotation = [0, 0, 0]\n\
             translation = [{x:?}, 0, 0]\n"
        )
    };
    let toml = format!("[cam_0]\n{}[cam_1]\n{}", camera(0.0), camera(-0.1));
    write(folder.path(), "rig.toml", &toml);
    let view = Plane::from_fn(50, 40, |u, v| (u * v) as u8);
    for name in ["left.png", "right.png"] {
        ga_image::file::write(folder.path().join(name), &view).unwrap();
    }
    let line = "stereo rectify left.png right.png --rig rig.toml --out d";
    let output = nullcone(folder.path(), line.split_whitespace());
    assert!(!output.status.success());
    let error = text(&output.stderr);
    let lines: Vec<&str> = error.lines().collect();
    assert!(lines[0].starts_with("warning: rig.toml: "), "{error}");
    assert!(lines[0].contains("states no unit of length"), "{error}");
    assert!(
        lines[1].starts_with("error: left.png has 50 × 40 pixels"),
        "{error}"
    );
    let quiet = nullcone(folder.path(), format!("{line} --quiet").split_whitespace());
    assert!(text(&quiet.stderr).starts_with("error: "));
}

/// What OpenCV's file does not hold is in the warnings.
#[test]
fn what_the_target_does_not_hold_is_listed() {
    let folder = tempdir().unwrap();
    let text = "cam0=[500 0 320; 0 500 240; 0 0 1]\ncam1=[500 0 325; 0 500 240; 0 0 1]\ndoffs=5\n\
                baseline=100\nwidth=640\nheight=480\nndisp=64\n";
    write(folder.path(), "calib.txt", text);
    let words = ["camera", "convert", "calib.txt", "--out", "rig.yml"];
    let report = json(folder.path(), &words);
    let warnings = report["warnings"].as_array().unwrap();
    let what: Vec<&str> = warnings
        .iter()
        .map(|w| w["what"].as_str().unwrap())
        .collect();
    assert_eq!(
        what,
        ["marks of rectified pictures", "bounds of disparities"]
    );
}

/// One line for a wrong file of each format, which names the file, the key and the line.
#[test]
fn wrong_files_of_all_formats_are_named_with_key_and_line() {
    let folder = tempdir().unwrap();
    let cases = [
        (
            "cv.yml",
            "%YAML:1.0\n---\nK: [[500, 0, x], [0, 500, 240], [0, 0, 1]]\n",
            "line 3: `K`",
        ),
        (
            "cv.xml",
            "<?xml version=\"1.0\"?>\n<opencv_storage>\n<K>1 2 3</K>\n</opencv_storage>\n",
            "line 3: `K`",
        ),
        (
            "cv.json",
            "{\n\"K\": [[500, 0, 320],\n[0, 500], [0, 0, 1]]}",
            "line 3: `K`",
        ),
        (
            "camera.json",
            "{\"width\": 640, \"height\": 480,\n\"fx\": 0, \"fy\": 1, \"cx\": 0, \"cy\": 0}",
            "line 1: `camera`",
        ),
        (
            "views.json",
            "{\"views\": [\n{\"picture\": \"a.png\", \"camera\": 5}]}",
            "line 2: view 0: `camera`",
        ),
        (
            "camchain.yaml",
            "cam0:\n  camera_model: pinhole\n  intrinsics: [500, 500, 320]\n",
            "line 3: `cam0.intrinsics`",
        ),
        (
            "sensor.yaml",
            "camera_model: pinhole\nintrinsics: [500, 500, 320, 240]\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1]\n",
            "line 3: `T_BS`",
        ),
        (
            "ros.yaml",
            "distortion_model: fov\nd: [0.1]\nk: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n",
            "line 1: `distortion_model`",
        ),
        (
            "kitti.txt",
            "P0: 500 0 320 0 0 500 240 0 0 0 1 0\nP1: 1\n",
            "line 2: `P1`",
        ),
        (
            "middlebury.txt",
            "cam0=[500 0 320; 0 500 240; 0 0 1]\ncam1=[500 0; 0 500 240; 0 0 1]\nbaseline=1\n",
            "line 2: `cam1`",
        ),
        (
            "cameras.txt",
            "1 PINHOLE 640 480 500 500 320\n",
            "line 1: there is no `PARAMS`",
        ),
        (
            "anipose.toml",
            "[cam_0]\nmatrix = [[500.0, 0, 320], [0, 500, 240], [0, 0, 1]]\ndistortions = [0.1]\n",
            "line 3: `cam_0.distortions`",
        ),
        (
            "qualisys.qca.txt",
            "<calibration><cameras><camera serial=\"a\">\n<intrinsic focalLengthU=\"x\"/>\n</camera></cameras></calibration>",
            "line 2: `intrinsic.focalLengthU`",
        ),
        (
            "transforms.json",
            "{\"w\": 640, \"h\": 480, \"fl_x\": 500,\n\"frames\": [{\"file_path\": \"a.png\",\n\"transform_matrix\": 5}]}",
            "line 3: view 0: `transform_matrix`",
        ),
    ];
    for (name, contents, place) in cases {
        write(folder.path(), name, contents);
        let output = nullcone(
            folder.path(),
            ["camera", "convert", name, "--out", "out.yml"],
        );
        assert_failure(&output, &[&format!("{name}: {place}")]);
        assert!(!folder.path().join("out.yml").exists(), "{name}");
    }
    // A file that is not one of cameras, and one that is cut.
    for (name, contents) in [
        ("a.png", "\u{89}PNG"),
        ("empty.yml", ""),
        ("cut.json", "{\"views\": ["),
    ] {
        write(folder.path(), name, contents);
        let output = nullcone(
            folder.path(),
            ["camera", "convert", name, "--out", "out.yml"],
        );
        assert_failure(&output, &[name, "line 1"]);
    }
}
