//! approx 0.5: comparisons with a tolerance for every type, those of your own algebras included.
//!
//! [`AbsDiffEq`], [`RelativeEq`] and [`UlpsEq`] compare each stored coefficient with its
//! counterpart, by the scalar's own trait and with its defaults; two values are close where all
//! coefficients are. So a tolerance applies to coefficients: for a [`Point`](crate::cga3::Point)
//! these are coordinates, for a [`Rotor`](crate::cga3::Rotor) cosine and sine of half the angle. A
//! versor and its negative are the same transformation but are not close to one another, and
//! multiples of a blade represent the same object but are not close either. Constant types have one
//! member and do not implement these traits. [`Affine`] maps are compared in the same way, entry by
//! entry.
//!
//! ```
//! use approx_05::{assert_abs_diff_eq, assert_abs_diff_ne, assert_relative_eq};
//! use ga_runtime::cga3::{Point, Rotor};
//!
//! let third = Rotor::from_axis_angle([1.0, 1.0, 1.0], std::f64::consts::TAU / 3.0).unwrap();
//! assert_abs_diff_eq!(third * third * third, -Rotor::default(), epsilon = 1e-15);
//! assert_abs_diff_ne!(third * third * third, Rotor::default());
//! assert_relative_eq!(
//!     third.transform(Point::new(1e9, 0.0, 0.0)),
//!     Point::new(0.0, 1e9, 0.0),
//!     epsilon = 1e-6
//! );
//! ```

use approx_05::{AbsDiffEq, RelativeEq, UlpsEq};

use crate::geometry::Affine;

/// Whether all entries of two maps are close.
fn all<S>(a: &Affine<S>, b: &Affine<S>, is_close: impl Fn(&S, &S) -> bool) -> bool {
    let linear = a.linear.iter().flatten().zip(b.linear.iter().flatten());
    let translation = a.translation.iter().zip(&b.translation);
    linear.chain(translation).all(|(x, y)| is_close(x, y))
}

impl<S: AbsDiffEq> AbsDiffEq for Affine<S>
where
    S::Epsilon: Clone,
{
    type Epsilon = S::Epsilon;

    fn default_epsilon() -> S::Epsilon {
        S::default_epsilon()
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: S::Epsilon) -> bool {
        all(self, other, |x, y| x.abs_diff_eq(y, epsilon.clone()))
    }
}

impl<S: RelativeEq> RelativeEq for Affine<S>
where
    S::Epsilon: Clone,
{
    fn default_max_relative() -> S::Epsilon {
        S::default_max_relative()
    }

    fn relative_eq(&self, other: &Self, epsilon: S::Epsilon, max_relative: S::Epsilon) -> bool {
        all(self, other, |x, y| {
            x.relative_eq(y, epsilon.clone(), max_relative.clone())
        })
    }
}

impl<S: UlpsEq> UlpsEq for Affine<S>
where
    S::Epsilon: Clone,
{
    fn default_max_ulps() -> u32 {
        S::default_max_ulps()
    }

    fn ulps_eq(&self, other: &Self, epsilon: S::Epsilon, max_ulps: u32) -> bool {
        all(self, other, |x, y| x.ulps_eq(y, epsilon.clone(), max_ulps))
    }
}

/// Emits the traits of approx for a declared type.
#[doc(hidden)]
#[macro_export]
macro_rules! __approximate {
    (constant $($description:tt)*) => {};
    (parameters $name:ident $text:literal { $($field:ident $place:tt $label:literal [$path:ty]),* }) => {
        $crate::__approximate! { by_fields $name { $($field [$path]),* } }
    };
    (by_fields $name:ident { $($field:ident [$path:ty]),* }) => {
        impl<S> $crate::__private::approx::AbsDiffEq for $name<S>
        where
            S: $crate::__private::approx::AbsDiffEq,
            S::Epsilon: ::core::clone::Clone,
        {
            type Epsilon = S::Epsilon;
            #[inline]
            fn default_epsilon() -> S::Epsilon {
                S::default_epsilon()
            }
            #[inline]
            fn abs_diff_eq(&self, other: &Self, epsilon: S::Epsilon) -> ::core::primitive::bool {
                $(<$path as $crate::__private::approx::AbsDiffEq>::abs_diff_eq(
                    &self.$field,
                    &other.$field,
                    ::core::clone::Clone::clone(&epsilon),
                ))&&*
            }
        }

        impl<S> $crate::__private::approx::RelativeEq for $name<S>
        where
            S: $crate::__private::approx::RelativeEq,
            S::Epsilon: ::core::clone::Clone,
        {
            #[inline]
            fn default_max_relative() -> S::Epsilon {
                S::default_max_relative()
            }
            #[inline]
            fn relative_eq(
                &self,
                other: &Self,
                epsilon: S::Epsilon,
                max_relative: S::Epsilon,
            ) -> ::core::primitive::bool {
                $(<$path as $crate::__private::approx::RelativeEq>::relative_eq(
                    &self.$field,
                    &other.$field,
                    ::core::clone::Clone::clone(&epsilon),
                    ::core::clone::Clone::clone(&max_relative),
                ))&&*
            }
        }

        impl<S> $crate::__private::approx::UlpsEq for $name<S>
        where
            S: $crate::__private::approx::UlpsEq,
            S::Epsilon: ::core::clone::Clone,
        {
            #[inline]
            fn default_max_ulps() -> ::core::primitive::u32 {
                S::default_max_ulps()
            }
            #[inline]
            fn ulps_eq(
                &self,
                other: &Self,
                epsilon: S::Epsilon,
                max_ulps: ::core::primitive::u32,
            ) -> ::core::primitive::bool {
                $(<$path as $crate::__private::approx::UlpsEq>::ulps_eq(
                    &self.$field,
                    &other.$field,
                    ::core::clone::Clone::clone(&epsilon),
                    max_ulps,
                ))&&*
            }
        }
    };
    ($role:ident $name:ident $text:literal { $($field:ident $place:tt $blade:literal),* } $one:tt) => {
        $crate::__approximate! { by_fields $name { $($field [S]),* } }
    };
}
