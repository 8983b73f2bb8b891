//! The errors of reconstructed joints.

use ga_camera::Camera;
use ga_runtime::cga3::Point;

use crate::BodyError;
use crate::pose_error::{mean_per_joint_position_error, procrustes_aligned, root_aligned_error};

/// Mean errors over the frames of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scores {
    /// The mean per joint position error in metres.
    pub position_error: f64,
    /// The same relative to the root, in metres, over the frames that have it.
    pub root_relative_error: Option<f64>,
    /// The error after Procrustes alignment without reflection in metres, over the frames with
    /// three joints or more.
    pub aligned_error: Option<f64>,
    /// The mean distance in the pictures from where the joints truly are, in pixels, over all views
    /// in front of whose cameras both are.
    pub joint_error_px: f64,
    /// The part of all joints that was found.
    pub found: f64,
}

/// The scores of reconstructed joints, `None` for those that were not found. The first joint is the
/// root.
///
/// # Errors
/// [`BodyError`] for other numbers of frames or joints than the true motion has, for joints
/// that are not finite, and where no joint was found.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_body::evaluation::score;
/// use ga_camera::{Camera, Intrinsics};
///
/// let intrinsics = Intrinsics::new([1000.0, 1000.0], [0.0, 0.0])?;
/// let camera = Camera { intrinsics, world_to_camera: Default::default() };
/// let truth = vec![[[0.0, 0.0, 4.0], [1.0, 0.0, 4.0], [0.0, 1.0, 4.0]].map(Point::from).to_vec()];
/// let mut found = vec![truth[0].iter().copied().map(Some).collect::<Vec<_>>()];
/// found[0][1] = Some(Point::new(1.0, 0.0, 4.3));
/// found[0][2] = None;
/// let scores = score(&[camera], &truth, &found)?;
/// assert!((scores.position_error - 0.15).abs() < 1e-12);
/// assert_eq!(scores.aligned_error, None);
/// // 1 m to the side is at 250 px from 4 m, and at 232.6 px from 4.3 m.
/// assert!((scores.joint_error_px - 0.5 * (250.0 - 1000.0 / 4.3)).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn score(
    cameras: &[Camera],
    truth: &[Vec<Point<f64>>],
    found: &[Vec<Option<Point<f64>>>],
) -> Result<Scores, BodyError> {
    if truth.len() != found.len() {
        return Err(BodyError::JointCounts {
            expected: truth.len(),
            found: found.len(),
        });
    }
    let [
        mut position,
        mut relative,
        mut aligned,
        mut pixels,
        mut part,
    ] = [Mean::default(); 5];
    for (truth, found) in truth.iter().zip(found) {
        if truth.len() != found.len() {
            return Err(BodyError::JointCounts {
                expected: truth.len(),
                found: found.len(),
            });
        }
        let pairs = truth.iter().zip(found);
        let pairs = pairs.filter_map(|(&truth, &found)| Some((truth, found?)));
        let (truths, founds): (Vec<_>, Vec<_>) = pairs.unzip();
        part.add(truths.len() as f64 / truth.len().max(1) as f64);
        if truths.is_empty() {
            continue;
        }
        position.add(mean_per_joint_position_error(&truths, &founds)?);
        if found[0].is_some() {
            relative.add(root_aligned_error(&truths, &founds, 0)?);
        }
        if let Ok(fit) = procrustes_aligned(&truths, &founds) {
            aligned.add(fit.mean_error);
        }
        for camera in cameras {
            for (truth, found) in truths.iter().zip(&founds) {
                if let (Ok([u, v]), Ok(there)) = (camera.project(*truth), camera.project(*found)) {
                    pixels.add((there[0] - u).hypot(there[1] - v));
                }
            }
        }
    }
    Ok(Scores {
        position_error: position.value().ok_or(BodyError::NoJoints)?,
        root_relative_error: relative.value(),
        aligned_error: aligned.value(),
        joint_error_px: pixels.value().unwrap_or(0.0),
        found: part.value().unwrap_or(0.0),
    })
}

#[derive(Clone, Copy, Default)]
struct Mean {
    sum: f64,
    count: usize,
}

impl Mean {
    fn add(&mut self, value: f64) {
        self.sum += value;
        self.count += 1;
    }

    fn value(self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }
}
