//! What a tag in a picture is.

use super::dictionary::Dictionary;
use super::edge::lengths;

/// A tag in a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Tag {
    /// Its number in the dictionary.
    pub id: usize,
    /// The corners of its black border in pixels, clockwise from the top left one of the upright
    /// tag.
    pub corners: [[f64; 2]; 4],
    /// How many modules are wrong.
    pub hamming: u32,
}

impl Tag {
    /// The mean of its corners.
    pub(super) fn centre(&self) -> [f64; 2] {
        [0, 1].map(|k| self.corners.iter().map(|corner| corner[k]).sum::<f64>() / 4.0)
    }

    /// The longest of its edges, in pixels.
    pub(super) fn longest_edge(&self) -> f64 {
        lengths(&self.corners).into_iter().fold(0.0, f64::max)
    }
}

/// How tags are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TagOptions {
    /// The tags that are looked for.
    pub dictionary: Dictionary,
    /// How many modules wide the black border of a tag is: 1, or 2 for the boards of kalibr.
    pub border: u8,
}
