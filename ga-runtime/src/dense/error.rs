//! Errors in the definition of an algebra or of a multivector.

use alloc::string::String;
use core::fmt;

/// Why an [`Algebra`](super::Algebra) or a [`Multivector`](super::Multivector) could not be made.
///
/// Rows, columns, vectors and coefficients are numbered from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DenseError {
    /// More basis vectors than [`Algebra::MAXIMUM_DIMENSION`](super::Algebra::MAXIMUM_DIMENSION).
    TooManyVectors {
        /// The requested number of basis vectors.
        dimension: usize,
    },
    /// The number of entries in a row of the metric is not the number of its rows.
    NotSquare {
        /// The row.
        row: usize,
        /// Its number of entries.
        entries: usize,
        /// The number of rows.
        dimension: usize,
    },
    /// An entry of the metric differs from its mirror image, or is not a number.
    NotSymmetric {
        /// The row of the entry.
        row: usize,
        /// The column of the entry.
        column: usize,
    },
    /// The number of names is not the number of basis vectors.
    NameCount {
        /// The number of basis vectors.
        expected: usize,
        /// The number of names.
        found: usize,
    },
    /// A name that is empty or already the name of an earlier vector.
    UnusableName {
        /// The vector.
        vector: usize,
        /// Its name.
        name: String,
    },
    /// The number of coefficients is not that of the basis vectors, or of the basis blades.
    CoefficientCount {
        /// The number of basis vectors or blades.
        expected: usize,
        /// The number of coefficients.
        found: usize,
    },
    /// A blade with a vector that the algebra does not have.
    NoSuchBlade {
        /// The bitmask of the blade.
        blade: usize,
        /// The number of basis vectors.
        dimension: usize,
    },
    /// A basis blade that has been given a coefficient already.
    RepeatedBlade {
        /// The bitmask of the blade.
        blade: usize,
    },
}

impl fmt::Display for DenseError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooManyVectors { dimension } => write!(
                formatter,
                "an algebra of {dimension} basis vectors is too large, the maximum is {}",
                super::blade::MAXIMUM_DIMENSION
            ),
            Self::NotSquare {
                row,
                entries,
                dimension,
            } => {
                write!(
                    formatter,
                    "row {row} of the metric has {entries} entries instead of {dimension}"
                )
            }
            Self::NotSymmetric { row, column } => {
                write!(
                    formatter,
                    "the metric is not symmetric in row {row}, column {column}"
                )
            }
            Self::NameCount { expected, found } => {
                write!(formatter, "{found} names for {expected} basis vectors")
            }
            Self::UnusableName { vector, name } if name.is_empty() => {
                write!(formatter, "basis vector {vector} has an empty name")
            }
            Self::UnusableName { vector, name } => {
                write!(
                    formatter,
                    "basis vector {vector} has the name `{name}` of an earlier one"
                )
            }
            Self::CoefficientCount { expected, found } => {
                write!(formatter, "{found} coefficients instead of {expected}")
            }
            Self::NoSuchBlade { blade, dimension } => {
                write!(
                    formatter,
                    "blade {blade:#b} does not exist with {dimension} basis vectors"
                )
            }
            Self::RepeatedBlade { blade } => {
                write!(formatter, "blade {blade:#b} has two coefficients")
            }
        }
    }
}

impl core::error::Error for DenseError {}
