//! Pairs of basis vectors of which one is null, such as infinity and the origin.
//!
//! Let i be a basis vector with `i² = 0`, o the only one with `o·i ≠ 0`, and o orthogonal to all
//! others. The blades of the other vectors are called E here.

use crate::algebra::{Algebra, Blade, Ratio};
use crate::ir::{Arena, Multivector};

/// Such a pair.
#[derive(Clone, Copy)]
pub(super) struct NullPair {
    /// The vector i.
    pub(super) null: usize,
    /// The vector o.
    pub(super) partner: usize,
    /// `o·i`.
    pub(super) inner: Ratio,
}

impl NullPair {
    /// The pairs of an algebra.
    pub(super) fn all(algebra: &Algebra) -> impl Iterator<Item = Self> {
        let metric = algebra.metric();
        let partners = move |index: usize| {
            let all = 0..metric.dimension();
            all.filter(move |&other| !metric.get(index, other).is_zero())
        };
        (0..metric.dimension()).filter_map(move |null| {
            let mut found = partners(null);
            let (Some(partner), None) = (found.next(), found.next()) else {
                return None;
            };
            let is_free = partners(partner).all(|other| [null, partner].contains(&other));
            (partner != null && is_free).then(|| Self {
                null,
                partner,
                inner: metric.get(null, partner),
            })
        })
    }

    /// A multivector N of blades without i for which `N i = M i`.
    ///
    /// `(E∧i) i = 0`, so these blades are left out, and `(E∧o∧i) i = E (o i − o·i) i = −(o·i) E i`,
    /// so `E∧o∧i` becomes `−(o·i) E`.
    pub(super) fn folded(self, arena: &mut Arena, value: &Multivector) -> Multivector {
        let terms: Vec<_> = value
            .terms()
            .iter()
            .filter_map(|&(blade, value)| {
                if !blade.contains(self.null) {
                    return Some((blade, value));
                }
                let rest = self.rest(blade);
                let factor = self.sign(blade) * -self.inner;
                blade
                    .contains(self.partner)
                    .then(|| (rest, value.scaled(factor)))
            })
            .collect();
        Multivector::new(arena, terms)
    }

    /// `Σ e E` from `Σ e E∧i`.
    pub(super) fn without_null(self, arena: &mut Arena, value: &Multivector) -> Multivector {
        let terms = value.terms().iter();
        let terms = terms.map(|&(blade, e)| (self.rest(blade), e.scaled(self.sign(blade))));
        let terms: Vec<_> = terms.collect();
        Multivector::new(arena, terms)
    }

    /// Whether a blade is `E∧i`.
    pub(super) const fn is_upper(self, blade: Blade) -> bool {
        blade.contains(self.null) && !blade.contains(self.partner)
    }

    /// The blade E of `E`, `E∧o`, `E∧i` or `E∧o∧i`.
    pub(super) fn rest(self, blade: Blade) -> Blade {
        blade.without(self.null).without(self.partner)
    }

    /// 1 or −1: `E`, `E∧o`, `E∧i` or `E∧o∧i` against the blade in rising order.
    pub(super) fn sign(self, blade: Blade) -> Ratio {
        let mut before = self.rest(blade);
        let mut is_negative = false;
        for vector in [self.partner, self.null] {
            if blade.contains(vector) {
                is_negative ^= before.wedge_is_negative(Blade::vector(vector));
                before = Blade(before.0 | 1 << vector);
            }
        }
        Ratio::integer(if is_negative { -1 } else { 1 })
    }
}
