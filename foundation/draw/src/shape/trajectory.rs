//! Trajectories.

use ga_runtime::batch;
use ga_runtime::cga3::{Motor, MotorGenerator, Point};

use super::motion::frame;
use super::{Drawable, NotDrawable, Shape};

/// A path through points, or the path of a point that motors move.
///
/// ```
/// use ga_draw::{Drawable, Shape, Trajectory};
/// use ga_runtime::cga3::{MotorGenerator, Point};
/// // A rotation by 180° about the z axis and a translation by 2 along it.
/// let generator = MotorGenerator::new(-0.5 * std::f64::consts::PI, 0.0, 0.0, 0.0, 0.0, -1.0);
/// let path = Trajectory::screw(generator, 10).carrying(Point::new(1.0, 0.0, 0.0)).with_frames(3);
/// let Shape::Trajectory { points, frames } = path.shape()? else { panic!() };
/// assert_eq!((points.len(), frames.len()), (11, 3));
/// let end = points[10];
/// assert!((end.e1() + 1.0).abs() < 1e-15 && (end.e3() - 2.0).abs() < 1e-15);
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
    /// The path that goes straight from each point to the next.
    #[must_use]
    pub fn through(points: impl IntoIterator<Item = Point<f64>>) -> Self {
        Self {
            path: Path::Points(points.into_iter().collect()),
            frames: 0,
        }
    }

    /// The path of the origin under motors, straight from each image to the next. Many motors give
    /// a smooth path.
    #[must_use]
    pub fn of_motors(motors: impl IntoIterator<Item = Motor<f64>>) -> Self {
        Self {
            path: Path::Motors(motors.into_iter().collect(), Point::default()),
            frames: 0,
        }
    }

    /// The path of the origin under `exp(t G)` for t from 0 to 1 in a number of steps, which is a
    /// helix. The generator may rotate by more than 360°.
    #[must_use]
    pub fn screw(generator: MotorGenerator<f64>, steps: usize) -> Self {
        let steps = steps.max(1);
        let part = |step| generator * (step as f64 / steps as f64);
        let generators: Vec<_> = (0..=steps).map(part).collect();
        let mut motors = vec![Motor::default(); generators.len()];
        batch::exp(&generators, &mut motors).expect("a motor for each generator");
        Self::of_motors(motors)
    }

    /// The path of a given point instead of the origin. A path through points stays as it is.
    #[must_use]
    pub fn carrying(self, point: Point<f64>) -> Self {
        let path = match self.path {
            Path::Motors(motors, _) => Path::Motors(motors, point),
            path => path,
        };
        Self { path, ..self }
    }

    /// The path with a number of its motors drawn as frames, evenly spaced from the first to the
    /// last.
    #[must_use]
    pub fn with_frames(self, frames: usize) -> Self {
        Self { frames, ..self }
    }
}

impl Drawable for Trajectory {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let (points, frames) = match &self.path {
            Path::Points(points) => (points.clone(), Vec::new()),
            Path::Motors(motors, point) => {
                let frames = motors.iter().map(frame).collect::<Result<Vec<_>, _>>()?;
                let carry = carrying(*point);
                let points: Vec<_> = motors.iter().map(|motor| carry.apply(*motor)).collect();
                // The frames move with the point.
                let shown = evenly(frames.len(), self.frames);
                let shown = shown
                    .map(|index| (points[index], frames[index].1))
                    .collect();
                (points, shown)
            }
        };
        if points.is_empty() {
            return Err(NotDrawable::EmptyTrajectory);
        }
        Shape::Trajectory { points, frames }.checked()
    }
}

ga_runtime::ga! {
    ga_runtime::cga3;
    /// A point that many motors move.
    fn carrying(uniform point: Point, motor: Motor) -> Point { sandwich(motor, point) }
}

/// `wanted` of the numbers below `count`, evenly spaced from the first to the last.
fn evenly(count: usize, wanted: usize) -> impl Iterator<Item = usize> {
    let wanted = wanted.min(count);
    (0..wanted).map(move |k| match wanted {
        1 => 0,
        _ => k * (count - 1) / (wanted - 1),
    })
}
