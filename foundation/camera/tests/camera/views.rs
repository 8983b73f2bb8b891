//! Files of views: what they say, and what is wrong with them.

use std::path::Path;

use ga_camera::Lens;
use ga_camera::format::{self, CameraFileError, NamedCamera};
use ga_runtime::cga3::Point;
use tempfile::tempdir;

const CAMERA: &str = r#"{"width": 64, "height": 48, "fx": 50, "fy": 60, "cx": 30, "cy": 20}"#;

/// A file of one view with these further values, and others in its camera.
fn file(values: &str, in_camera: &str) -> String {
    let camera = CAMERA.replace('}', &format!("{in_camera}}}"));
    format!(r#"{{"views": [{{"picture": "a.png", "camera": {camera}{values}}}]}}"#)
}

fn read(text: &str) -> Result<Vec<NamedCamera>, CameraFileError> {
    Ok(format::decode(text.as_bytes(), Path::new("folder"))?.cameras)
}

/// A rotation by 90° about y: x of the world points away from the camera.
const ROTATION: &str = r#", "rotation": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]"#;
const TRANSLATION: &str = r#", "translation": [0.5, 0, 3]"#;

#[test]
fn a_pose_may_stand_beside_the_camera_or_in_it() {
    let beside = read(&file(&[ROTATION, TRANSLATION].concat(), "")).unwrap();
    let within = read(&file("", &[ROTATION, TRANSLATION].concat())).unwrap();
    let split = read(&file(TRANSLATION, ROTATION)).unwrap();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let quaternion = format!(r#", "quaternion_wxyz": [{half}, 0, {half}, 0]"#);
    let turned = read(&file(TRANSLATION, &quaternion)).unwrap();
    assert_eq!(beside, within);
    assert_eq!(beside, split);
    assert_eq!(
        beside[0].picture.as_deref(),
        Some(Path::new("folder/a.png"))
    );
    assert_eq!(beside[0].name, "a.png");
    assert_eq!(beside[0].size, Some([64, 48]));
    for view in [&beside[0], &turned[0]] {
        // (x, y, z) = (2 + 0.5, 0.3, −1 + 3).
        let camera = view.camera().unwrap();
        let pixel = camera.project(Point::new(1.0, 0.3, 2.0)).unwrap();
        let expected = [50.0 * 2.5 / 2.0 + 30.0, 60.0 * 0.3 / 2.0 + 20.0];
        assert!(
            (0..2).all(|k| (pixel[k] - expected[k]).abs() < 1e-9),
            "{pixel:?}"
        );
    }
}

#[test]
fn lenses_are_those_of_opencv() {
    let pose = [ROTATION, TRANSLATION].concat();
    let lens = |more: &str| {
        let views = read(&file(&pose, more)).unwrap();
        views[0].intrinsics().unwrap().lens()
    };
    assert_eq!(lens(""), Lens::Pinhole);
    let radial = lens(r#", "distortion": [-0.1, 0.02, 0.001, 0.002, 0.003]"#);
    assert!(matches!(radial, Lens::RadialTangential(_)));
    assert_eq!(
        radial.coefficients()[..5],
        [-0.1, 0.02, 0.001, 0.002, 0.003]
    );
    let fisheye = lens(r#", "distortion": [0.1, 0.02, 0, 0], "lens": "fisheye""#);
    assert!(matches!(fisheye, Lens::Fisheye(_)));
}

#[test]
fn cameras_may_be_in_files_of_their_own() {
    let folder = tempdir().unwrap();
    let yaml = "%YAML:1.0\n---\nK: [[50, 0, 30], [0, 60, 20], [0, 0, 1]]\n";
    std::fs::write(folder.path().join("c.yml"), yaml).unwrap();
    let json = CAMERA.replace('}', &[ROTATION, TRANSLATION, "}"].concat());
    std::fs::write(folder.path().join("c.json"), json).unwrap();
    let text = format!(
        r#"{{"views": [{{"picture": "a.png", "camera": "c.yml"{ROTATION}{TRANSLATION}}},
            {{"picture": "b.png", "camera": "c.json"}}]}}"#
    );
    let path = folder.path().join("views.json");
    std::fs::write(&path, text).unwrap();
    let views = format::read(&path).unwrap().cameras;
    assert_eq!(views[0].camera().unwrap(), views[1].camera().unwrap());
    assert_eq!((views[0].size, views[1].size), (None, Some([64, 48])));
    assert_eq!(views[1].picture, Some(folder.path().join("b.png")));
    assert_eq!(format::read(folder.path()).unwrap().cameras, views);

    let text = r#"{"views": [{"picture": "a.png", "camera": "none.yml"}]}"#;
    std::fs::write(&path, text).unwrap();
    let message = format::read(&path).unwrap_err().to_string();
    assert!(
        message.contains("views.json: line 1: view 0: `camera`: cannot read"),
        "{message}"
    );
    assert!(message.contains("none.yml"), "{message}");
}

#[test]
fn faults_name_the_view_and_the_key() {
    let pose = [ROTATION, TRANSLATION].concat();
    let in_line = |text: &str| read(text).unwrap_err().to_string();
    let wrong = file(&pose, "").replace("\"fy\": 60", "\n\"fy\": \"60\"");
    assert_eq!(
        in_line(&wrong),
        "line 2: view 0: `camera.fy` is not a number"
    );
    assert!(in_line("[").starts_with("line 1: not JSON: EOF"));
    let fault = |text: &str| in_line(text).trim_start_matches("line 1: ").to_owned();
    for text in ["[]", "{}", r#"{"views": []}"#, r#"{"views": 3}"#] {
        assert_eq!(fault(text), "`views` is not a list of at least one view");
    }
    let good = file(&pose, "");
    for (from, to, message) in [
        (
            "\"picture\": \"a.png\", ",
            "",
            "view 0: `picture` is missing",
        ),
        ("\"a.png\"", "7", "view 0: `picture` is not a path"),
        ("\"fx\": 50, ", "", "view 0: `camera.fx` is missing"),
        (
            "\"fx\": 50",
            "\"fx\": \"50\"",
            "view 0: `camera.fx` is not a number",
        ),
        (
            "\"fx\": 50",
            "\"fx\": -50",
            "view 0: `camera`: focal lengths [-50.0, 60.0]",
        ),
        (
            "\"fx\"",
            "\"f\"",
            "view 0: `camera.f` is not a key of a view",
        ),
        (
            "64",
            "0",
            "view 0: `camera.width` is not a number of pixels",
        ),
        (
            "[0, 1, 0]",
            "[0, 2, 0]",
            "view 0: `rotation` is not a rotation",
        ),
        (
            "[0, 1, 0]",
            "[0, 1]",
            "view 0: `rotation` is not three rows of three numbers",
        ),
        (
            "[0.5, 0, 3]",
            "[0.5, 0]",
            "view 0: `translation` is not three numbers",
        ),
        (TRANSLATION, "", "view 0: `translation` is missing"),
        (ROTATION, "", "view 0: `rotation` is missing"),
    ] {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from}");
        let found = fault(&text);
        assert!(found.starts_with(message), "{found} is not {message}");
    }
    let quaternion = r#", "quaternion_wxyz": [1, 0, 0, 0]"#;
    let twice = fault(&file(&[&pose, quaternion].concat(), ""));
    assert_eq!(
        twice,
        "view 0: `rotation` is given, and also `quaternion_wxyz`"
    );
    let twice = fault(&file(&pose, TRANSLATION));
    assert_eq!(
        twice,
        "view 0: `translation` is given, and also `camera.translation`"
    );
    let long = fault(&file(
        &[TRANSLATION, r#", "quaternion_wxyz": [2, 0, 0, 0]"#].concat(),
        "",
    ));
    assert!(
        long.starts_with("view 0: `quaternion_wxyz` is not a rotation"),
        "{long}"
    );
    let skewed = read(&file(&pose, r#", "skew": 1.5"#)).unwrap();
    assert_eq!(skewed[0].intrinsics_and_skew().unwrap().1, 1.5);
    let error = skewed[0].camera().unwrap_err();
    assert!(matches!(error, CameraFileError::Skew { skew: 1.5, .. }));
    let few = fault(&file(&pose, r#", "distortion": [0.1, 0.2, 0.3]"#));
    assert!(
        few.starts_with("view 0: `camera.distortion`: 3 distortion coefficients"),
        "{few}"
    );
}
