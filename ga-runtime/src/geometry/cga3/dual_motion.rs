//! Versors acting on dual forms.
//!
//! How a versor acts on a blade does not depend on what the blade represents. So a dual form is
//! transformed as the direct form with the same blades, and needs no code of its own.

use crate::cga3::{
    Circle, Dilator, Direction, DualCircle, DualDirection, DualFlatPoint, DualPlane, DualPointPair,
    DualSphere, FlatPoint, Motor, PointPair, Rotor, RoundVector, Similarity, Translator,
};
use crate::products::Sandwich;
use crate::scalar::Ring;

macro_rules! with_the_blades_of {
    ($($Versor:ident)*; $Dual:ident, $Direct:ident) => {$(
        impl<S: Ring> Sandwich<$Dual<S>> for $Versor<S>
        where
            Self: Sandwich<$Direct<S>, Output = $Direct<S>>,
        {
            type Output = $Dual<S>;

            #[inline]
            fn sandwich(self, other: $Dual<S>) -> $Dual<S> {
                $Dual::from(Sandwich::sandwich(self, $Direct::from(other)))
            }
        }
    )*};
}

with_the_blades_of!(Rotor Translator Motor Dilator Similarity DualPlane RoundVector; DualSphere, RoundVector);
with_the_blades_of!(Rotor Translator Motor Dilator Similarity DualPlane RoundVector; DualCircle, PointPair);
with_the_blades_of!(Rotor Translator Motor Dilator Similarity DualPlane RoundVector; DualPointPair, Circle);

/// Even versors do not change the pseudoscalar, so the dual of the image is the image of the dual.
macro_rules! through_the_direct_form {
    ($($Versor:ident)*; $Dual:ident, $Direct:ident) => {$(
        impl<S: Ring> Sandwich<$Dual<S>> for $Versor<S>
        where
            Self: Sandwich<$Direct<S>, Output = $Direct<S>>,
        {
            type Output = $Dual<S>;

            #[inline]
            fn sandwich(self, other: $Dual<S>) -> $Dual<S> {
                Sandwich::sandwich(self, other.undual()).dual()
            }
        }
    )*};
}

through_the_direct_form!(Rotor Translator Motor Dilator Similarity; DualFlatPoint, FlatPoint);
through_the_direct_form!(Rotor Translator Motor Dilator Similarity; DualDirection, Direction);
