//! Why a marked body cannot be fitted.

use crate::BodyError;

/// Why no pose can be fitted to coloured dots.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MarkedError {
    /// There are other numbers of points and of marks.
    #[error("{found} marks for the {expected} points of the body")]
    Marks {
        /// How many points the model has.
        expected: usize,
        /// How many marks are given.
        found: usize,
    },
    /// A normal has no direction.
    #[error("the normal {normal:?} of the point {point:?} is not a direction")]
    Normal {
        /// The name of the point.
        point: String,
        /// Its normal.
        normal: [f64; 3],
    },
    /// There are other numbers of cameras and of pictures.
    #[error("dots of {found} pictures are given for {expected} cameras")]
    Views {
        /// How many cameras there are.
        expected: usize,
        /// How many pictures have dots.
        found: usize,
    },
    /// A picture has no dots.
    #[error("no marker was found in view {view}")]
    NoDots {
        /// Which view, from 0.
        view: usize,
    },
    /// A dot is not at finite pixels.
    #[error("view {view}: the dot at {centre:?} is not finite")]
    NotFinite {
        /// Which view, from 0.
        view: usize,
        /// Its centre.
        centre: [f64; 2],
    },
    /// Too few dots are seen by two views or more: no part of the body can be recognised.
    #[error(
        "no part of the body is recognised by its markers: of {joint:?}, most likely, {found} are \
         seen by two views in their places, and {needed} are needed"
    )]
    TooFewMarkers {
        /// The joint of which most are seen.
        joint: String,
        /// How many they are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// The pose cannot be fitted to the dots that were recognised.
    #[error(transparent)]
    Body(#[from] BodyError),
}
