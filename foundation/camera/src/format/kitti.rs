//! The calibrations of KITTI: `calib.txt` and `calib_cam_to_cam.txt`.
//!
//! ```text
//! P0: 7.215377e+02 0 6.095593e+02 0 0 7.215377e+02 1.728540e+02 0 0 0 1 0
//! P1: 7.215377e+02 0 6.095593e+02 -3.875744e+02 0 7.215377e+02 1.728540e+02 0 0 0 1 0
//! ```
//!
//! `P0` to `P3`, or `P_rect_00` to `P_rect_03`, are the projections K [I | t] of rectified
//! pictures, 3×4 by rows: t takes the frame of the rectified camera 0 into that of the camera, in
//! metres. In `calib_cam_to_cam.txt`, the camera `K_02` is the one before rectification, with its
//! distortion `D_02`, the motion `R_02` and `T_02` from the frame of camera 0 into its own, and the
//! size `S_02` of its pictures; `S_rect_02` is that of the rectified ones. The cameras are named
//! after these keys, rectified ones first. Lines of other sensors are ignored.
//!
//! The world is the frame of the rectified camera 0 for all of them, into which `R_rect_00` turns
//! that of camera 0; where nothing is rectified, it is the frame of camera 0.

use std::fmt::Write;

use ga_runtime::cga3::{Motor, Translator};

use super::camera::used_coefficients;
use super::camera_file::{CameraFile, NamedCamera, Rectified};
use super::error::{CameraFileError, finite};
use super::fields::{by_rows, pinhole_of_matrix, pixels};
use super::key_values::KeyValues;
use super::lens::stated_lens;
use super::rotation::{nearest_rotor, rigid, rows};
use super::storage::list;
use crate::rig::RectifiedRig;
use crate::{Lens, LensModel};

/// The name of the format in errors.
const NAME: &str = "KITTI's calibration";

/// Whether a line of a text is that of a projection or of a camera.
pub(super) fn is_calibration(text: &str) -> bool {
    text.lines().any(|line| {
        let parts = line.split_once(':');
        parts.is_some_and(|(key, values)| {
            let is_camera = is_projection(key.trim()) || key.trim().starts_with("K_");
            let first = values.split_whitespace().next();
            is_camera && first.is_some_and(|word| word.parse::<f64>().is_ok())
        })
    })
}

fn is_projection(key: &str) -> bool {
    let number = key.strip_prefix("P_rect_").or(key.strip_prefix('P'));
    number.is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

/// The rotation from the frame of camera 0 into that of its rectified pictures.
const RECTIFICATION: &str = "R_rect_00";

/// The cameras of a file.
pub(super) fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    let entries = KeyValues::new(text, ':', "not of the form KEY: values")?;
    let projections = entries.keys().filter(|key| is_projection(key));
    let projections = projections.map(|key| projection(&entries, key));
    let mut cameras = projections.collect::<Result<Vec<_>, _>>()?;
    let raw = entries.keys().filter(|key| key.starts_with("K_"));
    let raw = raw.map(|key| before_rectification(&entries, key));
    let mut raw = raw.collect::<Result<Vec<_>, _>>()?;
    let posed = raw.iter().find(|camera| camera.pose.is_some());
    if let (false, Some(posed)) = (cameras.is_empty(), posed) {
        // Both kinds of cameras stand in one world.
        let rows = entries.exactly(RECTIFICATION, "3 × 3")?;
        let rows = rows.ok_or_else(|| entries.missing_beside(RECTIFICATION, &posed.name))?;
        let place = || entries.place(RECTIFICATION);
        let from_rectified = Motor::from(nearest_rotor(by_rows(rows), place)?).reverse();
        for camera in &mut raw {
            camera.pose = camera.pose.map(|pose| pose * from_rectified);
        }
    }
    cameras.append(&mut raw);
    let rectified = rectified(&cameras);
    Ok(CameraFile { cameras, rectified })
}

/// The rectified rig of two projections that are those of one.
fn rectified(cameras: &[NamedCamera]) -> Option<Rectified> {
    let [left, right] = cameras else { return None };
    if !cameras.iter().all(|camera| is_projection(&camera.name)) {
        return None;
    }
    let motion = right.pose? * left.pose?.reverse();
    let [x, y, z] = motion.translator().displacement();
    if y != 0.0 || z != 0.0 {
        return None;
    }
    let sides = [left.intrinsics().ok()?, right.intrinsics().ok()?];
    let rig = RectifiedRig::new(sides[0], sides[1], -x).ok()?;
    Some(Rectified {
        rig,
        disparities: None,
    })
}

fn size(entries: &KeyValues, key: &str) -> Result<Option<[usize; 2]>, CameraFileError> {
    let Some([width, height]) = entries.exactly(key, "width and height")? else {
        return Ok(None);
    };
    let pixels = |value| pixels(entries.place(key), value);
    Ok(Some([pixels(width)?, pixels(height)?]))
}

fn projection(entries: &KeyValues, key: &str) -> Result<NamedCamera, CameraFileError> {
    let values: [f64; 12] = entries.required(key, "3 × 4")?;
    let [a, b, c, x, d, e, f, y, g, h, i, z] = values;
    let place = || entries.place(key);
    let intrinsics = pinhole_of_matrix([[a, b, c], [d, e, f], [g, h, i]], place)?;
    let along = [(x - c * z) / a, (y - f * z) / e, z];
    for value in along {
        finite(place, value)?;
    }
    let size = match key.strip_prefix("P_rect_") {
        Some(number) => size(entries, &format!("S_rect_{number}"))?,
        None => None,
    };
    let pose = Translator::from_displacement(along).into();
    let camera = NamedCamera::new(key, intrinsics).with_size(size);
    Ok(camera.with_pose(Some(pose)))
}

fn before_rectification(entries: &KeyValues, key: &str) -> Result<NamedCamera, CameraFileError> {
    let matrix = by_rows(entries.required(key, "3 × 3")?);
    let plain = pinhole_of_matrix(matrix, || entries.place(key))?;
    let number = &key[2..];
    let [distortion, rotation, translation, pixels] =
        ["D", "R", "T", "S"].map(|letter| format!("{letter}_{number}"));
    let values = entries.numbers(&distortion)?.unwrap_or_default();
    let place = || entries.place(&distortion);
    let lens = stated_lens(&values, LensModel::RadialTangential, place)?;
    let turned = entries.exactly(&rotation, "3 × 3")?;
    let along = entries.exactly::<3>(&translation, "three components")?;
    let pose = match (turned, along) {
        (None, None) => None,
        (Some(values), Some(along)) => {
            let turned = by_rows(values);
            let rows = [0, 1, 2].map(|k| {
                let [a, b, c] = turned[k];
                [a, b, c, along[k]]
            });
            Some(rigid(rows, || entries.place(&rotation))?)
        }
        (None, Some(_)) => return Err(entries.missing_beside(&rotation, &translation)),
        (Some(_), None) => return Err(entries.missing_beside(&translation, &rotation)),
    };
    let camera = NamedCamera::new(key, plain.with_lens(lens));
    Ok(camera.with_size(size(entries, &pixels)?).with_pose(pose))
}

/// The text of a file: projections of cameras without distortion that look the same way, and
/// cameras before rectification otherwise. The world is the frame of the first camera.
pub(super) fn encode(cameras: &[NamedCamera]) -> Result<String, CameraFileError> {
    let all = cameras
        .iter()
        .map(|camera| Ok((camera.intrinsics()?, from_first(cameras, camera)?)));
    let all = all.collect::<Result<Vec<_>, CameraFileError>>()?;
    let are_projections = are_projections(cameras);
    let mut text = String::new();
    let mut line = |key: String, values: &[f64]| {
        // Writing to a string does not fail.
        _ = writeln!(text, "{key}: {}", list(values, " "));
    };
    for (index, ((intrinsics, pose), camera)) in all.iter().zip(cameras).enumerate() {
        let k = intrinsics.to_matrix();
        if are_projections {
            let [x, y, z] = pose.translator().displacement();
            let row = |[a, b, c]: [f64; 3]| [a, b, c, a * x + b * y + c * z];
            line(format!("P{index}"), k.map(row).as_flattened());
            continue;
        }
        let used = used_coefficients(&intrinsics.lens());
        if intrinsics.lens().model() == LensModel::Fisheye || used.len() > 5 {
            return Err(CameraFileError::CannotHold {
                format: NAME,
                what: "a distortion beyond k1, k2, p1, p2 and k3, as that of a fisheye,",
                name: camera.name.clone(),
            });
        }
        if let Some([width, height]) = camera.size {
            line(format!("S_{index:02}"), &[width as f64, height as f64]);
        }
        line(format!("K_{index:02}"), k.as_flattened());
        let coefficients = if used.is_empty() { vec![0.0; 5] } else { used };
        line(format!("D_{index:02}"), &coefficients);
        let motion = rows(*pose);
        let turned = motion.map(|[a, b, c, _]| [a, b, c]);
        line(format!("R_{index:02}"), turned.as_flattened());
        line(format!("T_{index:02}"), &motion.map(|row| row[3]));
    }
    Ok(text)
}

/// Whether all cameras are without distortion and look the same way, and so are written as
/// projections, which have no size.
pub(super) fn are_projections(cameras: &[NamedCamera]) -> bool {
    /// The largest angle of a rotation that is rounding, in radians.
    const ROUNDING: f64 = 1e-15;
    cameras.iter().all(|camera| {
        let is_pinhole = camera
            .intrinsics()
            .is_ok_and(|found| found.lens() == Lens::Pinhole);
        let pose = from_first(cameras, camera);
        let angle = pose.map(|pose| pose.rotor().canonical().to_axis_angle().1.abs());
        is_pinhole && angle.is_ok_and(|angle| angle <= ROUNDING)
    })
}

/// The motor from the first camera's frame into that of a camera.
fn from_first(
    cameras: &[NamedCamera],
    camera: &NamedCamera,
) -> Result<Motor<f64>, CameraFileError> {
    match cameras {
        [] | [_] => Ok(Motor::default()),
        [first, ..] => Ok(camera.world_to_camera()? * first.world_to_camera()?.reverse()),
    }
}
