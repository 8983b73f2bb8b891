//! Features of views: corners that are found again in another view.

/// The pixels at which two views show one point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelPair {
    /// The pixel in the left view.
    pub left: [f64; 2],
    /// The pixel in the right view.
    pub right: [f64; 2],
}
