//! `+ − * ^ | &` on multivectors and on references to them.

use core::ops::{Add, BitAnd, BitOr, BitXor, Mul, Neg, Sub};

use super::Multivector;
use crate::scalar::{Field, Ring};

macro_rules! implement_operator {
    ($scalar:ident: $operator:ident $method:ident, $function:expr) => {
        impl<S: $scalar> $operator<&Multivector<S>> for &Multivector<S> {
            type Output = Multivector<S>;
            fn $method(self, other: &Multivector<S>) -> Multivector<S> {
                $function(self, other)
            }
        }

        impl<S: $scalar> $operator<Multivector<S>> for &Multivector<S> {
            type Output = Multivector<S>;
            fn $method(self, other: Multivector<S>) -> Multivector<S> {
                $function(self, &other)
            }
        }

        impl<S: $scalar> $operator<&Multivector<S>> for Multivector<S> {
            type Output = Multivector<S>;
            fn $method(self, other: &Multivector<S>) -> Multivector<S> {
                $function(&self, other)
            }
        }

        impl<S: $scalar> $operator<Multivector<S>> for Multivector<S> {
            type Output = Multivector<S>;
            fn $method(self, other: Multivector<S>) -> Multivector<S> {
                $function(&self, &other)
            }
        }
    };
}

implement_operator!(Ring: Add add, |a: &Multivector<S>, b| a.combine(b, |x, y| x + y));
implement_operator!(Ring: Sub sub, |a: &Multivector<S>, b| a.combine(b, |x, y| x - y));
implement_operator!(Ring: Mul mul, Multivector::geometric);
implement_operator!(Ring: BitXor bitxor, Multivector::wedge);
implement_operator!(Ring: BitOr bitor, Multivector::left_contraction);
implement_operator!(Field: BitAnd bitand, Multivector::vee);

impl<S: Ring> Neg for &Multivector<S> {
    type Output = Multivector<S>;
    fn neg(self) -> Multivector<S> {
        self.map(|_, value| -value)
    }
}

impl<S: Ring> Neg for Multivector<S> {
    type Output = Multivector<S>;
    fn neg(self) -> Multivector<S> {
        -&self
    }
}
