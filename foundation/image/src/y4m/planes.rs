//! From pictures in red, green and blue to what films store.

use super::Sampling;
use crate::plane::Plane;
use crate::ycbcr::{YCbCr, rounded};

/// Where in its row a colour difference stands that is stored for two pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Siting {
    /// In the middle between them, as in JPEG.
    Centre,
    /// At the first, as in H.264 where the stream does not say otherwise.
    Left,
}

impl Siting {
    /// The columns of a picture of some width from which a difference is made, with their weights.
    fn columns(self, column: usize, across: usize, width: usize) -> Vec<(usize, f32)> {
        let first = column * across;
        match self {
            Self::Left if across == 2 => vec![
                (first.saturating_sub(1), 1.0),
                (first, 2.0),
                ((first + 1).min(width - 1), 1.0),
            ],
            _ => (first..width)
                .take(across)
                .map(|column| (column, 1.0))
                .collect(),
        }
    }
}

/// Luma, Cb and Cr of a picture. A difference that is stored for several pixels is the mean of
/// theirs, or from [`Siting::Left`] of the three pixels around the first one with the weights 1, 2
/// and 1; at the border there may be fewer.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{Sampling, Siting, planes};
/// use ga_image::ycbcr::YCbCr;
///
/// let red = Plane::filled(3, 2, [255, 0, 0]);
/// let [luma, cb, cr] = planes(&red, Sampling::Quarter, Siting::Centre, YCbCr::default());
/// assert_eq!(luma, Plane::filled(3, 2, 81));
/// assert_eq!((cb, cr), (Plane::filled(2, 1, 90), Plane::filled(2, 1, 240)));
/// ```
#[must_use]
pub fn planes(
    picture: &Plane<[u8; 3]>,
    sampling: Sampling,
    siting: Siting,
    colours: YCbCr,
) -> [Plane<u8>; 3] {
    let encoded = picture.map(|rgb| colours.encoded(rgb.map(f32::from)));
    let size = [picture.width(), picture.height()];
    let [width, height] = sampling.difference_size(size);
    let (across, down) = (
        size[0].div_ceil(width.max(1)),
        size[1].div_ceil(height.max(1)),
    );
    let columns = (0..width).map(|column| siting.columns(column, across, size[0]));
    let columns: Vec<Vec<(usize, f32)>> = columns.collect();
    let difference = |channel: usize| {
        Plane::from_fn(width, height, |column, row| {
            let (mut sum, mut weights) = (0.0, 0.0);
            for row in (row * down..size[1]).take(down) {
                for &(column, weight) in &columns[column] {
                    sum += weight * encoded.row(row)[column][channel];
                    weights += weight;
                }
            }
            rounded(sum / weights)
        })
    };
    let luma = encoded.map(|[luma, ..]| rounded(luma));
    [luma, difference(1), difference(2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_stand_between_pixels_or_at_the_first() {
        // Cb at a border of colours between the third and the fourth column.
        let (grey, blue) = ([128; 3], [0, 0, 255]);
        let picture = Plane::from_fn(6, 2, |column, _| if column < 3 { grey } else { blue });
        let blue = YCbCr::default().encoded([0.0, 0.0, 255.0])[1];
        let step = |part: f32| rounded(128.0 + part * (blue - 128.0));
        let row = |siting| {
            let [_, cb, _] = planes(&picture, Sampling::Quarter, siting, YCbCr::default());
            cb.row(0).to_vec()
        };
        assert_eq!(row(Siting::Centre), [128, step(0.5), step(1.0)]);
        assert_eq!(row(Siting::Left), [128, step(0.25), step(1.0)]);
    }
}
