//! Where the cameras stand: before the person, and so far away that it is in the pictures.

use std::f64::consts::PI;

use anyhow::{Context as _, Result, bail};
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

use super::SIZE;

/// The focal length in pixels.
pub(in crate::commands::demo) const FOCAL: f64 = 1000.0;
/// How far the cameras are from each other, in metres.
pub(in crate::commands::demo) const BASELINE: f64 = 0.18;
/// How far the person is, in metres, where it need not be farther.
const DISTANCE: f64 = 3.4;
/// The cameras stand at this height and look at the middle of the person.
const HEIGHT: f64 = 1.25;
pub(super) const MIDDLE: f64 = 0.88;
/// The direction from which they look, from that in which the person faces, in radians.
const AZIMUTH: f64 = 0.4;
/// The direction in which a person faces is a multiple of this: hips and shoulders turn by less in
/// a walk, which goes straight on.
const TURN: f64 = PI / 6.0;
/// By how much the right camera is rolled and raised, which viewers of stereoscopic films feel.
const ROLL: f64 = 0.012;
const PITCH: f64 = 0.004;
/// By so much a hand or a foot may leave the pictures, in pixels, as one does where the walk ends.
const OUTSIDE: f64 = 36.0;
/// The studio grows by steps, and not for ever.
const GROWTH: f64 = 0.05;
const MOST_STEPS: u32 = 40;

/// Where the cameras stand.
#[derive(Clone, Copy, Debug)]
pub(in crate::commands::demo) struct Standpoint {
    /// On the floor, below the person.
    pub(in crate::commands::demo) place: Point<f64>,
    /// The direction in which the person faces, from +z towards +x, in radians.
    pub(in crate::commands::demo) heading: f64,
    /// How many times larger than usual the studio is.
    pub(super) scale: f64,
}

impl Standpoint {
    /// The nearest one from which both cameras see all points, or nearly so.
    ///
    /// # Errors
    ///
    /// Where that would be too far away.
    pub(in crate::commands::demo) fn before(
        place: Point<f64>,
        heading: f64,
        points: &[Point<f64>],
    ) -> Result<Self> {
        let mut standpoint = Self {
            place,
            heading: (heading / TURN).round() * TURN,
            scale: 1.0,
        };
        for step in 0..MOST_STEPS {
            standpoint.scale = 1.0 + GROWTH * f64::from(step);
            let StereoRig { left, right } = standpoint.rig()?;
            let mut all = points
                .iter()
                .flat_map(|point| [&left, &right].map(|c| c.project(*point)));
            if all.all(|pixel| pixel.is_ok_and(is_inside)) {
                return Ok(standpoint);
            }
        }
        bail!(
            "the person goes too far in the second that is filmed: cameras at a distance of {:.1} m \
             do not see all of it",
            DISTANCE * standpoint.scale
        )
    }

    /// The cameras, with y up.
    pub(in crate::commands::demo) fn rig(&self) -> Result<StereoRig> {
        let [x, y, z] = self.place.coordinates();
        let (sin, cos) = (self.heading + AZIMUTH).sin_cos();
        let target = Point::new(x, y + MIDDLE, z);
        let distance = DISTANCE * self.scale;
        let height = self.height(HEIGHT);
        let eye = Point::new(x + distance * sin, y + height, z + distance * cos);
        let principal = SIZE.map(|side| 0.5 * (side as f64 - 1.0));
        let intrinsics = Intrinsics::new([FOCAL; 2], principal)?;
        let middle = Camera::look_at(intrinsics, eye, target, [0.0, 1.0, 0.0]);
        let middle = middle.context("the cameras of the demonstration look along the vertical")?;
        let aside = |metres: f64| Motor::from(Translator::from_displacement([metres, 0.0, 0.0]));
        let rotation = |axis: [f64; 3], angle: f64| {
            Motor::from(Rotor::from_axis_angle(axis, angle).unwrap_or_default())
        };
        let tilt = rotation([0.0, 0.0, 1.0], ROLL) * rotation([1.0, 0.0, 0.0], PITCH);
        let camera = |motion: Motor<f64>| Camera {
            world_to_camera: motion * middle.world_to_camera,
            ..middle
        };
        Ok(StereoRig {
            left: camera(aside(0.5 * BASELINE)),
            right: camera(tilt * aside(-0.5 * BASELINE)),
        })
    }

    /// A height in the studio: it grows about the middle of the person, so that the pictures of
    /// what does not move stay nearly the same.
    pub(super) fn height(&self, usual: f64) -> f64 {
        MIDDLE + (usual - MIDDLE) * self.scale
    }
}

/// Whether a pixel is in the pictures, or near to them.
fn is_inside(pixel: [f64; 2]) -> bool {
    let inside = |k: usize| (-OUTSIDE..SIZE[k] as f64 + OUTSIDE).contains(&pixel[k]);
    inside(0) && inside(1)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    /// The cameras look against the direction in which the person faces, but for 0.4 rad, and the
    /// greatest cylinder that fits is seen whole.
    #[test]
    fn the_cameras_see_the_face_of_whoever_is_there() {
        let place = Point::new(3.0, 0.0, -2.0);
        for (heading, radius, height) in [(0.0, 0.5, 1.8), (2.0, 1.4, 1.8), (-3.0, 0.5, 3.0)] {
            let ring = (0..24).flat_map(|k| {
                let (sin, cos) = (f64::from(k) * PI / 12.0).sin_cos();
                [0.0, height].map(|y| Point::new(3.0 + radius * sin, y, -2.0 + radius * cos))
            });
            let points: Vec<Point<f64>> = ring.collect();
            let standpoint = Standpoint::before(place, heading, &points).unwrap();
            let rig = standpoint.rig().unwrap();
            assert!((rig.baseline() - BASELINE).abs() < 1e-12);
            for camera in [rig.left, rig.right] {
                assert!(
                    points
                        .iter()
                        .all(|p| is_inside(camera.project(*p).unwrap()))
                );
                let [x, y, z] = camera.centre().coordinates();
                let from = (x - 3.0).atan2(z + 2.0) - AZIMUTH - heading;
                assert!(
                    from.sin().abs() < 0.3 && from.cos() > 0.0,
                    "{heading} {from}"
                );
                assert!(y > 1.0);
            }
        }
    }
}
