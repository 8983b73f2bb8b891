//! Vector spaces with a metric: Euclidean, indefinite, degenerate and skew ones.

use ga_compiler::check_types;
use ga_compiler::define::Definition;

/// The names of the basis vectors, how the metric is declared, and its symmetric matrix.
pub(super) struct Algebra {
    name: &'static str,
    basis: &'static [&'static str],
    metric: &'static str,
    matrix: &'static [&'static [f64]],
}

pub(super) const ALGEBRAS: [Algebra; 10] = [
    Algebra {
        name: "plane",
        basis: &["e1", "e2"],
        metric: "signature 2, 0;",
        matrix: &[&[1.0, 0.0], &[0.0, 1.0]],
    },
    Algebra {
        name: "space",
        basis: &["e1", "e2", "e3"],
        metric: "signature 3, 0;",
        matrix: &[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, 0.0, 1.0]],
    },
    Algebra {
        name: "line",
        basis: &["e1"],
        metric: "signature 1, 0;",
        matrix: &[&[1.0]],
    },
    Algebra {
        name: "negative",
        basis: &["e1", "e2"],
        metric: "signature 0, 2;",
        matrix: &[&[-1.0, 0.0], &[0.0, -1.0]],
    },
    Algebra {
        name: "hyperbolic",
        basis: &["e1", "e2"],
        metric: "signature 1, 1;",
        matrix: &[&[1.0, 0.0], &[0.0, -1.0]],
    },
    Algebra {
        name: "spacetime",
        basis: &["e1", "e2", "e3"],
        metric: "signature 1, 2;",
        matrix: &[&[1.0, 0.0, 0.0], &[0.0, -1.0, 0.0], &[0.0, 0.0, -1.0]],
    },
    Algebra {
        name: "degenerate",
        basis: &["e1", "e2", "e3"],
        metric: "signature 2, 0, 1;",
        matrix: &[&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, 0.0, 0.0]],
    },
    Algebra {
        name: "degenerate_and_indefinite",
        basis: &["e1", "e2", "e3"],
        metric: "signature 1, 1, 1;",
        matrix: &[&[1.0, 0.0, 0.0], &[0.0, -1.0, 0.0], &[0.0, 0.0, 0.0]],
    },
    Algebra {
        name: "null_basis",
        basis: &["e1", "eo", "ei"],
        metric: "metric e1*e1 = 1, eo*ei = -1;",
        matrix: &[&[1.0, 0.0, 0.0], &[0.0, 0.0, -1.0], &[0.0, -1.0, 0.0]],
    },
    Algebra {
        name: "skew",
        basis: &["a", "b"],
        metric: "metric a*a = 2, a*b = 1, b*b = 3;",
        matrix: &[&[2.0, 1.0], &[1.0, 3.0]],
    },
];

/// An algebra with its types, and the metric by which the interpreter computes.
pub(super) struct Space {
    pub(super) name: &'static str,
    pub(super) definition: Definition,
    matrix: &'static [&'static [f64]],
}

impl Space {
    pub(super) fn new(algebra: &Algebra) -> Self {
        let Algebra {
            name,
            basis,
            metric,
            matrix,
        } = algebra;
        let vectors = basis.join(", ");
        let declaration =
            format!("pub mod {name} {{ basis {vectors}; {metric} struct Vector {{ {vectors} }} }}");
        let definition = check_types(declaration.parse().expect("tokens"), quote::quote! { r });
        Self {
            name,
            definition: definition.expect("a declaration"),
            matrix,
        }
    }

    pub(super) fn dimension(&self) -> usize {
        self.matrix.len()
    }

    /// The inner product, and the sum of the sizes of its terms.
    pub(super) fn inner(&self, v: &[f64], w: &[f64]) -> (f64, f64) {
        let (mut sum, mut size) = (0.0, 0.0_f64);
        for (row, x) in self.matrix.iter().zip(v) {
            for (entry, y) in row.iter().zip(w) {
                sum += entry * x * y;
                size += (entry * x * y).abs();
            }
        }
        (sum, size)
    }
}
