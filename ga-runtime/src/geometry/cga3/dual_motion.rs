//! Versors acting on dual forms.
//!
//! Dual forms of flats are transformed as the direct forms.

use crate::cga3::{
    Dilator, Direction, DualDirection, DualFlatPoint, FlatPoint, Motor, Rotor, Similarity,
    Translator,
};
use crate::products::Sandwich;
use crate::scalar::Ring;

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
