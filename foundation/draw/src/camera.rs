//! Projection from space to the picture, and what hides what.

use ga_runtime::vga3::Vector;

use crate::picture::{Ball, Patch};
use crate::plane::Plane;
use crate::view::{Projection, View};

/// The distance of the eye from the middle of the scene, in radii of the scene.
pub(crate) const EYE: f64 = 4.0;

/// A place in the picture: pixels to the right and down from its upper left corner.
pub(crate) type Pixel = [f64; 2];

/// Projects points of space to the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Camera {
    right: Vector<f64>,
    up: Vector<f64>,
    /// From the middle of the scene towards the eye, of length 1.
    pub(crate) toward: Vector<f64>,
    perspective: bool,
    /// The number of pixels of the scene's radius.
    pub(crate) scale: f64,
    /// The place of the scene's middle.
    pub(crate) middle: Pixel,
}

impl Camera {
    /// The camera of a view. The middle of the scene is at pixel (0, 0) and its radius is one
    /// pixel.
    pub(crate) fn new(view: &View) -> Self {
        let [ahead, aside, up] = view.up.axes();
        let sensible = |degrees: f64| {
            if degrees.is_finite() {
                degrees.to_radians()
            } else {
                0.0
            }
        };
        let (sin_azimuth, cos_azimuth) = sensible(view.azimuth % 360.0).sin_cos();
        let (sin_elevation, cos_elevation) = sensible(view.elevation.clamp(-90.0, 90.0)).sin_cos();
        let out = ahead * cos_azimuth + aside * sin_azimuth;
        let right = aside * cos_azimuth - ahead * sin_azimuth;
        let toward = out * cos_elevation + up * sin_elevation;
        Self {
            right,
            up: toward.cross(right),
            toward,
            perspective: view.projection == Projection::Perspective,
            scale: 1.0,
            middle: [0.0; 2],
        }
    }

    /// How near a point is to the eye, measured along the direction of view.
    pub(crate) fn depth(&self, point: Vector<f64>) -> f64 {
        point.dot(self.toward)
    }

    pub(crate) fn project(&self, point: Vector<f64>) -> Pixel {
        let scale = if self.perspective {
            self.scale * EYE / (EYE - self.depth(point)).max(0.2)
        } else {
            self.scale
        };
        [
            self.middle[0] + scale * point.dot(self.right),
            self.middle[1] - scale * point.dot(self.up),
        ]
    }

    /// The direction from a point to the eye, of length 1, and the distance of the eye.
    fn ray(&self, point: Vector<f64>) -> (Vector<f64>, f64) {
        if !self.perspective {
            return (self.toward, f64::INFINITY);
        }
        let way = self.toward * EYE - point;
        let distance = way.length().max(1e-9);
        (way * distance.recip(), distance)
    }

    /// Whether the eye is on the positive side of a plane.
    pub(crate) fn is_above(&self, plane: Plane) -> bool {
        let toward = plane.normal.dot(self.toward);
        if self.perspective {
            EYE * toward > plane.distance
        } else {
            toward > 0.0
        }
    }

    /// The plane through the outline of a ball, with the visible part on its positive side.
    pub(crate) fn horizon(&self, centre: Vector<f64>, radius: f64) -> Plane {
        let (normal, distance) = self.ray(centre);
        // The plane is the polar plane of the eye. For parallel rays r²/∞ is zero.
        let height = (radius * radius / distance).min(0.999 * radius);
        Plane {
            normal,
            distance: normal.dot(centre) + height,
        }
    }

    /// Whether a ball hides a point. A point on its front is not hidden.
    pub(crate) fn is_behind_ball(&self, point: Vector<f64>, ball: &Ball) -> bool {
        let (ray, _) = self.ray(point);
        let from = point - ball.centre;
        let ahead = from.dot(ray);
        let discriminant = ahead * ahead - from.dot(from) + ball.radius * ball.radius;
        discriminant > 0.0 && discriminant.sqrt() - ahead > 1e-4 + 0.02 * ball.radius
    }

    /// Whether a patch hides a point. A point on the patch is not hidden.
    pub(crate) fn is_behind_patch(&self, point: Vector<f64>, patch: &Patch) -> bool {
        let (ray, distance) = self.ray(point);
        let slope = patch.normal.dot(ray);
        if slope.abs() < 1e-6 {
            return false;
        }
        let t = patch.normal.dot(patch.corners[0] - point) / slope;
        if !(t > 1e-3 && t < distance) {
            return false;
        }
        let through = point + ray * t;
        let sides = patch
            .corners
            .iter()
            .zip(patch.corners.iter().cycle().skip(1));
        sides.into_iter().all(|(from, to)| {
            let across = (*to - *from).cross(through - *from);
            across.dot(patch.normal) >= 0.0
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::PALETTE;
    use crate::view::Up;

    fn camera(azimuth: f64, elevation: f64, projection: Projection, up: Up) -> Camera {
        let mut camera = Camera::new(&View {
            azimuth,
            elevation,
            zoom: 1.0,
            projection,
            up,
        });
        (camera.scale, camera.middle) = (100.0, [400.0, 300.0]);
        camera
    }

    fn assert_near(found: Pixel, expected: Pixel) {
        let near = (0..2).all(|k| (found[k] - expected[k]).abs() < 1e-9);
        assert!(near, "{found:?} is not {expected:?}");
    }

    #[test]
    fn known_points_along_parallel_rays() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector::from);
        // From +x with z up, y points right.
        let front = camera(0.0, 0.0, Projection::Orthographic, Up::Z);
        assert_near(front.project(x), [400.0, 300.0]);
        assert_near(front.project(y), [500.0, 300.0]);
        assert_near(front.project(z), [400.0, 200.0]);
        assert_eq!(front.depth(x), 1.0);
        // From +y with z up, x points left.
        let side = camera(90.0, 0.0, Projection::Orthographic, Up::Z);
        assert_near(side.project(x), [300.0, 300.0]);
        // From above with y up: x to the right, z down the picture.
        let above = camera(0.0, 90.0, Projection::Orthographic, Up::Y);
        assert_near(above.project(x), [500.0, 300.0]);
        assert_near(above.project(z), [400.0, 400.0]);
    }

    #[test]
    fn an_eye_sees_near_things_larger() {
        let front = camera(0.0, 0.0, Projection::Perspective, Up::Z);
        // At depth 2 of 4 twice as large, at depth −4 half as large.
        assert_near(front.project(Vector::new(2.0, 1.0, 0.0)), [600.0, 300.0]);
        assert_near(front.project(Vector::new(-4.0, 0.0, 1.0)), [400.0, 250.0]);
    }

    #[test]
    fn a_ball_hides_what_is_behind_and_within_it() {
        let ball = Ball {
            element: None,
            colour: PALETTE[0],
            centre: Vector::new(0.5, 0.0, 0.0),
            radius: 0.25,
            opacity: 1.0,
            width: 1.0,
            imaginary: false,
        };
        for projection in [Projection::Orthographic, Projection::Perspective] {
            let front = camera(0.0, 0.0, projection, Up::Z);
            for (point, hidden) in [
                ([0.0, 0.0, 0.0], true),
                ([0.5, 0.0, 0.0], true),
                ([0.25, 0.0, 0.0], true),
                ([0.75, 0.0, 0.0], false),
                ([0.9, 0.0, 0.0], false),
                ([0.0, 0.4, 0.0], false),
            ] {
                assert_eq!(
                    front.is_behind_ball(point.into(), &ball),
                    hidden,
                    "{point:?}"
                );
            }
        }
    }

    #[test]
    fn a_patch_hides_what_is_behind_it_and_within_its_bounds() {
        let patch = Patch {
            element: None,
            colour: PALETTE[0],
            corners: [
                [0.0, -1.0, -1.0],
                [0.0, 1.0, -1.0],
                [0.0, 1.0, 1.0],
                [0.0, -1.0, 1.0],
            ]
            .map(Vector::from)
            .to_vec(),
            normal: Vector::new(1.0, 0.0, 0.0),
            opacity: 0.2,
        };
        for projection in [Projection::Orthographic, Projection::Perspective] {
            for (azimuth, behind) in [(0.0, -0.5), (180.0, 0.5)] {
                let camera = camera(azimuth, 0.0, projection, Up::Z);
                assert!(camera.is_behind_patch([behind, 0.5, 0.5].into(), &patch));
                assert!(!camera.is_behind_patch([-behind, 0.5, 0.5].into(), &patch));
                assert!(!camera.is_behind_patch([0.0, 0.5, 0.5].into(), &patch));
                assert!(!camera.is_behind_patch([behind, 2.5, 0.5].into(), &patch));
            }
        }
    }
}
