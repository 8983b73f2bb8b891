//! Elements of an algebra as lists of coefficients, for code that is generic over types.

mod emitted;
mod membership;
mod normalized;
mod relative;
mod text;

pub use membership::NotMember;
pub use text::ParseElementError;

#[doc(hidden)]
pub use membership::are_within;
#[doc(hidden)]
pub use normalized::{divided_by_largest, largest, scaled_norm};
pub use relative::Relative;
#[doc(hidden)]
pub use text::{parse, write};

use alloc::format;
use core::iter::FusedIterator;

use crate::dense::blade_name;
use crate::scalar::{Mask, Real, Ring, Select};

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
    /// The name of the type.
    const NAME: &'static str;
    /// The names of the basis vectors of the algebra.
    const BASIS: &'static [&'static str];
    /// The blades that the type has, stored, constant or derived.
    const BLADES: &'static [usize];
    /// The names of these blades as declared, in the same order; `scalar` for the blade 0.
    const NAMES: &'static [&'static str];
    /// The blades whose declared name orders the vectors with the opposite sign, as `e31` for
    /// e1∧e3. The coefficient by that name is minus that of the blade.
    const REVERSED: &'static [usize] = &[];
    /// Whether every member satisfies `M ~M = 1`.
    const IS_UNIT_VERSOR: bool;
    /// Whether any stored coefficients make a member.
    const IS_FREE: bool;
    /// The inner products of the basis vectors as (numerator, denominator).
    const METRIC: &'static [&'static [(i64, i64)]];

    /// The coefficient of a blade; zero for one that the type does not have.
    fn coefficient(&self, blade: usize) -> Self::Scalar;

    /// The same element over another scalar, each number converted by itself: to `f32` for
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
        U::from_numbers(&mut |place| scalar(self.number(place)))
    }

    /// One of the numbers that the element is made of, by its place: those of its parameters for a
    /// type that has some, and otherwise the coefficients of its blades.
    ///
    /// ```
    /// use ga_runtime::{Element, cga3::{Point, Sphere}};
    /// let sphere = Sphere::from_centre_radius(Point::new(5.0, 0.0, 0.0), 0.5);
    /// // The weight, the coefficients of the centre, the squared radius.
    /// assert_eq!((sphere.number(0), sphere.number(1), sphere.number(6)), (1.0, 5.0, 0.25));
    /// ```
    #[inline]
    fn number(&self, place: usize) -> Self::Scalar {
        let blade = Self::BLADES.get(place);
        blade.map_or_else(Self::Scalar::zero, |blade| self.coefficient(*blade))
    }

    /// The element that is made of some numbers, by their places. The caller must ensure that they
    /// are those of a member.
    #[inline]
    fn from_numbers(number: &mut dyn FnMut(usize) -> Self::Scalar) -> Self {
        Self::from_coefficients_unchecked(&mut |blade| {
            let place = Self::BLADES.iter().position(|other| *other == blade);
            place.map_or_else(Self::Scalar::zero, &mut *number)
        })
    }

    /// The member whose stored coefficients the function returns. The caller must ensure that
    /// constant and derived blades and the facts of the type agree with it.
    fn from_coefficients_unchecked(coefficient: &mut dyn FnMut(usize) -> Self::Scalar) -> Self;

    /// The coefficients of all blades of the type with their names.
    #[inline]
    fn coefficients(self) -> Coefficients<Self> {
        Coefficients::new(self)
    }

    /// The coefficient of the blade of that name; `None` where the type has no such blade.
    #[inline]
    fn coefficient_of(self, name: &str) -> Option<Self::Scalar> {
        let mut coefficients = self.coefficients();
        coefficients.find_map(|(other, value)| (other == name).then_some(value))
    }

    /// Whether every coefficient is neither infinite nor NaN; for lanes, one mask entry per lane.
    #[inline]
    fn is_finite(self) -> <Self::Scalar as Select>::Mask
    where
        Self::Scalar: Real,
    {
        let everywhere = <Self::Scalar as Select>::Mask::splat(true);
        Self::BLADES.iter().fold(everywhere, |finite, &blade| {
            finite & self.coefficient(blade).is_finite()
        })
    }

    /// Whether the facts of the type hold: each coefficient of `M ~M − 1` of a unit versor, and
    /// each Plücker relation of a blade, is at most as large as the tolerance times the terms that
    /// cancel in it. True for types whose facts hold for all coefficients.
    #[inline]
    fn satisfies_facts(&self, _tolerance: Self::Scalar) -> bool
    where
        Self::Scalar: Real<Mask = bool>,
    {
        true
    }

    /// The member of this type that another element is, up to a tolerance relative to its largest
    /// coefficient. `TryFrom` does the same with a tolerance of 1024 ε: 2·10⁻¹³ for `f64`, 10⁻⁴ for
    /// `f32`.
    ///
    /// # Errors
    /// [`NotMember`] with the coefficient that is different.
    ///
    /// ```
    /// use ga_runtime::cga3::{Point, RoundVector};
    /// let nearly = RoundVector::new(1.0, 2.0, 2.0, 1.0, 4.5 + 1e-9);
    /// assert_eq!(Point::try_from_element(nearly, 1e-6), Ok(Point::new(1.0, 2.0, 2.0)));
    /// let error = Point::try_from(nearly * 2.0).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "not a Point: the coefficient of eo is 2.0 instead of 1.0"
    /// );
    /// ```
    #[inline]
    fn try_from_element<U: Element<Scalar = Self::Scalar>>(
        element: U,
        tolerance: Self::Scalar,
    ) -> Result<Self, NotMember>
    where
        Self::Scalar: Real<Mask = bool>,
    {
        member(U::BLADES, &|blade| element.coefficient(blade), tolerance)
    }
}

/// The coefficients of an element with the names of their blades, in the order of the declaration:
/// see [`Element::coefficients`].
///
/// ```
/// use ga_runtime::cga3::Point;
/// let terms: Vec<_> = Point::new(1.0, 2.0, 2.0).coefficients().collect();
/// assert_eq!(terms, [("e1", 1.0), ("e2", 2.0), ("e3", 2.0), ("eo", 1.0), ("ei", 4.5)]);
/// ```
#[derive(Clone, Debug)]
pub struct Coefficients<T> {
    element: T,
    next: usize,
}

impl<T: Element> Coefficients<T> {
    #[inline]
    fn new(element: T) -> Self {
        Self { element, next: 0 }
    }
}

impl<T: Element> Iterator for Coefficients<T> {
    type Item = (&'static str, T::Scalar);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let (&blade, &name) = (T::BLADES.get(self.next)?, T::NAMES.get(self.next)?);
        self.next += 1;
        let value = self.element.coefficient(blade);
        let is_reversed = T::REVERSED.contains(&blade);
        Some((name, if is_reversed { -value } else { value }))
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let rest = T::BLADES.len() - self.next;
        (rest, Some(rest))
    }
}

impl<T: Element> ExactSizeIterator for Coefficients<T> {}
impl<T: Element> FusedIterator for Coefficients<T> {}

/// The member of `T` with these coefficients on these blades and zero on all others, up to a
/// tolerance relative to the largest coefficient.
pub(crate) fn member<T: Element>(
    blades: &[usize],
    coefficient: &dyn Fn(usize) -> T::Scalar,
    tolerance: T::Scalar,
) -> Result<T, NotMember>
where
    T::Scalar: Real<Mask = bool>,
{
    let type_name = T::NAME;
    let mut largest = T::Scalar::zero();
    for &blade in blades {
        let size = coefficient(blade).abs();
        if !size.is_finite() {
            let blade = blade_name(T::BASIS, blade);
            return Err(NotMember::NotFinite { type_name, blade });
        }
        largest = largest.max(size);
    }
    let allowed = tolerance * largest;
    let member = T::from_coefficients_unchecked(&mut |blade| coefficient(blade));
    for &blade in blades.iter().chain(T::BLADES) {
        let (found, expected) = (coefficient(blade), member.coefficient(blade));
        if !are_within(&[found - expected], allowed) {
            return Err(NotMember::Coefficient {
                type_name,
                blade: blade_name(T::BASIS, blade),
                found: format!("{found:?}"),
                expected: format!("{expected:?}"),
            });
        }
    }
    if !member.satisfies_facts(tolerance) {
        return Err(if T::IS_UNIT_VERSOR {
            NotMember::NotUnitVersor { type_name }
        } else {
            NotMember::NotBlade { type_name }
        });
    }
    Ok(member)
}

/// The tolerance of `TryFrom` and `FromStr`, relative to the largest coefficient.
pub fn default_tolerance<S: Real>() -> S {
    S::epsilon() * S::from_integer(1024)
}

/// The element whose numbers are chosen by a mask.
#[inline]
pub fn select<T: Element<Scalar: Real>>(
    mask: <T::Scalar as Select>::Mask,
    if_true: T,
    if_false: T,
) -> T {
    T::from_numbers(&mut |place| {
        T::Scalar::select(mask, if_true.number(place), if_false.number(place))
    })
}

/// The part of one grade, in a type with all blades of the element.
#[inline]
pub fn grade<T: Element, U: Element<Scalar = T::Scalar>>(element: T, grade: usize) -> U {
    U::from_coefficients_unchecked(&mut |blade| {
        if blade.count_ones() as usize == grade {
            element.coefficient(blade)
        } else {
            T::Scalar::zero()
        }
    })
}

/// The element 1 of a type that has it.
#[inline]
pub fn one<T: Element>() -> T {
    T::from_coefficients_unchecked(&mut |blade| match blade {
        0 => T::Scalar::one(),
        _ => T::Scalar::zero(),
    })
}
