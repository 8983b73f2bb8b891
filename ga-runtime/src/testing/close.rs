//! Equality up to rounding.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

use crate::Element;
use crate::dense::Multivector;
use crate::scalar::Ring;

/// Asserts that two values agree up to rounding: that no two coefficients differ by more than the
/// tolerance times the largest absolute value of all coefficients on either side.
///
/// - `assert_close!(a, b)` takes [`Coefficients::TOLERANCE`] of the type: 10⁻¹² over `f64`, 10⁻⁵
///   over `f32`.
/// - `assert_close!(a, b, tolerance)` takes another.
/// - `assert_close!(a, b, tolerance, scale)` measures relative to the given scale instead of the
///   largest coefficient. That is the form for results that should be zero, where `scale` is the
///   size of the terms that cancel.
///
/// A coefficient that is infinite or NaN fails, and so do values with different numbers of
/// coefficients. The message names the coefficient of the largest deviation. See
/// [`Coefficients`](crate::testing::Coefficients) for what can be compared.
///
/// ```
/// use ga_runtime::testing::assert_close;
/// assert_close!(0.1 + 0.2, 0.3);
/// assert_close!([1.0, 1e-9], [1.0, 0.0], 1e-8);
/// assert_close!(std::f64::consts::PI.sin(), 0.0, 1e-15, 1.0);
/// ```
///
/// Elements of an algebra are compared in all blades of the algebra, so that a motor can be
/// compared with an even multivector:
///
/// ```
/// use ga_runtime::cga3::{Even, Motor, Rotor};
/// use ga_runtime::testing::assert_close;
/// let third = Rotor::from_axis_angle([1.0, 1.0, 1.0], std::f64::consts::TAU / 3.0).unwrap();
/// assert_close!(third * third * third, -Rotor::<f64>::default());
/// assert_close!(Motor::from(third), Even::from(third));
/// ```
///
/// ```should_panic
/// use ga_runtime::testing::assert_close;
/// assert_close!(vec![[0.0, 1.0], [f64::NAN, 2.0]], vec![[0.0, 1.0], [f64::NAN, 2.0]]);
/// ```
#[macro_export]
macro_rules! assert_close {
    ($left:expr, $right:expr $(,)?) => {
        $crate::assert_close!(@ $left, $right, None, None)
    };
    ($left:expr, $right:expr, $tolerance:expr $(,)?) => {
        $crate::assert_close!(@ $left, $right, Some($tolerance), None)
    };
    ($left:expr, $right:expr, $tolerance:expr, $scale:expr $(,)?) => {
        $crate::assert_close!(@ $left, $right, Some($tolerance), Some($scale))
    };
    (@ $left:expr, $right:expr, $tolerance:expr, $scale:expr) => {
        match (&$left, &$right) {
            (left, right) => {
                if let Err(deviation) = $crate::testing::check_close(left, right, $tolerance, $scale) {
                    panic!(
                        "{} is not close to {}: {deviation}",
                        stringify!($left),
                        stringify!($right),
                    );
                }
            }
        }
    };
}

/// Compares as [`assert_close!`] does, and returns an error instead of panicking.
///
/// Without a tolerance the larger [`Coefficients::TOLERANCE`] of the two types is taken, without a
/// scale the largest absolute value of all coefficients.
///
/// # Errors
///
/// The [`Deviation`] of the worst coefficient.
pub fn check_close<A, B>(
    left: &A,
    right: &B,
    tolerance: Option<f64>,
    scale: Option<f64>,
) -> Result<(), Deviation>
where
    A: Coefficients + ?Sized,
    B: Coefficients + ?Sized,
{
    let (mut left_values, mut right_values) = (Vec::new(), Vec::new());
    left.append_to(&mut left_values);
    right.append_to(&mut right_values);
    if left_values.len() != right_values.len() {
        return Err(Deviation::Count {
            left: left_values.len(),
            right: right_values.len(),
        });
    }
    for (index, (&left_value, &right_value)) in left_values.iter().zip(&right_values).enumerate() {
        if !(left_value.is_finite() && right_value.is_finite()) {
            return Err(Deviation::NotFinite {
                coefficient: name_of(left, index),
                left: left_value,
                right: right_value,
            });
        }
    }
    let scale = scale.unwrap_or_else(|| {
        left_values
            .iter()
            .chain(&right_values)
            .fold(0.0, |largest: f64, value| largest.max(value.abs()))
    });
    let tolerance = tolerance.unwrap_or(A::TOLERANCE.max(B::TOLERANCE));
    let worst = left_values
        .iter()
        .zip(&right_values)
        .map(|(left_value, right_value)| (left_value - right_value).abs())
        .enumerate()
        .max_by(|(_, a), (_, b)| a.total_cmp(b));
    let Some((index, difference)) = worst else {
        return Ok(());
    };
    // Written in this way, a tolerance that is NaN fails too.
    let close = difference <= tolerance * scale;
    if close {
        return Ok(());
    }
    Err(Deviation::TooLarge {
        coefficient: name_of(left, index),
        left: left_values[index],
        right: right_values[index],
        relative: difference / scale,
        tolerance,
    })
}

fn name_of(value: &(impl Coefficients + ?Sized), index: usize) -> String {
    match value.coefficient_name(index) {
        name if name.is_empty() => String::from("the value"),
        name => name,
    }
}

/// What [`assert_close!`] compares: a value as a list of real numbers, each with a name.
///
/// Numbers implement it, elements of an algebra, dense multivectors, and arrays, slices and vectors
/// of all of these, also nested ones. A type of your own needs two methods:
///
/// ```
/// use ga_runtime::testing::{Coefficients, assert_close};
///
/// struct Circle {
///     center: [f64; 2],
///     radius: f64,
/// }
///
/// impl Coefficients for Circle {
///     const TOLERANCE: f64 = f64::TOLERANCE;
///
///     fn append_to(&self, list: &mut Vec<f64>) {
///         self.center.append_to(list);
///         self.radius.append_to(list);
///     }
///
///     fn coefficient_name(&self, index: usize) -> String {
///         ["x", "y", "radius"][index].to_owned()
///     }
/// }
///
/// assert_close!(
///     Circle {
///         center: [0.0, 1.0],
///         radius: 0.1 + 0.2
///     },
///     Circle {
///         center: [0.0, 1.0],
///         radius: 0.3
///     }
/// );
/// ```
pub trait Coefficients {
    /// The relative deviation that rounding may cause in a short computation.
    const TOLERANCE: f64;

    /// Appends all coefficients, in a fixed order.
    fn append_to(&self, list: &mut Vec<f64>);

    /// The name of the coefficient of this index in that order, for messages; empty for a number,
    /// which has only one. It is called for existing coefficients only.
    fn coefficient_name(&self, index: usize) -> String;
}

/// Why two values are not close.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Deviation {
    /// One value has more coefficients than the other.
    Count {
        /// The number of coefficients on the left.
        left: usize,
        /// The number of coefficients on the right.
        right: usize,
    },
    /// A coefficient is infinite or not a number.
    NotFinite {
        /// The name of the coefficient.
        coefficient: String,
        /// Its value on the left.
        left: f64,
        /// Its value on the right.
        right: f64,
    },
    /// A coefficient deviates by more than the tolerance; the worst of them if there are several.
    TooLarge {
        /// The name of the coefficient.
        coefficient: String,
        /// Its value on the left.
        left: f64,
        /// Its value on the right.
        right: f64,
        /// The deviation relative to the scale.
        relative: f64,
        /// The relative deviation that was allowed.
        tolerance: f64,
    },
}

impl fmt::Display for Deviation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count { left, right } => {
                write!(
                    formatter,
                    "{left} coefficients on the left, {right} on the right"
                )
            }
            Self::NotFinite {
                coefficient,
                left,
                right,
            } => {
                write!(
                    formatter,
                    "{coefficient} is {left:?} on the left, {right:?} on the right"
                )
            }
            Self::TooLarge {
                coefficient,
                left,
                right,
                relative,
                tolerance,
            } => write!(
                formatter,
                "{coefficient} is {left:?} on the left, {right:?} on the right, \
                 a relative deviation of {relative:.1e} where {tolerance:.1e} is allowed"
            ),
        }
    }
}

impl core::error::Error for Deviation {}

macro_rules! implement_number {
    ($type:ty, $tolerance:expr) => {
        impl Coefficients for $type {
            const TOLERANCE: f64 = $tolerance;

            fn append_to(&self, list: &mut Vec<f64>) {
                list.push(f64::from(*self));
            }

            fn coefficient_name(&self, _index: usize) -> String {
                String::new()
            }
        }
    };
}
implement_number!(f64, 1e-12);
implement_number!(f32, 1e-5);

impl<T: Coefficients> Coefficients for [T] {
    const TOLERANCE: f64 = T::TOLERANCE;

    fn append_to(&self, list: &mut Vec<f64>) {
        for element in self {
            element.append_to(list);
        }
    }

    fn coefficient_name(&self, index: usize) -> String {
        let mut coefficients = Vec::new();
        let mut before = 0;
        for (position, element) in self.iter().enumerate() {
            element.append_to(&mut coefficients);
            if index < coefficients.len() {
                let name = element.coefficient_name(index - before);
                return match name.chars().next() {
                    None | Some('[') => format!("[{position}]{name}"),
                    Some(_) => format!("[{position}].{name}"),
                };
            }
            before = coefficients.len();
        }
        format!("[{index}]")
    }
}

impl<T: Coefficients, const N: usize> Coefficients for [T; N] {
    const TOLERANCE: f64 = T::TOLERANCE;

    fn append_to(&self, list: &mut Vec<f64>) {
        self.as_slice().append_to(list);
    }

    fn coefficient_name(&self, index: usize) -> String {
        self.as_slice().coefficient_name(index)
    }
}

impl<T: Coefficients> Coefficients for Vec<T> {
    const TOLERANCE: f64 = T::TOLERANCE;

    fn append_to(&self, list: &mut Vec<f64>) {
        self.as_slice().append_to(list);
    }

    fn coefficient_name(&self, index: usize) -> String {
        self.as_slice().coefficient_name(index)
    }
}

impl<S: Ring + Coefficients> Coefficients for Multivector<S> {
    const TOLERANCE: f64 = S::TOLERANCE;

    fn append_to(&self, list: &mut Vec<f64>) {
        self.coefficients().append_to(list);
    }

    fn coefficient_name(&self, index: usize) -> String {
        self.algebra().blade_name(index)
    }
}

/// All blades of the algebra in the order of their numbers, so that elements of different types can
/// be compared.
impl<T> Coefficients for T
where
    T: Element,
    T::Scalar: Coefficients,
{
    const TOLERANCE: f64 = <T::Scalar as Coefficients>::TOLERANCE;

    fn append_to(&self, list: &mut Vec<f64>) {
        for blade in 0..1 << T::METRIC.len() {
            self.coefficient(blade).append_to(list);
        }
    }

    fn coefficient_name(&self, index: usize) -> String {
        let vectors = T::METRIC.len();
        format!(
            "the coefficient of blade {index:#0width$b}",
            width = vectors + 2
        )
    }
}
