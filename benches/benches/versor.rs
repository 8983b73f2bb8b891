//! Exponentials, logarithms and interpolations of motions.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_runtime::cga3::MotorGenerator;
use nullcone_benches::comparison::{self, Comparison};
use nullcone_benches::inputs::{self, Numbers};
use nullcone_benches::precision::Precision;
use nullcone_benches::rivals::Rivals;

fn exponentials<S: Rivals>(criterion: &mut Criterion) {
    let generators = inputs::list(1, |numbers| {
        let [e12, e13, e23, e1i, e2i, e3i] = numbers.numbers::<S, 6>();
        MotorGenerator {
            e12,
            e13,
            e23,
            e1i,
            e2i,
            e3i,
        }
    });
    let mut group = Comparison::new(criterion, &format!("versor/exp-{}", S::NAME));
    group.map("nullcone", &generators, |generator| generator.exp());
    moved_points(&mut group);
    S::exponential(&mut group);
}

fn logarithms<S: Rivals>(criterion: &mut Criterion) {
    let motors = inputs::list(1, Numbers::motor::<S>);
    let mut group = Comparison::new(criterion, &format!("versor/log-{}", S::NAME));
    group.map("nullcone", &motors, |motor| motor.log());
    moved_points(&mut group);
    S::logarithm(&mut group);
}

fn interpolations<S: Rivals>(criterion: &mut Criterion) {
    let motors = inputs::list(1, |numbers| {
        (
            numbers.motor::<S>(),
            numbers.motor::<S>(),
            unit_interval::<S>(numbers),
        )
    });
    let quaternions: Vec<_> = motors
        .iter()
        .map(|(a, b, t)| {
            let [a, b] = [a, b].map(|m| {
                let (vector, scalar) = m.rotor().to_quaternion();
                S::quaternion(vector, scalar)
            });
            (a, b, *t)
        })
        .collect();
    let mut group = Comparison::new(criterion, &format!("versor/interpolate-{}", S::NAME));
    group.map("nullcone", &motors, |(a, b, t)| a.interpolate(*b, *t));
    let rotors: Vec<_> = motors
        .iter()
        .map(|(a, b, t)| (a.rotor(), b.rotor(), *t))
        .collect();
    group.map("nullcone, rotations alone", &rotors, |(a, b, t)| {
        a.interpolate(*b, *t)
    });
    let slerp = format!("{} slerp, rotations alone", S::QUATERNION);
    group.map(&slerp, &quaternions, |(a, b, t)| S::slerp(a, b, *t));
    S::interpolation(&mut group);
}

/// A point moved by a matrix, as a unit of measurement for the speed of the machine.
fn moved_points(group: &mut Comparison<'_>) {
    let moves = inputs::list(1, |numbers| {
        let matrix = f32::matrix(numbers.motor::<f32>().to_matrix());
        (matrix, f32::vector(numbers.numbers()))
    });
    let name = format!("{} of a point", f32::MATRIX);
    group.map(&name, &moves, |(matrix, point)| {
        f32::by_matrix(matrix, point)
    });
}

fn unit_interval<S: Precision>(numbers: &mut Numbers) -> S {
    (numbers.number::<S>() + S::one()) * S::from_ratio(1, 2)
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = exponentials::<f32>, exponentials::<f64>, logarithms::<f32>, logarithms::<f64>,
        interpolations::<f32>, interpolations::<f64>
}
criterion_main!(benches);
