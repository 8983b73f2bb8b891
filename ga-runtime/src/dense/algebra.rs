//! A geometric algebra: basis vectors, their metric and their names.

use alloc::format;

use crate::Element;
#[cfg(not(target_has_atomic = "ptr"))]
use alloc::rc::Rc as Arc;
use alloc::string::String;
#[cfg(target_has_atomic = "ptr")]
use alloc::sync::Arc;
use alloc::vec;
use alloc::vec::Vec;

use super::DenseError;
use super::blade::{MAXIMUM_DIMENSION, blade_name};
use crate::scalar::{Field, Ring};

/// A geometric algebra over the scalars `S`, given by the inner products of its basis vectors.
///
/// Multivectors are created by methods of their algebra. Clones share the definition, so that
/// cloning is cheap. Two algebras are equal if their metrics are.
///
/// ```
/// use ga_runtime::dense::Algebra;
/// # fn main() -> Result<(), ga_runtime::dense::DenseError> {
/// let space = Algebra::with_signature(3, 0, 0)?;
/// let a = space.vector([1.0, 2.0, 3.0])?;
/// let plane = space.blade(0b011)?;
/// assert_eq!((&a ^ &plane).to_string(), "3 e123");
/// assert_eq!((&a * &plane).to_string(), "-2 e1 + e2 + 3 e123");
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Algebra<S> {
    definition: Arc<Definition<S>>,
}

#[derive(Clone, Debug)]
struct Definition<S> {
    metric: Vec<Vec<S>>,
    names: Vec<String>,
    /// The determinant of the metric.
    determinant: S,
}

impl<S: Ring> Algebra<S> {
    /// The largest number of basis vectors.
    pub const MAXIMUM_DIMENSION: usize = MAXIMUM_DIMENSION;

    /// The algebra in which `metric[i][j]` is the inner product of the basis vectors i and j, named
    /// e1, e2 and so on.
    ///
    /// Whether the metric is singular, and so what dual means, is decided by whether its
    /// determinant has an inverse; with floating-point scalars the entries should therefore be
    /// small integers or fractions of powers of two.
    ///
    /// # Errors
    ///
    /// [`DenseError::TooManyVectors`], [`DenseError::NotSquare`] or [`DenseError::NotSymmetric`],
    /// which is also the error for an entry that is not a number.
    pub fn new(metric: Vec<Vec<S>>) -> Result<Self, DenseError> {
        let dimension = metric.len();
        if dimension > MAXIMUM_DIMENSION {
            return Err(DenseError::TooManyVectors { dimension });
        }
        for (row, entries) in metric.iter().enumerate() {
            if entries.len() != dimension {
                return Err(DenseError::NotSquare {
                    row,
                    entries: entries.len(),
                    dimension,
                });
            }
        }
        for (row, entries) in metric.iter().enumerate() {
            for (column, &entry) in entries.iter().enumerate().take(row + 1) {
                // Unlike `!=`, this refuses NaN on the diagonal as well.
                let symmetric = entry == metric[column][row];
                if !symmetric {
                    return Err(DenseError::NotSymmetric { row, column });
                }
            }
        }
        let names = (1..=dimension).map(|number| format!("e{number}")).collect();
        let definition = Definition {
            metric,
            names,
            determinant: S::zero(),
        };
        let unmeasured = Self {
            definition: Arc::new(definition.clone()),
        };
        // The blade of all vectors times its reverse is the determinant of their inner products.
        let pseudoscalar = unmeasured.pseudoscalar();
        let determinant = pseudoscalar.scalar_product(&pseudoscalar.reverse());
        Ok(Self {
            definition: Arc::new(Definition {
                determinant,
                ..definition
            }),
        })
    }

    /// The algebra of an orthogonal basis: first `positive` vectors of square 1, then `negative` of
    /// square −1, then `null` of square 0.
    ///
    /// # Errors
    ///
    /// [`DenseError::TooManyVectors`].
    pub fn with_signature(
        positive: usize,
        negative: usize,
        null: usize,
    ) -> Result<Self, DenseError> {
        let dimension = positive.saturating_add(negative).saturating_add(null);
        if dimension > MAXIMUM_DIMENSION {
            return Err(DenseError::TooManyVectors { dimension });
        }
        let mut metric = vec![vec![S::zero(); dimension]; dimension];
        for (vector, row) in metric.iter_mut().enumerate() {
            row[vector] = if vector < positive {
                S::one()
            } else if vector < positive + negative {
                -S::one()
            } else {
                S::zero()
            };
        }
        Self::new(metric)
    }

    /// The same algebra with names for its basis vectors, for output.
    ///
    /// # Errors
    ///
    /// [`DenseError::NameCount`], or [`DenseError::UnusableName`] for a name that is empty or given
    /// twice.
    pub fn with_names<N: Into<String>>(
        &self,
        names: impl IntoIterator<Item = N>,
    ) -> Result<Self, DenseError> {
        let names: Vec<String> = names.into_iter().map(Into::into).collect();
        if names.len() != self.dimension() {
            return Err(DenseError::NameCount {
                expected: self.dimension(),
                found: names.len(),
            });
        }
        for (vector, name) in names.iter().enumerate() {
            if name.is_empty() || names[..vector].contains(name) {
                return Err(DenseError::UnusableName {
                    vector,
                    name: name.clone(),
                });
            }
        }
        let definition = Definition {
            names,
            ..(*self.definition).clone()
        };
        Ok(Self {
            definition: Arc::new(definition),
        })
    }

    /// The algebra of a declared type, with its metric and the names of its basis vectors.
    ///
    /// ```
    /// use ga_runtime::{cga3, dense::Algebra};
    /// # fn main() -> Result<(), ga_runtime::dense::DenseError> {
    /// let algebra = Algebra::<f64>::of::<cga3::Point<f64>>()?;
    /// let point = algebra.element(&cga3::Point::new(1.0, 0.0, 2.0));
    /// assert_eq!(point.to_string(), "e1 + 2 e3 + eo + 2.5 ei");
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`declared`](Self::declared). A type of `algebra!` causes none.
    pub fn of<T: Element>() -> Result<Self, DenseError>
    where
        S: Field,
    {
        Self::declared(T::METRIC, T::BASIS)
    }

    /// The algebra of a metric given as fractions and of the names of its basis vectors: `METRIC`
    /// and `BASIS` of the module that `algebra!` emits.
    ///
    /// # Errors
    ///
    /// Those of [`new`](Self::new) and [`with_names`](Self::with_names).
    pub fn declared(metric: &[&[(i64, i64)]], basis: &[&str]) -> Result<Self, DenseError>
    where
        S: Field,
    {
        let entry = |&(numerator, denominator): &(i64, i64)| S::from_ratio(numerator, denominator);
        let rows = metric.iter().map(|row| row.iter().map(entry).collect());
        Self::new(rows.collect())?.with_names(basis.iter().copied())
    }

    /// The number of basis vectors, n.
    pub fn dimension(&self) -> usize {
        self.definition.metric.len()
    }

    /// The number of basis blades, 2ⁿ.
    pub fn size(&self) -> usize {
        1 << self.dimension()
    }

    /// The inner products of the basis vectors.
    pub fn metric(&self) -> &[Vec<S>] {
        &self.definition.metric
    }

    /// The determinant of the metric, which is I ~I for the pseudoscalar I.
    pub fn determinant(&self) -> S {
        self.definition.determinant
    }

    /// The names of the basis vectors.
    pub fn names(&self) -> &[String] {
        &self.definition.names
    }
}

impl<S> Algebra<S> {
    /// The name of a basis blade: the names of its vectors, joined after the common prefix of all
    /// names of the algebra, such as `e12` for `e1` and `e2`; `1` for the scalar. An underscore
    /// separates the vectors where one of the names has more than one character after that prefix,
    /// as in `e1_10`.
    ///
    /// Bits beyond the basis vectors of the algebra are ignored.
    pub fn blade_name(&self, blade: usize) -> String {
        blade_name(&self.definition.names, blade)
    }
}

impl<S: PartialEq> PartialEq for Algebra<S> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.definition, &other.definition)
            || self.definition.metric == other.definition.metric
    }
}
