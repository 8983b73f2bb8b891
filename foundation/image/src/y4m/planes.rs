//! From pictures in red, green and blue to what films store.

use super::Sampling;
use crate::plane::Plane;
use crate::ycbcr::{YCbCr, rounded};

/// Luma, Cb and Cr of a picture. A difference that is stored for several pixels is the mean of
/// theirs; at the border these may be fewer.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{Sampling, planes};
/// use ga_image::ycbcr::YCbCr;
///
/// let red = Plane::filled(3, 2, [255, 0, 0]);
/// let [luma, cb, cr] = planes(&red, Sampling::Quarter, YCbCr::default());
/// assert_eq!(luma, Plane::filled(3, 2, 81));
/// assert_eq!((cb, cr), (Plane::filled(2, 1, 90), Plane::filled(2, 1, 240)));
/// ```
#[must_use]
pub fn planes(picture: &Plane<[u8; 3]>, sampling: Sampling, colours: YCbCr) -> [Plane<u8>; 3] {
    let encoded = picture.map(|rgb| colours.encoded(rgb.map(f32::from)));
    let size = [picture.width(), picture.height()];
    let [width, height] = sampling.difference_size(size);
    let (across, down) = (
        size[0].div_ceil(width.max(1)),
        size[1].div_ceil(height.max(1)),
    );
    let difference = |channel: usize| {
        Plane::from_fn(width, height, |column, row| {
            let rows = (row * down..size[1]).take(down);
            let (mut sum, mut count) = (0.0, 0.0);
            for row in rows {
                for pixel in encoded.row(row)[column * across..].iter().take(across) {
                    sum += pixel[channel];
                    count += 1.0;
                }
            }
            rounded(sum / count)
        })
    };
    let luma = encoded.map(|[luma, ..]| rounded(luma));
    [luma, difference(1), difference(2)]
}
