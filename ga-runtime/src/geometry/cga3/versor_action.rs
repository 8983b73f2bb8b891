//! General versors acting on vectors, point pairs, circles and spheres, in direct and dual form.
//!
//! The image of a round may be flat, and that of a flat round. So it is of the type that holds
//! both: a [`RoundVector`], [`Bivector`], [`Trivector`] or [`Quadvector`]. Convert a flat to that
//! type by `From` first, and the image of a round back by `TryFrom`.

use super::odd_versor::even_part;
use crate::cga3::{
    Bivector, Circle, DualCircle, DualPlane, DualPointPair, DualSphere, Even, EvenVersor,
    OddVersor, Point, PointPair, Quadvector, RoundVector, Sphere, Transversor, Trivector,
};
use crate::products::Sandwich;
use crate::scalar::{Field, Ring};

/// An even element that acts as the versor does, up to a sign that it applies to even blades.
trait EvenAction<S> {
    /// The image of an even blade.
    fn even_image(self, blade: Even<S>) -> Even<S>;
    /// The image of an even blade that represents its product with the pseudoscalar.
    fn dual_image(self, blade: Even<S>) -> Even<S>;
}

fn conjugated<S: Ring>(versor: Even<S>, blade: Even<S>) -> Even<S> {
    versor * blade * versor.reverse()
}

impl<S: Ring> EvenAction<S> for EvenVersor<S> {
    fn even_image(self, blade: Even<S>) -> Even<S> {
        conjugated(self.into(), blade)
    }

    fn dual_image(self, blade: Even<S>) -> Even<S> {
        conjugated(self.into(), blade)
    }
}

impl<S: Ring> EvenAction<S> for OddVersor<S> {
    // V = E I with I ~I = −1: V x ~V = −E x ~E.
    fn even_image(self, blade: Even<S>) -> Even<S> {
        -conjugated(even_part(self.into()), blade)
    }

    fn dual_image(self, blade: Even<S>) -> Even<S> {
        conjugated(even_part(self.into()), blade)
    }
}

impl<S: Ring> EvenAction<S> for Transversor<S> {
    fn even_image(self, blade: Even<S>) -> Even<S> {
        conjugated(self.into(), blade)
    }

    fn dual_image(self, blade: Even<S>) -> Even<S> {
        conjugated(self.into(), blade)
    }
}

macro_rules! acts_on {
    ($($Versor:ident)*; $($Blade:ident -> $Output:ident, $image:expr;)*) => {
        acts_on!(@ [$($Versor)*] [$($Blade -> $Output, $image;)*]);
    };
    (@ [$Versor:ident $($rest:ident)*] $blades:tt) => {
        acts_on!(@one $Versor $blades);
        acts_on!(@ [$($rest)*] $blades);
    };
    (@ [] $blades:tt) => {};
    (@one $Versor:ident [$($Blade:ident -> $Output:ident, $image:expr;)*]) => {$(
        impl<S: Field> Sandwich<$Blade<S>> for $Versor<S> {
            type Output = $Output<S>;

            #[inline]
            fn sandwich(self, other: $Blade<S>) -> $Output<S> {
                let image: fn($Versor<S>, $Blade<S>) -> $Output<S> = $image;
                image(self, other)
            }
        }
    )*};
}

acts_on! {
    EvenVersor OddVersor;
    RoundVector -> RoundVector, |v, x| v.dual_image(x.undual().into()).extract_quadvector().dual();
    Point -> RoundVector, |v, x| Sandwich::sandwich(v, RoundVector::from(x));
    DualPlane -> RoundVector, |v, x| Sandwich::sandwich(v, RoundVector::from(x));
}

acts_on! {
    EvenVersor OddVersor Transversor;
    DualSphere -> RoundVector, |v, x| Sandwich::sandwich(v, RoundVector::from(x));
    Bivector -> Bivector, |v, x| v.even_image(x.into()).extract_bivector();
    PointPair -> Bivector, |v, x| Sandwich::sandwich(v, Bivector::from(x));
    DualCircle -> Bivector, |v, x| Sandwich::sandwich(v, Bivector::from(x));
    Trivector -> Trivector, |v, x| v.dual_image(x.dual().into()).extract_bivector().undual();
    Circle -> Trivector, |v, x| Sandwich::sandwich(v, Trivector::from(x));
    DualPointPair -> Trivector, |v, x| Sandwich::sandwich(v, Trivector::from(x));
    Quadvector -> Quadvector, |v, x| v.even_image(x.into()).extract_quadvector();
    Sphere -> Quadvector, |v, x| Sandwich::sandwich(v, Quadvector::from(x));
}

macro_rules! methods {
    ($($Versor:ident, $formula:literal;)*) => {$(
        impl<S: Field> $Versor<S> {
            #[doc = concat!("Moves another element by this versor, `x ↦ ", $formula, "`.")]
            ///
            /// The image of a point is a vector with a weight, that of a round of the type that
            /// holds flats too. Convert a flat to that type first: a line to a trivector, a plane
            /// to a quadvector, a flat point to a bivector.
            #[inline]
            #[must_use]
            pub fn sandwich<B>(self, other: B) -> <Self as Sandwich<B>>::Output
            where
                Self: Sandwich<B>,
            {
                Sandwich::sandwich(self, other)
            }

            /// The same as [`sandwich`](Self::sandwich).
            #[inline]
            #[must_use]
            pub fn transform<B>(self, other: B) -> <Self as Sandwich<B>>::Output
            where
                Self: Sandwich<B>,
            {
                Sandwich::sandwich(self, other)
            }
        }
    )*};
}

methods! {
    EvenVersor, "V x ~V";
    OddVersor, "V x̂ ~V` with the grade involution `x̂";
}
