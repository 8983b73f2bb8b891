//! The motion and the cameras that see it.

use ga_anim::bvh::Bvh;
use ga_anim::pose::Pose;
use ga_anim::recording::Recording;
use ga_anim::unit::likely_unit;
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::error::EvaluationError;
use crate::BodyModel;

/// From the mean of the body's points to each camera, in metres.
pub(super) const DISTANCE: f64 = 4.0;
/// Between the two cameras of a rig, in metres.
pub(super) const BASELINE: f64 = 1.0;
pub(super) const FOCAL_LENGTH: f64 = 1000.0;
/// The middle of pictures of 1920 × 1080 pixels.
const PRINCIPAL_POINT: [f64; 2] = [959.5, 539.5];
/// The frames of a stretch: a second of motion capture.
const STRETCH: usize = 120;

/// Which part of a recorded motion is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionOptions {
    /// The length of one unit of the recording in metres; without it the
    /// [likely one](ga_anim::unit).
    pub metres_per_unit: Option<f64>,
    /// The first frame, counted from 0; 0 by default.
    pub first: usize,
    /// The step from each frame to the next; 1 by default.
    pub every: usize,
    /// The greatest number of frames, in stretches of at most 120 that are evenly spread over the
    /// motion; 0, the default, for all.
    pub most: usize,
}

impl Default for MotionOptions {
    fn default() -> Self {
        Self {
            metres_per_unit: None,
            first: 0,
            every: 1,
            most: 0,
        }
    }
}

/// A motion of a body in metres, in stretches of neighbouring frames.
#[derive(Clone, Debug)]
pub struct Motion {
    pub(super) model: BodyModel,
    pub(super) metres_per_unit: f64,
    pub(super) frames_per_second: f64,
    pub(super) stretches: Vec<Stretch>,
}

/// Frames one after the other, and where the cameras look.
#[derive(Clone, Debug)]
pub(super) struct Stretch {
    /// The points of the model in each frame.
    pub(super) frames: Vec<Vec<Point<f64>>>,
    /// The number of the first frame in the file, from 0, and the step from each to the next.
    first: usize,
    every: usize,
    /// The mean of all of them.
    middle: Vector<f64>,
    /// The level direction from there to the cameras: the body moves across rather than in depth.
    towards_cameras: Vector<f64>,
}

impl Motion {
    /// The part of a recording that the options say. Joints that are in one place at rest count
    /// once.
    ///
    /// # Errors
    /// [`EvaluationError`] for a motion without frames, a step of 0, and a recording that has no
    /// skeleton.
    pub fn new(recorded: &Bvh, options: &MotionOptions) -> Result<Self, EvaluationError> {
        let MotionOptions { first, every, .. } = *options;
        if every == 0 {
            return Err(EvaluationError::Every);
        }
        let metres_per_unit = match options.metres_per_unit {
            Some(unit) => unit,
            None => likely_unit(recorded).metres,
        };
        let recording = Recording::from_bvh(recorded, metres_per_unit)?;
        let skeleton = recording.to_skeleton()?;
        let clip = recording.to_clip()?;
        let model = BodyModel::of_distinct_joints(skeleton)?;
        let poses: Vec<_> = clip.frames().iter().skip(first).step_by(every).collect();
        if poses.is_empty() {
            return Err(EvaluationError::NoFrames);
        }
        let points = |pose: &&Pose| -> Result<Vec<Point<f64>>, EvaluationError> {
            let motions = pose.motions(model.skeleton())?;
            let points = model.points().iter().map(|point| {
                let joint = point.joints.first().map_or(0, |(joint, _)| *joint);
                motions[joint].transform(Point::from(point.at_rest))
            });
            Ok(points.collect())
        };
        let stretches = stretches(poses.len(), options.most)
            .into_iter()
            .map(|range| {
                let first = first + every * range.start;
                let frames = poses[range].iter().map(points);
                Ok(Stretch::new(
                    frames.collect::<Result<_, _>>()?,
                    first,
                    every,
                ))
            });
        Ok(Self {
            stretches: stretches.collect::<Result<_, EvaluationError>>()?,
            model,
            metres_per_unit,
            frames_per_second: 1.0 / (recording.frame_time() * every as f64),
        })
    }

    /// The number of frames that are taken.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        let stretches = self.stretches.iter();
        stretches.map(|stretch| stretch.frames.len()).sum()
    }
}

impl Stretch {
    fn new(frames: Vec<Vec<Point<f64>>>, first: usize, every: usize) -> Self {
        let points = || frames.iter().flatten().map(|&point| Vector::from(point));
        let [low, high] = ga_mesh::bounds(points()).unwrap_or_default();
        let size = high - low;
        let (sum, count) = (
            points().fold(Vector::ZERO, |sum, p| sum + p),
            points().count(),
        );
        let towards_cameras = if size.e1 < size.e3 {
            Vector::X
        } else {
            Vector::Z
        };
        Self {
            middle: sum * (1.0 / count.max(1) as f64),
            towards_cameras,
            frames,
            first,
            every,
        }
    }

    /// The number in the file of a frame of the stretch, both from 0.
    pub(super) fn number_in_file(&self, frame: usize) -> usize {
        self.first + self.every * frame
    }

    /// One camera; two with the baseline between them, side by side; or more in a circle.
    pub(super) fn cameras(&self, count: usize) -> Result<Vec<Camera>, EvaluationError> {
        let intrinsics = Intrinsics::new([FOCAL_LENGTH; 2], PRINCIPAL_POINT)?;
        let step = match count {
            2 => 2.0 * (0.5 * BASELINE / DISTANCE).asin(),
            _ => std::f64::consts::TAU / count as f64,
        };
        let start = if count == 2 { -0.5 * step } else { 0.0 };
        let across = Vector::Y.cross(self.towards_cameras);
        let cameras = (0..count).map(|index| {
            let (sin, cos) = (start + step * index as f64).sin_cos();
            let way = self.towards_cameras * cos + across * sin;
            let eye = Point::from(self.middle + way * DISTANCE);
            Camera::look_at(intrinsics, eye, self.middle.into(), [0.0, 1.0, 0.0])
                .ok_or(EvaluationError::NoDirection)
        });
        cameras.collect()
    }
}

/// Ranges of `count` frames that are at most `most` together, 0 for all.
fn stretches(count: usize, most: usize) -> Vec<std::ops::Range<usize>> {
    let wanted = if most == 0 { count } else { most.min(count) };
    let number = wanted.div_ceil(STRETCH).max(1);
    let length = wanted / number;
    let slack = count - number * length;
    let range = |index: usize| {
        let start = index * length + slack * index / number.saturating_sub(1).max(1);
        start..start + length
    };
    (0..number).map(range).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_are_apart_and_within_the_motion() {
        for (count, most) in [
            (2752, 480),
            (2752, 0),
            (100, 480),
            (1, 480),
            (500, 7),
            (481, 480),
        ] {
            let ranges = stretches(count, most);
            assert!(ranges.last().is_some_and(|range| range.end <= count));
            assert!(
                ranges
                    .iter()
                    .all(|range| (1..=STRETCH).contains(&range.len()))
            );
            assert!(ranges.windows(2).all(|pair| pair[0].end <= pair[1].start));
            let frames: usize = ranges.iter().map(ExactSizeIterator::len).sum();
            let wanted = if most == 0 { count } else { most.min(count) };
            assert!(
                frames <= wanted && frames + ranges.len() > wanted,
                "{frames} {wanted}"
            );
        }
    }
}
