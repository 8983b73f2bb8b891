//! Why numbers do not form a camera, or a camera does not see a point.

/// Why numbers do not form a camera, or a camera does not see a point.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// A focal length is not positive and finite, or the principal point is not finite.
    #[error(
        "focal lengths {focal:?} and principal point {principal:?} do not form a camera: {problem}"
    )]
    Intrinsics {
        /// The focal lengths in pixels.
        focal: [f64; 2],
        /// The principal point in pixels.
        principal: [f64; 2],
        /// Which of them is faulty.
        problem: &'static str,
    },
    /// A calibration matrix is not upper triangular with a last row of 0, 0, 1 and no skew.
    #[error("row {row}, column {column} of a calibration matrix is {found}, not {expected}")]
    Matrix {
        /// The row, from 0.
        row: usize,
        /// The column, from 0.
        column: usize,
        /// The entry.
        found: f64,
        /// What it must be.
        expected: f64,
    },
    /// A distortion coefficient is infinite, not a number, or beyond what the model allows.
    #[error("the distortion coefficient {name} is {value}, which is not {expected}")]
    Coefficient {
        /// Its name in OpenCV, such as `k1`.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        expected: &'static str,
    },
    /// A distortion model does not have this number of coefficients.
    #[error("{found} distortion coefficients are given, and the model has {expected}")]
    CoefficientCount {
        /// How many are given.
        found: usize,
        /// The possible numbers.
        expected: &'static str,
    },
    /// The number of parameters is not that of the camera.
    #[error("{found} intrinsic parameters are given, and the camera has {expected}")]
    ParameterCount {
        /// How many are given.
        found: usize,
        /// How many the camera has.
        expected: usize,
    },
    /// Rotation and translation are not a rigid motion.
    #[error("the pose {rotation:?}, {translation:?} is not a rigid motion")]
    Pose {
        /// The matrix by rows.
        rotation: [[f64; 3]; 3],
        /// The translation.
        translation: [f64; 3],
    },
    /// A point is in the plane of the camera's centre or behind it.
    #[error("the point {point:?} is not in front of the camera: its depth is {depth} m")]
    Behind {
        /// The point in the world.
        point: [f64; 3],
        /// Its coordinate along the optical axis.
        depth: f64,
    },
    /// A point is so far from the optical axis that the distortion is not one-to-one there: the
    /// image would be folded.
    #[error("the point {0:?} is outside the field in which the lens distortion is one-to-one")]
    PointOutsideField([f64; 3]),
    /// No point inside the field in which the distortion is one-to-one is seen at a pixel.
    #[error("the pixel {0:?} is outside the field in which the lens distortion is one-to-one")]
    PixelOutsideField([f64; 2]),
    /// The iteration that inverts the distortion at a pixel did not converge.
    #[error("the lens distortion could not be inverted at the pixel {0:?}")]
    NotConverged([f64; 2]),
    /// A pixel or a point has a coordinate that is infinite or not a number.
    #[error("the coordinates {0:?} are not finite")]
    NotFinite([f64; 3]),
}

impl CameraError {
    /// The same about a point that is given by its coordinates in another frame.
    pub(super) fn of_point(self, coordinates: [f64; 3]) -> Self {
        match self {
            Self::Behind { depth, .. } => Self::Behind {
                point: coordinates,
                depth,
            },
            Self::PointOutsideField(_) => Self::PointOutsideField(coordinates),
            Self::NotFinite(_) => Self::NotFinite(coordinates),
            other => other,
        }
    }
}
