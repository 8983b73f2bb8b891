//! ROS' messages of cameras, `sensor_msgs/CameraInfo`: as calibrations store them, and as `rostopic
//! echo` and `ros2 topic echo` print them.
//!
//! K is `camera_matrix`, `K` or `k`, the distortion `distortion_coefficients`, `D` or `d`, the size
//! `image_width` and `image_height`, or `width` and `height`. `distortion_model` is `plumb_bob` or
//! `rational_polynomial`, or of a fisheye `equidistant`, `kannala_brandt` or `fisheye`; empty, it
//! states none. Messages about pictures that are parts of others or have fewer pixels are refused.
//!
//! `R` and `P` of a message are those of its rectified pictures, and are ignored. With a
//! translation beside them the values are those of [OpenCV](super::opencv), whose `R` and `T` are a
//! pose.

use super::camera::used_coefficients;
use super::camera_file::{CameraFile, NamedCamera, SINGLE};
use super::error::CameraFileError;
use super::fields::{self, first, size};
use super::lens_name::named_lens;
use super::storage::{Storage, in_quotes, list};
use crate::LensModel;

const MATRIX: [&str; 3] = ["camera_matrix", "K", "k"];
const DISTORTION: [&str; 3] = ["distortion_coefficients", "D", "d"];
/// What a message does not have.
const TRANSLATION: [&str; 4] = ["T", "t", "translation", "tvec"];
const SIZES: [[&str; 2]; 2] = [["image_width", "image_height"], ["width", "height"]];

/// Whether it is such a message.
pub(super) fn is_message(storage: &Storage) -> bool {
    storage.has("distortion_model")
        && first(storage, &MATRIX).is_some()
        && first(storage, &DISTORTION).is_some()
        && first(storage, &TRANSLATION).is_none()
}

/// The camera of a message.
pub(super) fn decode(storage: &Storage) -> Result<CameraFile, CameraFileError> {
    check_whole(storage)?;
    let model = named_lens(storage, "distortion_model")?;
    let name = storage.text("camera_name")?;
    let name = name.filter(|name| !name.is_empty());
    let name = name.as_deref().unwrap_or(SINGLE);
    let camera = fields::camera(storage, name, [&MATRIX, &DISTORTION], model)?;
    Ok(CameraFile::new(vec![camera.with_size(size(
        storage,
        &SIZES,
        &[],
    )?)]))
}

/// Checks that the picture is the whole one with all its pixels: K is that of such a one.
fn check_whole(storage: &Storage) -> Result<(), CameraFileError> {
    let refuse = |storage: &Storage, name, problem| CameraFileError::Unsupported {
        line: storage.line(name),
        problem,
    };
    for name in ["binning_x", "binning_y"] {
        if storage.number(name)?.is_some_and(|count| count > 1.0) {
            let problem =
                "the picture has fewer pixels than the camera (binning), which is not read";
            return Err(refuse(storage, name, problem));
        }
    }
    for (_, part) in storage.maps().iter().filter(|(name, _)| name == "roi") {
        for name in ["x_offset", "y_offset"] {
            if part.number(name)?.is_some_and(|offset| offset != 0.0) {
                let problem = "the picture is a part of another one (roi), which is not read";
                return Err(refuse(part, name, problem));
            }
        }
    }
    Ok(())
}

/// The text of a file, as calibrations of ROS store it.
pub(super) fn encode(camera: &NamedCamera) -> Result<String, CameraFileError> {
    let intrinsics = camera.intrinsics()?;
    let lens = intrinsics.lens();
    let used = used_coefficients(&lens);
    let (model, coefficients) = match (lens.model(), used.len()) {
        (LensModel::Fisheye, _) => ("equidistant", used),
        (_, 0) => ("plumb_bob", vec![0.0; 5]),
        (_, 5) => ("plumb_bob", used),
        (_, 8) => ("rational_polynomial", used),
        _ => {
            return Err(CameraFileError::CannotHold {
                format: "ROS' camera_info",
                what: "the thin prism and the tilt of the lens",
                name: camera.name.clone(),
            });
        }
    };
    let [width, height] = camera.known_size()?;
    let k = intrinsics.to_matrix();
    let name = in_quotes(&camera.name);
    let matrix = |name: &str, columns: usize, values: Vec<f64>| {
        let rows = values.len() / columns;
        let data = list(&values, ", ");
        format!("{name}:\n  rows: {rows}\n  cols: {columns}\n  data: [{data}]\n")
    };
    let identity = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    let projection = k.iter().flat_map(|[a, b, c]| [*a, *b, *c, 0.0]);
    Ok([
        format!("image_width: {width}\nimage_height: {height}\ncamera_name: {name}\n"),
        matrix("camera_matrix", 3, k.concat()),
        format!("distortion_model: {model}\n"),
        matrix("distortion_coefficients", coefficients.len(), coefficients),
        matrix("rectification_matrix", 3, identity.to_vec()),
        matrix("projection_matrix", 4, projection.collect()),
    ]
    .concat())
}
