//! The frames of an animation.

/// What a sheet says below the picture of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Caption {
    /// The frame's number.
    pub number: usize,
    /// The frame's time in seconds.
    pub time: f64,
    /// Whether it was given or computed.
    pub kind: Kind,
}

/// A figure at one moment: what is to be seen whole.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// What is said of it.
    pub caption: Caption,
    /// The places of the figure's vertices.
    pub positions: &'a [[f64; 3]],
    /// Segments drawn over the picture, none or the bones of a skeleton.
    pub bones: &'a [[[f64; 3]; 2]],
}

impl Caption {
    /// Of a key frame at the time 0.
    #[must_use]
    pub fn new(number: usize) -> Self {
        Self {
            number,
            time: 0.0,
            kind: Kind::Key,
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
