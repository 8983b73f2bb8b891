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

use std::collections::HashSet;
use std::fmt::Write;

use ga_runtime::cga3::{Motor, Translator};

use super::camera::used_coefficients;
use super::camera_file::{CameraFile, NamedCamera, Rectified};
use super::error::{CameraFileError, Place, wrong_type};
use super::fields::{by_rows, lens, pixels, refused, rigid, rows};
use super::storage::plain;
use crate::rig::RectifiedRig;
use crate::{Intrinsics, Lens, LensModel};

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

/// The cameras of a file.
pub(super) fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    let entries = Entries::new(text)?;
    let keys = || entries.0.iter().map(|(key, ..)| *key);
    let projections = keys().filter(|key| is_projection(key));
    let projections = projections.map(|key| entries.projection(key));
    let raw = keys().filter(|key| key.starts_with("K_"));
    let raw = raw.map(|key| entries.raw(key));
    let cameras = projections.chain(raw).collect::<Result<Vec<_>, _>>()?;
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

fn absent(key: &str) -> CameraFileError {
    CameraFileError::Missing {
        place: Place::on_line(0, key),
        also: Vec::new(),
    }
}

/// Keys and values with their lines.
struct Entries<'a>(Vec<(&'a str, usize, &'a str)>);

impl<'a> Entries<'a> {
    fn new(text: &'a str) -> Result<Self, CameraFileError> {
        let mut found = Vec::new();
        let mut keys = HashSet::new();
        for (index, text) in text.lines().enumerate() {
            let line = index + 1;
            if text.trim().is_empty() {
                continue;
            }
            let (key, value) = text.split_once(':').ok_or(CameraFileError::Unsupported {
                line,
                problem: "not of the form KEY: values",
            })?;
            let key = key.trim();
            if !keys.insert(key) {
                return Err(CameraFileError::Duplicate(Place::on_line(line, key)));
            }
            found.push((key, line, value.trim()));
        }
        Ok(Self(found))
    }

    fn place(&self, key: &str) -> Place {
        let entry = self.0.iter().find(|(other, ..)| *other == key);
        Place::on_line(entry.map_or(0, |(_, line, _)| *line), key)
    }

    /// The numbers of a key, all finite.
    fn numbers(&self, key: &str) -> Result<Option<Vec<f64>>, CameraFileError> {
        let entry = self.0.iter().find(|(other, ..)| *other == key);
        let Some((_, line, text)) = entry else {
            return Ok(None);
        };
        let numbers = text.split_whitespace().map(|word| {
            let number = word.parse::<f64>();
            let number = number.map_err(|_| wrong_type(key, *line, "a list of numbers"))?;
            match number.is_finite() {
                true => Ok(number),
                false => Err(CameraFileError::NotFinite {
                    place: self.place(key),
                    value: number,
                }),
            }
        });
        numbers.collect::<Result<_, _>>().map(Some)
    }

    fn exactly<const N: usize>(
        &self,
        key: &str,
        expected: &'static str,
    ) -> Result<Option<[f64; N]>, CameraFileError> {
        let Some(values) = self.numbers(key)? else {
            return Ok(None);
        };
        let found = <[f64; N]>::try_from(values);
        found.map(Some).map_err(|values| CameraFileError::Shape {
            place: self.place(key),
            rows: 1,
            columns: values.len(),
            expected,
        })
    }

    /// As [`exactly`](Self::exactly), where the key must be there.
    fn required<const N: usize>(
        &self,
        key: &str,
        expected: &'static str,
    ) -> Result<[f64; N], CameraFileError> {
        self.exactly(key, expected)?.ok_or_else(|| absent(key))
    }

    fn size(&self, key: &str) -> Result<Option<[usize; 2]>, CameraFileError> {
        let Some([width, height]) = self.exactly(key, "width and height")? else {
            return Ok(None);
        };
        let pixels = |value| pixels(self.place(key), value);
        Ok(Some([pixels(width)?, pixels(height)?]))
    }

    fn projection(&self, key: &str) -> Result<NamedCamera, CameraFileError> {
        let values: [f64; 12] = self.required(key, "3 × 4")?;
        let [a, b, c, x, d, e, f, y, g, h, i, z] = values;
        let intrinsics = Intrinsics::from_matrix([[a, b, c], [d, e, f], [g, h, i]]);
        let intrinsics = intrinsics.map_err(|error| refused(self.place(key), error))?;
        let along = [(x - c * z) / a, (y - f * z) / e, z];
        if let Some(value) = along.into_iter().find(|value| !value.is_finite()) {
            let place = self.place(key);
            return Err(CameraFileError::NotFinite { place, value });
        }
        let size = match key.strip_prefix("P_rect_") {
            Some(number) => self.size(&format!("S_rect_{number}"))?,
            None => None,
        };
        let pose = Translator::from_displacement(along).into();
        let camera = NamedCamera::new(key, intrinsics).with_size(size);
        Ok(camera.with_pose(Some(pose)))
    }

    fn raw(&self, key: &str) -> Result<NamedCamera, CameraFileError> {
        let matrix = by_rows(self.required(key, "3 × 3")?);
        let plain = Intrinsics::from_matrix(matrix);
        let plain = plain.map_err(|error| refused(self.place(key), error))?;
        let number = &key[2..];
        let [distortion, rotation, translation, size] =
            ["D", "R", "T", "S"].map(|letter| format!("{letter}_{number}"));
        let values = self.numbers(&distortion)?.unwrap_or_default();
        let (lens, _) = lens(&values, Some(LensModel::RadialTangential))
            .map_err(|error| refused(self.place(&distortion), error))?;
        let turned = self.exactly(&rotation, "3 × 3")?;
        let along = self.exactly::<3>(&translation, "three components")?;
        let pose = match (turned, along) {
            (None, None) => None,
            (Some(values), Some(along)) => {
                let turned = by_rows(values);
                let rows = [0, 1, 2].map(|k| {
                    let [a, b, c] = turned[k];
                    [a, b, c, along[k]]
                });
                let motor = rigid(rows).map_err(|deviation| CameraFileError::Rotation {
                    place: self.place(&rotation),
                    deviation,
                });
                Some(motor?)
            }
            (None, Some(_)) => return Err(absent(&rotation)),
            (Some(_), None) => return Err(absent(&translation)),
        };
        let camera = NamedCamera::new(key, plain.with_lens(lens));
        Ok(camera.with_size(self.size(&size)?).with_pose(pose))
    }
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
        let values: Vec<String> = values.iter().map(|value| plain(*value)).collect();
        // Writing to a string does not fail.
        _ = writeln!(text, "{key}: {}", values.join(" "));
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
