//! Pinhole cameras.

use ga_runtime::batch;
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::geometry::ray::Ray;

/// The projection of a camera from its frame to its picture: `u = f_x x/z + c_x`,
/// `v = f_y y/z + c_y`, without skew.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    focal: [f64; 2],
    principal: [f64; 2],
}

/// A pinhole camera in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Focal lengths and principal point.
    pub intrinsics: Intrinsics,
    /// The motor that takes the world into the camera's frame.
    pub world_to_camera: Motor<f64>,
}

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
    /// A pixel or a point has a coordinate that is infinite or not a number.
    #[error("the coordinates {0:?} are not finite")]
    NotFinite([f64; 3]),
}

impl Intrinsics {
    /// Intrinsics from focal lengths and principal point in pixels.
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
        Ok(Self { focal, principal })
    }

    /// Intrinsics from a calibration matrix K by rows.
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
}

impl Camera {
    /// A camera at `eye` that looks at `target`, with the direction `up` upwards in its picture.
    /// `None` where it would look along that direction, or where the two points coincide.
    #[must_use]
    pub fn look_at(
        intrinsics: Intrinsics,
        eye: Point<f64>,
        target: Point<f64>,
        up: [f64; 3],
    ) -> Option<Self> {
        let view = Motor::look_at(eye, target, up.into()).ok()?;
        // From y up and z backwards to y down and z forwards.
        let half_turn_about_x = Rotor::new_unchecked(0.0, 0.0, 0.0, -1.0);
        Some(Self {
            intrinsics,
            world_to_camera: half_turn_about_x * view,
        })
    }

    /// The camera's centre in the world.
    #[must_use]
    pub fn centre(&self) -> Point<f64> {
        self.world_to_camera.reverse().transform(Point::default())
    }

    /// The pixel at which the camera sees a point of the world.
    ///
    /// # Errors
    /// [`CameraError::Behind`] for a point that is not in front, [`CameraError::NotFinite`] for a
    /// point or pixel that is not finite.
    pub fn project(&self, point: Point<f64>) -> Result<[f64; 2], CameraError> {
        self.project_from_frame(point, self.world_to_camera.transform(point))
    }

    /// The pixels at which the camera sees points of the world.
    ///
    /// # Errors
    /// The index of the first point that the camera does not see, with the error of
    /// [`project`](Self::project).
    pub fn project_all(
        &self,
        points: &[Point<f64>],
    ) -> Result<Vec<[f64; 2]>, (usize, CameraError)> {
        let mut in_frame = points.to_vec();
        batch::transform(&self.world_to_camera, &mut in_frame);
        let pairs = points.iter().zip(in_frame).enumerate();
        pairs
            .map(|(index, (&point, in_frame))| {
                let pixel = self.project_from_frame(point, in_frame);
                pixel.map_err(|error| (index, error))
            })
            .collect()
    }

    /// The pixel of a point of the world that the camera's frame has at `in_frame`.
    fn project_from_frame(
        &self,
        point: Point<f64>,
        in_frame: Point<f64>,
    ) -> Result<[f64; 2], CameraError> {
        let [x, y, depth] = in_frame.coordinates();
        if !(x.is_finite() && y.is_finite() && depth.is_finite()) {
            return Err(CameraError::NotFinite(point.coordinates()));
        }
        if depth <= 0.0 {
            return Err(CameraError::Behind {
                point: point.coordinates(),
                depth,
            });
        }
        let ([fx, fy], [cx, cy]) = (self.intrinsics.focal, self.intrinsics.principal);
        let pixel = [fx * (x / depth) + cx, fy * (y / depth) + cy];
        if pixel.iter().all(|u| u.is_finite()) {
            Ok(pixel)
        } else {
            Err(CameraError::NotFinite(point.coordinates()))
        }
    }

    /// The ray that a pixel looks along, in the world: in the camera's frame it begins at the
    /// origin in the direction `((u − c_x)/f_x, (v − c_y)/f_y, 1)`, and the reverse of the pose
    /// moves it.
    ///
    /// # Errors
    /// [`CameraError::NotFinite`] for a pixel that is not finite, or so far from the principal
    /// point that its direction is not.
    pub fn ray(&self, pixel: [f64; 2]) -> Result<Ray<f64>, CameraError> {
        let [u, v] = pixel;
        let ([fx, fy], [cx, cy]) = (self.intrinsics.focal, self.intrinsics.principal);
        let in_frame = Ray::new(Point::default(), [(u - cx) / fx, (v - cy) / fy, 1.0]);
        let in_frame = in_frame.ok_or(CameraError::NotFinite([u, v, 1.0]))?;
        Ok(self.world_to_camera.reverse().transform(in_frame))
    }
}
