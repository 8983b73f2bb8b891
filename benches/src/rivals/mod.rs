//! Crates other than glam that do the same work. They take part with the feature `rivals` only.

#[cfg(feature = "rivals")]
mod clifford;
#[cfg(feature = "rivals")]
mod geometric_algebra;
#[cfg(feature = "rivals")]
mod ultraviolet;

use crate::comparison::Comparison;
use crate::precision::Precision;

/// Adds the crates that can perform an operation in this precision to the group of the operation.
pub trait Rivals: Precision {
    /// A motor moves a point.
    fn motor_point(group: &mut Comparison<'_>);
    /// A motor moves a vector of five coefficients.
    fn motor_round_vector(group: &mut Comparison<'_>);
    /// A motor moves a plane.
    fn motor_plane(group: &mut Comparison<'_>);
    /// A motor moves a sphere.
    fn motor_sphere(group: &mut Comparison<'_>);
    /// A motor moves a line.
    fn motor_line(group: &mut Comparison<'_>);
    /// A motor moves a circle.
    fn motor_circle(group: &mut Comparison<'_>);
    /// A motor moves a point pair.
    fn motor_point_pair(group: &mut Comparison<'_>);
    /// The product of two motors.
    fn motor_motor(group: &mut Comparison<'_>);
    /// The product of two rotors.
    fn rotor_rotor(group: &mut Comparison<'_>);
    /// The outer product of three points.
    fn three_points(group: &mut Comparison<'_>);
    /// The outer product of four points.
    fn four_points(group: &mut Comparison<'_>);
    /// A sphere meets a plane.
    fn sphere_plane(group: &mut Comparison<'_>);
    /// A line meets a sphere.
    fn line_sphere(group: &mut Comparison<'_>);
    /// The exponential of a dual line.
    fn exponential(group: &mut Comparison<'_>);
    /// The logarithm of a motor.
    fn logarithm(group: &mut Comparison<'_>);
    /// The interpolation of two rotations.
    fn interpolation(group: &mut Comparison<'_>);
}

macro_rules! rivals {
    ($($scalar:ident: $($operation:ident $({ $($rival:ident)* })?),*;)*) => {$(
        impl Rivals for $scalar {$(
            #[allow(unused_variables)]
            fn $operation(group: &mut Comparison<'_>) {
                $($(#[cfg(feature = "rivals")] $rival::$operation::<$scalar>(group);)*)?
            }
        )*}
    )*};
}

rivals! {
    f32:
        motor_point { clifford geometric_algebra ultraviolet },
        motor_round_vector { clifford },
        motor_plane { clifford geometric_algebra },
        motor_sphere { clifford },
        motor_line { clifford geometric_algebra },
        motor_circle { clifford },
        motor_point_pair { clifford },
        motor_motor { clifford geometric_algebra ultraviolet },
        rotor_rotor { geometric_algebra ultraviolet },
        three_points { clifford },
        four_points { clifford },
        sphere_plane { clifford },
        line_sphere { clifford },
        exponential { geometric_algebra },
        logarithm { geometric_algebra },
        interpolation { ultraviolet };
    f64:
        motor_point { clifford ultraviolet },
        motor_round_vector { clifford },
        motor_plane { clifford },
        motor_sphere { clifford },
        motor_line { clifford },
        motor_circle { clifford },
        motor_point_pair { clifford },
        motor_motor { clifford ultraviolet },
        rotor_rotor { ultraviolet },
        three_points { clifford },
        four_points { clifford },
        sphere_plane { clifford },
        line_sphere { clifford },
        exponential,
        logarithm,
        interpolation { ultraviolet };
}
