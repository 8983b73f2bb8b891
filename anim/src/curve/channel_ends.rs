//! The conditions at the ends of the splines of several channels.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

use super::ends::{EndKind, Ends};

/// The conditions at the ends of the splines of all channels of a table, as they are written in
/// words: `natural`, `clamped`, `slopes:A,B`, `not-a-knot` or `periodic`. They are shown without
/// their numbers.
///
/// ```
/// use ga_anim::curve::{ChannelEnds, Ends};
///
/// let ends: ChannelEnds = "slopes:1,2,-3,-4".parse()?;
/// assert_eq!(ends.of_channel(1, 2), Some(Ends::Slopes([2.0, -4.0])));
/// // For two channels, not for three.
/// assert_eq!(ends.of_channel(1, 3), None);
/// assert_eq!(ends.to_string(), "slopes");
/// # Ok::<(), ga_anim::curve::ChannelEndsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum ChannelEnds {
    /// [`Ends::Natural`] in every channel.
    Natural,
    /// [`Ends::clamped`] in every channel.
    Clamped,
    /// [`Ends::Slopes`]: the slopes at the start and at the end, for all channels, or all slopes at
    /// the start and then all at the end.
    Slopes(Vec<f64>),
    /// [`Ends::NotAKnot`] in every channel.
    NotAKnot,
    /// [`Ends::Periodic`] in every channel.
    Periodic,
}

/// A text that is not a condition at the ends.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ChannelEndsError {
    /// It is none of the words.
    #[error("expected natural, clamped, slopes:A,B, not-a-knot or periodic")]
    Unknown,
    /// A slope is not a finite number.
    #[error("{0:?} is not a slope")]
    Slope(String),
    /// There is an odd number of slopes.
    #[error("{0} slopes, but each channel has two")]
    Odd(usize),
}

impl ChannelEnds {
    /// The kind of the conditions, which is the same in every channel.
    #[must_use]
    pub fn kind(&self) -> EndKind {
        match self {
            Self::Natural => EndKind::Natural,
            Self::Clamped | Self::Slopes(_) => EndKind::Slopes,
            Self::NotAKnot => EndKind::NotAKnot,
            Self::Periodic => EndKind::Periodic,
        }
    }

    /// The conditions of one of `count` channels; `None` where there is another number of slopes.
    #[must_use]
    pub fn of_channel(&self, channel: usize, count: usize) -> Option<Ends<f64>> {
        match self {
            Self::Natural => Some(Ends::Natural),
            Self::Clamped => Some(Ends::clamped()),
            Self::NotAKnot => Some(Ends::NotAKnot),
            Self::Periodic => Some(Ends::Periodic),
            Self::Slopes(slopes) => match slopes[..] {
                [start, end] => Some(Ends::Slopes([start, end])),
                _ if slopes.len() != 2 * count || channel >= count => None,
                _ => Some(Ends::Slopes([slopes[channel], slopes[count + channel]])),
            },
        }
    }
}

impl FromStr for ChannelEnds {
    type Err = ChannelEndsError;

    fn from_str(text: &str) -> Result<Self, ChannelEndsError> {
        match text {
            "natural" => return Ok(Self::Natural),
            "clamped" => return Ok(Self::Clamped),
            "not-a-knot" => return Ok(Self::NotAKnot),
            "periodic" => return Ok(Self::Periodic),
            _ => {}
        }
        let list = text.strip_prefix("slopes:");
        let list = list.ok_or(ChannelEndsError::Unknown)?;
        let slope = |word: &str| match word.trim().parse::<f64>() {
            Ok(slope) if slope.is_finite() => Ok(slope),
            _ => Err(ChannelEndsError::Slope(word.to_owned())),
        };
        let slopes: Vec<f64> = list.split(',').map(slope).collect::<Result<_, _>>()?;
        match slopes.len() {
            count if count.is_multiple_of(2) => Ok(Self::Slopes(slopes)),
            count => Err(ChannelEndsError::Odd(count)),
        }
    }
}

impl Display for ChannelEnds {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Natural => "natural",
            Self::Clamped => "clamped",
            Self::Slopes(_) => "slopes",
            Self::NotAKnot => "not-a-knot",
            Self::Periodic => "periodic",
        })
    }
}
