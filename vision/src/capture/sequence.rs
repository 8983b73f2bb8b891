//! Frames of points, separated into the pose of the head and its expression.

use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::error::NEEDED;
use super::pose::{PoseOptions, RigidPose, check, rigid_pose};
use crate::capture::CaptureError;

/// A head at rest, ready to be found in frames.
///
/// Calibrated points are those that an expression does not move, such as temples, forehead and the
/// bridge of the nose: they show the pose, and what all points do beyond it is the expression.
///
/// ```
/// use ga_runtime::cga3::{Motor, Point, Translator};
/// use ga_vision::capture::{Capture, PoseOptions};
///
/// // Four calibrated points and a corner of the mouth, in metres.
/// let rest = [
///     [-0.07, 0.0, 0.0], [0.07, 0.0, 0.0], [0.0, 0.01, 0.09], [0.0, 0.06, 0.08],
///     [0.025, -0.05, 0.08],
/// ];
/// let rest = rest.map(Point::from).to_vec();
/// let capture = Capture::new(rest.clone(), vec![0, 1, 2, 3], PoseOptions::default())?;
///
/// // The head moves by 1 m, and the corner of the mouth rises by 1 cm.
/// let motor: Motor<f64> = Translator::from_displacement([0.0, 0.0, 1.0]).into();
/// let mut seen: Vec<_> = rest.iter().map(|&point| Some(motor.transform(point))).collect();
/// seen[4] = Some(Point::new(0.025, -0.04, 1.08));
/// let frame = capture.frame(&seen)?;
/// let centre = frame.pose.motor.transform(Point::default());
/// assert!(centre.distance(Point::new(0.0, 0.0, 1.0)) < 1e-12);
/// let smile = frame.expression[4].ok_or("it was seen")?;
/// assert!((smile.y() - 0.01).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Capture {
    rest: Vec<Point<f64>>,
    calibrated: Vec<usize>,
    options: PoseOptions,
}

/// What a frame shows.
#[derive(Clone, Debug, PartialEq)]
pub struct CapturedFrame {
    /// Where the head is. Its inliers are indices of points, among the calibrated ones.
    pub pose: RigidPose,
    /// For each point where it would be if the head were at rest, `~M y M`; `None` where it was not
    /// seen.
    pub still: Vec<Option<Point<f64>>>,
    /// For each point its displacement by the expression, `~M y M − x`, in the frame of the head
    /// at rest; `None` where the point was not seen.
    pub expression: Vec<Option<Vector<f64>>>,
}

/// What a frame of a sequence shows, or why it does not show where the head is.
pub type FrameOutcome = Result<CapturedFrame, CaptureError>;

/// The capture matrix of a frame (Cui, §2.1.1): the 4 × N homogeneous coordinates of its points
/// with the pose of the head taken out, which are the paper's reverse points,
///
/// ```text
///     ⎡ x₁ x₂ … xN ⎤
/// C = ⎢ y₁ y₂ … yN ⎥    (xₖ, yₖ, zₖ) = ~M pₖ M
///     ⎢ z₁ z₂ … zN ⎥
///     ⎣ 1  1  …  1 ⎦
/// ```
///
/// for the points pₖ that were seen. Lengths are in the unit of the points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CaptureMatrix {
    /// The point of each column.
    pub points: Vec<usize>,
    /// The columns (x, y, z, 1).
    pub columns: Vec<[f64; 4]>,
}

impl Capture {
    /// A head whose points at rest are `rest`, of which some are calibrated.
    ///
    /// # Errors
    /// [`CaptureError`]: a point at rest that is not finite; a calibrated point that does not exist
    /// or is named twice; fewer than three calibrated points; calibrated points in one place or on
    /// one line.
    pub fn new(
        rest: Vec<Point<f64>>,
        calibrated: Vec<usize>,
        options: PoseOptions,
    ) -> Result<Self, CaptureError> {
        let points = rest.len();
        if let Some(point) = rest.iter().position(|&x| !Vector::from(x).is_finite()) {
            return Err(CaptureError::RestNotFinite { point });
        }
        for (place, &point) in calibrated.iter().enumerate() {
            if point >= points {
                return Err(CaptureError::NoPoint { point, points });
            }
            if calibrated[..place].contains(&point) {
                return Err(CaptureError::Twice(point));
            }
        }
        let chosen: Vec<_> = calibrated.iter().map(|&point| rest[point]).collect();
        check(&chosen).map_err(|error| CaptureError::Rest(Box::new(error)))?;
        Ok(Self {
            rest,
            calibrated,
            options,
        })
    }

    /// The points at rest.
    #[must_use]
    pub fn rest(&self) -> &[Point<f64>] {
        &self.rest
    }

    /// The calibrated points.
    #[must_use]
    pub fn calibrated(&self) -> &[usize] {
        &self.calibrated
    }

    /// Separates a frame into pose and expression. Points that were not seen are `None`.
    ///
    /// # Errors
    /// [`CaptureError`]: another number of points than at rest, points that are not finite, fewer
    /// than three calibrated points seen, calibrated points that determine no pose.
    pub fn frame(&self, seen: &[Option<Point<f64>>]) -> Result<CapturedFrame, CaptureError> {
        let (expected, found) = (self.rest.len(), seen.len());
        if expected != found {
            return Err(CaptureError::FrameCounts { expected, found });
        }
        let is_wrong = |point: &Option<Point<f64>>| {
            point.is_some_and(|point| !Vector::from(point).is_finite())
        };
        if let Some(point) = seen.iter().position(is_wrong) {
            return Err(CaptureError::PointNotFinite { point });
        }
        let pose = self.pose(seen)?;
        let back = pose.motor.reverse();
        let still: Vec<_> = seen
            .iter()
            .map(|point| point.map(|point| back.transform(point)))
            .collect();
        let moved = |(&rest, still): (&Point<f64>, &Option<Point<f64>>)| {
            still.map(|still| rest.vector_to(still))
        };
        Ok(CapturedFrame {
            expression: self.rest.iter().zip(&still).map(moved).collect(),
            pose,
            still,
        })
    }

    /// Separates all frames of a sequence. A frame that does not show where the head is says why,
    /// and does not fail the others.
    ///
    /// # Errors
    /// [`CaptureError::Frame`] for the first frame that is not valid: with another number of points
    /// than at rest, or points that are not finite. [`CaptureError::Threshold`].
    /// [`CaptureError::NoPose`] where there are frames, and none shows where the head is.
    pub fn frames<F: AsRef<[Option<Point<f64>>]> + Sync>(
        &self,
        frames: &[F],
    ) -> Result<Vec<FrameOutcome>, CaptureError> {
        let found: Vec<_> = frames
            .par_iter()
            .map(|frame| self.frame(frame.as_ref()))
            .collect();
        for (frame, outcome) in found.iter().enumerate() {
            match outcome {
                Err(error @ CaptureError::Threshold(_)) => return Err(error.clone()),
                Err(
                    problem @ (CaptureError::FrameCounts { .. }
                    | CaptureError::PointNotFinite { .. }),
                ) => {
                    let problem = Box::new(problem.clone());
                    return Err(CaptureError::Frame { frame, problem });
                }
                _ => {}
            }
        }
        match found.first() {
            Some(Err(problem)) if found.iter().all(Result::is_err) => Err(CaptureError::NoPose {
                problem: Box::new(problem.clone()),
            }),
            _ => Ok(found),
        }
    }

    fn pose(&self, seen: &[Option<Point<f64>>]) -> Result<RigidPose, CaptureError> {
        let visible = |point: &usize| seen[*point].map(|place| (*point, place));
        let places: Vec<_> = self.calibrated.iter().filter_map(visible).collect();
        let missing = || -> Vec<usize> {
            let all = self.calibrated.iter().copied();
            all.filter(|&point| seen[point].is_none()).collect()
        };
        if places.len() < NEEDED {
            return Err(CaptureError::Missing {
                seen: places.len(),
                needed: NEEDED,
                missing: missing(),
            });
        }
        let [rest, there]: [Vec<_>; 2] = [
            places.iter().map(|&(point, _)| self.rest[point]).collect(),
            places.iter().map(|&(_, place)| place).collect(),
        ];
        let pose = rigid_pose(&rest, &there, &self.options);
        let mut pose = pose.map_err(|error| match missing() {
            missing if missing.is_empty() => error,
            missing => CaptureError::PoseOfSeen {
                missing,
                error: Box::new(error),
            },
        })?;
        for inlier in &mut pose.inliers {
            *inlier = places[*inlier].0;
        }
        pose.inliers.sort_unstable();
        Ok(pose)
    }
}

impl CapturedFrame {
    /// The motor that takes the head at rest to where it is.
    #[must_use]
    pub fn motor(&self) -> Motor<f64> {
        self.pose.motor
    }

    /// The capture matrix of the frame.
    ///
    /// ```
    /// use ga_runtime::cga3::{Motor, Point, Translator};
    /// use ga_vision::capture::{Capture, PoseOptions};
    /// let rest = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    /// let rest = rest.map(Point::from).to_vec();
    /// let seen: Vec<_> = rest.iter().map(|&p| Some(p)).collect();
    /// let capture = Capture::new(rest, vec![0, 1, 2, 3], PoseOptions::default())?;
    /// let matrix = capture.frame(&seen)?.matrix();
    /// assert_eq!(matrix.rows()[3], [1.0; 4]);
    /// assert_eq!(matrix.points, [0, 1, 2, 3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn matrix(&self) -> CaptureMatrix {
        let seen = self.still.iter().enumerate();
        let seen = seen.filter_map(|(point, place)| place.map(|place| (point, place)));
        let column = |(point, place): (usize, Point<f64>)| {
            let [x, y, z] = place.coordinates();
            (point, [x, y, z, 1.0])
        };
        let (points, columns) = seen.map(column).unzip();
        CaptureMatrix { points, columns }
    }
}

impl CaptureMatrix {
    /// The four rows: all x, all y, all z, all ones.
    #[must_use]
    pub fn rows(&self) -> [Vec<f64>; 4] {
        std::array::from_fn(|row| self.columns.iter().map(|column| column[row]).collect())
    }
}
