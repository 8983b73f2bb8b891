//! Cameras: pinholes, lenses with distortion, and fisheye lenses.
//!
//! A [`Camera`] is a pose, a motor, and [`Intrinsics`]: focal lengths, principal point and a
//! [`Lens`]. It projects points to pixels, gives the derivatives of that in closed form, and turns
//! pixels into rays, which are lines of conformal algebra with an origin. The models and their
//! parameters are those of OpenCV.
//!
//! | lens | image of `(x, y, z)` at focal length 1 | seen |
//! | --- | --- | --- |
//! | [`Lens::Pinhole`] | `(x/z, y/z)` | z > 0 |
//! | [`RadialTangential`] | polynomials in x/z and y/z | z > 0, up to a radius |
//! | [`Fisheye`] | a polynomial in the angle from the axis | up to an angle, at most π |
//!
//! A distortion is one-to-one only near the axis. Points and pixels beyond that are errors, and not
//! seen at places where the image is folded.
//!
//! Coordinates have no frame of reference of their own; [`frame`](crate::frame) gives them one in
//! their type.

mod error;
mod fisheye;
mod intrinsics;
mod lens;
mod monotone;
mod radial_tangential;
mod tilt;

pub use error::CameraError;
pub use fisheye::Fisheye;
pub use intrinsics::{FrameProjection, Intrinsics};
pub use lens::{Lens, LensModel};
pub use radial_tangential::RadialTangential;

use ga_runtime::batch;
use ga_runtime::cga3::{Direction, Motor, Point};
use ga_runtime::geometry::ray::Ray;
use ga_runtime::vga3::Vector;

use crate::frame::{CameraFrame, Pose, World, y_up};

/// A camera in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Focal lengths, principal point and lens.
    pub intrinsics: Intrinsics,
    /// The motor that takes the world into the camera's frame.
    pub world_to_camera: Motor<f64>,
}

/// A pixel with its derivatives.
///
/// The pose varies by twists on the left, `M' = exp(G) M` with the
/// [generator](ga_runtime::cga3::MotorGenerator::from_velocities) of the angular velocity ω and the
/// velocity u of the camera's origin. A point x of the camera's frame moves with `ω × x + u`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// The pixel `[u, v]`.
    pub pixel: [f64; 2],
    /// The derivatives of u and of v by the coordinates of the point in the world.
    pub by_point: [[f64; 3]; 2],
    /// The derivatives of u and of v by the twist `[ω₁, ω₂, ω₃, u₁, u₂, u₃]`.
    pub by_twist: [[f64; 6]; 2],
    /// The derivatives of u and of v by the intrinsic parameters, in the order of
    /// [`Intrinsics::parameters`].
    pub by_parameters: [[f64; Intrinsics::MAX_PARAMETERS]; 2],
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
        Some(Self {
            intrinsics,
            world_to_camera: y_up() * view,
        })
    }

    /// The same camera in a world that has y up and z backwards, where its own had y down and z
    /// forwards, as the frame of a camera has.
    #[must_use]
    pub fn in_world_with_y_up(self) -> Self {
        Self {
            world_to_camera: self.world_to_camera * y_up(),
            ..self
        }
    }

    /// The camera's centre in the world.
    #[must_use]
    pub fn centre(&self) -> Point<f64> {
        self.world_to_camera.reverse().transform(Point::default())
    }

    /// The pixel at which the camera sees a point of the world.
    ///
    /// # Errors
    /// [`CameraError::Behind`] for a point that is not in front (except for a fisheye lens),
    /// [`CameraError::PointOutsideField`] where the distortion is not one-to-one,
    /// [`CameraError::NotFinite`] for a point or pixel that is not finite.
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
        let pixel = self.intrinsics.project(in_frame);
        pixel.map_err(|error| error.of_point(point.coordinates()))
    }

    /// The pixel at which the camera sees a point of the world, with its derivatives in closed form
    /// by the point, the pose and the intrinsic parameters.
    ///
    /// # Errors
    /// As [`project`](Self::project).
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, Motor, MotorGenerator, Point};
    /// use ga_camera::{Camera, Intrinsics};
    /// let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0])?;
    /// let camera = Camera { intrinsics, world_to_camera: Motor::default() };
    /// let point = Point::new(0.5, 0.1, 2.0);
    /// let seen = camera.project_with_derivatives(point)?;
    /// // The point moves a millimetre to the right, against the camera.
    /// let step = MotorGenerator::from_velocities(
    ///     Direction::default(),
    ///     Direction::new(1e-3, 0.0, 0.0),
    /// );
    /// let moved = Camera { world_to_camera: step.exp() * camera.world_to_camera, ..camera };
    /// let change = moved.project(point)?[0] - seen.pixel[0];
    /// assert!((change - 1e-3 * seen.by_twist[0][3]).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn project_with_derivatives(&self, point: Point<f64>) -> Result<Projection, CameraError> {
        let in_frame = self.world_to_camera.transform(point);
        let seen = self.intrinsics.project_with_derivatives(in_frame);
        let seen = seen.map_err(|error| error.of_point(point.coordinates()))?;
        let place = Vector::from(in_frame);
        let to_world = self.world_to_camera.reverse();
        Ok(Projection {
            pixel: seen.pixel,
            by_point: seen
                .by_point
                .map(|row| to_world.transform(Direction::from_vector(row)).vector()),
            by_twist: seen.by_point.map(|row| by_twist(place, row.into())),
            by_parameters: seen.by_parameters,
        })
    }

    /// The ray that a pixel looks along, in the world: in the camera's frame it begins at the
    /// origin in the [direction](Intrinsics::direction) of the pixel, and the reverse of the pose
    /// moves it. Its [`line`](Ray::line) is the conformal line `o∧d∧ei`.
    ///
    /// # Errors
    /// [`CameraError::NotFinite`] for a pixel that is not finite, or so far from the principal
    /// point that its direction is not; [`CameraError::PixelOutsideField`] and
    /// [`CameraError::NotConverged`] where the distortion cannot be inverted.
    pub fn ray(&self, pixel: [f64; 2]) -> Result<Ray<f64>, CameraError> {
        let direction = self.intrinsics.direction(pixel)?;
        let in_frame = Ray::new_unchecked(Point::default(), direction);
        Ok(self.world_to_camera.reverse().transform(in_frame))
    }

    /// The pose, with the frames in its type.
    #[must_use]
    pub fn pose(&self) -> Pose<World, CameraFrame> {
        Pose::new(self.world_to_camera)
    }
}

/// The derivatives of a number by the twist of a frame, from those by the place x in the frame:
/// `row · (ω × x + u) = ω · (x × row) + u · row`.
#[must_use]
pub fn by_twist(place: Vector<f64>, row: Vector<f64>) -> [f64; 6] {
    let ([a, b, c], [x, y, z]) = (place.cross(row).coordinates(), row.coordinates());
    [a, b, c, x, y, z]
}
