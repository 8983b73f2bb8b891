//! From where and how a scene is seen.

use ga_camera::{Camera, Intrinsics, Lens};
use ga_runtime::cga3::{Direction, Motor, Point, Rotor};
use ga_runtime::geometry::LookAtError;

use crate::space::is_rigid;
use crate::{LARGEST_COORDINATE, RenderError, Vector};

/// From where and how a scene is seen: the position, viewing direction and projection of a pinhole
/// camera, and the depths between which it draws.
///
/// A point's *depth* is its distance along the viewing direction. Pixel *(0, 0)* is at the top
/// left; columns and rows count from its upper left corner, so that pixel centres lie on halves. A
/// point at right offset *x*, up offset *y* and depth *d* falls on
///
/// ```text
/// column = width/2  + (x/d) (height/2) / tan(φ/2)
/// row    = height/2 − (y/d) (height/2) / tan(φ/2)
/// ```
///
/// with φ the vertical field of view, or where the [`Camera`] of [`View::pinhole`] sees it.
/// Lengths are in the unit of the model, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    eye: Vector,
    right: Vector,
    up: Vector,
    forward: Vector,
    projection: Projection,
    skew: f64,
    near: f64,
    far: f64,
}

/// How a camera projects what lies in its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Projection {
    /// By the tangent of half the vertical field of view, for a picture of any size.
    FieldOfView { tangent: f64 },
    /// By pixels of one picture, from the middle of the first.
    Pixels {
        focal: [f64; 2],
        principal: [f64; 2],
    },
}

/// The side a model is seen from, in a world whose *y* axis points up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewDirection {
    /// Angle about the *y* axis, in radians: 0 looks at the model from +*z*, π/2 from +*x*.
    pub azimuth: f64,
    /// Angle above the horizon, in radians, from −π/2 to π/2.
    pub elevation: f64,
}

impl Default for ViewDirection {
    /// Three-quarter view: 35° to the side, 12° above the horizon.
    fn default() -> Self {
        Self {
            azimuth: 35f64.to_radians(),
            elevation: 12f64.to_radians(),
        }
    }
}

impl ViewDirection {
    /// The unit vector from the model towards the camera.
    pub(crate) fn towards_camera(self) -> Vector {
        let (sin_azimuth, cos_azimuth) = self.azimuth.sin_cos();
        let (sin_elevation, cos_elevation) = self.elevation.sin_cos();
        Vector::new(
            sin_azimuth * cos_elevation,
            sin_elevation,
            cos_azimuth * cos_elevation,
        )
    }

    /// The unit vector to the right in the picture.
    pub(crate) fn right(self) -> Vector {
        Vector::new(self.azimuth.cos(), 0.0, -self.azimuth.sin())
    }
}

impl View {
    /// A camera at `eye` looking at `target`, with `up` pointing up in the picture.
    ///
    /// Nothing nearer than the depth `near` is drawn.
    ///
    /// # Errors
    ///
    /// [`RenderError::Camera`] when a value is not finite, `eye` is `target`, `up` lies along the
    /// viewing direction, the field of view is not between 0 and π, or `near` is not positive.
    pub fn look_at(
        eye: [f64; 3],
        target: [f64; 3],
        up: [f64; 3],
        vertical_field_of_view: f64,
        near: f64,
    ) -> Result<Self, RenderError> {
        let reasonable = |v: [f64; 3]| v.iter().all(|c| c.abs() <= LARGEST_COORDINATE);
        if !(reasonable(eye) && reasonable(target) && reasonable(up)) {
            return Err(RenderError::Camera("a position is not finite"));
        }
        let [eye, target] = [eye, target].map(Vector::from);
        let view = Rotor::look_along((target - eye).into(), up.into()).map_err(|error| {
            RenderError::Camera(match error {
                LookAtError::NoDirection => "its eye and its target coincide",
                LookAtError::UpIsZero => "its up vector is zero",
                LookAtError::UpAlongView => "it looks along its up vector",
                _ => "a position is not finite",
            })
        })?;
        let [right, up, back] = view.to_matrix().map(Vector::from);
        if !(near > 0.0 && near <= LARGEST_COORDINATE) {
            return Err(RenderError::Camera("its near depth is not positive"));
        }
        Ok(Self {
            eye,
            right,
            up,
            forward: -back,
            projection: Projection::FieldOfView {
                tangent: half_tangent(vertical_field_of_view)?,
            },
            skew: 0.0,
            near,
            far: f64::INFINITY,
        })
    }

    /// What a camera sees.
    ///
    /// The picture is as large as [`Style`](crate::Style) says; the intrinsics are those of that
    /// picture. Nothing nearer than the depth `near` is drawn.
    ///
    /// # Errors
    ///
    /// [`RenderError::Lens`] for a lens with distortion; [`RenderError::Camera`] when a number is
    /// beyond 10³⁰, `near` is not positive, or the pose is not a rigid motion.
    ///
    /// ```
    /// use ga_camera::{Camera, Intrinsics};
    /// use ga_render::View;
    /// use ga_runtime::cga3::Translator;
    ///
    /// let camera = Camera {
    ///     intrinsics: Intrinsics::new([500.0, 500.0], [319.5, 239.5])?,
    ///     world_to_camera: Translator::from_displacement([0.0, 0.0, 2.0]).into(),
    /// };
    /// let view = View::pinhole(&camera, 0.1)?;
    /// // u = 500 · 0.1/2 + 319.5 = 344.5 and v = 500 · 0.2/2 + 239.5 = 289.5; columns and rows
    /// // count from a corner, u and v from the middle of the first pixel.
    /// let [column, row, depth] = view.project([0.1, 0.2, 0.0], 640, 480).unwrap();
    /// assert!((column - 345.0).abs() < 1e-12 && (row - 290.0).abs() < 1e-12 && depth == 2.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pinhole(camera: &Camera, near: f64) -> Result<Self, RenderError> {
        let Camera {
            intrinsics,
            world_to_camera,
        } = *camera;
        if intrinsics.lens() != Lens::Pinhole {
            return Err(RenderError::Lens);
        }
        // Quotients of two numbers within this range stay finite.
        let reasonable = |number: f64| number.abs() <= LARGEST_COORDINATE;
        if !intrinsics
            .focal()
            .iter()
            .all(|&f| reasonable(f) && f > 1e-30)
        {
            return Err(RenderError::Camera("a focal length is not positive"));
        }
        if !intrinsics.principal().iter().all(|&c| reasonable(c)) {
            return Err(RenderError::Camera("its principal point is not finite"));
        }
        let [right, down, forward] = world_to_camera.rotor().to_matrix().map(Vector::from);
        let eye = Vector::from(world_to_camera.reverse().transform(Point::default()));
        if !is_rigid(world_to_camera) {
            return Err(RenderError::Camera("its pose is not a rigid motion"));
        }
        if !eye
            .coordinates()
            .iter()
            .all(|c| c.abs() <= LARGEST_COORDINATE)
        {
            return Err(RenderError::Camera("a position is not finite"));
        }
        if !(near > 0.0 && near <= LARGEST_COORDINATE) {
            return Err(RenderError::Camera("its near depth is not positive"));
        }
        Ok(Self {
            eye,
            right,
            up: -down,
            forward,
            projection: Projection::Pixels {
                focal: intrinsics.focal(),
                principal: intrinsics.principal(),
            },
            skew: 0.0,
            near,
            far: f64::INFINITY,
        })
    }

    /// The same view with a skew s in pixels: `u = f_x x/z + s y/z + c_x`.
    ///
    /// # Errors
    ///
    /// [`RenderError::Camera`] when it is not finite.
    pub fn with_skew(self, skew: f64) -> Result<Self, RenderError> {
        if skew.abs() <= LARGEST_COORDINATE {
            Ok(Self { skew, ..self })
        } else {
            Err(RenderError::Camera("its skew is not finite"))
        }
    }

    /// The same camera, which draws nothing further away than the depth `far`.
    ///
    /// # Errors
    ///
    /// [`RenderError::Camera`] when `far` is not greater than the near depth.
    pub fn with_far(self, far: f64) -> Result<Self, RenderError> {
        if far > self.near {
            Ok(Self { far, ..self })
        } else {
            Err(RenderError::Camera(
                "its far depth is not beyond its near depth",
            ))
        }
    }

    /// The nearest camera on the given side that sees all `points`, with the picture `aspect`
    /// (width / height) and a border of `margin` (a fraction of the half picture, so 0.1 leaves a
    /// twentieth free on each side).
    ///
    /// A point at offsets *x*, *y* and depth *d* from an eye at *(eₓ, e_y, e_d)* is inside when
    /// `|x − eₓ| ≤ τ (d − e_d)`, τ the tangent of the half angle. So `e_d` is at most
    /// `(min(x + τ d) − max(x − τ d)) / 2τ`, likewise for *y*; the smaller of the two is attained.
    ///
    /// # Errors
    ///
    /// [`RenderError::Camera`] when there is no point or only one place to look at, when a value is
    /// not finite, the elevation is beyond a right angle, or `aspect` or `margin` make no picture.
    pub fn fit(
        points: impl IntoIterator<Item = [f64; 3]>,
        view: ViewDirection,
        vertical_field_of_view: f64,
        aspect: f64,
        margin: f64,
    ) -> Result<Self, RenderError> {
        let tangent = half_tangent(vertical_field_of_view)?;
        if !(aspect > 0.0 && aspect.is_finite()) {
            return Err(RenderError::Camera("its aspect is not positive"));
        }
        if !(0.0..1.0).contains(&margin) {
            return Err(RenderError::Camera("its margin is not between 0 and 1"));
        }
        let right_angle = std::f64::consts::FRAC_PI_2;
        if !(view.azimuth.is_finite() && view.elevation.abs() <= right_angle) {
            return Err(RenderError::Camera("its elevation is beyond a right angle"));
        }
        let backward = view.towards_camera();
        let right = view.right();
        let up = backward.cross(right);
        let forward = -backward;

        let (tangent_x, tangent_y) = (tangent * aspect * (1.0 - margin), tangent * (1.0 - margin));
        let mut span_x = Span::default();
        let mut span_y = Span::default();
        let (mut nearest, mut farthest) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut largest = 0f64;
        for point in points {
            if !point.iter().all(|c| c.abs() <= LARGEST_COORDINATE) {
                return Err(RenderError::Camera("a point to be seen is not finite"));
            }
            largest = point.iter().fold(largest, |most, c| most.max(c.abs()));
            let point = Vector::from(point);
            let depth = point.dot(forward);
            span_x.include(point.dot(right), tangent_x * depth);
            span_y.include(point.dot(up), tangent_y * depth);
            nearest = nearest.min(depth);
            farthest = farthest.max(depth);
        }
        let foremost = (span_x.width() / (2.0 * tangent_x)).min(span_y.width() / (2.0 * tangent_y));
        let extent = farthest - foremost;
        // Points in one place leave nothing but rounding.
        if !(extent > 1e-12 * largest && extent.is_finite()) {
            return Err(RenderError::Camera("there is nothing to look at"));
        }
        // Along a line of sight the cone condition alone would let the camera touch the nearest
        // point.
        let eye_depth = foremost.min(nearest - 0.05 * extent);
        Ok(Self {
            eye: forward * eye_depth + right * span_x.centre() + up * span_y.centre(),
            right,
            up,
            forward,
            projection: Projection::FieldOfView { tangent },
            skew: 0.0,
            near: (nearest - eye_depth) * 0.25,
            far: f64::INFINITY,
        })
    }

    /// The same camera, displaced.
    pub fn moved_by(&self, displacement: [f64; 3]) -> Self {
        Self {
            eye: self.eye + Vector::from(displacement),
            ..*self
        }
    }

    /// The same camera after a rigid motion of the world's points, so that it sees what moved with
    /// it as before.
    ///
    /// ```
    /// use ga_render::View;
    /// use ga_runtime::cga3::{Motor, Rotor};
    ///
    /// let up = [0.0, 1.0, 0.0];
    /// let view = View::look_at([0.0, 0.0, 5.0], [0.0; 3], up, 0.8, 0.1)?;
    /// let quarter = Rotor::from_axis_angle(up, std::f64::consts::FRAC_PI_2).unwrap();
    /// let [x, y, z] = view.moved(Motor::from(quarter)).eye();
    /// assert!((x - 5.0).abs() < 1e-12 && y.abs() < 1e-12 && z.abs() < 1e-12);
    /// # Ok::<(), ga_render::RenderError>(())
    /// ```
    pub fn moved(&self, motion: Motor<f64>) -> Self {
        let rotate = |axis: Vector| Vector::from(motion.transform(Direction::from(axis)));
        Self {
            eye: motion.transform(Point::from(self.eye)).into(),
            right: rotate(self.right),
            up: rotate(self.up),
            forward: rotate(self.forward),
            ..*self
        }
    }

    /// The centre of projection.
    pub fn eye(&self) -> [f64; 3] {
        self.eye.coordinates()
    }

    /// The unit viewing direction.
    pub fn forward(&self) -> [f64; 3] {
        self.forward.coordinates()
    }

    /// The unit vector to the right in the picture.
    pub fn right(&self) -> [f64; 3] {
        self.right.coordinates()
    }

    /// The unit vector up in the picture.
    pub fn up(&self) -> [f64; 3] {
        self.up.coordinates()
    }

    /// The least depth that is drawn.
    pub fn near(&self) -> f64 {
        self.near
    }

    /// The greatest depth that is drawn.
    pub fn far(&self) -> f64 {
        self.far
    }

    /// The skew in pixels, 0 for most cameras.
    pub fn skew(&self) -> f64 {
        self.skew
    }

    fn world_to_camera(&self) -> Motor<f64> {
        let row = |axis: Vector| [axis.e1, axis.e2, axis.e3, -axis.dot(self.eye)];
        let rows = [row(self.right), row(-self.up), row(self.forward)];
        Motor::from_matrix(rows).unwrap_or_default()
    }

    /// The camera that takes a picture of the given size, but for its [skew](Self::skew). That of
    /// [`View::pinhole`] is for one size, and the one given here is not used.
    ///
    /// # Errors
    ///
    /// [`RenderError::Style`] for a picture without rows.
    ///
    /// ```
    /// use ga_render::View;
    ///
    /// let (eye, target, up) = ([0.0, 0.0, 4.0], [0.0; 3], [0.0, 1.0, 0.0]);
    /// let view = View::look_at(eye, target, up, std::f64::consts::FRAC_PI_2, 0.1)?;
    /// // The tangent of half the field of view is 1: half the height at depth 1.
    /// let intrinsics = view.camera(640, 480)?.intrinsics;
    /// assert!((intrinsics.focal()[0] - 240.0).abs() < 1e-9);
    /// assert_eq!(intrinsics.principal(), [319.5, 239.5]);
    /// # Ok::<(), ga_render::RenderError>(())
    /// ```
    pub fn camera(&self, width: u32, height: u32) -> Result<Camera, RenderError> {
        let [width, height] = [width, height].map(f64::from);
        let (focal, principal) = match self.projection {
            Projection::Pixels { focal, principal } => (focal, principal),
            Projection::FieldOfView { tangent } => (
                [height / (2.0 * tangent); 2],
                [width, height].map(|side| (side - 1.0) / 2.0),
            ),
        };
        let intrinsics = Intrinsics::new(focal, principal);
        Ok(Camera {
            intrinsics: intrinsics.map_err(|_| RenderError::Style("it has no rows"))?,
            world_to_camera: self.world_to_camera(),
        })
    }

    pub(crate) fn projection(&self) -> Projection {
        self.projection
    }

    /// Right offset, up offset and depth of a point.
    pub(crate) fn in_frame(&self, point: Vector) -> Vector {
        let offset = point - self.eye;
        Vector::new(
            offset.dot(self.right),
            offset.dot(self.up),
            offset.dot(self.forward),
        )
    }

    /// The world vector of a vector given by right offset, up offset and depth.
    pub(crate) fn world_direction(&self, view: Vector) -> Vector {
        self.right * view.e1 + self.up * view.e2 + self.forward * view.e3
    }
}

/// `max(a − b)` and `min(a + b)` over the included pairs.
struct Span {
    high_edge: f64,
    low_edge: f64,
}

impl Default for Span {
    fn default() -> Self {
        Self {
            high_edge: f64::NEG_INFINITY,
            low_edge: f64::INFINITY,
        }
    }
}

impl Span {
    fn include(&mut self, offset: f64, reach: f64) {
        self.high_edge = self.high_edge.max(offset - reach);
        self.low_edge = self.low_edge.min(offset + reach);
    }

    fn width(&self) -> f64 {
        self.low_edge - self.high_edge
    }

    fn centre(&self) -> f64 {
        (self.low_edge + self.high_edge) / 2.0
    }
}

fn half_tangent(field_of_view: f64) -> Result<f64, RenderError> {
    if field_of_view > 0.0 && field_of_view < std::f64::consts::PI {
        Ok((field_of_view / 2.0).tan())
    } else {
        Err(RenderError::Camera(
            "its field of view is not between 0 and π",
        ))
    }
}
