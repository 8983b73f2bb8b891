//! Elements of an algebra as lists of coefficients, for code that is generic over types.

use crate::scalar::Ring;

/// A type that `algebra!` has declared, seen as coefficients by blade.
///
/// A blade is numbered by its basis vectors: bit `k` stands for the `k`-th, and the blade is their
/// outer product in rising order. Tests, references and conversions use this trait and so are
/// written once for all types.
///
/// ```
/// use ga_runtime::{Element, cga3::Point};
/// let p = Point::new(1.0, 2.0, 2.0);
/// // e1, eo and ei of the conformal point x + eo + ½x² ei.
/// assert_eq!(
///     (
///         p.coefficient(0b1),
///         p.coefficient(0b1000),
///         p.coefficient(0b10000)
///     ),
///     (1.0, 1.0, 4.5)
/// );
/// assert_eq!(p.coefficient(0b11), 0.0);
/// ```
pub trait Element: Copy {
    /// The coefficients.
    type Scalar: Ring;
    /// The blades that the type has, stored, constant or derived.
    const BLADES: &'static [usize];
    /// Whether every member satisfies `M ~M = 1`.
    const IS_UNIT_VERSOR: bool;
    /// Whether any stored coefficients make a member.
    const IS_FREE: bool;
    /// The inner products of the basis vectors as (numerator, denominator).
    const METRIC: &'static [&'static [(i64, i64)]];

    /// The coefficient of a blade; zero for one that the type does not have.
    fn coefficient(&self, blade: usize) -> Self::Scalar;

    /// The same element over another scalar, each coefficient converted by itself: to `f32` for
    /// drawing, to lanes, to constants of dual numbers. The target is the same type with the other
    /// scalar. A unit versor remains one up to rounding of the new scalar.
    ///
    /// ```
    /// use ga_runtime::{Element, cga3::Point};
    /// let p: Point<f32> = Element::map(Point::new(1.0_f64, 2.0, 0.1), |x| x as f32);
    /// assert_eq!(p.coordinates(), [1.0, 2.0, 0.1]);
    /// ```
    #[inline]
    fn map<U: Element>(self, mut scalar: impl FnMut(Self::Scalar) -> U::Scalar) -> U
    where
        Self: Sized,
    {
        U::from_coefficients_unchecked(&mut |blade| scalar(self.coefficient(blade)))
    }

    /// The member whose stored coefficients the function returns. The caller must ensure that
    /// constant and derived blades and the facts of the type agree with it.
    fn from_coefficients_unchecked(coefficient: &mut dyn FnMut(usize) -> Self::Scalar) -> Self;
}
