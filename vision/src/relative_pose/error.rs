//! Why pairs of pixels do not determine a motion.

use ga_camera::CameraError;

/// One of two views.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// The first view.
    Left,
    /// The second view.
    Right,
}

impl std::fmt::Display for View {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
        })
    }
}

/// Why pairs of pixels do not determine how two views are related.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RelativePoseError {
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
}
