//! Conversions between pga3 and cga3.
//!
//! The map `e0 ↦ −ei` embeds pga3 in cga3 with all its products: the plane `n + d e0` becomes the
//! dual plane `n − d ei`, and motors act in the same way. The conversion is exact.

use crate::cga3;
use crate::pga3::{Direction, Line, Motor, MotorSum, Plane, Point, Rotor, Translator};
use crate::scalar::{Field, Real, Ring};

/// Implements both directions of a conversion that changes the signs of some blades.
macro_rules! alike {
    ($($Type:ident, $Conformal:ident, $make:ident, $read:tt: $($a:ident -> $b:ident $sign:tt),+;)+) => {$(
        impl<S: Ring> From<cga3::$Conformal<S>> for $Type<S> {
            #[inline]
            fn from(value: cga3::$Conformal<S>) -> Self {
                Self::$make($(alike!($sign alike!($read value $b))),+)
            }
        }

        impl<S: Ring> From<$Type<S>> for cga3::$Conformal<S> {
            #[inline]
            fn from(value: $Type<S>) -> Self {
                Self::$make($(alike!($sign alike!($read value $a))),+)
            }
        }
    )+};
    (private $value:ident $blade:ident) => { $value.$blade() };
    (public $value:ident $blade:ident) => { $value.$blade };
    (+ $($value:tt)+) => { $($value)+ };
    (- $($value:tt)+) => { -$($value)+ };
}

alike! {
    Rotor, Rotor, new_unchecked, private: scalar -> scalar +, e12 -> e12 +, e13 -> e13 +, e23 -> e23 +;
    Translator, Translator, new, private: e10 -> e1i -, e20 -> e2i -, e30 -> e3i -;
    Motor, Motor, new_unchecked, private:
        scalar -> scalar +, e12 -> e12 +, e13 -> e13 +, e23 -> e23 +,
        e10 -> e1i -, e20 -> e2i -, e30 -> e3i -, e1230 -> e123i -;
    MotorSum, DualQuaternion, new, public:
        scalar -> scalar +, e12 -> e12 +, e13 -> e13 +, e23 -> e23 +,
        e10 -> e1i -, e20 -> e2i -, e30 -> e3i -, e1230 -> e123i -;
    Line, MotorGenerator, new, public:
        e12 -> e12 +, e13 -> e13 +, e23 -> e23 +, e10 -> e1i -, e20 -> e2i -, e30 -> e3i -;
    Plane, DualPlane, new, public: e1 -> e1 +, e2 -> e2 +, e3 -> e3 +, e0 -> ei -;
}

/// The same line with the same direction and moment.
impl<S: Ring> From<cga3::Line<S>> for Line<S> {
    #[inline]
    fn from(line: cga3::Line<S>) -> Self {
        Self::from_direction_moment(line.direction(), line.moment())
    }
}

/// The same line with the same direction and moment.
impl<S: Ring> From<Line<S>> for cga3::Line<S> {
    #[inline]
    fn from(line: Line<S>) -> Self {
        let ([d1, d2, d3], [m1, m2, m3]) = (line.direction(), line.moment());
        Self::new(m3, -m2, m1, -d1, -d2, -d3)
    }
}

/// The same plane with the same normal.
impl<S: Field> From<cga3::Plane<S>> for Plane<S> {
    #[inline]
    fn from(plane: cga3::Plane<S>) -> Self {
        plane.dual().into()
    }
}

/// The same plane with the same normal.
impl<S: Field> From<Plane<S>> for cga3::Plane<S> {
    #[inline]
    fn from(plane: Plane<S>) -> Self {
        cga3::DualPlane::from(plane).undual()
    }
}

/// The same point with weight 1.
impl<S: Ring> From<cga3::Point<S>> for Point<S> {
    #[inline]
    fn from(point: cga3::Point<S>) -> Self {
        Self::from_coordinates(point.coordinates())
    }
}

/// The same point with the same weight; ideal points are those without a part in eo∧ei.
impl<S: Ring> From<cga3::FlatPoint<S>> for Point<S> {
    #[inline]
    fn from(point: cga3::FlatPoint<S>) -> Self {
        Self::from_homogeneous([point.e1i, point.e2i, point.e3i], point.eoi)
    }
}

/// The same point with the same weight.
impl<S: Ring> From<Point<S>> for cga3::FlatPoint<S> {
    #[inline]
    fn from(point: Point<S>) -> Self {
        let [x, y, z] = point.homogeneous();
        Self::new(x, y, z, point.weight())
    }
}

/// The same free vector.
impl<S: Ring> From<cga3::Direction<S>> for Direction<S> {
    #[inline]
    fn from(direction: cga3::Direction<S>) -> Self {
        Self::from_vector(direction.vector())
    }
}

/// The same free vector.
impl<S: Ring> From<Direction<S>> for cga3::Direction<S> {
    #[inline]
    fn from(direction: Direction<S>) -> Self {
        Self::from_vector(direction.vector())
    }
}

impl<S: Real<Mask = bool>> Point<S> {
    /// The point of [`cga3`] at the same position; `None` for an ideal point. The conversion to
    /// [`cga3::FlatPoint`] by `From` is exact and always possible.
    #[inline]
    #[must_use]
    pub fn to_conformal(self) -> Option<cga3::Point<S>> {
        self.coordinates().map(cga3::Point::from)
    }
}
