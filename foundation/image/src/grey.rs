//! From colour to grey.

use crate::plane::{Plane, PlaneView};
use crate::sample::Sample;

pub use crate::luma::Luma;

impl Luma {
    /// The grey of one colour.
    #[must_use]
    #[inline]
    pub fn of<T: Sample>(self, rgb: [T; 3]) -> T {
        T::luma(rgb, self)
    }

    /// The picture in grey.
    #[must_use]
    pub fn plane<'a, T: Sample>(self, picture: impl Into<PlaneView<'a, [T; 3]>>) -> Plane<T> {
        picture.into().map(|rgb| self.of(rgb))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::luma::weighted;

    #[test]
    fn integers_agree_with_the_weights() {
        for luma in [Luma::Bt601, Luma::Bt709, Luma::Bt2020] {
            for rgb in [
                [1u8, 2, 3],
                [255, 0, 0],
                [0, 255, 0],
                [13, 200, 77],
                [255; 3],
            ] {
                let exact = weighted(rgb.map(f32::from), luma);
                assert!((f32::from(luma.of(rgb)) - exact).abs() < 0.52, "{rgb:?}");
                let deep = luma.of(rgb.map(|v| u16::from(v) * 257));
                assert!((f32::from(deep) - 257.0 * exact).abs() < 0.52, "{rgb:?}");
            }
        }
    }
}
