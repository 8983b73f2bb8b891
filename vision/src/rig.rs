//! Two cameras that see the same scene.

use ga_runtime::cga3::Motor;

use crate::camera::{Camera, CameraError, Intrinsics};
use crate::triangulation::{Triangulation, TriangulationError, triangulate};

/// Two cameras in one world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoRig {
    /// The first camera.
    pub left: Camera,
    /// The second camera.
    pub right: Camera,
}

/// Why two pictures do not determine points.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RigError {
    /// A pixel gives no ray.
    #[error("point {point}: {error}")]
    Camera {
        /// Which point, from 0.
        point: usize,
        /// What is wrong with it.
        error: CameraError,
    },
    /// Two rays do not determine a point.
    #[error("point {point}: {error}")]
    Triangulation {
        /// Which point, from 0.
        point: usize,
        /// What is wrong with it.
        error: TriangulationError,
    },
    /// The pictures have different numbers of points.
    #[error("{left} points in the left picture, {right} in the right one")]
    Counts {
        /// How many there are on the left.
        left: usize,
        /// How many there are on the right.
        right: usize,
    },
}

impl StereoRig {
    /// The rig whose world is the frame of the left camera, with the right camera's frame given by
    /// `x_right = R x_left + t`.
    ///
    /// # Errors
    /// [`CameraError::Pose`] where R is not a rotation or t is not finite.
    pub fn from_matrices(
        left: Intrinsics,
        right: Intrinsics,
        rotation: [[f64; 3]; 3],
        translation: [f64; 3],
    ) -> Result<Self, CameraError> {
        let row = |k: usize| {
            let [x, y, z] = rotation[k];
            [x, y, z, translation[k]]
        };
        let pose = Motor::from_matrix([row(0), row(1), row(2)]);
        let world_to_camera = pose.ok_or(CameraError::Pose {
            rotation,
            translation,
        })?;
        Ok(Self {
            left: Camera {
                intrinsics: left,
                world_to_camera: Motor::default(),
            },
            right: Camera {
                intrinsics: right,
                world_to_camera,
            },
        })
    }

    /// The motor between the cameras: it takes the left camera's frame into the right one's,
    /// `M_right ~M_left`.
    #[must_use]
    pub fn left_to_right(&self) -> Motor<f64> {
        self.right.world_to_camera * self.left.world_to_camera.reverse()
    }

    /// The distance between the cameras' centres in metres.
    #[must_use]
    pub fn baseline(&self) -> f64 {
        self.left.centre().distance(self.right.centre())
    }

    /// The point that is seen at one pixel in each picture.
    ///
    /// # Errors
    /// [`RigError`] where a pixel is not finite or the rays are parallel.
    pub fn triangulate(&self, left: [f64; 2], right: [f64; 2]) -> Result<Triangulation, RigError> {
        self.triangulate_point(0, left, right)
    }

    /// The points that are seen at pairs of pixels.
    ///
    /// # Errors
    /// [`RigError`] for pictures of different numbers of points, and for the first pair that does
    /// not determine a point.
    pub fn triangulate_all(
        &self,
        left: &[[f64; 2]],
        right: &[[f64; 2]],
    ) -> Result<Vec<Triangulation>, RigError> {
        if left.len() != right.len() {
            return Err(RigError::Counts {
                left: left.len(),
                right: right.len(),
            });
        }
        let pairs = left.iter().zip(right).enumerate();
        pairs
            .map(|(point, (&a, &b))| self.triangulate_point(point, a, b))
            .collect()
    }

    fn triangulate_point(
        &self,
        point: usize,
        left: [f64; 2],
        right: [f64; 2],
    ) -> Result<Triangulation, RigError> {
        let no_ray = |error| RigError::Camera { point, error };
        let first = self.left.ray(left).map_err(no_ray)?;
        let second = self.right.ray(right).map_err(no_ray)?;
        triangulate(first, second).map_err(|error| RigError::Triangulation { point, error })
    }
}
