//! The conditions at the ends of a spline.

use super::value::Value;

/// The conditions at the ends of a cubic spline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends<V> {
    /// The second derivative is 0 at both ends.
    Natural,
    /// The slopes at the first and the last key, per unit of time.
    Slopes([V; 2]),
    /// The third derivative is continuous at the second key and at the last but one, so the first
    /// two pieces are one polynomial, and so are the last two. Three keys give a parabola.
    NotAKnot,
    /// The first two derivatives at the end are those at the start; the values must be equal. The
    /// curve repeats.
    Periodic,
}

impl<V: Value> Ends<V> {
    /// The slope 0 at both ends.
    #[must_use]
    pub fn clamped() -> Self {
        Self::Slopes([V::zero(); 2])
    }

    /// The kind of these conditions, without their numbers.
    #[must_use]
    pub fn kind(&self) -> EndKind {
        match self {
            Self::Natural => EndKind::Natural,
            Self::Slopes(_) => EndKind::Slopes,
            Self::NotAKnot => EndKind::NotAKnot,
            Self::Periodic => EndKind::Periodic,
        }
    }
}

/// The kind of the conditions at the ends of a spline; see [`Ends`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndKind {
    /// [`Ends::Natural`].
    Natural,
    /// [`Ends::Slopes`].
    Slopes,
    /// [`Ends::NotAKnot`].
    NotAKnot,
    /// [`Ends::Periodic`].
    Periodic,
}
