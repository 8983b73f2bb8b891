//! Conversion between sRGB and linear light, IEC 61966-2-1.
//!
//! `ga_image::colour` has the same curve for pictures. This one is extended to numbers below 0 and
//! above 1, which files of meshes may have, and spares the crate a dependency on the readers and
//! writers of pictures.

/// The linear light of an sRGB value between 0 and 1; both are odd functions beyond.
pub(crate) fn linear_from_srgb(value: f64) -> f64 {
    let size = value.abs();
    let linear = if size <= 0.04045 {
        size / 12.92
    } else {
        ((size + 0.055) / 1.055).powf(2.4)
    };
    linear.copysign(value)
}

/// The sRGB value of linear light.
pub(crate) fn srgb_from_linear(value: f64) -> f64 {
    let size = value.abs();
    let encoded = if size <= 0.0031308 {
        size * 12.92
    } else {
        1.055 * size.powf(1.0 / 2.4) - 0.055
    };
    encoded.copysign(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value of mid grey, 128/255, from the tables of the standard.
    #[test]
    fn mid_grey_is_a_fifth_of_white() {
        assert!((linear_from_srgb(128.0 / 255.0) - 0.215_860_500_113_899).abs() < 1e-12);
        assert_eq!(linear_from_srgb(0.0), 0.0);
        assert_eq!(linear_from_srgb(1.0), 1.0);
    }

    #[test]
    fn the_conversions_are_inverse() {
        for step in -300..=300 {
            let value = f64::from(step) / 255.0;
            assert!((srgb_from_linear(linear_from_srgb(value)) - value).abs() < 1e-7);
        }
    }
}
