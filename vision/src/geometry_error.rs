//! What can be wrong with the geometry of views.

use ga_camera::CameraError;

use crate::relative_pose::view::View;

/// Why it cannot be found how cameras stand to each other or to known points, or why their views
/// cannot be rectified. Points, pairs and views are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ViewGeometryError {
    /// There are too few pairs.
    #[error("{needed} pairs of pixels are needed, not {found}")]
    TooFew {
        /// How many there are.
        found: usize,
        /// How many the model needs.
        needed: usize,
    },
    /// There are more or fewer pairs of directions than pairs of pixels.
    #[error("{pixels} pairs of pixels cannot have {directions} pairs of directions")]
    Counts {
        /// Pairs of pixels.
        pixels: usize,
        /// Pairs of directions.
        directions: usize,
    },
    /// A pixel is not finite.
    #[error("the {view} pixel of pair {pair} is not finite")]
    NotFinite {
        /// Which pair, from 0.
        pair: usize,
        /// Which pixel of it.
        view: View,
    },
    /// A pixel gives no ray.
    #[error("the {view} pixel of pair {pair}: {error}")]
    Camera {
        /// Which pair, from 0.
        pair: usize,
        /// Which pixel of it.
        view: View,
        /// What is wrong with it.
        error: CameraError,
    },
    /// The pixels of a view are on one line or in one place.
    #[error("all pixels of the {view} view are on one line within {distance} px")]
    Collinear {
        /// Which view.
        view: View,
        /// The root mean square of their distances from the line, in pixels.
        distance: f64,
    },
    /// The pixels of a view are too near one place for their noise.
    #[error(
        "all pixels of the {view} view are within {distance} px of one place, which is too near"
    )]
    OnePlace {
        /// Which view.
        view: View,
        /// The root mean square of their distances from the place, in pixels.
        distance: f64,
    },
    /// The pairs determine a motion so badly that it is not worth its name.
    #[error(
        "the pairs of pixels determine the motion no better than to {degrees:.0}°: they are too near \
         each other or too noisy, or the baseline is too short"
    )]
    Uncertain {
        /// The standard deviation of the rotation or the direction, whichever is greater.
        degrees: f64,
    },
    /// A rotation alone explains the pairs: the cameras are in one place, or all points are so far
    /// away that the baseline does not show.
    #[error(
        "a rotation alone explains the pairs to {rotation_rms:.3e} px, a rotation and a translation to \
         {motion_rms:.3e} px: the baseline is zero, or too short for this scene"
    )]
    PureRotation {
        /// The root mean square of what a rotation leaves, in pixels.
        rotation_rms: f64,
        /// The root mean square of the Sampson distances with a translation, in pixels.
        motion_rms: f64,
    },
    /// Too few pairs agree with any one motion.
    #[error("of {pairs} pairs of pixels no more than {agreeing} agree with one motion")]
    NoConsensus {
        /// How many agree with the best motion.
        agreeing: usize,
        /// How many there are.
        pairs: usize,
    },
    /// The equations have no unique solution.
    #[error("the pairs of pixels do not determine a unique solution")]
    Undetermined,
    /// No motion that explains the pairs has the points in front of both cameras.
    #[error("of {pairs} points only {in_front} are in front of both cameras")]
    Behind {
        /// How many are in front of both for the best motion.
        in_front: usize,
        /// How many points agree.
        pairs: usize,
    },
    /// There are not as many pixels as points.
    #[error("{points} points have {pixels} pixels")]
    PointCounts {
        /// How many points there are.
        points: usize,
        /// How many pixels there are.
        pixels: usize,
    },
    /// There are too few points.
    #[error("{needed} points are needed, not {found}")]
    TooFewPoints {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A point is not finite.
    #[error("point {0} is not finite")]
    PointNotFinite(usize),
    /// A pixel gives no ray.
    #[error("the pixel of point {point}: {error}")]
    PointCamera {
        /// Which point, from 0.
        point: usize,
        /// What is wrong with its pixel.
        error: CameraError,
    },
    /// The threshold is not positive and finite.
    #[error("{0} pixels is not a distance within which points agree")]
    PointThreshold(f64),
    /// All points are on one line or in one place.
    #[error("all points are on one line within {distance} units of length")]
    PointsCollinear {
        /// The root mean square of their distances from the line.
        distance: f64,
    },
    /// Too few points agree with any one pose.
    #[error("of {points} points no more than {agreeing} agree with one pose")]
    NoPointConsensus {
        /// How many agree with the best pose.
        agreeing: usize,
        /// How many there are.
        points: usize,
    },
    /// No pose was found from which the camera sees the points in front of it.
    #[error("no pose of the camera explains the pixels")]
    PoseUndetermined,
    /// There are too few pairs of points.
    #[error("{found} pairs of points are given, and at least {needed} are needed")]
    TooFewMatches {
        /// How many there are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("pair {0}: a coordinate is not finite")]
    MatchNotFinite(usize),
    /// The threshold is not positive and finite.
    #[error("the threshold is {0} px, which is not positive and finite")]
    MatchThreshold(f64),
    /// The points of the right view lie on one line, so that rotation and zoom are not determined.
    #[error("the points in the right view lie on one line")]
    OnOneLine,
    /// Too few pairs agree on a model: the views do not show one scene, or are far from rectified.
    #[error(
        "only {agreeing} of {pairs} pairs of points agree: these are not two views of one scene, \
         or they are far from rectified"
    )]
    NoMatchConsensus {
        /// How many agree with the best model.
        agreeing: usize,
        /// How many there are.
        pairs: usize,
    },
    /// The cameras are at the same place, or a number is not finite.
    #[error("the distance between the cameras is {0} m, so there is no disparity")]
    Baseline(f64),
    /// The second camera is before or behind the first, within 10° of its axis.
    #[error("the second camera is at {0:?} m from the first: before or behind it, not beside it")]
    Forward([f64; 3]),
    /// The second camera is to the left of the first.
    #[error(
        "the second camera is at {0:?} m, left of the first: the views are exchanged; put the \
         second view and its camera first"
    )]
    Exchanged([f64; 3]),
    /// There is no picture, or the rectified ones would have more than 2²⁸ pixels.
    #[error("pictures of {} × {} pixels cannot be rectified", .0[0], .0[1])]
    Size([usize; 2]),
    /// `alpha` is not in [0, 1].
    #[error("alpha is {0}, not from 0 to 1")]
    Alpha(f64),
    /// A camera does not see what is in front of it after the rotation.
    #[error("the new axis is outside the field of a camera: the cameras look too far apart")]
    Axis,
    /// There is no rectangle that both cameras see.
    #[error("the rectified pictures would show nothing: the views do not overlap")]
    Empty,
    /// A pixel has no place in the other picture.
    #[error(transparent)]
    Unseen(CameraError),
    /// There is no picture.
    #[error("pictures of {0:?} pixels cannot be undistorted")]
    UndistortionSize([usize; 2]),
    /// The camera sees no rectangle.
    #[error("the camera sees no rectangle around its axis")]
    NoRectangle,
}
