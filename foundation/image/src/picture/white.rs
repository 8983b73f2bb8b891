//! How far the numbers of pictures with 16 bits reach.

use super::Picture;
use crate::plane::Plane;
use crate::sample::{Pixel, spread_to_16_bits};

/// The bits of the numbers that cameras store in files of 16 bits.
const DEPTHS: [u32; 5] = [8, 10, 12, 14, 16];

impl Picture {
    /// Pictures that were taken alike, such as the views of a pair, with their range spread so that
    /// white is the greatest number: for measuring, where the factor between stored numbers and
    /// light is free.
    ///
    /// Cameras of 10, 12 or 14 bits store their numbers in files of 16 bits as they are, so that
    /// the brightest is at most 1023, 4095 or 16383 and a program that takes 65535 as white sees
    /// black pictures. No file format says so for certain: PNG's chunk sBIT tells how many bits
    /// count of numbers that are scaled to 16 bits already. So the greatest number decides, the
    /// colours of all pictures taken together: where it is less than 2ᵇ for b = 8, 10, 12 or 14,
    /// 2ᵇ − 1 becomes white. The numbers stay as different as they are. Pictures of 8 bits, floats
    /// and alpha do not change. A portable grey map says what white is: where that is 1023, it has
    /// been applied when the file was read.
    ///
    /// ```
    /// use ga_image::picture::Picture;
    /// use ga_image::plane::Plane;
    ///
    /// // Two views with 10 bits; the left one alone looks like one of 8 bits.
    /// let views = [[0u16, 255], [512, 1023]].map(|v| Plane::from_values(2, 1, v.to_vec()));
    /// let [left, right] = views;
    /// let [left, right] = Picture::spread([left?.into(), right?.into()]);
    /// assert_eq!(left, Plane::from_values(2, 1, vec![0u16, 16336])?.into());
    /// assert_eq!(right, Plane::from_values(2, 1, vec![32800u16, 65535])?.into());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn spread<const N: usize>(pictures: [Self; N]) -> [Self; N] {
        let greatest = pictures.iter().filter_map(Self::greatest_of_16_bits).max();
        let Some(greatest) = greatest else {
            return pictures;
        };
        let white = DEPTHS.map(|bits| ((1u32 << bits) - 1) as u16);
        match white.into_iter().find(|white| greatest <= *white) {
            Some(white) if white < u16::MAX => pictures.map(|picture| picture.with_white(white)),
            _ => pictures,
        }
    }

    /// The greatest number of the colours; `None` for pictures of another depth.
    fn greatest_of_16_bits(&self) -> Option<u16> {
        fn greatest<P: Pixel<Sample = u16>>(plane: &Plane<P>, colours: usize) -> Option<u16> {
            let samples = P::samples(plane.values()).chunks_exact(P::CHANNELS);
            samples.flat_map(|pixel| &pixel[..colours]).copied().max()
        }
        match self {
            Self::Grey16(plane) => greatest(plane, 1),
            Self::GreyAlpha16(plane) => greatest(plane, 1),
            Self::Rgb16(plane) => greatest(plane, 3),
            Self::Rgba16(plane) => greatest(plane, 3),
            _ => None,
        }
    }

    /// Colours of 16 bits scaled so that a number, which none exceeds, becomes the greatest.
    fn with_white(self, white: u16) -> Self {
        let spread = |value: u16| spread_to_16_bits(value, white);
        match self {
            Self::Grey16(plane) => plane.map(spread).into(),
            Self::GreyAlpha16(plane) => plane.map(|[v, alpha]| [spread(v), alpha]).into(),
            Self::Rgb16(plane) => plane.map(|rgb: [u16; 3]| rgb.map(spread)).into(),
            Self::Rgba16(plane) => plane
                .map(|[r, g, b, alpha]| [spread(r), spread(g), spread(b), alpha])
                .into(),
            other => other,
        }
    }
}
