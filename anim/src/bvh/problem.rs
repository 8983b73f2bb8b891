//! What can be wrong with a line of a BVH file.

/// What can be wrong with a BVH file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BvhProblem {
    /// The line is not UTF-8, or holds a null byte.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// Another word should stand here.
    #[error("expected {expected}, found {found:?}")]
    Expected {
        /// What should stand here.
        expected: &'static str,
        /// What does.
        found: String,
    },
    /// The file ends too early.
    #[error("the file ends; expected {expected}")]
    EndOfFile {
        /// What should follow.
        expected: &'static str,
    },
    /// A word is in the place of a number.
    #[error("{word:?} is not a number")]
    NotANumber {
        /// The word.
        word: String,
    },
    /// A number is infinite, not a number, or too large.
    #[error("{word:?} is not a finite number")]
    NotFinite {
        /// The word.
        word: String,
    },
    /// A frame time is 0 or negative.
    #[error("the frame time must be greater than 0 seconds, but is {0}")]
    FrameTime(f64),
    /// A word is in the place of a channel; perhaps fewer channels follow than the line announces.
    #[error("{word:?} is not a channel")]
    UnknownChannel {
        /// The word.
        word: String,
    },
    /// A joint has one channel twice.
    #[error("joint {joint:?} has channel {word} twice")]
    DuplicateChannel {
        /// The joint.
        joint: String,
        /// The channel.
        word: String,
    },
    /// Two joints have the same name.
    #[error("two joints are called {name:?}")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// An element that a joint must have once is missing or there twice.
    #[error("joint {joint:?} has {found} {what} lines instead of one")]
    NotOnce {
        /// The joint.
        joint: String,
        /// `"OFFSET"`, `"CHANNELS"` or `"End Site"`.
        what: &'static str,
        /// How many it has.
        found: usize,
    },
    /// No joint has a channel.
    #[error("no joint has a channel")]
    NoChannels,
    /// The numbers of a frame are not as many as the channels.
    #[error("a frame has {expected} numbers, but this one has {found}")]
    FrameLength {
        /// How many channels there are.
        expected: usize,
        /// How many numbers the frame has.
        found: usize,
    },
    /// The number of frames differs from the one announced by more than one, or none is there.
    #[error("the file announces {expected} frames and has {found}")]
    FrameCount {
        /// How many frames are announced.
        expected: usize,
        /// How many there are, or two more than announced.
        found: usize,
    },
}
