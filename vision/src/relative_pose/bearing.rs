//! Directions in which a camera sees pixels.

use ga_runtime::cga3::{Line, Point};
use ga_runtime::vga3::Vector;

use ga_camera::{CameraError, Intrinsics};

/// Directions whose cosine to the optical axis is below this are scaled to length 1.
const LEAST_DEPTH: f64 = 0.05;

/// The direction in which a camera sees a pixel, and how it changes with the pixel.
///
/// The direction d is in the camera's frame, with the coordinate 1 along the optical axis, or of
/// length 1 where a fisheye lens looks almost beside the camera. The ray is the line `eo ∧ d ∧ ei`
/// through the camera's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing {
    /// The direction d.
    pub direction: Vector<f64>,
    /// `∂d/∂u` and `∂d/∂v`, a pixel to the right and a pixel down.
    pub derivatives: [Vector<f64>; 2],
}

impl Bearing {
    /// The direction in which a camera sees a pixel.
    ///
    /// # Errors
    /// As [`Intrinsics::direction`].
    ///
    /// ```
    /// use ga_camera::Intrinsics;
    /// use ga_vision::relative_pose::Bearing;
    ///
    /// let camera = Intrinsics::new([500.0, 400.0], [320.0, 240.0])?;
    /// let bearing = Bearing::of_pixel(&camera, [420.0, 240.0])?;
    /// assert!((bearing.direction.e1 - 0.2).abs() < 1e-15 && bearing.direction.e3 == 1.0);
    /// assert!((bearing.derivatives[0].e1 - 0.002).abs() < 1e-15);
    /// # Ok::<(), ga_camera::CameraError>(())
    /// ```
    pub fn of_pixel(intrinsics: &Intrinsics, pixel: [f64; 2]) -> Result<Self, CameraError> {
        let direction = Vector::from(intrinsics.direction(pixel)?);
        let is_in_front = direction.e3 > LEAST_DEPTH;
        let direction = match is_in_front {
            true => direction / direction.e3,
            false => direction,
        };
        let seen = intrinsics.project_with_derivatives(direction.into())?;
        // The reciprocal vectors of the gradients of u and v: a pixel to the right changes u by 1
        // and v by 0.
        let [by_u, by_v] = seen.by_point.map(Vector::from);
        let normal = by_u.cross(by_v);
        let across = [by_v.cross(normal), normal.cross(by_u)].map(|x| x / normal.length_squared());
        let derivatives = match is_in_front {
            // The coordinate along the axis stays 1.
            true => across.map(|x| x - direction * x.e3),
            false => across,
        };
        let bearing = Self {
            direction,
            derivatives,
        };
        let is_finite = direction.is_finite() && derivatives.iter().all(|x| x.is_finite());
        is_finite
            .then_some(bearing)
            .ok_or(CameraError::NotFinite(direction.coordinates()))
    }

    /// Half the squared distance, in square pixels, of the pixel from that of another direction:
    /// the least sum of squares by which the pixels of two views move onto each other. To first
    /// order by the derivatives; infinite for a direction on the other side of the camera.
    pub(super) fn half_squared_distance(&self, other: Vector<f64>) -> f64 {
        if other.dot(self.direction) <= 0.0 {
            return f64::INFINITY;
        }
        // The other direction as a combination of this one and its derivatives.
        let [along_u, along_v] = self.derivatives;
        let volume = |a: Vector<f64>, b: Vector<f64>, c: Vector<f64>| a.dot(b.cross(c));
        let whole = volume(other, along_u, along_v);
        let u = volume(self.direction, other, along_v) / whole;
        let v = volume(self.direction, along_u, other) / whole;
        0.5 * (u * u + v * v)
    }

    /// The ray as a line through the origin, which is the camera's centre: `eo ∧ d ∧ ei`.
    #[must_use]
    pub fn line(&self) -> Line<f64> {
        through_centre(self.direction)
    }

    /// The lines through the centre along the derivatives: those of [`line`](Self::line) by the
    /// pixel's coordinates.
    #[must_use]
    pub fn line_derivatives(&self) -> [Line<f64>; 2] {
        self.derivatives.map(through_centre)
    }
}

fn through_centre(direction: Vector<f64>) -> Line<f64> {
    Line::from_point_direction(Point::ORIGIN, direction.coordinates())
}
