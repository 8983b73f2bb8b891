//! Lines, circles and ellipses through points of a plane, and lines and circles in space, by least
//! squares.

mod space;

pub use space::{circle_in_space, line_in_space};

use ga_runtime::cga2::{Circle, Line, Point};
use nalgebra_035::{Matrix2, Matrix3, Vector2, Vector3};

use crate::least_squares::{Columns, Equations, Loss, Problem, Settings, minimise};

/// Points that do not determine a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    /// There are too few points.
    #[error("{count} points do not determine a {figure}; at least {least} are needed")]
    TooFew {
        /// What should be fitted.
        figure: &'static str,
        /// The number of points.
        count: usize,
        /// The least number.
        least: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("point {index} is not finite")]
    NotFinite {
        /// The point, counted from 0.
        index: usize,
    },
    /// The points lie so that several figures or none fit them best.
    #[error("the points do not determine a {figure}: {arrangement}")]
    Degenerate {
        /// What should be fitted.
        figure: &'static str,
        /// How the points lie.
        arrangement: &'static str,
    },
}

/// An ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// The centre.
    pub centre: [f64; 2],
    /// Half the lengths of the axes, the longer one first.
    pub semi_axes: [f64; 2],
    /// The angle from the u axis to the longer axis in radians, towards the v axis, from −π/2 to
    /// π/2.
    pub angle: f64,
}

/// The line with the least sum of squared distances to the points, of weight 1: through their
/// centroid along the direction of their greatest variance.
///
/// ```
/// use ga_runtime::cga2::Point;
/// use ga_vision::contour::fit::line;
///
/// let fitted = line(&[[0.0, 1.0], [2.0, 2.0], [4.0, 3.0]])?;
/// assert!(fitted.signed_distance(Point::new(6.0, 4.0)).is_some_and(|d| d.abs() < 1e-12));
/// # Ok::<(), ga_vision::contour::fit::FitError>(())
/// ```
///
/// # Errors
///
/// [`FitError`] for fewer than two points, points at one place or equally spread in all directions,
/// and numbers that are not finite.
pub fn line(points: &[[f64; 2]]) -> Result<Line<f64>, FitError> {
    const FIGURE: &str = "line";
    let frame = Frame::new(points, FIGURE, 2)?;
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    for [x, y] in frame.points() {
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    let spread = (2.0 * xy).hypot(xx - yy);
    if spread.is_nan() || spread <= 1e-12 * (xx + yy) {
        return Err(FitError::Degenerate {
            figure: FIGURE,
            arrangement: "they spread equally in all directions",
        });
    }
    let angle = (2.0 * xy).atan2(xx - yy) / 2.0;
    let centre = Point::from(frame.centre);
    Ok(Line::from_point_direction(
        centre,
        [angle.cos(), angle.sin()],
    ))
}

/// The circle with the least sum of squared distances to the points, by the method of Levenberg and
/// Marquardt from the circle that fits `|x − c|² = r²` best (I. Kåsa, 1976).
///
/// ```
/// use ga_vision::contour::fit::circle;
///
/// let fitted = circle(&[[3.0, 0.0], [0.0, 1.0], [-3.0, 0.0]])?;
/// assert!(fitted.radius().is_some_and(|radius| (radius - 5.0).abs() < 1e-12));
/// # Ok::<(), ga_vision::contour::fit::FitError>(())
/// ```
///
/// # Errors
///
/// [`FitError`] for fewer than three points, points on one line, points that no circle fits best,
/// since larger ones fit ever better, and numbers that are not finite.
pub fn circle(points: &[[f64; 2]]) -> Result<Circle<f64>, FitError> {
    const FIGURE: &str = "circle";
    /// Circles through short arcs are found slowly.
    const SETTINGS: Settings = Settings {
        steps: 1000,
        relative_tolerance: 1e-9,
        absolute_tolerance: 1e-11,
        loss: Loss::Squares,
    };
    let frame = Frame::new(points, FIGURE, 3)?;
    let on_a_line = FitError::Degenerate {
        figure: FIGURE,
        arrangement: "they lie on one line",
    };
    // The equations x² + y² = 2 c·x + (r² − c²), whose sums of x and y vanish.
    let count = points.len() as f64;
    let (mut normal, mut right, mut constant) = (Matrix2::zeros(), Vector2::zeros(), 0.0);
    for place in frame.points() {
        let place = Vector2::from(place);
        normal += 2.0 * place * place.transpose();
        right += place.norm_squared() * place;
        constant += place.norm_squared() / count;
    }
    let spread = normal.symmetric_eigenvalues();
    if spread.min().is_nan() || spread.min() <= 1e-12 * spread.max() {
        return Err(on_a_line);
    }
    let centre = normal.try_inverse().ok_or(on_a_line)? * right;
    let radius = (constant + centre.norm_squared()).sqrt();
    let start = [centre.x, centre.y, radius];
    let found = minimise(&Radial(&frame), start, &SETTINGS);
    let [x, y, radius] = found
        .map_err(|_| FitError::Degenerate {
            figure: FIGURE,
            arrangement: "no circle fits them best",
        })?
        .state;
    Ok(Circle::from_centre_radius(
        Point::from(frame.outside([x, y])),
        frame.scale * radius,
    ))
}

/// The distances of points from a circle, of which a state is the centre and the radius.
struct Radial<'a, 'b>(&'b Frame<'a, 2>);

impl Problem for Radial<'_, '_> {
    type State = [f64; 3];

    fn columns(&self) -> Columns {
        Columns::dense(3)
    }

    fn evaluate(&self, [x, y, radius]: &[f64; 3], equations: &mut Equations) -> Option<()> {
        for [u, v] in self.0.points() {
            let (across, down) = (u - x, v - y);
            let distance = across.hypot(down);
            // The distance from a point at the centre has no slope.
            let slope = |part: f64| {
                if distance > 0.0 {
                    -part / distance
                } else {
                    0.0
                }
            };
            equations.add(
                [distance - radius],
                &[(0, [slope(across)]), (1, [slope(down)]), (2, [-1.0])],
            );
        }
        Some(())
    }

    fn stepped(&self, circle: &[f64; 3], step: &[f64]) -> Option<[f64; 3]> {
        let next = [0, 1, 2].map(|k| circle[k] + step[k]);
        (next[2] > 0.0).then_some(next)
    }
}

/// The ellipse whose conic `A u² + B u v + C v² + D u + E v + F` has the least sum of squares at
/// the points with `4AC − B² = 1` (A. Fitzgibbon, M. Pilu and R. Fisher, "Direct least square
/// fitting of ellipses", 1999, in the form of R. Halíř and J. Flusser, 1998).
///
/// ```
/// use ga_vision::contour::fit::ellipse;
///
/// // u²/9 + v²/4 = 1, moved by (5, 1).
/// let points = [[8.0, 1.0], [5.0, 3.0], [2.0, 1.0], [5.0, -1.0], [6.8, 2.6], [3.2, -0.6]];
/// let fitted = ellipse(&points)?;
/// assert!((fitted.semi_axes[0] - 3.0).abs() < 1e-9 && (fitted.semi_axes[1] - 2.0).abs() < 1e-9);
/// assert!((fitted.centre[0] - 5.0).abs() < 1e-9 && fitted.angle.abs() < 1e-9);
/// # Ok::<(), ga_vision::contour::fit::FitError>(())
/// ```
///
/// # Errors
///
/// [`FitError`] for fewer than five points, points on one line or on no ellipse, and numbers that
/// are not finite.
pub fn ellipse(points: &[[f64; 2]]) -> Result<Ellipse, FitError> {
    const FIGURE: &str = "ellipse";
    let frame = Frame::new(points, FIGURE, 5)?;
    let degenerate = FitError::Degenerate {
        figure: FIGURE,
        arrangement: "no ellipse fits them best",
    };
    // The fit does not depend on affine maps: the places are stretched to equal variance first, so
    // that long ellipses are as accurate as circles.
    let mut variance = Matrix2::zeros();
    for place in frame.points() {
        let place = Vector2::from(place);
        variance += place * place.transpose() / points.len() as f64;
    }
    let axes = variance.symmetric_eigen();
    let [least, greatest] = [axes.eigenvalues.min(), axes.eigenvalues.max()];
    if least.is_nan() || least <= 1e-12 * greatest {
        return Err(degenerate);
    }
    let scales = Matrix2::from_diagonal(&axes.eigenvalues.map(|value| 1.0 / value.sqrt()));
    let stretch = scales * axes.eigenvectors.transpose();
    let [mut s1, mut s2, mut s3] = [Matrix3::<f64>::zeros(); 3];
    for place in frame.points() {
        let [x, y] = (stretch * Vector2::from(place)).into();
        let square = Vector3::new(x * x, x * y, y * y);
        let linear = Vector3::new(x, y, 1.0);
        s1 += square * square.transpose();
        s2 += square * linear.transpose();
        s3 += linear * linear.transpose();
    }
    let eliminated = -s3.try_inverse().ok_or(degenerate)? * s2.transpose();
    let reduced = s1 + s2 * eliminated;
    let constraint = Matrix3::new(0.0, 0.0, 0.5, 0.0, -1.0, 0.0, 0.5, 0.0, 0.0);
    let matrix = constraint * reduced;
    let quadratic = matrix
        .complex_eigenvalues()
        .iter()
        .map(|value| null_vector(matrix - Matrix3::identity() * value.re))
        .max_by(|a, b| discriminant(*a).total_cmp(&discriminant(*b)))
        .filter(|found| discriminant(*found) > 1e-9)
        .ok_or(degenerate)?;
    let [a, b, c] = quadratic.into();
    let [d, e, f] = (eliminated * quadratic).into();
    let form = Matrix2::new(a, b / 2.0, b / 2.0, c);
    let inverse = form.try_inverse().ok_or(degenerate)?;
    let centre = inverse * Vector2::new(d, e) * -0.5;
    let level = -(f + (d * centre.x + e * centre.y) / 2.0);
    let centre = stretch.try_inverse().ok_or(degenerate)? * centre;
    let eigen = (stretch.transpose() * form * stretch).symmetric_eigen();
    let squares = eigen.eigenvalues.map(|value| level / value);
    let [long, short] = if squares[0] >= squares[1] {
        [0, 1]
    } else {
        [1, 0]
    };
    if squares[short].is_nan() || squares[short] <= 0.0 {
        return Err(degenerate);
    }
    let axis = eigen.eigenvectors.column(long);
    Ok(Ellipse {
        centre: frame.outside(centre.into()),
        semi_axes: [long, short].map(|k| frame.scale * squares[k].sqrt()),
        angle: (axis[1] / axis[0]).atan(),
    })
}

fn discriminant(conic: Vector3<f64>) -> f64 {
    4.0 * conic.x * conic.z - conic.y * conic.y
}

/// The unit vector that a singular matrix takes to zero.
fn null_vector(matrix: Matrix3<f64>) -> Vector3<f64> {
    let rows = [0, 1, 2].map(|row| matrix.row(row).transpose());
    let products = [
        rows[0].cross(&rows[1]),
        rows[1].cross(&rows[2]),
        rows[2].cross(&rows[0]),
    ];
    let longest = products
        .into_iter()
        .max_by(|a, b| a.norm().total_cmp(&b.norm()));
    let vector = longest.unwrap_or_default();
    vector.try_normalize(0.0).unwrap_or_default()
}

/// Points seen from their centroid, in units of their root mean square distance from it.
struct Frame<'a, const N: usize> {
    points: &'a [[f64; N]],
    centre: [f64; N],
    scale: f64,
}

impl<'a, const N: usize> Frame<'a, N> {
    fn new(points: &'a [[f64; N]], figure: &'static str, least: usize) -> Result<Self, FitError> {
        let count = points.len();
        if count < least {
            return Err(FitError::TooFew {
                figure,
                count,
                least,
            });
        }
        let is_finite = |point: &[f64; N]| point.iter().all(|x| x.is_finite());
        if let Some(index) = points.iter().position(|point| !is_finite(point)) {
            return Err(FitError::NotFinite { index });
        }
        let mean =
            |value: &dyn Fn(&[f64; N]) -> f64| points.iter().map(value).sum::<f64>() / count as f64;
        let centre: [f64; N] = std::array::from_fn(|axis| mean(&|point| point[axis]));
        let square = |p: &[f64; N]| {
            p.iter()
                .zip(centre)
                .map(|(x, c)| (x - c).powi(2))
                .sum::<f64>()
        };
        let scale = mean(&square).sqrt();
        let size = centre.iter().fold(0.0f64, |size, x| size.max(x.abs()));
        if !(scale > 1e-12 * size && scale.is_finite()) {
            return Err(FitError::Degenerate {
                figure,
                arrangement: "they lie at one place",
            });
        }
        Ok(Self {
            points,
            centre,
            scale,
        })
    }

    fn points(&self) -> impl Iterator<Item = [f64; N]> {
        let inside = |p: &[f64; N]| std::array::from_fn(|k| (p[k] - self.centre[k]) / self.scale);
        self.points.iter().map(inside)
    }

    fn outside(&self, place: [f64; N]) -> [f64; N] {
        std::array::from_fn(|axis| self.centre[axis] + self.scale * place[axis])
    }
}
