//! Points, and what displaces them.

use core::ops::{Add, AddAssign, Sub, SubAssign};

use crate::cga3::{Direction, Point};
use crate::scalar::{ConstRing, Field, Real, Ring};
use crate::vga3::Vector;

impl<S: ConstRing> Point<S> {
    /// The origin.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// assert_eq!(Point::ORIGIN, Point::new(0.0, 0.0, 0.0));
    /// ```
    pub const ORIGIN: Self = Self::new(S::ZERO, S::ZERO, S::ZERO);
}

impl<S: Ring> Point<S> {
    /// The coordinates `[x, y, z]`.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// assert_eq!(Point::new(1.0, 2.0, 3.0).coordinates(), [1.0, 2.0, 3.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn coordinates(self) -> [S; 3] {
        [self.e1(), self.e2(), self.e3()]
    }

    /// The coordinate along the x axis.
    #[inline]
    #[must_use]
    pub fn x(self) -> S {
        self.e1()
    }

    /// The coordinate along the y axis.
    #[inline]
    #[must_use]
    pub fn y(self) -> S {
        self.e2()
    }

    /// The coordinate along the z axis.
    #[inline]
    #[must_use]
    pub fn z(self) -> S {
        self.e3()
    }

    /// The direction from this point to another, the free vector `q − p` as `(q − p)∧ei`. Added to
    /// this point, it gives the other; motions rotate it and do not translate it.
    ///
    /// The operator `q - p` is the difference of two conformal vectors, a
    /// [`RoundVector`](crate::cga3::RoundVector), which also has the coefficient `½(q² − p²)` of
    /// ei.
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, Line, Point};
    /// let (p, q) = (Point::new(1.0, 2.0, 3.0), Point::new(5.0, 5.0, 5.0));
    /// let way = p.to(q);
    /// assert_eq!(way, Direction::new(4.0, 3.0, 2.0));
    /// assert_eq!(p + way, q);
    /// assert_eq!(q - way, p);
    /// // The outer product of a point and a direction is the line through both points.
    /// assert_eq!(p ^ way, Line::through(p, q));
    /// ```
    #[inline]
    #[must_use]
    pub fn to(self, other: Self) -> Direction<S> {
        self.vector_to(other).into()
    }

    /// The vector of vga3 from this point to another, `other − self`: the coordinates of the
    /// direction [`to`](Self::to) the other.
    ///
    /// ```
    /// use ga_runtime::{cga3::Point, vga3::Vector};
    /// let (p, q) = (Point::new(1, 2, 3), Point::new(5, 5, 5));
    /// assert_eq!(p.vector_to(q), Vector::new(4, 3, 2));
    /// ```
    #[inline]
    #[must_use]
    pub fn vector_to(self, other: Self) -> Vector<S> {
        Vector::from(other) - Vector::from(self)
    }

    /// The squared distance between two points, `−2 P·Q`, computed from differences of coordinates,
    /// which avoids cancellation far from the origin.
    #[inline]
    #[must_use]
    pub fn distance_squared(self, other: Self) -> S {
        other.vector_to(self).length_squared()
    }

    /// The point `(1 − t) p + t q` of the line through two points: exactly p at t = 0 and q at
    /// t = 1, beyond them for other t outside [0, 1].
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// let (p, q) = (Point::new(1.0, 2.0, 3.0), Point::new(5.0, 2.0, -1.0));
    /// assert_eq!(p.lerp(q, 0.25), Point::new(2.0, 2.0, 2.0));
    /// assert_eq!(p.lerp(q, 2.0), Point::new(9.0, 2.0, -5.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn lerp(self, other: Self, t: S) -> Self {
        Vector::from(self).lerp(other.into(), t).into()
    }
}

impl<S: Field> Point<S> {
    /// The point midway between two points.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// let (p, q) = (Point::new(1.0, 2.0, 3.0), Point::new(5.0, 2.0, -1.0));
    /// assert_eq!(p.midpoint(q), Point::new(3.0, 2.0, 1.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn midpoint(self, other: Self) -> Self {
        self.lerp(other, S::from_ratio(1, 2))
    }
}

impl<S: Real> Point<S> {
    /// The distance between two points, `√(−2 P·Q)` (Cui, eq. 32, corrected). For other primitives:
    /// [`distance_to`](Self::distance_to).
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// let (p, q) = (Point::new(1.0_f64, 1.0, 0.0), Point::new(4.0, 5.0, 0.0));
    /// assert_eq!(p.distance(q), 5.0);
    /// assert_eq!((-2.0 * (p | q)).sqrt(), 5.0);
    ///
    /// use ga_runtime::scalar::Lanes;
    /// let two = Point::new(Lanes::from_array([3.0, 0.0]), Lanes::splat(4.0), Lanes::splat(0.0));
    /// assert_eq!(two.distance(Point::default()).to_array(), [5.0, 4.0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> S {
        other.vector_to(self).length()
    }
}

impl<S> From<[S; 3]> for Point<S> {
    #[inline]
    fn from([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<S: Ring> From<Point<S>> for [S; 3] {
    #[inline]
    fn from(point: Point<S>) -> Self {
        point.coordinates()
    }
}

macro_rules! displacements {
    ($($Vector:ident)*) => {$(
        displacements! { of $Vector<S> }
        displacements! { of &$Vector<S> }

        impl<S: Ring> AddAssign<$Vector<S>> for Point<S> {
            #[inline]
            fn add_assign(&mut self, displacement: $Vector<S>) {
                *self = *self + displacement;
            }
        }

        impl<S: Ring> SubAssign<$Vector<S>> for Point<S> {
            #[inline]
            fn sub_assign(&mut self, displacement: $Vector<S>) {
                *self = *self - displacement;
            }
        }
    )*};
    (of $Vector:ty) => {
        /// The point displaced by a vector v, `x + v`: the translation of the point.
        impl<S: Ring> Add<$Vector> for Point<S> {
            type Output = Self;

            #[inline]
            fn add(self, displacement: $Vector) -> Self {
                let [x, y, z] = displacement.coordinates();
                Self::new(self.e1() + x, self.e2() + y, self.e3() + z)
            }
        }

        /// The point displaced by minus a vector v, `x − v`.
        impl<S: Ring> Sub<$Vector> for Point<S> {
            type Output = Self;

            #[inline]
            fn sub(self, displacement: $Vector) -> Self {
                let [x, y, z] = displacement.coordinates();
                Self::new(self.e1() - x, self.e2() - y, self.e3() - z)
            }
        }
    };
}

displacements! { Direction Vector }
