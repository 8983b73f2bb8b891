//! Inversion in a sphere.
//!
//! A point at x goes to `c + r² (x − c)/∣x − c∣²`. With the dual sphere `σ = c − ½r² ei` it is the
//! versor action `σ X̂ σ⁻¹`, X̂ the grade involution, so that a blade is mapped point by point and
//! keeps its orientation. The image of an element through the centre of the sphere is flat; the
//! image of a flat element that does not contain the centre is round and passes through the centre.
//!
//! - A point becomes a point; the result is `None` for the centre, whose image is at infinity.
//! - A point pair or flat point becomes a [`RoundOrFlat`] of point pair and flat point, flat where
//!   one of its points is the centre.
//! - A circle or line becomes a [`RoundOrFlat`] of circle and line, flat where it passes through
//!   the centre.
//! - A sphere or plane becomes a [`RoundOrFlat`] of sphere and plane, flat where it passes through
//!   the centre.
//!
//! Whether the element contains the centre is decided within `tolerance.distance`. If it does, the
//! result has a flat type, which leaves out the blades with eo and without ei. Points within that
//! distance of the centre have no image.
//!
//! ```
//! use ga_runtime::cga3::{Plane, Point, Sphere};
//! use ga_runtime::geometry::relation::{RoundOrFlat, Tolerance};
//!
//! let tolerance = Tolerance::default();
//! let unit = Sphere::from_centre_radius(Point::default(), 1.0);
//! assert_eq!(
//!     Point::new(2.0, 0.0, 0.0).invert_in(unit, tolerance),
//!     Some(Point::new(0.5, 0.0, 0.0))
//! );
//! let plane = Plane::from_point_normal(Point::new(0.0, 0.0, 2.0), [0.0, 0.0, 1.0]);
//! match plane.invert_in(unit, tolerance) {
//!     Some(RoundOrFlat::Round(sphere)) => assert_eq!(sphere.radius(), Some(0.25)),
//!     other => panic!("{other:?}"),
//! }
//! // A sphere through the centre becomes a plane.
//! let through = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.25), 0.25);
//! assert!(matches!(
//!     through.invert_in(unit, tolerance),
//!     Some(RoundOrFlat::Flat(_))
//! ));
//! ```

use super::figure::sphere_parts;
use super::figure_distance::from_place;
use super::tolerance::within;
use super::{Primitive, Tolerance};
use crate::Element;
use crate::cga3::{
    Bivector, Circle, FlatPoint, Line, Plane, Point, PointPair, Quadvector, Sphere, Translator,
    Trivector,
};
use crate::products::Sandwich;
use crate::scalar::{Field, Real};
use crate::vga3::Vector;

/// A round element, or the flat element of the same grade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RoundOrFlat<R, F> {
    /// The round element.
    Round(R),
    /// The flat element.
    Flat(F),
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The image under inversion in a sphere, `c + r² (x − c)/∣x − c∣²`; see
    /// [`inversion`](crate::geometry::relation::inversion). `None` for the centre within the
    /// tolerance, and where the sphere has radius zero, is imaginary or is not a sphere.
    #[must_use]
    pub fn invert_in(self, sphere: Sphere<S>, tolerance: Tolerance<S>) -> Option<Self> {
        let (centre, radius) = mirror(sphere)?;
        let arm = Vector::from(self) - centre;
        let away = arm.length();
        if within(away, tolerance.distance) || !S::zero().less_than(away) {
            return None;
        }
        let stretch = radius / away;
        let place = centre + arm * stretch * stretch;
        place.is_finite().then(|| Point::from(place))
    }
}

macro_rules! inversions {
    ($($Element:ident: $Round:ident or $Flat:ident in $Sum:ident;)*) => {$(
        impl<S: Real<Mask = bool>> $Element<S> {
            /// The image under inversion in a sphere, `σ X̂ σ⁻¹` with the dual sphere σ; see
            /// [`inversion`](crate::geometry::relation::inversion). The image is flat where this
            /// element contains the centre within `tolerance.distance`. `None` where the sphere has
            /// radius zero, is imaginary or is not a sphere, where this element is not a figure, or
            /// where the image is beyond the range of the scalar.
            #[must_use]
            pub fn invert_in(
                self,
                sphere: Sphere<S>,
                tolerance: Tolerance<S>,
            ) -> Option<RoundOrFlat<$Round<S>, $Flat<S>>> {
                let (centre, radius) = mirror(sphere)?;
                let away = from_place(self.figure()?, centre)?;
                let there = Translator::from_displacement(centre.into());
                let moved = Sandwich::sandwich(there.reverse(), self);
                let image: $Sum<S> = inverted(recast(moved), radius);
                // A round is read about the centre of inversion, where it keeps its size.
                Some(if within(away, tolerance.distance) {
                    RoundOrFlat::Flat(finite(recast(Sandwich::sandwich(there, image)))?)
                } else {
                    let round: $Round<S> = recast(image);
                    RoundOrFlat::Round(finite(Sandwich::sandwich(there, round))?)
                })
            }
        }
    )*};
}

inversions! {
    PointPair: PointPair or FlatPoint in Bivector;
    FlatPoint: PointPair or FlatPoint in Bivector;
    Circle: Circle or Line in Trivector;
    Line: Circle or Line in Trivector;
    Sphere: Sphere or Plane in Quadvector;
    Plane: Sphere or Plane in Quadvector;
}

/// Centre and radius of the sphere of an inversion.
fn mirror<S: Real<Mask = bool>>(sphere: Sphere<S>) -> Option<(Vector<S>, S)> {
    let (centre, squared) = sphere_parts(sphere)?;
    S::zero()
        .less_than(squared)
        .then(|| (centre, squared.sqrt()))
}

/// The image of a multivector by inversion in a sphere about the origin, which exchanges eo and ei
/// and multiplies by ½r² or divides.
fn inverted<T: Element<Scalar: Field>>(element: T, radius: T::Scalar) -> T {
    const ORIGIN: usize = 0b01000;
    const INFINITY: usize = 0b10000;
    let half_square = radius * radius * T::Scalar::from_ratio(1, 2);
    T::from_coefficients_unchecked(&mut |blade| match blade & (ORIGIN | INFINITY) {
        0 => element.coefficient(blade),
        ORIGIN => element.coefficient(blade ^ ORIGIN ^ INFINITY) / half_square,
        INFINITY => element.coefficient(blade ^ ORIGIN ^ INFINITY) * half_square,
        _ => -element.coefficient(blade),
    })
}

/// An element, if it is finite.
fn finite<T: Element<Scalar: Real<Mask = bool>>>(element: T) -> Option<T> {
    element.is_finite().then_some(element)
}

/// The element in another type, with the coefficients that both types store.
fn recast<T: Element, U: Element<Scalar = T::Scalar>>(element: T) -> U {
    U::from_coefficients_unchecked(&mut |blade| element.coefficient(blade))
}
