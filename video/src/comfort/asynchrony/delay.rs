//! The delay of an eye.

/// The delay of the right eye at a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Asynchrony {
    /// It is known.
    Measured(Delay),
    /// The pictures hardly change, or in a few frames only.
    NoMotion,
    /// The changes of one eye do not explain those of the other.
    Unrelated,
    /// Several delays explain them nearly equally well, as in repeated or constant motion.
    Ambiguous,
}

/// A measured delay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delay {
    /// How many frames the right eye is late; negative when the left one is late.
    pub frames: f64,
    /// The standard error, without that of the interpolation between frames.
    pub uncertainty_frames: f64,
}

impl Asynchrony {
    /// The delay, where it is known.
    #[must_use]
    pub fn delay(&self) -> Option<Delay> {
        match self {
            Self::Measured(delay) => Some(*delay),
            Self::NoMotion | Self::Unrelated | Self::Ambiguous => None,
        }
    }
}
