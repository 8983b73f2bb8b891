//! Which lengths of the character become those of the person.

use clap::ValueEnum;
use ga_body::Lengths;

/// The lengths that are fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FitLengths {
    /// A factor for each bone.
    Bones,
    /// One factor for the whole body.
    Size,
    /// None: the character keeps its own.
    None,
}

impl From<FitLengths> for Option<Lengths> {
    fn from(lengths: FitLengths) -> Self {
        match lengths {
            FitLengths::Bones => Some(Lengths::EachBone),
            FitLengths::Size => Some(Lengths::OneFactor),
            FitLengths::None => None,
        }
    }
}
