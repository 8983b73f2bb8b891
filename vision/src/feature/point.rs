//! Corners and what surrounds them.

use super::Descriptor;

/// A corner and what surrounds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feature {
    /// Where it is.
    pub pixel: [f64; 2],
    /// The size of a pixel of the scale in which it was found, in pixels of the view.
    pub size: f64,
    /// The direction from the corner to the brighter side of its surroundings, in radians from the
    /// u axis towards the v axis.
    pub angle: f64,
    /// The smaller eigenvalue of the structure tensor, in squared grey levels per squared pixel.
    pub strength: f64,
    /// Bits that describe its surroundings, rotated by the angle.
    pub descriptor: Descriptor,
    /// Which of the scales of the view it was found in.
    pub(super) scale: usize,
    /// Where it is in that scale.
    pub(super) place: [f64; 2],
}
