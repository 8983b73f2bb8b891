//! The pinhole camera of a picture.

use ga_runtime::cga3::Rotor;
use ga_runtime::geometry::LookAtError;

use crate::{LARGEST_COORDINATE, RenderError, Vector};

/// A pinhole camera: position, viewing direction and field of view.
///
/// Its frame is right-handed with *x* to the right, *y* up and *z* towards the viewer; a point's
/// *depth* is its distance along the viewing direction, so `-z`. Pixel *(0, 0)* is at the top left,
/// and pixel centres lie on halves. A point at right offset *x*, up offset *y* and depth *d* falls
/// on
///
/// ```text
/// column = width/2  + (x/d) (height/2) / tan(φ/2)
/// row    = height/2 − (y/d) (height/2) / tan(φ/2)
/// ```
///
/// with φ the vertical field of view. Lengths are in the unit of the model, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: Vector,
    right: Vector,
    up: Vector,
    forward: Vector,
    tangent: f64,
    near: f64,
}

/// The side a model is seen from, in a world whose *y* axis points up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewDirection {
    /// Angle about the *y* axis, in radians: 0 looks at the model from +*z*, π/2 from +*x*.
    pub azimuth: f64,
    /// Angle above the horizon, in radians, between −π/2 and π/2 (both excluded).
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
    fn towards_camera(self) -> Vector {
        let (sin_azimuth, cos_azimuth) = self.azimuth.sin_cos();
        let (sin_elevation, cos_elevation) = self.elevation.sin_cos();
        Vector::new(
            sin_azimuth * cos_elevation,
            sin_elevation,
            cos_azimuth * cos_elevation,
        )
    }
}

impl Camera {
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
            tangent: half_tangent(vertical_field_of_view)?,
            near,
        })
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
    /// not finite, the elevation is not below a right angle, or `aspect` or `margin` make no
    /// picture.
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
        let level = view.azimuth.is_finite() && view.elevation.abs() < 89.9f64.to_radians();
        if !level {
            return Err(RenderError::Camera("its elevation reaches a right angle"));
        }
        let backward = view.towards_camera();
        let right = Vector::new(view.azimuth.cos(), 0.0, -view.azimuth.sin());
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
            tangent,
            near: (nearest - eye_depth) * 0.25,
        })
    }

    /// The same camera, displaced.
    pub fn moved_by(&self, displacement: [f64; 3]) -> Self {
        Self {
            eye: self.eye + Vector::from(displacement),
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

    /// Column, row and depth at which a picture of the given size shows `point`; `None` when it is
    /// nearer than the near depth or behind the camera.
    pub fn project(&self, point: [f64; 3], width: u32, height: u32) -> Option<[f64; 3]> {
        let Vector {
            e1: x,
            e2: y,
            e3: depth,
        } = self.view(point.into());
        (depth >= self.near).then(|| {
            let [column, row] = Lens::new(self, width, height).project([x, y], 1.0 / depth);
            [column, row, depth]
        })
    }

    /// Right offset, up offset and depth of a point.
    pub(crate) fn view(&self, point: Vector) -> Vector {
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

/// A camera's projection onto the pixels of one picture.
#[derive(Clone, Copy)]
pub(crate) struct Lens {
    /// Pixels per unit of `x / depth`.
    pub(crate) focal: f64,
    pub(crate) centre: [f64; 2],
}

impl Lens {
    pub(crate) fn new(camera: &Camera, width: u32, height: u32) -> Self {
        Self {
            focal: f64::from(height) / (2.0 * camera.tangent),
            centre: [f64::from(width) / 2.0, f64::from(height) / 2.0],
        }
    }

    /// Column and row of the point at these right and up offsets and the given inverse depth.
    pub(crate) fn project(&self, [x, y]: [f64; 2], inverse_depth: f64) -> [f64; 2] {
        [
            self.centre[0] + x * inverse_depth * self.focal,
            self.centre[1] - y * inverse_depth * self.focal,
        ]
    }

    /// The view vector of depth 1 through a place in the picture.
    pub(crate) fn ray(&self, column: f64, row: f64) -> Vector {
        Vector::new(
            (column - self.centre[0]) / self.focal,
            (self.centre[1] - row) / self.focal,
            1.0,
        )
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
