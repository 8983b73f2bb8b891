//! The frames of an animation.

use crate::Polyline;

/// A mesh at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The frame's number, for the caption.
    pub number: usize,
    /// The frame's time in seconds, for the caption.
    pub time: f64,
    /// Whether it was given or computed.
    pub kind: Kind,
    /// The places of the vertices.
    pub positions: &'a [[f64; 3]],
    /// Segments to draw over the picture, none or the bones of a skeleton.
    pub bones: &'a [[[f64; 3]; 2]],
    /// Lines of the world to draw over the picture, such as the paths of joints. They have no
    /// influence on the camera.
    pub lines: &'a [Polyline<'a>],
}

impl<'a> Frame<'a> {
    /// A key frame at the time 0, without bones and lines.
    #[must_use]
    pub fn new(number: usize, positions: &'a [[f64; 3]]) -> Self {
        Self {
            number,
            time: 0.0,
            kind: Kind::Key,
            positions,
            bones: &[],
            lines: &[],
        }
    }
}

/// The role of a frame in an animation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Given.
    Key,
    /// Computed: `step` of `steps` equal steps of time after a key frame, the next key frame being
    /// at `steps`.
    InBetween {
        /// From 1 to `steps − 1`.
        step: usize,
        /// How many steps there are from key to key: one more than there are frames between.
        steps: usize,
    },
}
