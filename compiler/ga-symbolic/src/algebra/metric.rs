//! The inner products of the basis vectors, and the product of two basis blades that follows from
//! them.

use std::collections::BTreeMap;

use super::{Blade, Ratio};

/// A constant symmetric bilinear form on the basis vectors. It may be singular, and need not be
/// diagonal.
#[derive(Clone, Debug, PartialEq)]
pub struct Metric {
    dimension: usize,
    entries: Vec<Ratio>,
}

impl Metric {
    /// The form in which every inner product is zero.
    #[must_use]
    pub fn zero(dimension: usize) -> Self {
        Self {
            dimension,
            entries: vec![Ratio::ZERO; dimension * dimension],
        }
    }

    /// The diagonal form with `positive` squares of 1, then `negative` of −1, then `null` of 0.
    #[must_use]
    pub fn signature(positive: usize, negative: usize, null: usize) -> Self {
        let mut metric = Self::zero(positive + negative + null);
        for index in 0..positive + negative {
            let square = if index < positive { 1 } else { -1 };
            metric.set(index, index, Ratio::integer(square));
        }
        metric
    }

    /// The number of basis vectors.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The inner product of two basis vectors.
    #[must_use]
    pub fn get(&self, row: usize, column: usize) -> Ratio {
        self.entries[row * self.dimension + column]
    }

    /// Sets the inner product of two basis vectors, in both orders.
    pub fn set(&mut self, row: usize, column: usize, value: Ratio) {
        self.entries[row * self.dimension + column] = value;
        self.entries[column * self.dimension + row] = value;
    }

    /// Whether the coefficients of all products of basis blades fit 64 bits, by a bound.
    ///
    /// With the least common denominator d, d^n times such a coefficient is a whole number, and no
    /// larger than the product of the sums of the rows, each at least d.
    #[must_use]
    pub fn products_fit(&self) -> bool {
        let limit = f64::from(1_u32 << 31).powi(2);
        let mut common = Ratio::ONE;
        for entry in &self.entries {
            // d grows by the missing part of each denominator, so it stays a whole number.
            let lacking = (common * *entry).denominator();
            common = common * Ratio::integer(lacking);
            if common.to_f64() > limit {
                return false;
            }
        }
        let rows = self.entries.chunks(self.dimension.max(1));
        let bound: f64 = rows
            .map(|row| row.iter().map(|entry| entry.to_f64().abs()).sum::<f64>())
            .map(|sum| common.to_f64() * sum.max(1.0))
            .product();
        bound < limit
    }

    /// The square of the pseudoscalar: (−1)^(n(n−1)/2) det G. Zero where the metric is degenerate.
    #[must_use]
    pub fn pseudoscalar_square(&self) -> Ratio {
        let determinant = self.determinant();
        if Blade::pseudoscalar(self.dimension).reverse_is_negative() {
            -determinant
        } else {
            determinant
        }
    }

    /// By Gauss's elimination.
    fn determinant(&self) -> Ratio {
        let n = self.dimension;
        let mut rows = self.entries.clone();
        let mut determinant = Ratio::ONE;
        for step in 0..n {
            let Some(pivot) = (step..n).find(|&row| !rows[row * n + step].is_zero()) else {
                return Ratio::ZERO;
            };
            if pivot != step {
                (0..n).for_each(|column| rows.swap(pivot * n + column, step * n + column));
                determinant = -determinant;
            }
            determinant = determinant * rows[step * n + step];
            for row in step + 1..n {
                let factor = rows[row * n + step] / rows[step * n + step];
                for column in step..n {
                    let change = factor * rows[step * n + column];
                    rows[row * n + column] = rows[row * n + column] - change;
                }
            }
        }
        determinant
    }

    /// The geometric product of two basis blades, as a sum of basis blades.
    ///
    /// By Wick's theorem the product of two blades is a sum over all ways to contract some vectors
    /// of the left blade with vectors of the right one; each term is the outer product of the
    /// remaining vectors. The vectors of the left blade are taken from the last to the first. Each
    /// is kept, or contracted with one vector of the right blade, with a sign for every vector
    /// between them.
    #[must_use]
    pub fn geometric(&self, left: Blade, right: Blade) -> Vec<(Blade, Ratio)> {
        let mut terms = BTreeMap::from([((Blade::SCALAR, right), Ratio::ONE)]);
        for vector in left.vectors().rev() {
            let mut next = BTreeMap::new();
            let mut add = |kept, rest, value: Ratio| {
                let sum = next.entry((kept, rest)).or_insert(Ratio::ZERO);
                *sum = *sum + value;
            };
            for ((kept, rest), value) in terms {
                for partner in rest.vectors() {
                    let inner = self.get(vector, partner);
                    if inner.is_zero() {
                        continue;
                    }
                    let passed = kept.grade() + rest.rank_of(partner);
                    let signed = if passed % 2 == 1 { -inner } else { inner };
                    add(kept, rest.without(partner), value * signed);
                }
                add(Blade(kept.0 | 1 << vector), rest, value);
            }
            terms = next;
        }
        let mut result: BTreeMap<Blade, Ratio> = BTreeMap::new();
        for ((kept, rest), value) in terms {
            if kept.0 & rest.0 != 0 {
                continue;
            }
            let signed = if kept.wedge_is_negative(rest) {
                -value
            } else {
                value
            };
            let sum = result.entry(Blade(kept.0 | rest.0)).or_insert(Ratio::ZERO);
            *sum = *sum + signed;
        }
        result.retain(|_, value| !value.is_zero());
        result.into_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn null_basis() -> Metric {
        let mut metric = Metric::signature(3, 0, 2);
        metric.set(3, 4, Ratio::integer(-1));
        metric
    }

    #[test]
    fn vectors_multiply_to_inner_and_outer_part() {
        let metric = null_basis();
        let (eo, ei) = (Blade::vector(3), Blade::vector(4));
        let both = Blade(eo.0 | ei.0);
        assert_eq!(
            metric.geometric(eo, ei),
            [(Blade::SCALAR, Ratio::integer(-1)), (both, Ratio::ONE)]
        );
        assert_eq!(
            metric.geometric(ei, eo),
            [
                (Blade::SCALAR, Ratio::integer(-1)),
                (both, Ratio::integer(-1))
            ]
        );
        assert_eq!(metric.geometric(both, both), [(Blade::SCALAR, Ratio::ONE)]);
    }

    #[test]
    fn pseudoscalar_squares() {
        assert_eq!(null_basis().pseudoscalar_square(), Ratio::integer(-1));
        assert_eq!(
            Metric::signature(3, 0, 0).pseudoscalar_square(),
            Ratio::integer(-1)
        );
        assert_eq!(
            Metric::signature(3, 0, 1).pseudoscalar_square(),
            Ratio::ZERO
        );
        assert_eq!(
            Metric::signature(1, 3, 0).pseudoscalar_square(),
            Ratio::integer(-1)
        );
    }

    /// A metric with few zeros.
    fn full(dimension: usize) -> Metric {
        let mut metric = Metric::zero(dimension);
        for row in 0..dimension {
            for column in row..dimension {
                let numerator = (row * 3 + column * 7) as i128 % 5 - 2;
                let denominator = (row + column) as i128 % 3 + 1;
                metric.set(row, column, Ratio::new(numerator, denominator).unwrap());
            }
        }
        metric
    }

    #[test]
    fn determinant_is_the_product_of_pseudoscalars() {
        for dimension in 0..=6 {
            let metric = full(dimension);
            let pseudoscalar = Blade::pseudoscalar(dimension);
            let product = metric.geometric(pseudoscalar, pseudoscalar);
            let square = metric.pseudoscalar_square();
            let expected = if square.is_zero() {
                vec![]
            } else {
                vec![(Blade::SCALAR, square)]
            };
            assert_eq!(product, expected);
        }
        assert_ne!(full(6).pseudoscalar_square(), Ratio::ZERO);
    }

    #[test]
    fn the_bound_on_products_holds() {
        assert!(null_basis().products_fit() && full(6).products_fit());
        assert!(Metric::signature(9, 7, 0).products_fit());
        let mut metric = Metric::zero(4);
        (0..4).for_each(|index| metric.set(index, index, Ratio::integer(40_000)));
        assert!(metric.products_fit(), "40000⁴ < 2⁶²");
        metric.set(0, 1, Ratio::integer(40_000));
        metric.set(2, 3, Ratio::new(1, 3).unwrap());
        assert!(!metric.products_fit(), "(80000 · 40000 · 3²)² > 2⁶²");
    }

    #[test]
    fn product_is_associative_in_a_full_metric() {
        let metric = full(4);
        let multiply = |terms: &[(Blade, Ratio)], blade: Blade, on_left: bool| {
            let mut sums = vec![Ratio::ZERO; 16];
            for &(term, value) in terms {
                let product = if on_left {
                    metric.geometric(term, blade)
                } else {
                    metric.geometric(blade, term)
                };
                for (result, factor) in product {
                    sums[result.0 as usize] = sums[result.0 as usize] + value * factor;
                }
            }
            sums
        };
        for a in 0..16 {
            for b in 0..16 {
                for c in 0..16 {
                    let left = multiply(&metric.geometric(Blade(a), Blade(b)), Blade(c), true);
                    let right = multiply(&metric.geometric(Blade(b), Blade(c)), Blade(a), false);
                    assert_eq!(left, right, "({a} {b}) {c}");
                }
            }
        }
    }
}
