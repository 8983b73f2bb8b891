//! The calibration of Qualisys' QTM: XML with the ending `.qca.txt`.
//!
//! Of each camera, `intrinsic` has focal lengths and principal point in 64ths of a pixel, with the
//! middle of the first pixel at (0, 0), and `radialDistortion1` to `3` and `tangentalDistortion1`
//! and `2`, which are OpenCV's k1, k2, k3, p1 and p2. `transform` has the place of the camera in
//! millimetres and the rows of the rotation from the world to a frame with x to the right, y up and
//! z backwards. The name is the `serial`, the size that of `fov_video`. Cameras that are not active
//! are left out.
//!
//! The calibration is that of the pixels for markers, `fov_marker_max`. Where the video has others,
//! by `fov_video_max` or by a `video_resolution` such as `540p` of 1080 lines, focal lengths and
//! principal point are brought to its pixels: a place u is at `s (u + 1/2) - 1/2`.

use ga_runtime::cga3::{Motor, Point, Translator};
use roxmltree::Node;

use super::camera_file::{CameraFile, NamedCamera};
use super::error::{CameraFileError, Place, absent, finite, wrong_type};
use super::fields::{pinhole, pixels};
use super::lens::stated_lens;
use super::rotation::nearest_rotor;
use super::syntax::xml::Xml;
use crate::LensModel;

/// The parts of a pixel in which the file counts.
const PARTS: f64 = 64.0;

/// Whether the root is that of such a file.
pub(super) fn is_calibration(xml: &Xml) -> bool {
    let mut children = xml.root().children();
    xml.root().has_tag_name("calibration") && children.any(|child| child.has_tag_name("cameras"))
}

/// The cameras of a file.
pub(super) fn decode(xml: &Xml) -> Result<CameraFile, CameraFileError> {
    let elements = xml.root().descendants();
    let elements = elements.filter(|element| {
        element.has_tag_name("camera") && element.attribute("active") != Some("0")
    });
    let cameras = elements.enumerate().map(|(index, element)| {
        let part = Part { xml, element };
        part.camera(
            element
                .attribute("serial")
                .map_or_else(|| index.to_string(), str::to_owned),
        )
    });
    let cameras = cameras.collect::<Result<Vec<_>, _>>()?;
    match cameras.is_empty() {
        false => Ok(CameraFile::new(cameras)),
        true => Err(absent(Place::on_line(xml.line(xml.root()), "camera"))),
    }
}

/// An element with its attributes.
#[derive(Clone, Copy)]
struct Part<'a, 'b> {
    xml: &'a Xml<'b>,
    element: Node<'a, 'b>,
}

impl Part<'_, '_> {
    fn place(&self, name: &str) -> Place {
        let key = format!("{}.{name}", self.element.tag_name().name());
        Place::on_line(self.xml.line(self.element), key)
    }

    fn missing(&self, name: &str) -> CameraFileError {
        absent(self.place(name))
    }

    fn child(self, name: &str) -> Option<Self> {
        let mut children = self.element.children();
        let element = children.find(|child| child.has_tag_name(name))?;
        Some(Self { element, ..self })
    }

    fn required(self, name: &str) -> Result<Self, CameraFileError> {
        self.child(name).ok_or_else(|| self.missing(name))
    }

    fn number(&self, name: &str) -> Result<f64, CameraFileError> {
        let text = self.element.attribute(name);
        let text = text.ok_or_else(|| self.missing(name))?;
        let place = self.place(name);
        let line = place.line.unwrap_or(0);
        let number = text.trim().parse::<f64>();
        let value = number.map_err(|_| wrong_type(&place.key, line, "a number"))?;
        finite(|| place, value)
    }

    fn numbers<const N: usize>(&self, names: [&str; N]) -> Result<[f64; N], CameraFileError> {
        let mut values = [0.0; N];
        for (value, name) in values.iter_mut().zip(names) {
            *value = self.number(name)?;
        }
        Ok(values)
    }

    fn camera(self, name: String) -> Result<NamedCamera, CameraFileError> {
        let inner = self.required("intrinsic")?;
        let focal = inner.numbers(["focalLengthU", "focalLengthV"])?;
        let principal = inner.numbers(["centerPointU", "centerPointV"])?;
        let pictures = self.pictures()?;
        let scale = pictures.scale / PARTS;
        let corner = pictures.field.map_or([0.0; 2], |field| field.corner);
        // The principal point is that of the whole sensor, and pictures are a field of it.
        let principal = [0, 1].map(|k| {
            let from_edge = scale * (principal[k] + 0.5 * PARTS);
            from_edge - 0.5 - corner[k]
        });
        let place = || inner.place("focalLengthU");
        let plain = pinhole(focal.map(|f| scale * f), principal, place)?;
        let [k1, k2, k3] = inner.numbers([
            "radialDistortion1",
            "radialDistortion2",
            "radialDistortion3",
        ])?;
        let [p1, p2] = inner.numbers(["tangentalDistortion1", "tangentalDistortion2"])?;
        let coefficients = [k1, k2, p1, p2, k3];
        let place = || inner.place("radialDistortion1");
        let lens = stated_lens(&coefficients, LensModel::RadialTangential, place)?;
        let skew = match inner.element.has_attribute("skew") {
            true => scale * inner.number("skew")?,
            false => 0.0,
        };
        let camera = NamedCamera::new(name, plain.with_lens(lens)).with_skew(skew);
        let pose = self.child("transform").map(Part::pose).transpose()?;
        let size = pictures.field.map(|field| field.size);
        Ok(camera.with_size(size).with_pose(pose))
    }

    fn pose(self) -> Result<Motor<f64>, CameraFileError> {
        let [right, up, back] = [
            self.numbers(["r11", "r12", "r13"])?,
            self.numbers(["r21", "r22", "r23"])?,
            self.numbers(["r31", "r32", "r33"])?,
        ];
        // Down and forwards, where the file has up and backwards.
        let rotation = [right, up.map(|x| -x), back.map(|x| -x)];
        let rotor = nearest_rotor(rotation, || self.place("r11"))?;
        let centre = self.numbers(["x", "y", "z"])?.map(|x| x * 1e-3);
        let along = rotor.transform(Point::from(centre)).coordinates();
        Ok(Translator::from_displacement(along.map(|x| -x)) * rotor)
    }

    /// What the pictures are of the sensor: the video's, or else those for markers.
    fn pictures(self) -> Result<Pictures, CameraFileError> {
        let field = |name| self.child(name).map(Self::field).transpose();
        // Cameras for markers alone have no video, or one of a single pixel.
        let video = field("fov_video")?.filter(|video| video.size != [1; 2]);
        let Some(video) = video else {
            return Ok(Pictures {
                field: field("fov_marker")?,
                scale: 1.0,
            });
        };
        let sensor = field("fov_video_max")?.unwrap_or(video);
        let whole = field("fov_marker_max")?.unwrap_or(sensor).size;
        let scale = scale_between(whole, sensor.size);
        let scale = scale.ok_or_else(|| CameraFileError::Sizes {
            place: self.place("fov_video_max"),
            found: sensor.size,
            whole,
        })?;
        let Some(lines) = self.lines() else {
            let field = Some(video);
            return Ok(Pictures { field, scale });
        };
        // The fields may be those of all pixels, of which the video joins several to one.
        let sides = sensor.size[0].min(sensor.size[1]);
        let joined = (sides as f64 / lines as f64).round().max(1.0);
        let is_whole = (sides as f64 / (joined * lines as f64) - 1.0).abs() < 0.03;
        let size = video.size.map(|side| side as f64 / joined);
        if !is_whole || size.iter().any(|side| side.fract() != 0.0) {
            return Err(CameraFileError::Value {
                place: self.place("video_resolution"),
                expected: "the lines of fov_video_max, or a half or a third of them and so on",
            });
        }
        Ok(Pictures {
            field: Some(Field {
                corner: video.corner.map(|first| first / joined),
                size: size.map(|side| side as usize),
            }),
            scale: scale / joined,
        })
    }

    /// The lines of the video, by a resolution such as `1080p`.
    fn lines(&self) -> Option<usize> {
        let text = self.element.attribute("video_resolution")?;
        let lines = text.trim().strip_suffix('p')?.parse().ok();
        lines.filter(|lines| *lines > 0)
    }

    fn field(self) -> Result<Field, CameraFileError> {
        let [left, top, right, bottom] = self.numbers(["left", "top", "right", "bottom"])?;
        let pixels = |name, value| pixels(self.place(name), value);
        Ok(Field {
            corner: [left, top],
            size: [
                pixels("right", right - left + 1.0)?,
                pixels("bottom", bottom - top + 1.0)?,
            ],
        })
    }
}

/// Pixels of the sensor.
#[derive(Clone, Copy)]
struct Field {
    /// The first column and the first row.
    corner: [f64; 2],
    size: [usize; 2],
}

/// What pictures are of the sensor, and how many of their pixels are one of the calibration.
struct Pictures {
    field: Option<Field>,
    scale: f64,
}

/// How many pixels of one size are a pixel of another, where both are of the same sensor. Sizes of
/// the sensor may differ by a row or a column that is not used.
fn scale_between(from: [usize; 2], to: [usize; 2]) -> Option<f64> {
    let differ = |k: usize| from[k].abs_diff(to[k]);
    if differ(0) <= 1 && differ(1) <= 1 {
        return Some(1.0);
    }
    let [wide, high] = [0, 1].map(|k| to[k] as f64 / from[k] as f64);
    ((wide / high - 1.0).abs() < 0.01).then_some(0.5 * (wide + high))
}
