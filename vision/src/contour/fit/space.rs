//! Lines and circles in space.

use ga_runtime::cga3::{Circle, Direction, Line, Motor, MotorGenerator, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, SymmetricEigen, U3, Vector3};

use super::{FitError, Frame, circle};
use crate::least_squares::{Columns, Equations, Problem, Settings, minimise};

/// The line in space with the least sum of squared distances to the points, of weight 1: through
/// their centroid along the direction of their greatest variance.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_vision::contour::fit::line_in_space;
///
/// let points = [0.0, 1.0, 2.0, 5.0].map(|t| Point::new(1.0 + t, 2.0 - t, 3.0 * t));
/// let line = line_in_space(&points)?;
/// assert!(line.distance(Point::new(-1.0, 4.0, -6.0)).is_some_and(|distance| distance < 1e-12));
/// # Ok::<(), ga_vision::contour::fit::FitError>(())
/// ```
///
/// # Errors
///
/// [`FitError`] for fewer than two points, points at one place or of which no direction has the
/// greatest variance, and numbers that are not finite.
pub fn line_in_space(points: &[Point<f64>]) -> Result<Line<f64>, FitError> {
    const FIGURE: &str = "line";
    let places: Vec<[f64; 3]> = points.iter().map(|point| point.coordinates()).collect();
    let frame = Frame::new(&places, FIGURE, 2)?;
    let (values, axes) = axes(&frame);
    let gap = values[2] - values[1];
    if gap.is_nan() || gap <= 1e-12 * values[2] {
        return Err(FitError::Degenerate {
            figure: FIGURE,
            arrangement: "they spread equally in several directions",
        });
    }
    Ok(Line::from_point_direction(
        Point::from(frame.centre),
        axes[2].coordinates(),
    ))
}

/// The circle in space with the least sum of squared distances to the points: √((ρ − r)² + h²), for
/// the height h of a point above the plane of the circle and its distance ρ from the axis.
///
/// It is found by the method of Levenberg and Marquardt over the motor that takes the circle
/// `ρ = r, h = 0` to its place, and its radius, from the [circle](circle) in the plane of least
/// squared distances.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_vision::contour::fit::circle_in_space;
///
/// // In the plane x = 1 about (1, 2, 3).
/// let points = [0.0f64, 1.0, 2.0, 3.0, 4.5]
///     .map(|t| Point::new(1.0, 2.0 + 0.5 * t.cos(), 3.0 + 0.5 * t.sin()));
/// let circle = circle_in_space(&points)?;
/// assert!(circle.radius().is_some_and(|radius| (radius - 0.5).abs() < 1e-9));
/// let centre = circle.centre().ok_or("no centre")?;
/// assert!(centre.distance(Point::new(1.0, 2.0, 3.0)) < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`FitError`] for fewer than three points, points on one line, points that no circle fits best,
/// and numbers that are not finite.
pub fn circle_in_space(points: &[Point<f64>]) -> Result<Circle<f64>, FitError> {
    const FIGURE: &str = "circle";
    let places: Vec<[f64; 3]> = points.iter().map(|point| point.coordinates()).collect();
    let frame = Frame::new(&places, FIGURE, 3)?;
    let degenerate = |arrangement| FitError::Degenerate {
        figure: FIGURE,
        arrangement,
    };
    let (values, axes) = axes(&frame);
    if values[1].is_nan() || values[1] <= 1e-12 * values[2] {
        return Err(degenerate("they lie on one line"));
    }
    let [_, second, first] = axes;
    let normal = first.cross(second);
    let flat: Vec<[f64; 2]> = frame
        .points()
        .map(|place| [first, second].map(|axis| axis.dot(Vector::from(place))))
        .collect();
    let none = || degenerate("no circle fits them best");
    let start = circle(&flat)?;
    let ([x, y], radius) = start
        .centre()
        .map(|centre| centre.coordinates())
        .zip(start.radius())
        .ok_or_else(none)?;
    let rows = [first, second, normal].map(Vector::coordinates);
    let columns = [0, 1, 2].map(|row| rows.map(|axis| axis[row]));
    let rotor = Rotor::from_matrix(columns).ok_or_else(none)?;
    let middle = first * x + second * y;
    let state = Placed {
        motor: Translator::from_displacement(middle.coordinates()) * rotor,
        radius,
    };
    let problem = Distances {
        points: frame.points().map(Point::from).collect(),
    };
    // Three points determine five of the six unknowns of a general search: their circle is exact.
    let found = if places.len() == 3 {
        state
    } else {
        let minimum = minimise(&problem, state, &Settings::default());
        minimum.map_err(|_| none())?.state
    };
    let centre = frame.outside(found.motor.transform(Point::default()).coordinates());
    let axis = found.motor.transform(Direction::new(0.0, 0.0, 1.0));
    Circle::from_centre_normal_radius(
        Point::from(centre),
        axis.vector(),
        frame.scale * found.radius,
    )
    .ok_or_else(none)
}

/// The variances of the points of a frame along their principal axes, the least first, and the
/// axes.
fn axes(frame: &Frame<'_, 3>) -> ([f64; 3], [Vector<f64>; 3]) {
    let mut moments = Matrix3::zeros();
    for place in frame.points() {
        let place = Vector3::from(place);
        moments += place * place.transpose();
    }
    let eigen: SymmetricEigen<f64, U3> = moments.symmetric_eigen();
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let axis = |k: usize| {
        let column = eigen.eigenvectors.column(k);
        Vector::new(column[0], column[1], column[2])
    };
    (order.map(|k| eigen.eigenvalues[k]), order.map(axis))
}

/// A circle: its motor takes the circle of its radius about the z axis, at height 0, to its place.
#[derive(Clone, Copy, Debug)]
struct Placed {
    motor: Motor<f64>,
    radius: f64,
}

/// The distances of points from a circle.
struct Distances {
    points: Vec<Point<f64>>,
}

impl Problem for Distances {
    type State = Placed;

    /// The angular velocities about the x and y axes of the circle's frame, the velocity of its
    /// centre there, and the change of the radius.
    fn columns(&self) -> Columns {
        Columns::dense(6)
    }

    fn evaluate(&self, ring: &Placed, equations: &mut Equations) -> Option<()> {
        let to_frame = ring.motor.reverse();
        for point in &self.points {
            let [x, y, height] = to_frame.transform(*point).coordinates();
            let distance = x.hypot(y);
            let [c, s] = if distance > 0.0 {
                [x / distance, y / distance]
            } else {
                [0.0; 2]
            };
            // A point q of the frame moves with −(ω × q + u).
            let derivatives = [
                (0, [-y, s * height]),
                (1, [x, -c * height]),
                (2, [0.0, -c]),
                (3, [0.0, -s]),
                (4, [-1.0, 0.0]),
                (5, [0.0, -1.0]),
            ];
            equations.add([height, distance - ring.radius], &derivatives);
        }
        Some(())
    }

    fn stepped(&self, ring: &Placed, step: &[f64]) -> Option<Placed> {
        let angular = Direction::new(step[0], step[1], 0.0);
        let linear = Direction::new(step[2], step[3], step[4]);
        let motion = MotorGenerator::from_velocities(angular, linear).exp();
        let radius = ring.radius + step[5];
        (radius > 0.0).then_some(Placed {
            motor: ring.motor * motion,
            radius,
        })
    }
}
