//! The kinds of lenses as files name them, and how many coefficients files have.

use std::path::Path;

use ga_camera::format::{self, storage::Storage};
use ga_camera::{Fisheye, Intrinsics, Lens, LensModel, RadialTangential};

fn encoded(lens: Lens) -> String {
    let intrinsics = Intrinsics::new([500.0; 2], [320.0, 240.0]).unwrap();
    format::camera::storage(&intrinsics.with_lens(lens), None).encode()
}

/// The names in messages of ROS and in files of kalibr.
#[test]
fn lenses_have_the_names_of_other_programs() {
    let plain = encoded(Fisheye::new(&[0.1, 0.2, 0.3, 0.4]).unwrap().into());
    let unmarked = plain.replace("fisheye_model: 1", "");
    assert_ne!(plain, unmarked);
    let model = |name: &str| {
        let text = format!("{unmarked}distortion_model: {name}\n");
        let file = format::decode(text.as_bytes(), Path::new(""))?;
        Ok::<_, format::CameraFileError>(file.cameras[0].intrinsics()?.lens().model())
    };
    for (name, expected) in [
        ("plumb_bob", LensModel::RadialTangential),
        ("rational_polynomial", LensModel::RadialTangential),
        ("radtan", LensModel::RadialTangential),
        ("equidistant", LensModel::Fisheye),
        ("fisheye", LensModel::Fisheye),
    ] {
        assert_eq!(model(name).unwrap(), expected, "{name}");
    }
    let error = model("omni").unwrap_err().to_string();
    for part in ["distortion_model", "plumb_bob", "equidistant"] {
        assert!(error.contains(part), "{error}");
    }
}

/// OpenCV reads 4, 5, 8, 12 or 14 numbers.
#[test]
fn files_have_as_many_coefficients_as_are_needed() {
    for (last, expected) in [
        (0, 5),
        (4, 5),
        (5, 8),
        (7, 8),
        (8, 12),
        (11, 12),
        (12, 14),
        (13, 14),
    ] {
        let mut coefficients = [0.0; 14];
        coefficients[last] = 0.01;
        let text = encoded(RadialTangential::new(&coefficients).unwrap().into());
        let storage = Storage::decode(text.as_bytes()).unwrap();
        let written = storage.matrix("distortion_coefficients").unwrap().unwrap();
        assert_eq!(written.values(), &coefficients[..expected], "{last}");
    }
    let text = encoded(Fisheye::new(&[0.1, 0.0, 0.0, 0.0]).unwrap().into());
    let storage = Storage::decode(text.as_bytes()).unwrap();
    let written = storage.matrix("distortion_coefficients").unwrap().unwrap();
    assert_eq!(written.values(), [0.1, 0.0, 0.0, 0.0]);
}
