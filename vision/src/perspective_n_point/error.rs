//! Why known points do not determine a pose.

use ga_camera::CameraError;

/// Why known points and their pixels do not determine where a camera is.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PerspectiveError {
    /// There are not as many pixels as points.
    #[error("{points} points have {pixels} pixels")]
    Counts {
        /// How many points there are.
        points: usize,
        /// How many pixels there are.
        pixels: usize,
    },
    /// There are too few points.
    #[error("{needed} points are needed, not {found}")]
    TooFew {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A point is not finite.
    #[error("point {0} is not finite")]
    NotFinite(usize),
    /// A pixel gives no ray.
    #[error("the pixel of point {point}: {error}")]
    Camera {
        /// Which point, from 0.
        point: usize,
        /// What is wrong with its pixel.
        error: CameraError,
    },
    /// The threshold is not positive and finite.
    #[error("{0} pixels is not a distance within which points agree")]
    Threshold(f64),
    /// All points are on one line or in one place.
    #[error("all points are on one line within {distance} units of length")]
    Collinear {
        /// The root mean square of their distances from the line.
        distance: f64,
    },
    /// Too few points agree with any one pose.
    #[error("of {points} points no more than {agreeing} agree with one pose")]
    NoConsensus {
        /// How many agree with the best pose.
        agreeing: usize,
        /// How many there are.
        points: usize,
    },
    /// No pose was found from which the camera sees the points in front of it.
    #[error("no pose of the camera explains the pixels")]
    Undetermined,
}
