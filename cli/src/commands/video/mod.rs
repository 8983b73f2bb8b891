//! `nullcone video`: the shots and key frames of videos, and the comfort of stereoscopic ones.

pub(crate) mod comfort;
pub(crate) mod keyframes;
mod score;
mod shots;
mod statistics;

use crate::frame::group;

group! {
    /// Videos: cuts, shots, key frames, how well cuts are found, and the comfort of two views.
    Align: comfort::align::Arguments,
    Comfort: comfort::Arguments,
    Keyframes: keyframes::Arguments,
    Score: score::Arguments,
    Statistics: statistics::Arguments,
}
