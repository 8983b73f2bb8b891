//! The colour encoding of video: luma and two colour differences.

use crate::grey::Luma;

/// Which numbers of 8 bits stand for black and white.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Range {
    /// Luma from 16 to 235, colour differences from 16 to 240, as broadcast standards have it.
    #[default]
    Limited,
    /// Luma and colour differences from 0 to 255, as in JPEG.
    Full,
}

/// Y′CbCr with 8 bits for each channel.
///
/// With the weights `kr`, `kg`, `kb` of a [`Luma`], Y′ = kr R + kg G + kb B,
/// Cb = (B − Y′) / 2(1 − kb) and Cr = (R − Y′) / 2(1 − kr), where R, G, B and Y′ are in 0 to 1 and
/// Cb and Cr in −½ to ½.
///
/// ```
/// use ga_image::ycbcr::YCbCr;
///
/// let video = YCbCr::default();
/// assert_eq!(video.from_rgb([255, 255, 255]), [235, 128, 128]);
/// assert_eq!(video.from_rgb([255, 0, 0]), [81, 90, 240]);
/// assert_eq!(video.to_rgb([81, 90, 240]), [254, 0, 0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct YCbCr {
    /// The weights of luma.
    pub luma: Luma,
    /// The range of the numbers.
    pub range: Range,
}

impl YCbCr {
    /// Luma and colour differences of red, green and blue.
    #[must_use]
    pub fn from_rgb(self, rgb: [u8; 3]) -> [u8; 3] {
        self.encoded(rgb.map(f32::from)).map(rounded)
    }

    /// Red, green and blue; what is outside their range becomes the nearest number in it.
    #[must_use]
    pub fn to_rgb(self, encoded: [u8; 3]) -> [u8; 3] {
        self.decoded(encoded.map(f32::from)).map(rounded)
    }

    /// As [`to_rgb`](Self::to_rgb), of the 10-bit numbers of video, from 0 to 1023: in the limited
    /// range they are four times those of 8 bits.
    ///
    /// ```
    /// use ga_image::ycbcr::YCbCr;
    ///
    /// assert_eq!(YCbCr::default().to_rgb_of_ten_bits([940, 512, 512]), [255; 3]);
    /// ```
    #[must_use]
    pub fn to_rgb_of_ten_bits(self, encoded: [u16; 3]) -> [u8; 3] {
        let scale = match self.range {
            Range::Limited => 0.25,
            Range::Full => 255.0 / 1023.0,
        };
        let [y, cb, cr] = encoded.map(f32::from);
        let [cb, cr] = [cb, cr].map(|c| 128.0 + scale * (c - 512.0));
        self.decoded([scale * y, cb, cr]).map(rounded)
    }

    /// Red, green and blue, from 0 to 255, of numbers that need not be whole, such as means:
    /// without rounding, and outside of 0 to 255 where the numbers stand for no colour.
    ///
    /// ```
    /// use ga_image::ycbcr::YCbCr;
    ///
    /// let [red, green, blue] = YCbCr::default().decoded([125.5, 128.0, 128.0]);
    /// assert!((red - 127.5).abs() < 1e-4 && red == blue && (green - red).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn decoded(self, [y, cb, cr]: [f32; 3]) -> [f32; 3] {
        let [kr, kg, kb] = self.luma.weights();
        let ([black, luma_scale], colour_scale) = self.scales();
        let y = (y - black) / luma_scale;
        let [cb, cr] = [cb, cr].map(|c| (c - 128.0) / colour_scale);
        let red = y + 2.0 * (1.0 - kr) * cr;
        let blue = y + 2.0 * (1.0 - kb) * cb;
        [red, (y - kr * red - kb * blue) / kg, blue]
    }

    /// Luma and colour differences of red, green and blue, from 0 to 255, that need not be whole:
    /// without rounding, the inverse of [`decoded`](Self::decoded).
    ///
    /// ```
    /// use ga_image::ycbcr::YCbCr;
    ///
    /// let [luma, cb, cr] = YCbCr::default().encoded([127.5; 3]);
    /// assert!((luma - 125.5).abs() < 1e-4 && (cb - 128.0).abs() < 1e-4 && cb == cr);
    /// ```
    #[must_use]
    pub fn encoded(self, rgb: [f32; 3]) -> [f32; 3] {
        let [kr, kg, kb] = self.luma.weights();
        let ([black, luma_scale], colour_scale) = self.scales();
        let [red, green, blue] = rgb;
        let y = kr * red + kg * green + kb * blue;
        [
            black + luma_scale * y,
            128.0 + colour_scale * (blue - y) / (2.0 * (1.0 - kb)),
            128.0 + colour_scale * (red - y) / (2.0 * (1.0 - kr)),
        ]
    }

    /// The number of black and the factor of luma; the factor of colour differences.
    fn scales(self) -> ([f32; 2], f32) {
        match self.range {
            Range::Limited => ([16.0, 219.0 / 255.0], 224.0 / 255.0),
            Range::Full => ([0.0, 1.0], 1.0),
        }
    }
}

pub(crate) fn rounded(value: f32) -> u8 {
    crate::sample::Sample::from_f32(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_survive_the_way_there_and_back() {
        for luma in [Luma::Bt601, Luma::Bt709, Luma::Bt2020] {
            for range in [Range::Limited, Range::Full] {
                let video = YCbCr { luma, range };
                for code in 0..4096u32 {
                    let rgb = [code & 15, (code >> 4) & 15, code >> 8].map(|v| (17 * v) as u8);
                    let back = video.to_rgb(video.from_rgb(rgb));
                    let error = (0..3).map(|i| rgb[i].abs_diff(back[i])).max();
                    assert!(error <= Some(2), "{video:?}: {rgb:?} {back:?}");
                }
            }
        }
    }

    /// The numbers of ITU-R BT.709, 8 bits: the bars at 100 %.
    #[test]
    fn the_primaries_have_the_numbers_of_the_standard() {
        let video = YCbCr {
            luma: Luma::Bt709,
            range: Range::Limited,
        };
        assert_eq!(video.from_rgb([255, 0, 0]), [63, 102, 240]);
        assert_eq!(video.from_rgb([0, 255, 0]), [173, 42, 26]);
        assert_eq!(video.from_rgb([0, 0, 255]), [32, 240, 118]);
        assert_eq!(video.from_rgb([255, 255, 0]), [219, 16, 138]);
    }
}
