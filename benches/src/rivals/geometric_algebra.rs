//! The projective algebra of the crate `geometric_algebra`, in single precision. Its motors have
//! eight coefficients, as ours have.

use geometric_algebra::ppga3d::{Line, Motor, Plane, Point, Rotor};
use geometric_algebra::{Exp, GeometricProduct, Ln, Transformation};

use crate::comparison::Comparison;
use crate::inputs::{self, Numbers};

const NAME: &str = "geometric_algebra";

fn line(numbers: &mut Numbers) -> Line {
    let [a, b, c, d, e, f] = numbers.numbers();
    Line::new(a, b, c, d, e, f)
}

fn motor(numbers: &mut Numbers) -> Motor {
    line(numbers).exp()
}

fn rotor(numbers: &mut Numbers) -> Rotor {
    let [a, b, c, d] = numbers.numbers();
    Rotor::new(a, b, c, d)
}

fn moved<X: Copy>(group: &mut Comparison<'_>, make: fn(&mut Numbers) -> X)
where
    Motor: Transformation<X>,
{
    let (motors, things) = (inputs::list(1, motor), inputs::list(2, make));
    group.zip(NAME, &motors, &things, |m, x| m.transformation(*x));
}

pub(super) fn motor_point<S>(group: &mut Comparison<'_>) {
    moved(group, |numbers| {
        let [x, y, z] = numbers.numbers();
        Point::new(1.0, x, y, z)
    });
}

pub(super) fn motor_plane<S>(group: &mut Comparison<'_>) {
    moved(group, |numbers| {
        let [d, x, y, z] = numbers.numbers();
        Plane::new(d, x, y, z)
    });
}

pub(super) fn motor_line<S>(group: &mut Comparison<'_>) {
    moved(group, line);
}

pub(super) fn motor_motor<S>(group: &mut Comparison<'_>) {
    let (left, right) = (inputs::list(1, motor), inputs::list(2, motor));
    group.zip(NAME, &left, &right, |a, b| a.geometric_product(*b));
}

pub(super) fn rotor_rotor<S>(group: &mut Comparison<'_>) {
    let (left, right) = (inputs::list(1, rotor), inputs::list(2, rotor));
    group.zip(NAME, &left, &right, |a, b| a.geometric_product(*b));
}

pub(super) fn exponential<S>(group: &mut Comparison<'_>) {
    group.map(NAME, &inputs::list(1, line), |line| line.exp());
}

pub(super) fn logarithm<S>(group: &mut Comparison<'_>) {
    group.map(NAME, &inputs::list(1, motor), |motor| motor.ln());
}
