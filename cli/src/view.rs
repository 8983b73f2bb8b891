//! From where a model is seen.

use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use ga_render::ViewDirection;
use ga_render::model::Model;
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;

use crate::camera_file;
use crate::format::Format;

/// What `--camera` asks for.
#[derive(Clone, Debug)]
pub(crate) enum View {
    /// The whole model from a side.
    Named(ViewDirection),
    /// From a place towards another.
    Towards {
        eye: [f64; 3],
        target: [f64; 3],
        up: [f64; 3],
        /// The vertical field of view in degrees.
        field_of_view: f64,
    },
    /// A camera of a file, and what it sees.
    File {
        /// Columns and rows of its pictures, where the file states them.
        size: Option<[u32; 2]>,
        view: ga_render::View,
    },
}

/// The vertical field of view of named views, in radians.
const FIELD_OF_VIEW: f64 = 0.6;

/// The free border of named views, as a fraction of half the picture.
const MARGIN: f64 = 0.08;

/// The near depth of a camera at a place, as a share of the distance to its target.
const NEAR: f64 = 1e-3;

impl View {
    /// Reads a file where the text is the name of one, and takes its camera of a name.
    pub(crate) fn parse(text: &str, name: Option<&str>) -> Result<Self> {
        if let Some(path) = camera_path(text) {
            let camera = camera_file::read_one(path, name)?;
            let view = camera_file::to_view(&camera);
            let view = view.with_context(|| path.display().to_string())?;
            return Ok(Self::File {
                size: camera.size.map(|size| size.map(|side| side as u32)),
                view,
            });
        }
        ensure!(
            name.is_none(),
            "--view chooses a camera of a file, and --camera {text} is none"
        );
        let side = |azimuth: f64, elevation: f64| {
            Ok(Self::Named(ViewDirection {
                azimuth: azimuth.to_radians(),
                elevation: elevation.to_radians(),
            }))
        };
        match text.trim() {
            "front" => side(0.0, 0.0),
            "side" => side(90.0, 0.0),
            "top" => side(0.0, 90.0),
            "three-quarter" => side(35.0, 20.0),
            words if words.starts_with("eye ") => towards(words),
            _ => bail!(
                "--camera {text}: not front, side, top, three-quarter, the file of a camera, or of \
                 the form \"eye X,Y,Z target X,Y,Z fov DEGREES\""
            ),
        }
    }

    /// The size of the picture, where the view is for one.
    pub(crate) fn size(&self) -> Option<[u32; 2]> {
        match self {
            Self::File { size, .. } => *size,
            Self::Named(_) | Self::Towards { .. } => None,
        }
    }

    /// The cameras of a number of pictures with this quotient of width and height, the first as the
    /// view asks for, the others around the vertical axis through the middle of the model. A named
    /// view has the model whole in all of them.
    pub(crate) fn cameras(
        &self,
        model: &Model,
        aspect: f64,
        count: u32,
    ) -> Result<Vec<ga_render::View>> {
        let [low, high] = bounds(model);
        let middle = Point::new((low.e1 + high.e1) / 2.0, 0.0, (low.e3 + high.e3) / 2.0);
        let steps = (0..count).map(|step| {
            let angle = std::f64::consts::TAU * f64::from(step) / f64::from(count);
            let rotor = Rotor::from_axis_angle([0.0, 1.0, 0.0], angle).unwrap_or_default();
            Motor::about(middle, rotor)
        });
        // Seen from a camera that has moved, the model has moved in the opposite way.
        let shown = steps.clone().flat_map(|motion| {
            let back = motion.reverse();
            let points = model.points();
            points.map(move |point| back.transform(Point::from(point)).coordinates())
        });
        let first = self.camera(shown, aspect)?;
        Ok(steps.map(|motion| first.moved(motion)).collect())
    }

    fn camera(
        &self,
        shown: impl Iterator<Item = [f64; 3]>,
        aspect: f64,
    ) -> Result<ga_render::View> {
        Ok(match self {
            Self::Named(view) => ga_render::View::fit(shown, *view, FIELD_OF_VIEW, aspect, MARGIN)?,
            Self::Towards {
                eye,
                target,
                up,
                field_of_view,
            } => {
                let squares = (0..3).map(|axis| (eye[axis] - target[axis]).powi(2));
                let near = NEAR * squares.sum::<f64>().sqrt();
                let near = near.max(f64::MIN_POSITIVE);
                ga_render::View::look_at(*eye, *target, *up, field_of_view.to_radians(), near)?
            }
            Self::File { view, .. } => *view,
        })
    }
}

/// The path of a file of cameras, where `--camera` is one.
pub(crate) fn camera_path(text: &str) -> Option<&Path> {
    let text = text.trim();
    // Names of views mean them whatever lies in the folder.
    if ["front", "side", "top", "three-quarter"].contains(&text) || text.starts_with("eye ") {
        return None;
    }
    let path = Path::new(text);
    let is_known = Format::of(path, &[Format::Json, Format::Yaml, Format::Text]).is_some();
    (is_known || path.exists()).then_some(path)
}

/// The least and the greatest coordinates of the model's vertices; zeros without vertices.
pub(crate) fn bounds(model: &Model) -> [Vector<f64>; 2] {
    ga_mesh::bounds(model.points().map(Vector::from)).unwrap_or_default()
}

/// `eye X,Y,Z target X,Y,Z [up X,Y,Z] fov DEGREES`, the pairs in any order.
fn towards(text: &str) -> Result<View> {
    let (mut eye, mut target, mut up, mut field_of_view) = (None, None, None, None);
    let mut words = text.split_whitespace();
    while let Some(name) = words.next() {
        let value = words
            .next()
            .with_context(|| format!("--camera: there is nothing after {name}"))?;
        match name {
            "eye" => eye = Some(triple(name, value)?),
            "target" => target = Some(triple(name, value)?),
            "up" => up = Some(triple(name, value)?),
            "fov" => field_of_view = Some(number(name, value)?),
            _ => bail!("--camera: {name:?} is not eye, target, up or fov"),
        }
    }
    Ok(View::Towards {
        eye: eye.context("--camera: the eye is missing")?,
        target: target.context("--camera: the target is missing")?,
        up: up.unwrap_or([0.0, 1.0, 0.0]),
        field_of_view: field_of_view.context("--camera: the field of view (fov) is missing")?,
    })
}

fn triple(name: &str, text: &str) -> Result<[f64; 3]> {
    let numbers = text.split(',').map(|part| number(name, part));
    let numbers = numbers.collect::<Result<Vec<_>>>()?;
    let found = numbers.len();
    <[f64; 3]>::try_from(numbers)
        .ok()
        .with_context(|| format!("--camera: {name} {text} has {found} numbers, not 3"))
}

fn number(name: &str, text: &str) -> Result<f64> {
    let number = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.with_context(|| format!("--camera: {text:?} after {name} is not a finite number"))
}
