//! Where a picture ends: what lies there is not a border of anything that it shows.

/// A snake is drawn to the border of a picture where it is nearer to the centres of its outermost
/// pixels than this, in pixels: edges are blurred.
pub(super) const REACH_OF_SNAKES: f64 = 1.5;

/// Whether a place is at the border of a picture with these columns and rows: not farther inside
/// than `reach` from the centres of its outermost pixels.
pub(super) fn is_at_border(place: [f64; 2], size: [usize; 2], reach: f64) -> bool {
    let mut axes = place.iter().zip(size);
    axes.any(|(place, length)| *place <= reach || *place >= length as f64 - 1.0 - reach)
}
