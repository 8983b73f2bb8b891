//! Where a picture ends: what lies there is not a border of anything that it shows.

/// Whether a place is at the border of a picture with these columns and rows: on one of its
/// outermost pixels, or beyond their centres.
pub(super) fn is_at_border(place: [f64; 2], size: [usize; 2]) -> bool {
    let mut axes = place.iter().zip(size);
    axes.any(|(place, length)| *place < 0.5 || *place > length as f64 - 1.5)
}
