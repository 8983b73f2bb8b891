//! Basis blades, the metric, and the products of basis blades.

mod blade;
mod metric;
mod names;
mod operation;
mod product;
mod ratio;
mod table;

pub use blade::Blade;
pub use metric::Metric;
pub use names::{BladeNames, NameError, NamedBlade, SCALAR};
pub use product::{Product, Unary};
pub use ratio::Ratio;
pub use table::BladeSum;

use table::Table;

/// The largest number of basis vectors.
pub const MAX_DIMENSION: usize = 16;

/// A geometric algebra: named basis vectors and their inner products.
#[derive(Debug)]
pub struct Algebra {
    names: BladeNames,
    metric: Metric,
    pseudoscalar_square: Ratio,
    products: Table,
}

impl Algebra {
    /// An algebra over the given basis vectors; `metric` must have their number as its dimension.
    #[must_use]
    pub fn new(basis: &[String], metric: Metric) -> Self {
        Self {
            names: BladeNames::new(basis),
            pseudoscalar_square: metric.pseudoscalar_square(),
            products: Table::new(metric.dimension()),
            metric,
        }
    }

    /// The number of basis vectors.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.metric.dimension()
    }

    /// The inner products of the basis vectors.
    #[must_use]
    pub fn metric(&self) -> &Metric {
        &self.metric
    }

    /// The metric in words: the square of each basis vector, and the other inner products that are
    /// not zero, as in `e1² = e2² = 1, eo² = ei² = 0, eo·ei = -1`.
    #[must_use]
    pub fn metric_text(&self) -> String {
        let name = |index: usize| self.names.name(Blade::vector(index));
        let dimension = self.dimension();
        let mut parts: Vec<String> = Vec::new();
        let mut row = String::new();
        for index in 0..dimension {
            let square = self.metric.get(index, index);
            row.push_str(&format!("{}² = ", name(index)));
            let is_last = index + 1 == dimension || self.metric.get(index + 1, index + 1) != square;
            if is_last {
                parts.push(format!("{row}{square}"));
                row.clear();
            }
        }
        for left in 0..dimension {
            for right in left + 1..dimension {
                let product = self.metric.get(left, right);
                if !product.is_zero() {
                    parts.push(format!("{}·{} = {product}", name(left), name(right)));
                }
            }
        }
        parts.join(", ")
    }

    /// How blades are written.
    #[must_use]
    pub fn names(&self) -> &BladeNames {
        &self.names
    }

    /// The outer product of all basis vectors.
    #[must_use]
    pub fn pseudoscalar(&self) -> Blade {
        Blade::pseudoscalar(self.dimension())
    }

    /// Whether the pseudoscalar has no inverse, so that duals go through complements.
    #[must_use]
    pub fn is_degenerate(&self) -> bool {
        self.pseudoscalar_square.is_zero()
    }

    /// The geometric product of two basis blades.
    #[must_use]
    pub fn geometric(&self, left: Blade, right: Blade) -> BladeSum {
        let make = || self.metric.geometric(left, right).into();
        self.products.get(Product::Geometric, left, right, make)
    }

    /// The dual of a basis blade: `a I⁻¹`, or the right complement (`a ∧ dual a = I`) where I is
    /// singular.
    #[must_use]
    pub fn dual(&self, blade: Blade) -> Vec<(Blade, Ratio)> {
        if self.is_degenerate() {
            return vec![self.complement(blade, false)];
        }
        let inverse = Ratio::ONE / self.pseudoscalar_square;
        self.geometric(blade, self.pseudoscalar())
            .iter()
            .map(|&(result, value)| (result, value * inverse))
            .collect()
    }

    /// The inverse of [`dual`](Self::dual): `a I`, or the left complement where I is singular.
    #[must_use]
    pub fn undual(&self, blade: Blade) -> Vec<(Blade, Ratio)> {
        if self.is_degenerate() {
            return vec![self.complement(blade, true)];
        }
        self.geometric(blade, self.pseudoscalar()).to_vec()
    }

    fn complement(&self, blade: Blade, on_left: bool) -> (Blade, Ratio) {
        let rest = Blade(self.pseudoscalar().0 & !blade.0);
        let is_negative = if on_left {
            rest.wedge_is_negative(blade)
        } else {
            blade.wedge_is_negative(rest)
        };
        (rest, Ratio::integer(if is_negative { -1 } else { 1 }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_metric_is_written_by_squares_and_products() {
        let text = |basis: &[&str], metric: Metric| {
            let names: Vec<String> = basis.iter().map(ToString::to_string).collect();
            Algebra::new(&names, metric).metric_text()
        };
        let signature = text(&["a", "b", "c", "d"], Metric::signature(2, 1, 1));
        assert_eq!(signature, "a² = b² = 1, c² = -1, d² = 0");
        let mut metric = Metric::signature(1, 0, 2);
        metric.set(1, 2, Ratio::integer(-1));
        let conformal = text(&["e1", "eo", "ei"], metric);
        assert_eq!(conformal, "e1² = 1, eo² = ei² = 0, eo·ei = -1");
    }
}
