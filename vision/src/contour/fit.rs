//! Ellipses through points of a plane, by least squares. Lines and circles, of the plane and in
//! space, have their fits in [`ga_runtime::geometry::fit`].

use crate::contour::ContourError;
use nalgebra_035::{Matrix2, Matrix3, Vector2, Vector3};
use serde::Serialize;

/// An ellipse. Serialised, its numbers have their units in their names.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ellipse {
    /// The centre.
    #[serde(rename = "centre_px")]
    pub centre: [f64; 2],
    /// Half the lengths of the axes, the longer one first.
    #[serde(rename = "semi_axes_px")]
    pub semi_axes: [f64; 2],
    /// The angle from the u axis to the longer axis in radians, towards the v axis, from −π/2 to
    /// π/2.
    #[serde(rename = "angle_rad")]
    pub angle: f64,
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
/// # Ok::<(), ga_vision::contour::ContourError>(())
/// ```
///
/// # Errors
///
/// [`ContourError`] for fewer than five points, points on one line or on no ellipse, and numbers
/// that are not finite.
pub fn ellipse(points: &[[f64; 2]]) -> Result<Ellipse, ContourError> {
    let frame = Frame::new(points, 5)?;
    let degenerate = || ContourError::Degenerate {
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
        return Err(degenerate());
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
    let eliminated = -s3.try_inverse().ok_or_else(degenerate)? * s2.transpose();
    let reduced = s1 + s2 * eliminated;
    let constraint = Matrix3::new(0.0, 0.0, 0.5, 0.0, -1.0, 0.0, 0.5, 0.0, 0.0);
    let matrix = constraint * reduced;
    let quadratic = matrix
        .complex_eigenvalues()
        .iter()
        .map(|value| null_vector(matrix - Matrix3::identity() * value.re))
        .max_by(|a, b| discriminant(*a).total_cmp(&discriminant(*b)))
        .filter(|found| discriminant(*found) > 1e-9)
        .ok_or_else(degenerate)?;
    let [a, b, c] = quadratic.into();
    let [d, e, f] = (eliminated * quadratic).into();
    let form = Matrix2::new(a, b / 2.0, b / 2.0, c);
    let inverse = form.try_inverse().ok_or_else(degenerate)?;
    let centre = inverse * Vector2::new(d, e) * -0.5;
    let level = -(f + (d * centre.x + e * centre.y) / 2.0);
    let centre = stretch.try_inverse().ok_or_else(degenerate)? * centre;
    let eigen = (stretch.transpose() * form * stretch).symmetric_eigen();
    let squares = eigen.eigenvalues.map(|value| level / value);
    let [long, short] = if squares[0] >= squares[1] {
        [0, 1]
    } else {
        [1, 0]
    };
    if squares[short].is_nan() || squares[short] <= 0.0 {
        return Err(degenerate());
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
struct Frame<'a> {
    points: &'a [[f64; 2]],
    centre: [f64; 2],
    scale: f64,
}

impl<'a> Frame<'a> {
    fn new(points: &'a [[f64; 2]], least: usize) -> Result<Self, ContourError> {
        let count = points.len();
        if count < least {
            return Err(ContourError::EllipseTooFew { count, least });
        }
        let is_finite = |point: &[f64; 2]| point.iter().all(|x| x.is_finite());
        if let Some(index) = points.iter().position(|point| !is_finite(point)) {
            return Err(ContourError::EllipseNotFinite { index });
        }
        let mean =
            |value: &dyn Fn(&[f64; 2]) -> f64| points.iter().map(value).sum::<f64>() / count as f64;
        let centre = [0, 1].map(|axis| mean(&|point| point[axis]));
        let square = |[x, y]: &[f64; 2]| (x - centre[0]).powi(2) + (y - centre[1]).powi(2);
        let scale = mean(&square).sqrt();
        let size = centre[0].abs().max(centre[1].abs());
        if !(scale > 1e-12 * size && scale.is_finite()) {
            return Err(ContourError::Degenerate {
                arrangement: "they lie at one place",
            });
        }
        Ok(Self {
            points,
            centre,
            scale,
        })
    }

    fn points(&self) -> impl Iterator<Item = [f64; 2]> {
        let inside = |p: &[f64; 2]| [0, 1].map(|k| (p[k] - self.centre[k]) / self.scale);
        self.points.iter().map(inside)
    }

    fn outside(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.centre[axis] + self.scale * place[axis])
    }
}
