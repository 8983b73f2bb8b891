//! Directions in which a camera sees pixels.

use ga_runtime::cga3::{Line, Point};
use ga_runtime::vga3::Vector;

use crate::camera::{CameraError, Intrinsics};

/// The direction in which a camera sees a pixel, and how it changes with the pixel.
///
/// The direction d is in the camera's frame, with the coordinate 1 along the optical axis. The ray
/// is the line `eo ∧ d ∧ ei` through the camera's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing {
    /// The direction d.
    pub direction: Vector<f64>,
    /// `∂d/∂u` and `∂d/∂v`, a pixel to the right and a pixel down.
    pub derivatives: [Vector<f64>; 2],
}

impl Bearing {
    /// The direction in which a pinhole camera sees a pixel.
    ///
    /// # Errors
    /// [`CameraError::NotFinite`] for a pixel that is not finite, or whose direction is not.
    ///
    /// ```
    /// use ga_vision::camera::Intrinsics;
    /// use ga_vision::relative_pose::Bearing;
    ///
    /// let camera = Intrinsics::new([500.0, 400.0], [320.0, 240.0])?;
    /// let bearing = Bearing::of_pixel(&camera, [420.0, 240.0])?;
    /// assert_eq!(bearing.direction.coordinates(), [0.2, 0.0, 1.0]);
    /// assert_eq!(bearing.derivatives[0].coordinates(), [0.002, 0.0, 0.0]);
    /// # Ok::<(), ga_vision::camera::CameraError>(())
    /// ```
    pub fn of_pixel(intrinsics: &Intrinsics, pixel: [f64; 2]) -> Result<Self, CameraError> {
        let ([fx, fy], [cx, cy]) = (intrinsics.focal(), intrinsics.principal());
        let [x, y] = [(pixel[0] - cx) / fx, (pixel[1] - cy) / fy];
        let direction = Vector::new(x, y, 1.0);
        if !direction.is_finite() {
            return Err(CameraError::NotFinite(direction.coordinates()));
        }
        Ok(Self {
            direction,
            derivatives: [
                Vector::new(fx.recip(), 0.0, 0.0),
                Vector::new(0.0, fy.recip(), 0.0),
            ],
        })
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
