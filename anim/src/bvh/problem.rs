//! What can be wrong with a line of a BVH file.

use std::borrow::Cow;

use ga_files::Tolerated;
use ga_files::text::Encoding;

/// What can be wrong with a BVH file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BvhProblem {
    /// The line is not UTF-8, or holds a null byte.
    #[error("the file is not UTF-8 text")]
    NotText,
    /// The file is in another encoding.
    #[error("the file is not UTF-8 text")]
    NotUtf8 {
        /// As which it is read, unless it is read strictly.
        encoding: Encoding,
    },
    /// A line ends in a carriage return alone.
    #[error("the line ends in a carriage return alone")]
    CarriageReturns,
    /// An End Site has a name.
    #[error("expected {{, found {name:?}")]
    EndSiteName {
        /// The name.
        name: String,
    },
    /// Text stands where the format has none.
    #[error("expected the end of the line, found {word:?}")]
    ExtraText {
        /// Its first word.
        word: String,
    },
    /// A joint announces another number of channels than it lists.
    #[error("joint {joint:?} announces {announced} channels and lists {found}")]
    ChannelCount {
        /// The joint.
        joint: String,
        /// How many are announced.
        announced: usize,
        /// How many are listed.
        found: usize,
    },
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
        /// What the second one is called, unless the file is read strictly.
        instead: String,
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
    /// No frame is there although some are announced; for a strict reading also a number of frames
    /// that differs from the one announced by more than one.
    #[error("the file announces {expected} frames and has {found}")]
    FrameCount {
        /// How many frames are announced.
        expected: usize,
        /// How many there are.
        found: usize,
    },
}

impl Tolerated for BvhProblem {
    fn kind(&self) -> &'static str {
        match self {
            Self::NotText | Self::NotUtf8 { .. } => "encoding",
            Self::CarriageReturns => "line_ends",
            Self::EndSiteName { .. } => "end_site_name",
            Self::ExtraText { .. } => "extra_text",
            Self::ChannelCount { .. } => "channel_count",
            Self::Expected { .. } => "missing_blank",
            Self::DuplicateName { .. } => "duplicate_name",
            Self::NotOnce { .. } => "no_channels",
            Self::FrameLength { .. } => "wrapped_frames",
            Self::FrameCount { .. } => "frame_count",
            Self::EndOfFile { .. }
            | Self::NotANumber { .. }
            | Self::NotFinite { .. }
            | Self::FrameTime(_)
            | Self::UnknownChannel { .. }
            | Self::DuplicateChannel { .. }
            | Self::NoChannels => "error",
        }
    }

    fn remedy(&self) -> Cow<'_, str> {
        match self {
            Self::NotUtf8 { encoding } => return format!("it is read as {encoding}").into(),
            Self::CarriageReturns => "the next line begins behind it",
            Self::EndSiteName { .. } => "the name is ignored",
            Self::ChannelCount { .. } => "the channels that are listed count",
            Self::Expected { .. } => "the line is read as if it were there",
            Self::DuplicateName { instead, .. } => {
                return format!("the later one is read as {instead:?}").into();
            }
            Self::NotOnce { .. } => "the joint does not move",
            Self::FrameLength { .. } => "frames are read across lines",
            _ => "it is left out",
        }
        .into()
    }

    fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::DuplicateName { name, .. }, Self::DuplicateName { name: other, .. }) => {
                name == other
            }
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }
}
