//! What lies outside a picture.

/// How a filter continues a picture beyond its border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Border {
    /// `d c b a | a b c d | d c b a`: mirrored at the edge of the outermost pixel. SciPy's
    /// `reflect`, numpy's `symmetric`, OpenCV's `BORDER_REFLECT`.
    Reflect,
    /// `d c b | a b c d | c b a`: mirrored at the centre of the outermost pixel. SciPy's `mirror`,
    /// numpy's `reflect`, OpenCV's `BORDER_REFLECT_101`.
    Mirror,
    /// `a a a | a b c d | d d d`: the outermost pixel, repeated. SciPy's `nearest`, OpenCV's
    /// `BORDER_REPLICATE`.
    Replicate,
}

impl Border {
    /// The index, below `length`, of the pixel that stands at `index`. `length` is at least 1.
    #[must_use]
    pub(crate) fn index(self, index: isize, length: usize) -> usize {
        let last = length.cast_signed() - 1;
        let inside = match self {
            Self::Replicate => index.clamp(0, last),
            Self::Reflect => {
                let place = index.rem_euclid(2 * last + 2);
                place.min(2 * last + 1 - place)
            }
            Self::Mirror => {
                let place = index.rem_euclid((2 * last).max(1));
                place.min(2 * last - place)
            }
        };
        inside.max(0).cast_unsigned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples are those of `scipy.ndimage`'s documentation of its modes.
    #[test]
    fn borders_continue_as_their_names_say() {
        let continued = |border: Border, length: usize| -> String {
            let letters = ["a", "b", "c", "d"];
            (-6..10)
                .map(|index| letters[border.index(index, length)])
                .collect()
        };
        assert_eq!(continued(Border::Reflect, 4), "cddcbaabcddcbaab");
        assert_eq!(continued(Border::Mirror, 4), "abcdcbabcdcbabcd");
        assert_eq!(continued(Border::Replicate, 4), "aaaaaaabcddddddd");
        assert_eq!(continued(Border::Reflect, 1), "aaaaaaaaaaaaaaaa");
        assert_eq!(continued(Border::Mirror, 1), "aaaaaaaaaaaaaaaa");
        assert_eq!(continued(Border::Mirror, 2), "abababababababab");
    }
}
