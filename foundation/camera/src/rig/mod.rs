//! Two cameras that see the same scene: a [`StereoRig`] as it stands, and a [`RectifiedRig`], in
//! whose pictures the images of a point are in one row.

mod error;
mod rectified;

pub use error::RigError;
pub use rectified::RectifiedRig;

use ga_runtime::cga3::Motor;

use crate::frame::{LeftCamera, Pose, RightCamera};
use crate::triangulation::{
    Method, PixelColumns, PointColumns, Triangulation, TwoViews, triangulate,
};
use crate::{Camera, CameraError, Intrinsics, Lens};

/// Two cameras in one world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoRig {
    /// The first camera.
    pub left: Camera,
    /// The second camera.
    pub right: Camera,
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
    /// `M_right ~M_left`, with the frames in its type.
    #[must_use]
    pub fn left_to_right(&self) -> Pose<LeftCamera, RightCamera> {
        Pose::new(self.right.world_to_camera * self.left.world_to_camera.reverse())
    }

    /// The distance between the cameras' centres in metres.
    #[must_use]
    pub fn baseline(&self) -> f64 {
        self.left.centre().distance(self.right.centre())
    }

    /// The point that is seen at one pixel in each picture: the middle of the common perpendicular
    /// of both rays.
    ///
    /// # Errors
    /// [`RigError`] where a pixel is not finite or the rays are parallel.
    pub fn triangulate(&self, left: [f64; 2], right: [f64; 2]) -> Result<Triangulation, RigError> {
        self.triangulate_point(0, left, right)
    }

    /// The points that are seen at pairs of pixels: the middles of the common perpendiculars.
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

    /// The points that are seen at pairs of pixels by a method of your choice, of which
    /// [`Method::Optimal`] has the least error in both pictures, taken without the distortion of
    /// the lenses. For many calls with one rig, [`TwoViews`] is prepared once.
    ///
    /// # Errors
    /// [`RigError`] for pictures of different numbers of points, for cameras without a baseline,
    /// and for the first pair that does not determine a point.
    ///
    /// ```
    /// use ga_camera::Intrinsics;
    /// use ga_camera::rig::StereoRig;
    /// use ga_camera::triangulation::Method;
    /// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
    /// let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let rig = StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.2, 0.0, 0.0])?;
    /// // Errors of one pixel along v in opposite directions.
    /// let points = rig.triangulate_by(Method::Optimal, &[[336.0, 241.0]], &[[320.0, 239.0]])?;
    /// assert!((points.z[0] - 10.0).abs() < 1e-12 && points.y[0].abs() < 1e-12);
    /// // The rays pass at a distance of 0.0005/|(0.0025, −0.02, −0.000025)| of each other.
    /// assert!((points.gap[0] - 0.024807).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn triangulate_by(
        &self,
        method: Method,
        left: &[[f64; 2]],
        right: &[[f64; 2]],
    ) -> Result<PointColumns, RigError> {
        if left.len() != right.len() {
            return Err(RigError::Counts {
                left: left.len(),
                right: right.len(),
            });
        }
        let [first, second] = [self.left, self.right].map(|camera| Camera {
            intrinsics: camera.intrinsics.with_lens(Lens::Pinhole),
            ..camera
        });
        let views = TwoViews::new(&first, &second)?;
        let columns = [
            undistorted(&self.left, left)?,
            undistorted(&self.right, right)?,
        ];
        let [a, b] = columns.each_ref().map(|[u, v]| PixelColumns { u, v });
        let mut points = PointColumns::default();
        views.triangulate(method, a, b, &mut points)?;
        Ok(points)
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
        Ok(triangulate(first, second).map_err(|error| error.of_point(point))?)
    }
}

/// The pixels at which a pinhole would see what a camera sees, in columns.
fn undistorted(camera: &Camera, pixels: &[[f64; 2]]) -> Result<[Vec<f64>; 2], RigError> {
    let (mut u, mut v) = (Vec::new(), Vec::new());
    for (point, pixel) in pixels.iter().enumerate() {
        let pixel = camera.intrinsics.undistort(*pixel);
        let [column, row] = pixel.map_err(|error| RigError::Camera { point, error })?;
        u.push(column);
        v.push(row);
    }
    Ok([u, v])
}
