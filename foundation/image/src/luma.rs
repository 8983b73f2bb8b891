//! The weights of grey.

/// The weights with which red, green and blue make up grey.
///
/// They are applied to the numbers as the picture has them. For pictures encoded as sRGB or by a
/// video standard this is luma, Y′; for linear light it is luminance where the primaries are those
/// of the standard.
///
/// For `u8` the weights are rounded to multiples of 2⁻¹⁵ and the sum to the nearest integer, which
/// is what OpenCV 5 computes.
///
/// ```
/// use ga_image::grey::Luma;
/// use ga_image::plane::Plane;
///
/// assert_eq!(Luma::Bt601.of([255u8, 255, 255]), 255);
/// assert_eq!(Luma::Bt709.of([0.0, 1.0, 0.0]), 0.7152);
/// let picture = Plane::filled(4, 4, [0u8, 0, 255]);
/// assert_eq!(Luma::Bt601.plane(&picture).get(2, 2), Some(29));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Luma {
    /// ITU-R BT.601: 0.299, 0.587, 0.114.
    #[default]
    Bt601,
    /// ITU-R BT.709, also the luminance of sRGB's primaries: 0.2126, 0.7152, 0.0722.
    Bt709,
    /// ITU-R BT.2020 with luma that is not constant luminance: 0.2627, 0.678, 0.0593.
    Bt2020,
}

impl Luma {
    /// The weights of red, green and blue. Their sum is 1.
    #[must_use]
    pub const fn weights(self) -> [f32; 3] {
        match self {
            Self::Bt601 => [0.299, 0.587, 0.114],
            Self::Bt709 => [0.2126, 0.7152, 0.0722],
            Self::Bt2020 => [0.2627, 0.678, 0.0593],
        }
    }
}

pub(crate) fn weighted(rgb: [f32; 3], luma: Luma) -> f32 {
    let [red, green, blue] = luma.weights();
    red * rgb[0] + green * rgb[1] + blue * rgb[2]
}

/// The sum in integers, exact for weights that are multiples of 2⁻¹⁵.
pub(crate) fn weighted_bytes(rgb: [u8; 3], luma: Luma) -> u8 {
    let [red, green, blue]: [u32; 3] = match luma {
        Luma::Bt601 => [9798, 19235, 3735],
        Luma::Bt709 => [6966, 23436, 2366],
        Luma::Bt2020 => [8608, 22217, 1943],
    };
    let [r, g, b] = rgb.map(u32::from);
    ((red * r + green * g + blue * b + (1 << 14)) >> 15) as u8
}
