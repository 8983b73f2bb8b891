//! General versors acting on vectors, point pairs, circles and spheres, in direct and dual form.
//!
//! The image of a flat element may be round. So convert it by `From` to the round type that
//! contains it first: a line to a [`Circle`], a plane to a [`Sphere`], a flat point to a
//! [`PointPair`].

use super::odd_versor::even_part;
use crate::cga3::{
    Circle, DualCircle, DualPlane, DualPointPair, DualSphere, Even, EvenVersor, OddVersor, Point,
    PointPair, RoundVector, Sphere, Transversor,
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
    RoundVector -> RoundVector, |v, x| v.dual_image(x.undual().into()).extract_sphere().dual().into();
    Point -> RoundVector, |v, x| Sandwich::sandwich(v, RoundVector::from(x));
    DualPlane -> DualSphere, |v, x| Sandwich::sandwich(v, RoundVector::from(x)).into();
}

acts_on! {
    EvenVersor OddVersor Transversor;
    DualSphere -> DualSphere, |v, x| Sandwich::sandwich(v, RoundVector::from(x)).into();
    PointPair -> PointPair, |v, x| v.even_image(x.into()).extract_point_pair();
    DualCircle -> DualCircle, |v, x| Sandwich::sandwich(v, PointPair::from(x)).into();
    Circle -> Circle, |v, x| DualCircle::from(v.dual_image(x.dual().into()).extract_point_pair()).undual();
    DualPointPair -> DualPointPair, |v, x| Sandwich::sandwich(v, Circle::from(x)).into();
    Sphere -> Sphere, |v, x| v.even_image(x.into()).extract_sphere();
}

macro_rules! methods {
    ($($Versor:ident, $formula:literal;)*) => {$(
        impl<S: Field> $Versor<S> {
            #[doc = concat!("Moves another element by this versor, `x ↦ ", $formula, "`.")]
            ///
            /// The image of a point is a vector with a weight, that of a dual plane a dual sphere.
            /// Convert other flats first: a line to a circle, a plane to a sphere, a flat point to
            /// a point pair.
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
