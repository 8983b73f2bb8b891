//! The calibration of Qualisys' QTM: XML with the ending `.qca.txt`.
//!
//! Of each camera, `intrinsic` has focal lengths and principal point in 64ths of a pixel, with the
//! middle of the first pixel at (0, 0), and `radialDistortion1` to `3` and `tangentalDistortion1`
//! and `2`, which are OpenCV's k1, k2, k3, p1 and p2. `transform` has the place of the camera in
//! millimetres and the rows of the rotation from the world to a frame with x to the right, y up and
//! z backwards. The name is the `serial`, the size that of `fov_video`. Cameras that are not active
//! are left out.

use ga_runtime::cga3::{Motor, Point, Translator};
use roxmltree::Node;

use super::camera_file::{CameraFile, NamedCamera};
use super::error::{CameraFileError, Place, wrong_type};
use super::fields::{lens, pixels, refused};
use super::rotation::nearest_rotor;
use super::syntax::xml::Xml;
use crate::{Intrinsics, LensModel};

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
        true => Err(CameraFileError::Missing {
            place: Place::on_line(xml.line(xml.root()), "camera"),
            also: Vec::new(),
        }),
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
        CameraFileError::Missing {
            place: self.place(name),
            also: Vec::new(),
        }
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
        match value.is_finite() {
            true => Ok(value),
            false => Err(CameraFileError::NotFinite { place, value }),
        }
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
        let [focal, mut principal] = [focal, principal].map(|pair| pair.map(|x| x / PARTS));
        // The principal point is that of the whole sensor, and pictures are a field of it.
        let field = self.child("fov_video").or(self.child("fov_marker"));
        let corner = field
            .map(|field| field.numbers(["left", "top"]))
            .transpose()?;
        for (place, first) in principal.iter_mut().zip(corner.unwrap_or_default()) {
            *place -= first;
        }
        let plain = Intrinsics::new(focal, principal);
        let plain = plain.map_err(|error| refused(inner.place("focalLengthU"), error))?;
        let [k1, k2, k3] = inner.numbers([
            "radialDistortion1",
            "radialDistortion2",
            "radialDistortion3",
        ])?;
        let [p1, p2] = inner.numbers(["tangentalDistortion1", "tangentalDistortion2"])?;
        let coefficients = [k1, k2, p1, p2, k3];
        let (lens, _) = lens(&coefficients, Some(LensModel::RadialTangential))
            .map_err(|error| refused(inner.place("radialDistortion1"), error))?;
        let skew = match inner.element.has_attribute("skew") {
            true => inner.number("skew")? / PARTS,
            false => 0.0,
        };
        let camera = NamedCamera::new(name, plain.with_lens(lens)).with_skew(skew);
        let pose = self.child("transform").map(Part::pose).transpose()?;
        let size = field.map(Part::size).transpose()?;
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
        let rotor = nearest_rotor(rotation).map_err(|deviation| CameraFileError::Rotation {
            place: self.place("r11"),
            deviation,
        })?;
        let centre = self.numbers(["x", "y", "z"])?.map(|x| x * 1e-3);
        let along = rotor.transform(Point::from(centre)).coordinates();
        Ok(Translator::from_displacement(along.map(|x| -x)) * rotor)
    }

    fn size(self) -> Result<[usize; 2], CameraFileError> {
        let [left, top, right, bottom] = self.numbers(["left", "top", "right", "bottom"])?;
        let pixels = |name, value| pixels(self.place(name), value);
        Ok([
            pixels("right", right - left + 1.0)?,
            pixels("bottom", bottom - top + 1.0)?,
        ])
    }
}
