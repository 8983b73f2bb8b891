//! `nullcone quality`: measures of pictures and videos, and people's judgement of them.

pub(crate) mod compare;
mod fit;
mod ratings;

use crate::frame::group;

group! {
    /// The quality of pictures and videos, and people's judgement of it.
    Compare: compare::Arguments,
    Fit: fit::Arguments,
    Ratings: ratings::Arguments,
}
