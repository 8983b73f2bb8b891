//! Whether the numbers of two videos mean the same.

use std::fmt::{Display, Formatter, Result as Formatted};

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

use crate::{Properties, VideoError};

/// Something that two videos state differently.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PropertyDifference {
    /// The property.
    pub what: &'static str,
    /// That of the reference.
    pub reference: String,
    /// That of the other video.
    pub distorted: String,
}

/// The same as it is read.
#[derive(Deserialize)]
struct Stated {
    what: String,
    reference: String,
    distorted: String,
}

impl<'de> Deserialize<'de> for PropertyDifference {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Stated {
            what,
            reference,
            distorted,
        } = Stated::deserialize(deserializer)?;
        let known = [FRAME_RATE, FRAME_COUNT, LUMA, PIXELS];
        let found = known.into_iter().find(|known| *known == what);
        let wrong = || D::Error::custom(format!("{what:?} is not a property of videos"));
        Ok(Self {
            what: found.ok_or_else(wrong)?,
            reference,
            distorted,
        })
    }
}

impl Display for PropertyDifference {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Formatted {
        let Self {
            what,
            reference,
            distorted,
        } = self;
        write!(
            formatter,
            "the videos differ in {what}: {reference} and {distorted}"
        )
    }
}

impl PropertyDifference {
    /// Where the texts differ.
    fn of(what: &'static str, [reference, distorted]: [String; 2]) -> Option<Self> {
        (reference != distorted).then_some(Self {
            what,
            reference,
            distorted,
        })
    }
}

/// The name of the number of frames in a second.
pub const FRAME_RATE: &str = "frames in a second";

/// The name of the number of frames.
pub const FRAME_COUNT: &str = "number of frames";

const LUMA: &str = "weights of luma";
const PIXELS: &str = "shape of pixels";

/// Whether the samples of two videos can be compared.
pub(super) fn comparable(first: &Properties, second: &Properties) -> Result<(), VideoError> {
    let both = [first, second];
    let found = [
        PropertyDifference::of(
            "size",
            both.map(|p| format!("{} × {} pixels", p.size[0], p.size[1])),
        ),
        PropertyDifference::of("depth", both.map(|p| format!("{} bits", p.bit_depth))),
        PropertyDifference::of("sampling", both.map(|p| format!("{:?}", p.sampling))),
        PropertyDifference::of(
            "range",
            both.map(|p| format!("{:?}", p.colours.range).to_lowercase()),
        ),
    ];
    match found.into_iter().flatten().next() {
        None => Ok(()),
        Some(PropertyDifference {
            what,
            reference,
            distorted,
        }) => Err(VideoError::Properties {
            what,
            reference,
            distorted,
        }),
    }
}

/// What else they state differently.
pub(super) fn property_differences(
    first: &Properties,
    second: &Properties,
) -> Vec<PropertyDifference> {
    let both = [first, second];
    let rates = [first.frames_per_second, second.frames_per_second];
    let rates = match rates {
        [Some(a), Some(b)]
            if u64::from(a[0]) * u64::from(b[1]) != u64::from(b[0]) * u64::from(a[1]) =>
        {
            let rates = [a, b].map(|[count, seconds]| format!("{count}/{seconds}"));
            PropertyDifference::of(FRAME_RATE, rates)
        }
        _ => None,
    };
    let others = [
        PropertyDifference::of(
            LUMA,
            both.map(|p| format!("{:?}", p.colours.luma).to_uppercase()),
        ),
        PropertyDifference::of(
            PIXELS,
            both.map(|p| format!("{}:{}", p.pixel_aspect[0], p.pixel_aspect[1])),
        ),
        rates,
    ];
    others.into_iter().flatten().collect()
}
