//! Meets: the intersection of two of line, plane, circle and sphere, by cases.
//!
//! In blades the meet is the vee product `A ∨ B = undual(dual A ∧ dual B)`, if both together span
//! the whole space. One blade then represents a crossing, a contact or an imaginary figure, and
//! zero represents every other case; here each case is a variant of its own.
//!
//! | | line | plane | sphere | circle |
//! | --- | --- | --- | --- | --- |
//! | line | [`LineAndLine`] | [`LineAndPlane`] | [`LineAndSphere`] | [`LineAndCircle`] |
//! | plane | | [`PlaneAndPlane`] | [`PlaneAndSphere`] | [`PlaneAndCircle`] |
//! | sphere | | | [`SphereAndSphere`] | [`SphereAndCircle`] |
//! | circle | | | | [`CircleAndCircle`] |
//!
//! `a.meet(b, tolerance)` and `b.meet(a, tolerance)` return the same type. Either operand may be in
//! dual form ([`MotorGenerator`], [`DualPlane`], [`DualSphere`], [`DualCircle`]); the result is in
//! direct form, and the same as for the direct forms of both. Lines, point pairs and
//! circles in the result have weight 1, real or imaginary, and are oriented as the vee product in
//! the order of the call: they are positive multiples of it. The exception is a line, which gives
//! its points in the order in which it passes them. Where the vee product vanishes, as for figures
//! in one plane, the page of the result type describes the orientation.
//!
//! The tolerance decides as follows. Directions whose angle is at most `tolerance.angle` are
//! parallel. Figures are tangent if a displacement of at most `tolerance.distance` makes them
//! touch; otherwise their intersection is real or imaginary. The tests compare distances in space,
//! not coefficients. A radius whose square is negative by less than `tolerance.distance` squared is
//! treated as zero.
//!
//! The result is `None` where one of the two is not what its type says (a sphere of weight zero is
//! not a sphere), where it is not finite, or where the intersection is beyond the range of the
//! scalar. Imaginary circles and spheres are accepted.
//!
//! ```
//! use ga_runtime::cga3::{Line, Plane, Point, Sphere};
//! use ga_runtime::geometry::relation::Tolerance;
//! use ga_runtime::geometry::relation::meet::{LineAndSphere, PlaneAndSphere};
//!
//! let tolerance = Tolerance::default();
//! let sphere = Sphere::from_centre_radius(Point::default(), 5.0);
//! let line =
//!     |height: f64| Line::from_point_direction(Point::new(0.0, 0.0, height), [1.0, 0.0, 0.0]);
//! let Some(LineAndSphere::Points(pair)) = line(3.0).meet(sphere, tolerance) else {
//!     panic!()
//! };
//! let ends = pair.endpoints().unwrap().map(|p| p.coordinates());
//! assert_eq!(ends, [[-4.0, 0.0, 3.0], [4.0, 0.0, 3.0]]);
//! let touch = line(5.0).meet(sphere, tolerance);
//! let point = Point::new(0.0, 0.0, 5.0);
//! assert_eq!(
//!     touch,
//!     Some(LineAndSphere::Tangent {
//!         point,
//!         direction: [1.0, 0.0, 0.0]
//!     })
//! );
//! assert!(matches!(
//!     line(6.0).meet(sphere, tolerance),
//!     Some(LineAndSphere::Imaginary(_))
//! ));
//!
//! let plane = Plane::from_point_normal(Point::new(0.0, 0.0, 4.0), [0.0, 0.0, 1.0]);
//! let Some(PlaneAndSphere::Circle(circle)) = plane.meet(sphere, tolerance) else {
//!     panic!()
//! };
//! assert!((circle.radius().unwrap() - 3.0).abs() < 1e-14);
//! ```

mod circles;
mod flats;
mod spheres;

pub use circles::{CircleAndCircle, LineAndCircle, PlaneAndCircle, SphereAndCircle};
pub use flats::{LineAndLine, LineAndPlane, PlaneAndPlane};
pub use spheres::{LineAndSphere, PlaneAndSphere, SphereAndSphere};

use super::Tolerance;
use super::tolerance::within;
use crate::cga3::{
    Circle, DualCircle, DualPlane, DualSphere, Line, MotorGenerator, Plane, Point, PointPair,
    Sphere,
};
use crate::geometry::number::are_numbers;
use crate::scalar::Real;
use crate::vga3::Vector;

/// A primitive that can meet another.
pub trait Meet<B>: Sized {
    /// The scalar of both primitives.
    type Scalar;
    /// The type of the result: an enum of the possible cases.
    type Outcome;
    /// The intersection; see [`meet`](crate::geometry::relation::meet). `None` where one is not
    /// what its type says or the result is beyond the range of the scalar.
    fn meet(self, other: B, tolerance: Tolerance<Self::Scalar>) -> Option<Self::Outcome>;
}

macro_rules! meets {
    ($($Primitive:ident)*) => {$(
        impl<S: Real<Mask = bool>> $Primitive<S> {
            /// The intersection of this and the other, by cases; see
            /// [`meet`](crate::geometry::relation::meet). `None` where one is not what its type
            /// says or the result is beyond the range of the scalar.
            #[inline(always)]
            #[must_use]
            pub fn meet<B>(self, other: B, tolerance: Tolerance<S>) -> Option<<Self as Meet<B>>::Outcome>
            where
                Self: Meet<B, Scalar = S>,
            {
                Meet::meet(self, other, tolerance)
            }
        }
    )*};
}

meets!(Line Plane Circle Sphere MotorGenerator DualPlane DualCircle DualSphere);

/// Implements a meet for the other order too, where the vee product is the same.
macro_rules! either_way {
    ($($A:ident, $B:ident;)*) => {$(
        impl<S: Real<Mask = bool>> Meet<$B<S>> for $A<S> {
            type Scalar = S;
            type Outcome = <$B<S> as Meet<$A<S>>>::Outcome;
            #[inline(always)]
            fn meet(self, other: $B<S>, tolerance: Tolerance<S>) -> Option<Self::Outcome> {
                Meet::meet(other, self, tolerance)
            }
        }
    )*};
}

either_way! {
    Plane, Line;
    Sphere, Line;
    Circle, Line;
    Circle, Plane;
    Circle, Sphere;
}

/// Implements the meets of dual forms by their direct forms.
macro_rules! by_the_direct_form {
    ($($Dual:ident $Direct:ident;)*) => {$(
        impl<S: Real<Mask = bool>, B> Meet<B> for $Dual<S>
        where
            $Direct<S>: Meet<B, Scalar = S>,
        {
            type Scalar = S;
            type Outcome = <$Direct<S> as Meet<B>>::Outcome;
            fn meet(self, other: B, tolerance: Tolerance<S>) -> Option<Self::Outcome> {
                Meet::meet(self.undual(), other, tolerance)
            }
        }

        by_the_direct_form! { $Dual $Direct: [Line Plane Circle Sphere] }
    )*};
    ($Dual:ident $Direct:ident: [$($First:ident)*]) => {$(
        impl<S: Real<Mask = bool>> Meet<$Dual<S>> for $First<S> {
            type Scalar = S;
            type Outcome = <$First<S> as Meet<$Direct<S>>>::Outcome;
            fn meet(self, other: $Dual<S>, tolerance: Tolerance<S>) -> Option<Self::Outcome> {
                Meet::meet(self, other.undual(), tolerance)
            }
        }
    )*};
}

by_the_direct_form! {
    MotorGenerator Line;
    DualPlane Plane;
    DualCircle Circle;
    DualSphere Sphere;
}

/// The radius, from its square; zero where the square is negative within the tolerance, `None`
/// where it is imaginary.
#[inline]
fn radius<S: Real<Mask = bool>>(squared: S, tolerance: Tolerance<S>) -> Option<S> {
    if squared.less_than(S::zero()) {
        let is_zero = within(squared, tolerance.distance * tolerance.distance);
        return is_zero.then(S::zero);
    }
    Some(squared.sqrt())
}

/// `x² − y²` with as little cancellation as possible, where the square x² and the length y are
/// given.
#[inline]
fn less_square<S: Real<Mask = bool>>(squared: S, y: S) -> S {
    if squared.less_than(S::zero()) {
        return squared - y * y;
    }
    let x = squared.sqrt();
    (x - y) * (x + y)
}

#[inline]
fn finite_point<S: Real<Mask = bool>>(place: Vector<S>) -> Option<Point<S>> {
    are_numbers(place.coordinates()).then(|| Point::from(place))
}

#[inline]
fn pair<S: Real<Mask = bool>>(
    centre: Vector<S>,
    direction: Vector<S>,
    squared: S,
) -> Option<PointPair<S>> {
    PointPair::from_centre_axis_radius_squared(centre.into(), direction.into(), squared)
}

/// The circle about a centre, with a unit normal.
#[inline]
fn circle<S: Real<Mask = bool>>(
    centre: Vector<S>,
    normal: Vector<S>,
    squared: S,
) -> Option<Circle<S>> {
    Circle::around(centre, normal, squared)
}
