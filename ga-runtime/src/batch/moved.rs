//! The types that motors act on, and the linear map of a motor for each of them.

use crate::cga3::{
    Circle, Direction, DualPlane, FlatPoint, Line, Motor, Plane, Point, PointPair, RoundVector,
    Sphere,
};
use crate::scalar::Real;

/// The actions of a motor, with everything computed once that does not depend on the element.
#[allow(unreachable_pub)]
mod maps {
    crate::ga! { crate::cga3;
        /// `M x ~M` for many points.
        pub fn moving_point(uniform m: Motor, x: Point) -> Point { sandwich(m, x) }
        /// `M x ~M` for many weighted vectors.
        pub fn moving_round_vector(uniform m: Motor, x: RoundVector) -> RoundVector { sandwich(m, x) }
        /// `M x ~M` for many dual planes.
        pub fn moving_dual_plane(uniform m: Motor, x: DualPlane) -> DualPlane { sandwich(m, x) }
        /// `M x ~M` for many directions.
        pub fn moving_direction(uniform m: Motor, x: Direction) -> Direction { sandwich(m, x) }
        /// `M x ~M` for many flat points.
        pub fn moving_flat_point(uniform m: Motor, x: FlatPoint) -> FlatPoint { sandwich(m, x) }
        /// `M x ~M` for many lines.
        pub fn moving_line(uniform m: Motor, x: Line) -> Line { sandwich(m, x) }
        /// `M x ~M` for many planes.
        pub fn moving_plane(uniform m: Motor, x: Plane) -> Plane { sandwich(m, x) }
        /// `M x ~M` for many spheres.
        pub fn moving_sphere(uniform m: Motor, x: Sphere) -> Sphere { sandwich(m, x) }
        /// `M x ~M` for many circles.
        pub fn moving_circle(uniform m: Motor, x: Circle) -> Circle { sandwich(m, x) }
        /// `M x ~M` for many point pairs.
        pub fn moving_point_pair(uniform m: Motor, x: PointPair) -> PointPair { sandwich(m, x) }
    }
}

use maps::{
    MovingCircle, MovingDirection, MovingDualPlane, MovingFlatPoint, MovingLine, MovingPlane,
    MovingPoint, MovingPointPair, MovingRoundVector, MovingSphere, moving_circle, moving_direction,
    moving_dual_plane, moving_flat_point, moving_line, moving_plane, moving_point,
    moving_point_pair, moving_round_vector, moving_sphere,
};

/// An element that motors move: points, weighted vectors, dual planes, directions, flat points,
/// lines, planes, spheres, circles and point pairs.
pub trait Moved<S: Real>: sealed::Moved<S> {}

pub(super) mod sealed {
    use super::{Motor, Real};

    /// The action of a motor, in one step and in two.
    pub trait Moved<S: Real>: Copy {
        /// The linear map that is computed once for a motor that moves many elements.
        type Map: Copy;
        /// The map of a motor.
        fn map(motor: Motor<S>) -> Self::Map;
        /// The element moved by the map of a motor.
        fn mapped(self, map: &Self::Map) -> Self;
        /// The element moved by a motor.
        fn moved(self, motor: Motor<S>) -> Self;
    }
}

macro_rules! moved {
    ($($type:ident by $map:ident $function:ident),* $(,)?) => { $(
        impl<S: Real> Moved<S> for $type<S> {}

        impl<S: Real> sealed::Moved<S> for $type<S> {
            type Map = $map<S>;

            #[inline(always)]
            fn map(motor: Motor<S>) -> $map<S> {
                $function(motor)
            }

            #[inline(always)]
            fn mapped(self, map: &$map<S>) -> Self {
                map.apply(self)
            }

            #[inline(always)]
            fn moved(self, motor: Motor<S>) -> Self {
                motor.transform(self)
            }
        }
    )* };
}

moved!(
    Point by MovingPoint moving_point,
    RoundVector by MovingRoundVector moving_round_vector,
    DualPlane by MovingDualPlane moving_dual_plane,
    Direction by MovingDirection moving_direction,
    FlatPoint by MovingFlatPoint moving_flat_point,
    Line by MovingLine moving_line,
    Plane by MovingPlane moving_plane,
    Sphere by MovingSphere moving_sphere,
    Circle by MovingCircle moving_circle,
    PointPair by MovingPointPair moving_point_pair,
);
