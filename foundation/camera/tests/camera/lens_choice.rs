//! Which lens a file of cameras states, and which it does not.

use std::path::Path;

use ga_camera::format::{self, CameraFile, CameraFileError};
use ga_camera::{Fisheye, Lens, LensModel, RadialTangential};

fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    format::decode(text.as_bytes(), Path::new("folder"))
}

/// The lens of the only camera, where a kind is asked for.
fn lens_as(text: &str, model: Option<LensModel>) -> Result<Lens, CameraFileError> {
    let file = decode(text)?.with_lens_model(model);
    Ok(file.cameras[0].intrinsics()?.lens())
}

#[test]
fn lenses_are_those_that_are_stated() {
    let opencv =
        "%YAML:1.0\n---\nfisheye_model: 1\ncamera_matrix: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n";
    let error = decode(opencv).unwrap_err().to_string();
    assert!(error.contains("distortion_coefficients"), "{error}");
    // Six radial terms are not those of a fisheye.
    let rational = "fx: 500\nfy: 500\ncx: 320\ncy: 240\nk1: 0.1\nk2: 0.2\nk3: 0.3\nk4: 0.4\n\
                    k5: 0.5\nk6: 0.6\n";
    let found = decode(rational).unwrap().cameras[0].intrinsics().unwrap();
    assert_eq!(
        found.lens().coefficients()[..8],
        [0.1, 0.2, 0.0, 0.0, 0.3, 0.4, 0.5, 0.6]
    );
    // 640 in hexadecimal.
    let toml = "[cam_0]\nsize = [0x280, 480]\nmatrix = [[500.0, 0, 320], [0, 500, 240], [0, 0, 1]]\n\
                distortions = [0.1, 0, 0, 0, 0]\nrotation = [0, 0, 0]\ntranslation = [0, 0, 1]\n";
    assert_eq!(decode(toml).unwrap().cameras[0].size, Some([640, 480]));
}

#[test]
fn four_coefficients_without_a_mark_are_asked_for() {
    let unmarked = "camera_matrix: [[45.5, 0, 94.5], [0, 45.5, 61.5], [0, 0, 1]]\n\
                    distortion_coefficients: [0.003, 0.0272, -0.0268, 0.0079]\n";
    let json = r#"{"width": 190, "height": 124, "fx": 45.5, "fy": 45.5, "cx": 94.5, "cy": 61.5,
        "distortion": [0.003, 0.0272, -0.0268, 0.0079]}"#;
    for text in [unmarked, json] {
        let file = decode(text).unwrap();
        let error = file.cameras[0].intrinsics().unwrap_err().to_string();
        assert!(
            error.contains("has 4 numbers") && !error.contains("--"),
            "{error}"
        );
        let lens = |model| {
            let file = file.clone().with_lens_model(Some(model));
            file.cameras[0].intrinsics().unwrap().lens()
        };
        let k = [0.003, 0.0272, -0.0268, 0.0079];
        assert_eq!(lens(LensModel::Fisheye), Fisheye::new(&k).unwrap().into());
        let radial = RadialTangential::new(&k).unwrap();
        assert_eq!(lens(LensModel::RadialTangential), radial.into());
    }
    // What is stated stays, and cannot be changed.
    for (mark, model) in [
        ("fisheye_model: 1", LensModel::Fisheye),
        ("fisheye: true", LensModel::Fisheye),
        ("distortion_model: plumb_bob", LensModel::RadialTangential),
        ("fisheye_model: 0", LensModel::RadialTangential),
    ] {
        let file = decode(&format!("{unmarked}{mark}\n")).unwrap();
        assert_eq!(
            file.cameras[0].intrinsics().unwrap().lens().model(),
            model,
            "{mark}"
        );
        let other = match model {
            LensModel::Fisheye => LensModel::RadialTangential,
            _ => LensModel::Fisheye,
        };
        let changed = file.with_lens_model(Some(other));
        let error = changed.cameras[0].intrinsics().unwrap_err().to_string();
        assert!(error.contains("in the file"), "{error}");
    }
    // Nothing is unclear of five numbers, of none, and of zeros.
    for numbers in ["[0.1, 0, 0, 0, 0]", "[]", "[0, 0, 0, 0]"] {
        let text = unmarked.replace("[0.003, 0.0272, -0.0268, 0.0079]", numbers);
        decode(&text).unwrap().cameras[0].intrinsics().unwrap();
    }
}

/// By their names, four radial terms are those of a fisheye, or the first of another lens.
#[test]
fn bare_names_of_coefficients_are_asked_for() {
    let text = "fx: 500\nfy: 500\ncx: 320\ncy: 240\nk1: 0.1\nk2: 0.02\nk3: 0.01\nk4: 0.001\n";
    let error = lens_as(text, None).unwrap_err().to_string();
    assert!(error.starts_with("line 5: `k1` has 4 numbers"), "{error}");
    let k = [0.1, 0.02, 0.01, 0.001];
    let fisheye = lens_as(text, Some(LensModel::Fisheye)).unwrap();
    assert_eq!(fisheye, Fisheye::new(&k).unwrap().into());
    let radial = lens_as(text, Some(LensModel::RadialTangential)).unwrap();
    let expected = RadialTangential::new(&[0.1, 0.02, 0.0, 0.0, 0.01, 0.001, 0.0, 0.0]).unwrap();
    assert_eq!(radial, expected.into());
    // What only one of them has says which it is.
    for (more, model) in [
        ("p1: 0\n", LensModel::RadialTangential),
        ("k5: 0\nk6: 0\n", LensModel::RadialTangential),
        ("camera_model: fisheye\n", LensModel::Fisheye),
        ("Camera.type: \"KannalaBrandt8\"\n", LensModel::Fisheye),
    ] {
        let lens = lens_as(&format!("{text}{more}"), None).unwrap();
        assert_eq!(lens.model(), model, "{more}");
    }
    // Tangential terms alone are a distortion too.
    let tangential = "fx: 500\nfy: 500\ncx: 320\ncy: 240\np1: 0.01\np2: 0.02\n";
    let lens = lens_as(tangential, None).unwrap();
    assert_eq!(lens.coefficients()[..4], [0.0, 0.0, 0.01, 0.02]);
}

/// Zeros are written for pictures without distortion; of a fisheye, the image of a direction is as
/// far from the principal point as its angle says, f θ.
#[test]
fn four_zeros_are_those_of_a_pinhole_unless_a_fisheye_is_asked_for() {
    let list = "K: [[500, 0, 320], [0, 500, 240], [0, 0, 1]]\nD: [0, 0, 0, 0]\n";
    let names = "fx: 500\nfy: 500\ncx: 320\ncy: 240\nk1: 0\nk2: 0\nk3: 0\nk4: 0\n";
    let json = r#"{"width": 640, "height": 480, "fx": 500, "fy": 500, "cx": 320, "cy": 240,
        "distortion": [0, 0, 0, 0]}"#;
    let angle = 0.5_f64;
    let point = ga_runtime::cga3::Point::new(angle.tan(), 0.0, 1.0);
    for text in [list, names, json] {
        let seen = |model| {
            let file = decode(text).unwrap().with_lens_model(model);
            file.cameras[0]
                .intrinsics()
                .unwrap()
                .project(point)
                .unwrap()[0]
        };
        let pinhole = 320.0 + 500.0 * angle.tan();
        assert!((seen(None) - pinhole).abs() < 1e-9, "{text}");
        assert!((seen(Some(LensModel::RadialTangential)) - pinhole).abs() < 1e-9);
        let fisheye = 320.0 + 500.0 * angle;
        assert!((seen(Some(LensModel::Fisheye)) - fisheye).abs() < 1e-9);
    }
}

/// A lens is asked for where a camera is used, not of every camera of a file.
#[test]
fn the_lens_of_other_cameras_does_not_matter() {
    let text = r#"{"cameras": [
        {"name": "a", "K": [[500,0,320],[0,500,240],[0,0,1]], "D": [0.1, 0.02, 0.001, 0.002]},
        {"name": "b", "fisheye": true, "K": [[500,0,320],[0,500,240],[0,0,1]],
         "D": [0.1, 0.02, 0.001, 0.002]},
        {"name": "c", "K": [[500,0,320],[0,500,240],[0,0,1]]}]}"#;
    let file = decode(text).unwrap();
    let radial = file
        .clone()
        .with_lens_model(Some(LensModel::RadialTangential));
    let lens = |name: &str| {
        radial
            .camera(name)
            .unwrap()
            .intrinsics()
            .map(|found| found.lens())
    };
    assert_eq!(lens("a").unwrap().model(), LensModel::RadialTangential);
    assert_eq!(lens("c").unwrap(), Lens::Pinhole);
    let other = lens("b").unwrap_err();
    assert!(matches!(&other, CameraFileError::OtherLens { name, .. } if name == "b"));
    // A camera without coefficients is no fisheye.
    let fisheye = file.with_lens_model(Some(LensModel::Fisheye));
    let error = fisheye.camera("c").unwrap().intrinsics().unwrap_err();
    assert!(matches!(
        error,
        CameraFileError::OtherLens {
            stated: "pinhole",
            ..
        }
    ));
}

/// Models by the names that kalibr, Basalt, camodocal, ROS and ORB-SLAM3 have for them.
#[test]
fn other_models_are_refused_by_name_and_line() {
    let parameters = "fx: 500\nfy: 500\ncx: 320\ncy: 240\n";
    let matrix = "K: [[500, 0, 320], [0, 500, 240], [0, 0, 1]]\nD: [0.1, 0, 0, 0, 0]\n";
    for (key, name) in [
        ("camera_type", "ds"),
        ("camera_model", "eucm"),
        ("camera_model", "omni"),
        ("model_type", "MEI"),
        ("model_type", "SCARAMUZZA"),
        ("distortion_model", "fov"),
        ("distortion_model", "thin_prism"),
        ("Camera.type", "Rectified"),
        ("model", "double_sphere"),
        ("lens", "ucm"),
    ] {
        for text in [parameters, matrix] {
            let text = format!("{text}{key}: {name}\n");
            let line = text.lines().count();
            let error = decode(&text).unwrap_err().to_string();
            let expected = format!("line {line}: `{key}` is \"{name}\", which is not read");
            assert!(error.starts_with(&expected), "{error}");
        }
    }
    // Basalt's file, in the list of cameras.
    let basalt = r#"{"value0": {"intrinsics": [
        {"camera_type": "ds",
         "intrinsics": {"fx": 500, "fy": 500, "cx": 320, "cy": 240, "xi": -0.2, "alpha": 0.6}}]}}"#;
    let error = decode(basalt).unwrap_err().to_string();
    assert!(
        error.starts_with("line 2: `value0.intrinsics[0].camera_type` is \"ds\""),
        "{error}"
    );
    let bare = basalt.replace("\"camera_type\": \"ds\",", "");
    let error = decode(&bare).unwrap_err().to_string();
    assert!(
        error.starts_with("line 3: `value0.intrinsics[0].intrinsics.xi` is a parameter of"),
        "{error}"
    );
    // The name of a product is no model, and that of a pinhole leaves the distortion open.
    for name in [
        "model: C920",
        "lens: Fujinon 12 mm",
        "camera_model: pinhole",
    ] {
        let file = decode(&format!("{matrix}{name}\n")).unwrap();
        let lens = file.cameras[0].intrinsics().unwrap().lens();
        assert_eq!(lens.coefficients()[0], 0.1, "{name}");
    }
}
