//! Models of COLMAP as text.

use std::fmt::Write;
use std::str::FromStr;

use ga_runtime::cga3::{Motor, Rotor, Translator};

use super::device::{Device, Shot, distinct};
use super::model;
use crate::format::camera_file::NamedCamera;
use crate::format::error::{CameraFileError, Place, absent, finite, wrong_type};
use crate::format::fields::pixels;
use crate::format::storage::list;

/// Whether a line is that of a camera: its number and the name of a model.
pub(in crate::format) fn is_camera_line(line: &str) -> bool {
    let mut words = line.split_whitespace();
    let number = words.next().and_then(|word| word.parse::<u32>().ok());
    number.is_some() && words.next().is_some_and(model::is_name)
}

/// The words of a line.
struct Words<'a> {
    line: usize,
    words: std::str::SplitWhitespace<'a>,
}

impl Words<'_> {
    fn place(&self, key: &str) -> Place {
        Place::on_line(self.line, key)
    }

    fn next<T: FromStr>(
        &mut self,
        key: &str,
        expected: &'static str,
    ) -> Result<T, CameraFileError> {
        let word = self.words.next();
        let word = word.ok_or_else(|| absent(self.place(key)))?;
        word.parse()
            .map_err(|_| wrong_type(key, self.line, expected))
    }

    fn number(&mut self, key: &str) -> Result<f64, CameraFileError> {
        let value: f64 = self.next(key, "a number")?;
        finite(|| self.place(key), value)
    }
}

/// The lines of a text that are not comments, with their numbers from 1.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = text
        .lines()
        .enumerate()
        .map(|(index, line)| (index + 1, line));
    lines.filter(|(_, line)| !line.trim_start().starts_with('#'))
}

pub(super) fn devices(text: &str) -> Result<Vec<Device>, CameraFileError> {
    let lines = lines(text).filter(|(_, line)| !line.trim().is_empty());
    let devices = lines.map(|(line, text)| {
        let mut words = Words {
            line,
            words: text.split_whitespace(),
        };
        let id = words.next("CAMERA_ID", "a whole number")?;
        let name: String = words.next("MODEL", "a name")?;
        let model = model::find(Some(&name), 0, || words.place("MODEL"))?;
        let size = [words.number("WIDTH")?, words.number("HEIGHT")?];
        let size = [
            pixels(words.place("WIDTH"), size[0])?,
            pixels(words.place("HEIGHT"), size[1])?,
        ];
        let parameters = (0..model.parameters).map(|_| words.number("PARAMS"));
        let parameters = parameters.collect::<Result<Vec<_>, _>>()?;
        if words.words.next().is_some() {
            return Err(wrong_type(
                "PARAMS",
                line,
                "the parameters of its model alone",
            ));
        }
        let intrinsics = model.intrinsics(&parameters, || words.place("PARAMS"))?;
        Ok(Device {
            id,
            size,
            intrinsics,
            line,
        })
    });
    distinct(devices.collect::<Result<_, _>>()?)
}

/// The images: each has two lines, of which the second, which may be empty, has points of the
/// picture, which are not used.
pub(super) fn shots(bytes: &[u8]) -> Result<Vec<Shot>, CameraFileError> {
    let text = crate::format::text::text(bytes)?;
    let mut lines = lines(text);
    let mut shots = Vec::new();
    while let Some((line, text)) = lines.next() {
        if text.trim().is_empty() {
            continue;
        }
        let mut words = Words {
            line,
            words: text.split_whitespace(),
        };
        words.next::<u32>("IMAGE_ID", "a whole number")?;
        let [w, x, y, z] = [
            words.number("QW")?,
            words.number("QX")?,
            words.number("QY")?,
            words.number("QZ")?,
        ];
        let along = [
            words.number("TX")?,
            words.number("TY")?,
            words.number("TZ")?,
        ];
        let device = words.next("CAMERA_ID", "a whole number")?;
        let name: Vec<&str> = words.words.by_ref().collect();
        if name.is_empty() {
            return Err(absent(words.place("NAME")));
        }
        let pose = pose([w, x, y, z], along).ok_or_else(|| CameraFileError::Value {
            place: words.place("QW"),
            expected: "the first of four numbers of a quaternion that is not zero",
        })?;
        shots.push(Shot {
            device,
            name: name.join(" "),
            pose,
            place: line,
        });
        if let Some((line, points)) = lines.next() {
            check_points(line, points)?;
        }
    }
    Ok(shots)
}

/// Checks that a line has three numbers for each point. An image whose line of points is left out
/// would otherwise take the image after it for points.
fn check_points(line: usize, text: &str) -> Result<(), CameraFileError> {
    let numbers = text.split_whitespace().map(str::parse::<f64>);
    let count = numbers.collect::<Result<Vec<_>, _>>().map(|all| all.len());
    match count {
        Ok(count) if count % 3 == 0 => Ok(()),
        _ => Err(wrong_type(
            "POINTS2D",
            line,
            "a list of points, which follows the line of an image and may be an empty line",
        )),
    }
}

/// The motor of a quaternion, which need not have the length 1, and a translation.
pub(super) fn pose([w, x, y, z]: [f64; 4], along: [f64; 3]) -> Option<Motor<f64>> {
    let length = (w * w + x * x + y * y + z * z).sqrt();
    if !(length.is_finite() && length > 1e-6 && along.iter().all(|x| x.is_finite())) {
        return None;
    }
    let [w, x, y, z] = [w, x, y, z].map(|part| part / length);
    let rotor = Rotor::from_quaternion([x, y, z], w)?;
    Some(Translator::from_displacement(along) * rotor)
}

/// The text of the file of cameras, one for each.
pub(in crate::format) fn encode_cameras(
    cameras: &[NamedCamera],
) -> Result<String, CameraFileError> {
    let mut text = String::from("# Camera list with one line of data per camera:\n");
    text += "#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
    for (index, camera) in cameras.iter().enumerate() {
        let found = model::of(&camera.intrinsics()?);
        let (model, parameters) = found.ok_or_else(|| CameraFileError::CannotHold {
            format: "COLMAP's model",
            what: "the thin prism and the tilt of the lens",
            name: camera.name.clone(),
        })?;
        let [width, height] = camera.known_size()?;
        let parameters = list(&parameters, " ");
        // Writing to a string does not fail.
        _ = writeln!(text, "{} {model} {width} {height} {parameters}", index + 1);
    }
    Ok(text)
}

/// The text of the file of images, one of each camera.
pub(in crate::format) fn encode_images(cameras: &[NamedCamera]) -> Result<String, CameraFileError> {
    let mut text = String::from("# Image list with two lines of data per image:\n");
    text += "#   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n";
    text += "#   POINTS2D[] as (X, Y, POINT3D_ID)\n";
    for (index, camera) in cameras.iter().enumerate() {
        let words: Vec<&str> = camera.name.split_whitespace().collect();
        if words.is_empty() || words.join(" ") != camera.name {
            return Err(CameraFileError::CannotHold {
                format: "COLMAP's model",
                what: "a name that is empty or has other blanks than single spaces",
                name: camera.name.clone(),
            });
        }
        let pose = camera.world_to_camera()?;
        let ([x, y, z], w) = pose.rotor().canonical().to_quaternion();
        let [a, b, c] = pose.translator().displacement();
        let numbers = list(&[w, x, y, z, a, b, c], " ");
        let number = index + 1;
        // Writing to a string does not fail.
        _ = writeln!(text, "{number} {numbers} {number} {}\n", camera.name);
    }
    Ok(text)
}
