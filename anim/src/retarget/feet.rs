//! How feet lie on the ground.

use std::ops::RangeInclusive;

use ga_numerics::order_statistics::Sorted;
use ga_runtime::vga3::Vector;

/// As a part of the leg's length, the height above the lowest place up to which an ankle belongs to
/// a foot on the ground.
const LOW: f64 = 0.1;
/// The least number of frames that say how a foot stands.
const FRAMES: usize = 3;

/// The left and the right foot.
#[derive(Clone, Debug, Default)]
pub(super) struct Feet {
    pub(super) sides: [Foot; 2],
}

/// A foot in the frames of a motion.
#[derive(Clone, Debug, Default)]
pub(super) struct Foot {
    frames: Vec<FootPose>,
}

#[derive(Clone, Copy, Debug)]
struct FootPose {
    frame: usize,
    /// Of the ankle.
    height: f64,
    /// The angle in degrees of the sole from flat.
    tilt: f64,
    /// The angle in degrees between the foot and where the pelvis looks, in the horizontal plane;
    /// `None` where one of them is vertical.
    heading: Option<f64>,
}

impl Foot {
    /// Adds a frame with the height of the ankle, the normal of the sole, and the directions of
    /// foot and pelvis.
    pub(super) fn add(
        &mut self,
        frame: usize,
        height: f64,
        normal: Vector<f64>,
        directions: [Vector<f64>; 2],
    ) {
        let degrees = |a: Vector<f64>, b: Vector<f64>| Some(a.angle(b)?.to_degrees());
        let [foot, pelvis] = directions.map(|v| Vector::new(v.e1, 0.0, v.e3));
        self.frames.push(FootPose {
            frame,
            height,
            tilt: degrees(normal, Vector::new(0.0, 1.0, 0.0)).unwrap_or_default(),
            heading: degrees(foot, pelvis),
        });
    }

    /// Keeps the frames of these ranges in which the foot is as low as one on the ground.
    pub(super) fn retain_standing(&mut self, ranges: &[RangeInclusive<usize>], leg_length: f64) {
        let heights = self.frames.iter().map(|pose| pose.height);
        let limit = heights.fold(f64::INFINITY, f64::min) + LOW * leg_length;
        self.frames.retain(|pose| {
            pose.height <= limit && ranges.iter().any(|range| range.contains(&pose.frame))
        });
    }

    /// The median angle of the sole from flat, and the frame in which it is greatest.
    pub(super) fn tilt(&self) -> Option<(f64, usize)> {
        self.median(|pose| Some(pose.tilt))
    }

    /// The same of the angle between the foot and where the pelvis looks.
    pub(super) fn heading(&self) -> Option<(f64, usize)> {
        self.median(|pose| pose.heading)
    }

    fn median(&self, angle: impl Fn(&FootPose) -> Option<f64>) -> Option<(f64, usize)> {
        let found = self.frames.iter();
        let found = found.filter_map(|pose| Some((angle(pose)?, pose.frame)));
        let found: Vec<(f64, usize)> = found.collect();
        if found.len() < FRAMES {
            return None;
        }
        let &(_, worst) = found.iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
        let mut angles: Vec<f64> = found.into_iter().map(|(angle, _)| angle).collect();
        Some((Sorted::new(&mut angles)?.quantile(0.5), worst))
    }
}
