//! Why points of a head do not determine its pose or its expression.

use ga_runtime::geometry::motion::FitError;

/// The least number of calibrated points.
pub(super) const NEEDED: usize = 4;

/// Why two sets of points do not determine a rigid motion.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PoseError {
    /// There are not as many points as at rest.
    #[error("{rest} points at rest, but {seen} points seen")]
    Counts {
        /// How many there are at rest.
        rest: usize,
        /// How many were seen.
        seen: usize,
    },
    /// There are too few points.
    #[error("{needed} calibrated points are needed for a pose, not {found}")]
    TooFew {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A coordinate is not finite.
    #[error("calibrated point {point} is not finite")]
    NotFinite {
        /// Which point, from 0.
        point: usize,
    },
    /// All points coincide.
    #[error("all calibrated points {place} are in one place, which does not show a rotation")]
    Coincident {
        /// Which set of points it is.
        place: PointSet,
    },
    /// All points are on one line. Points in one plane do determine a pose.
    #[error(
        "all calibrated points {place} are on one line, about which a rotation cannot be seen \
         (points in one plane are enough)"
    )]
    Collinear {
        /// Which set of points it is.
        place: PointSet,
    },
    /// Several rotations fit equally well.
    #[error("several rotations fit the calibrated points equally well")]
    NotUnique,
    /// Too few points agree with any one motion.
    #[error(
        "no more than {agreeing} of {points} calibrated points agree with one pose, and {needed} \
         are needed"
    )]
    NoConsensus {
        /// How many agree with the best motion.
        agreeing: usize,
        /// How many points there are.
        points: usize,
        /// How many must agree.
        needed: usize,
    },
    /// The threshold is not positive and finite.
    #[error("{0} is not a distance within which points agree")]
    Threshold(f64),
    /// The motion is beyond the range of the numbers.
    #[error("the pose is beyond the range of double precision")]
    OutOfRange,
}

/// One of the two sets of points that a pose relates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointSet {
    /// The points at rest.
    Rest,
    /// The points of a frame.
    Seen,
}

impl std::fmt::Display for PointSet {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Rest => "at rest",
            Self::Seen => "of the frame",
        })
    }
}

impl PoseError {
    /// What a failed fit means, where the points at rest determine a motion or do not.
    pub(super) fn from_fit(error: FitError<f64>, place: PointSet) -> Self {
        match error {
            FitError::TooFewPairs { found, .. } => Self::TooFew {
                found,
                needed: NEEDED,
            },
            FitError::NotFinite { index } => Self::NotFinite { point: index },
            FitError::Coincident => Self::Coincident { place },
            FitError::Collinear => Self::Collinear { place },
            FitError::NotUnique => Self::NotUnique,
            _ => Self::OutOfRange,
        }
    }
}

/// Why a head cannot be captured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CaptureError {
    /// A calibrated point does not exist.
    #[error("calibrated point {point} does not exist; there are {points}, which count from 0")]
    NoPoint {
        /// The point.
        point: usize,
        /// How many points there are.
        points: usize,
    },
    /// A calibrated point is named twice.
    #[error("calibrated point {0} is named twice")]
    Twice(usize),
    /// A point at rest is not finite.
    #[error("point {point} at rest is not finite")]
    RestNotFinite {
        /// The point.
        point: usize,
    },
    /// The calibrated points at rest do not determine a pose.
    #[error(transparent)]
    Rest(PoseError),
    /// A frame is not valid.
    #[error("frame {frame}: {problem}")]
    Frame {
        /// Which frame, from 0.
        frame: usize,
        /// What is wrong with it.
        problem: FrameError,
    },
}

/// Why the points of a frame do not determine pose and expression.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FrameError {
    /// There are not as many points as at rest.
    #[error("{found} points, but there are {expected} at rest")]
    Counts {
        /// How many there are at rest.
        expected: usize,
        /// How many the frame has.
        found: usize,
    },
    /// A point is not finite.
    #[error("point {point} is not finite")]
    NotFinite {
        /// The point.
        point: usize,
    },
    /// Too few calibrated points were seen.
    #[error(
        "{seen} calibrated points are seen, and {needed} are needed; missing: {}",
        list(missing)
    )]
    Missing {
        /// How many calibrated points were seen.
        seen: usize,
        /// How many are needed.
        needed: usize,
        /// The calibrated points that were not seen.
        missing: Vec<usize>,
    },
    /// The calibrated points do not determine a pose.
    #[error(transparent)]
    Pose(#[from] PoseError),
    /// Those calibrated points that were seen do not determine a pose.
    #[error("{error}; missing: {}", list(missing))]
    PoseOfSeen {
        /// The calibrated points that were not seen.
        missing: Vec<usize>,
        /// Why the others do not determine a pose.
        error: PoseError,
    },
}

fn list(points: &[usize]) -> String {
    let names: Vec<_> = points
        .iter()
        .map(|point| format!("point {point}"))
        .collect();
    names.join(", ")
}
