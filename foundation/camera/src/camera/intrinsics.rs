//! The projection of a camera from its frame to its picture.

use ga_runtime::cga3::{Direction, Point};

use super::error::CameraError;
use super::lens::{Lens, NoImage};
use super::radial_tangential::NoInverse;

/// The projection of a camera from its frame to its picture: `u = f_x x' + c_x`,
/// `v = f_y y' + c_y` without skew, where `(x', y')` is what its [lens](Lens) makes of a point:
/// `(x/z, y/z)` for a pinhole.
///
/// # Parameters
///
/// In [`parameters`](Self::parameters) and in derivatives, the order is f_x, f_y, c_x, c_y, and
/// then the coefficients of the lens as OpenCV orders them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    focal: [f64; 2],
    principal: [f64; 2],
    lens: Lens,
}

/// A pixel with its derivatives by the point in the camera's frame and by the intrinsic parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameProjection {
    /// The pixel `[u, v]`.
    pub pixel: [f64; 2],
    /// The derivatives of u and of v by the coordinates of the point, in pixels per metre.
    pub by_point: [[f64; 3]; 2],
    /// The derivatives of u and of v by the intrinsic parameters, in the order of
    /// [`Intrinsics::parameters`].
    pub by_parameters: [[f64; Intrinsics::MAX_PARAMETERS]; 2],
}

impl Intrinsics {
    /// The largest number of parameters, that of a lens with radial–tangential distortion.
    pub const MAX_PARAMETERS: usize = 18;

    /// Intrinsics of a pinhole from focal lengths and principal point in pixels.
    ///
    /// # Errors
    /// [`CameraError::Intrinsics`] where a focal length is not positive or a number is not finite.
    pub fn new(focal: [f64; 2], principal: [f64; 2]) -> Result<Self, CameraError> {
        let refuse = |problem| {
            Err(CameraError::Intrinsics {
                focal,
                principal,
                problem,
            })
        };
        if !focal.iter().all(|f| f.is_finite() && *f > 0.0) {
            return refuse("a focal length is not positive and finite");
        }
        if !principal.iter().all(|c| c.is_finite()) {
            return refuse("the principal point is not finite");
        }
        Ok(Self {
            focal,
            principal,
            lens: Lens::Pinhole,
        })
    }

    /// Intrinsics of a pinhole from a calibration matrix K by rows.
    ///
    /// # Errors
    /// [`CameraError::Matrix`] names an entry that must be 0 or 1 and is not; otherwise as
    /// [`Intrinsics::new`].
    pub fn from_matrix(matrix: [[f64; 3]; 3]) -> Result<Self, CameraError> {
        let fixed = [
            (0, 1, 0.0),
            (1, 0, 0.0),
            (2, 0, 0.0),
            (2, 1, 0.0),
            (2, 2, 1.0),
        ];
        for (row, column, expected) in fixed {
            let found = matrix[row][column];
            if found != expected {
                return Err(CameraError::Matrix {
                    row,
                    column,
                    found,
                    expected,
                });
            }
        }
        Self::new([matrix[0][0], matrix[1][1]], [matrix[0][2], matrix[1][2]])
    }

    /// The same focal lengths and principal point behind another lens.
    #[must_use]
    pub fn with_lens(self, lens: impl Into<Lens>) -> Self {
        Self {
            lens: lens.into(),
            ..self
        }
    }

    /// The calibration matrix K by rows.
    #[must_use]
    pub fn to_matrix(&self) -> [[f64; 3]; 3] {
        let ([fx, fy], [cx, cy]) = (self.focal, self.principal);
        [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]]
    }

    /// The focal lengths along u and v in pixels.
    #[must_use]
    pub fn focal(&self) -> [f64; 2] {
        self.focal
    }

    /// The principal point in pixels.
    #[must_use]
    pub fn principal(&self) -> [f64; 2] {
        self.principal
    }

    /// The lens.
    #[must_use]
    pub fn lens(&self) -> Lens {
        self.lens
    }

    /// How many parameters there are: 4, and the coefficients of the lens.
    #[must_use]
    pub fn parameter_count(&self) -> usize {
        4 + self.lens.coefficient_count()
    }

    /// The parameters f_x, f_y, c_x, c_y and the coefficients of the lens, followed by zeros.
    #[must_use]
    pub fn parameters(&self) -> [f64; Self::MAX_PARAMETERS] {
        let mut all = [0.0; Self::MAX_PARAMETERS];
        all[..2].copy_from_slice(&self.focal);
        all[2..4].copy_from_slice(&self.principal);
        all[4..].copy_from_slice(&self.lens.coefficients());
        all
    }

    /// A camera with the same kind of lens and other parameters,
    /// [`parameter_count`](Self::parameter_count) of them.
    ///
    /// # Errors
    /// [`CameraError`] for another number of parameters, and as [`Intrinsics::new`],
    /// [`RadialTangential::new`](super::RadialTangential::new) and
    /// [`Fisheye::new`](super::Fisheye::new).
    pub fn with_parameters(&self, parameters: &[f64]) -> Result<Self, CameraError> {
        let expected = self.parameter_count();
        let (4.., true) = (parameters.len(), parameters.len() == expected) else {
            return Err(CameraError::ParameterCount {
                found: parameters.len(),
                expected,
            });
        };
        let (plain, coefficients) = parameters.split_at(4);
        let plain = Self::new([plain[0], plain[1]], [plain[2], plain[3]])?;
        Ok(plain.with_lens(self.lens.with_coefficients(coefficients)?))
    }

    /// The pixel of an image at focal length 1.
    fn pixel(&self, image: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| self.focal[k] * image[k] + self.principal[k])
    }

    /// The pixel at which a point of the camera's frame is seen.
    ///
    /// # Errors
    /// [`CameraError::Behind`] for a point that is not in front (except for a fisheye lens),
    /// [`CameraError::PointOutsideField`] where the distortion is not one-to-one,
    /// [`CameraError::NotFinite`] for a point or pixel that is not finite.
    pub fn project(&self, in_frame: Point<f64>) -> Result<[f64; 2], CameraError> {
        let point = finite(in_frame)?;
        let image = self.lens.image(point).map_err(|none| unseen(none, point))?;
        let pixel = self.pixel(image);
        if pixel.iter().all(|u| u.is_finite()) {
            Ok(pixel)
        } else {
            Err(CameraError::NotFinite(point))
        }
    }

    /// The pixel at which a point of the camera's frame is seen, with its derivatives in closed
    /// form.
    ///
    /// # Errors
    /// As [`project`](Self::project).
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_camera::Intrinsics;
    /// let camera = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
    /// let seen = camera.project_with_derivatives(Point::new(0.5, 0.0, 2.0))?;
    /// // 800 pixels per metre at depth 1 are 400 at depth 2, and −f x/z² along the axis.
    /// assert_eq!(seen.by_point, [[400.0, 0.0, -100.0], [0.0, 400.0, 0.0]]);
    /// // By f_x, f_y, c_x and c_y.
    /// assert_eq!(seen.by_parameters[0][..4], [0.25, 0.0, 1.0, 0.0]);
    /// # Ok::<(), ga_camera::CameraError>(())
    /// ```
    pub fn project_with_derivatives(
        &self,
        in_frame: Point<f64>,
    ) -> Result<FrameProjection, CameraError> {
        let point = finite(in_frame)?;
        let seen = self.lens.derivatives(point);
        let seen = seen.map_err(|none| unseen(none, point))?;
        let mut by_parameters = [[0.0; Self::MAX_PARAMETERS]; 2];
        for (k, row) in by_parameters.iter_mut().enumerate() {
            row[k] = seen.image[k];
            row[2 + k] = 1.0;
            for (place, change) in row[4..].iter_mut().zip(seen.by_coefficients[k]) {
                *place = self.focal[k] * change;
            }
        }
        let found = FrameProjection {
            pixel: self.pixel(seen.image),
            by_point: [0, 1].map(|k| seen.by_point[k].map(|x| self.focal[k] * x)),
            by_parameters,
        };
        let numbers = found.by_point.iter().flatten().chain(&found.pixel);
        if numbers
            .chain(found.by_parameters.iter().flatten())
            .all(|x| x.is_finite())
        {
            Ok(found)
        } else {
            Err(CameraError::NotFinite(point))
        }
    }

    /// The direction in the camera's frame in which a pixel looks, of length 1.
    ///
    /// The distortion is inverted by Newton's method.
    ///
    /// # Errors
    /// [`CameraError::PixelOutsideField`] for a pixel at which nothing inside the field of the lens
    /// is seen, [`CameraError::NotConverged`] where the distortion could not be inverted,
    /// [`CameraError::NotFinite`] for a pixel that is not finite, or so far from the principal
    /// point that its direction is not.
    pub fn direction(&self, pixel: [f64; 2]) -> Result<Direction<f64>, CameraError> {
        let not_finite = CameraError::NotFinite([pixel[0], pixel[1], 1.0]);
        let image = [0, 1].map(|k| (pixel[k] - self.principal[k]) / self.focal[k]);
        if !image.iter().all(|x| x.is_finite()) {
            return Err(not_finite);
        }
        let direction = self.lens.direction(image).map_err(|none| match none {
            NoInverse::OutsideField => CameraError::PixelOutsideField(pixel),
            NoInverse::NotConverged => CameraError::NotConverged(pixel),
        })?;
        Direction::from_vector(direction)
            .normalized()
            .ok_or(not_finite)
    }

    /// The pixel at which a pinhole with the same focal lengths and principal point sees what this
    /// camera sees at a pixel.
    ///
    /// # Errors
    /// As [`direction`](Self::direction), and [`CameraError::Behind`] for what a fisheye lens sees
    /// beside or behind the camera.
    pub fn undistort(&self, pixel: [f64; 2]) -> Result<[f64; 2], CameraError> {
        let direction = self.direction(pixel)?;
        self.with_lens(Lens::Pinhole)
            .project(Point::from(direction.vector()))
    }
}

fn finite(point: Point<f64>) -> Result<[f64; 3], CameraError> {
    let coordinates = point.coordinates();
    if coordinates.iter().all(|x| x.is_finite()) {
        Ok(coordinates)
    } else {
        Err(CameraError::NotFinite(coordinates))
    }
}

fn unseen(none: NoImage, point: [f64; 3]) -> CameraError {
    match none {
        NoImage::Behind => CameraError::Behind {
            point,
            depth: point[2],
        },
        NoImage::OutsideField => CameraError::PointOutsideField(point),
    }
}
