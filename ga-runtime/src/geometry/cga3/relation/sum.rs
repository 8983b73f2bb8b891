//! Sums of rounds and flats, which are one or the other by what their coefficients say.

use crate::cga3::{
    Bivector, Circle, FlatPoint, Line, Plane, PointPair, Quadvector, Sphere, Trivector,
};
use crate::element::Element;
use crate::scalar::Real;

macro_rules! sums {
    ($($Sum:ident: $Round:ident or $Flat:ident without $($weight:ident)*;)*) => {$(
        impl<S: Real> $Sum<S> {
            /// Whether it is a flat, and what it is as a flat and as a round.
            #[inline]
            pub(super) fn flat_or_round(self) -> (S::Mask, $Flat<S>, $Round<S>) {
                let read = |blade| self.coefficient(blade);
                (
                    $(self.$weight.is_zero())&*,
                    $Flat::from_coefficients_unchecked(&mut { read }),
                    $Round::from_coefficients_unchecked(&mut { read }),
                )
            }
        }
    )*};
}

sums! {
    Bivector: PointPair or FlatPoint without e1o e2o e3o;
    Trivector: Circle or Line without e123 e12o e13o e23o;
    Quadvector: Sphere or Plane without e123o;
}
