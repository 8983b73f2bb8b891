//! Motors as frames, and paths.

use ga_runtime::Element;
use ga_runtime::cga3::{Motor, MotorGenerator, Point, Rotor, Translator};

use super::{Drawable, NotDrawable, Shape, check_coefficients};
use crate::vector3::Vector3;

impl Drawable for Motor<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let (origin, axes) = frame(self)?;
        Shape::Frame { origin, axes }.checked()
    }
}

impl Drawable for Rotor<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        Motor::from(*self).shape()
    }
}

impl Drawable for Translator<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        Motor::from(*self).shape()
    }
}

/// A path: places in their order, or motors that carry a point along.
///
/// ```
/// use ga_draw::{Drawable, Shape, Trajectory};
/// use ga_runtime::cga3::{MotorGenerator, Point};
/// // Half a turn about the z axis, and up by 2.
/// let generator = MotorGenerator::new(-0.5 * std::f64::consts::PI, 0.0, 0.0, 0.0, 0.0, -1.0);
/// let path = Trajectory::screw(generator, 10).carrying(Point::new(1.0, 0.0, 0.0)).with_frames(3);
/// let Shape::Trajectory { points, frames } = path.shape()? else { panic!() };
/// assert_eq!((points.len(), frames.len()), (11, 3));
/// assert!((points[10][0] + 1.0).abs() < 1e-15 && (points[10][2] - 2.0).abs() < 1e-15);
/// # Ok::<(), ga_draw::NotDrawable>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    path: Path,
    frames: usize,
}

#[derive(Clone, Debug, PartialEq)]
enum Path {
    Points(Vec<Point<f64>>),
    Motors(Vec<Motor<f64>>, Point<f64>),
}

impl Trajectory {
    /// The path through points, straight from each to the next.
    #[must_use]
    pub fn through(points: impl IntoIterator<Item = Point<f64>>) -> Self {
        Self {
            path: Path::Points(points.into_iter().collect()),
            frames: 0,
        }
    }

    /// The path of the origin under motors, straight from each place to the next. Give many for a
    /// smooth one.
    #[must_use]
    pub fn of_motors(motors: impl IntoIterator<Item = Motor<f64>>) -> Self {
        Self {
            path: Path::Motors(motors.into_iter().collect(), Point::default()),
            frames: 0,
        }
    }

    /// The path of the origin under `exp(t G)` for t from 0 to 1 in a number of steps, which is a
    /// helix. The generator may turn more than once.
    #[must_use]
    pub fn screw(generator: MotorGenerator<f64>, steps: usize) -> Self {
        let steps = steps.max(1);
        Self::of_motors((0..=steps).map(|step| (generator * (step as f64 / steps as f64)).exp()))
    }

    /// The path of another point than the origin. A path through points stays as it is.
    #[must_use]
    pub fn carrying(self, point: Point<f64>) -> Self {
        let path = match self.path {
            Path::Motors(motors, _) => Path::Motors(motors, point),
            path => path,
        };
        Self { path, ..self }
    }

    /// With this many of the motors drawn as frames along the path, evenly spread from the first to
    /// the last.
    #[must_use]
    pub fn with_frames(self, frames: usize) -> Self {
        Self { frames, ..self }
    }
}

impl Drawable for Trajectory {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let (points, frames) = match &self.path {
            Path::Points(points) => {
                let points = points.iter().map(|point| point.coordinates());
                (points.collect::<Vec<_>>(), Vec::new())
            }
            Path::Motors(motors, point) => {
                let frames = motors.iter().map(frame).collect::<Result<Vec<_>, _>>()?;
                let place = |(origin, axes): &(Vector3, [Vector3; 3])| {
                    let [x, y, z] = point.coordinates();
                    [0, 1, 2].map(|k| origin[k] + axes[0][k] * x + axes[1][k] * y + axes[2][k] * z)
                };
                // The frames ride on the point.
                let riding = |frame: &(Vector3, [Vector3; 3])| (place(frame), frame.1);
                let shown = evenly(frames.len(), self.frames).map(|index| riding(&frames[index]));
                (frames.iter().map(place).collect(), shown.collect())
            }
        };
        if points.is_empty() {
            return Err(NotDrawable::EmptyTrajectory);
        }
        Shape::Trajectory { points, frames }.checked()
    }
}

/// `wanted` of the numbers below `count`, evenly spread from the first to the last.
fn evenly(count: usize, wanted: usize) -> impl Iterator<Item = usize> {
    let wanted = wanted.min(count);
    (0..wanted).map(move |k| match wanted {
        1 => 0,
        _ => k * (count - 1) / (wanted - 1),
    })
}

/// The images of the origin and of the axes.
fn frame(motor: &Motor<f64>) -> Result<(Vector3, [Vector3; 3]), NotDrawable> {
    let blades = Motor::<f64>::BLADES.iter();
    check_coefficients(blades.map(|&blade| motor.coefficient(blade)))?;
    let rows = motor.to_matrix();
    let column = |k: usize| rows.map(|row| row[k]);
    Ok((column(3), [column(0), column(1), column(2)]))
}
