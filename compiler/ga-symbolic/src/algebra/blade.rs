//! Basis blades as sets of basis vectors.

/// The outer product of a set of basis vectors in rising order: bit `k` is set where the `k`-th
/// basis vector takes part. `Blade(0)` is the scalar 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Blade(pub u32);

impl Blade {
    /// The scalar 1.
    pub const SCALAR: Self = Self(0);

    /// The blade of one basis vector.
    #[must_use]
    pub const fn vector(index: usize) -> Self {
        Self(1 << index)
    }

    /// The outer product of all `dimension` basis vectors.
    #[must_use]
    pub const fn pseudoscalar(dimension: usize) -> Self {
        Self((1 << dimension) - 1)
    }

    /// The number of vectors in the blade.
    #[must_use]
    pub const fn grade(self) -> u32 {
        self.0.count_ones()
    }

    /// Whether the basis vector `index` takes part.
    #[must_use]
    pub const fn contains(self, index: usize) -> bool {
        self.0 >> index & 1 == 1
    }

    /// The indices of the vectors in rising order.
    pub fn vectors(self) -> impl DoubleEndedIterator<Item = usize> {
        (0..u32::BITS as usize).filter(move |&index| self.contains(index))
    }

    /// How many vectors of the blade come before the basis vector `index`.
    #[must_use]
    pub const fn rank_of(self, index: usize) -> u32 {
        (self.0 & ((1 << index) - 1)).count_ones()
    }

    /// The blade without the basis vector `index`.
    #[must_use]
    pub const fn without(self, index: usize) -> Self {
        Self(self.0 & !(1 << index))
    }

    /// Whether the outer product with `other`, brought into rising order, changes sign.
    /// Both blades must have no vector in common.
    #[must_use]
    pub fn wedge_is_negative(self, other: Self) -> bool {
        let swaps: u32 = other
            .vectors()
            .map(|index| (self.0 >> index).count_ones())
            .sum();
        swaps % 2 == 1
    }

    /// Whether reversing the order of the vectors changes sign: (−1)^(k(k−1)/2) for grade k.
    #[must_use]
    pub const fn reverse_is_negative(self) -> bool {
        self.grade() % 4 >= 2
    }

    /// Whether the grade involution changes sign: (−1)^k for grade k.
    #[must_use]
    pub const fn involute_is_negative(self) -> bool {
        self.grade() % 2 == 1
    }

    /// Whether Clifford conjugation changes sign: (−1)^(k(k+1)/2) for grade k.
    #[must_use]
    pub const fn conjugate_is_negative(self) -> bool {
        let remainder = self.grade() % 4;
        remainder == 1 || remainder == 2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wedge_signs_count_swaps() {
        let (e1, e2, e3) = (Blade::vector(0), Blade::vector(1), Blade::vector(2));
        assert!(!e1.wedge_is_negative(e2));
        assert!(e2.wedge_is_negative(e1));
        assert!(!Blade(e2.0 | e3.0).wedge_is_negative(e1));
        assert!(e3.wedge_is_negative(Blade(e1.0)) && !e3.wedge_is_negative(Blade(e1.0 | e2.0)));
    }

    #[test]
    fn involutions_by_grade() {
        let signs: Vec<_> = (0..5)
            .map(Blade::pseudoscalar)
            .map(|b| {
                (
                    b.reverse_is_negative(),
                    b.involute_is_negative(),
                    b.conjugate_is_negative(),
                )
            })
            .collect();
        let (t, f) = (true, false);
        assert_eq!(
            signs,
            [(f, f, f), (f, t, t), (t, f, t), (t, t, f), (f, f, f)]
        );
    }
}
