//! Products of motors and rotors, and outer products of points.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_runtime::cga3::{Circle, Motor, Rotor, Sphere};
use nullcone_benches::comparison::{self, Comparison};
use nullcone_benches::functions::{circle_through, sphere_through};
use nullcone_benches::inputs::{self, Numbers};
use nullcone_benches::precision::Precision;
use nullcone_benches::rivals::Rivals;

fn motors<S: Rivals>(criterion: &mut Criterion) {
    let left = inputs::list(1, Numbers::motor::<S>);
    let right = inputs::list(2, Numbers::motor::<S>);
    let matrices = |motors: &[Motor<S>]| -> Vec<_> {
        motors.iter().map(|m| S::matrix(m.to_matrix())).collect()
    };
    let affines = |motors: &[Motor<S>]| -> Vec<_> {
        motors.iter().map(|m| S::affine(m.to_matrix())).collect()
    };

    let mut group = Comparison::new(criterion, &format!("product/motor-motor-{}", S::NAME));
    group.zip("nullcone", &left, &right, |a, b| *a * *b);
    group.zip(
        S::AFFINE,
        &affines(&left),
        &affines(&right),
        S::affine_product,
    );
    group.zip(
        S::MATRIX,
        &matrices(&left),
        &matrices(&right),
        S::matrix_product,
    );
    S::motor_motor(&mut group);
    drop(group);

    let name = format!("product/motor-motor-one-by-one-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    group.one_by_one("nullcone", &left, &right, |a, b| *a * *b);
    group.one_by_one(
        S::AFFINE,
        &affines(&left),
        &affines(&right),
        S::affine_product,
    );
}

fn rotors<S: Rivals>(criterion: &mut Criterion) {
    let left = inputs::list(1, Numbers::rotor::<S>);
    let right = inputs::list(2, Numbers::rotor::<S>);
    let (left_quaternions, right_quaternions) = (quaternions(&left), quaternions(&right));
    let mut group = Comparison::new(criterion, &format!("product/rotor-rotor-{}", S::NAME));
    group.zip("nullcone", &left, &right, |a, b| *a * *b);
    group.zip(
        S::QUATERNION,
        &left_quaternions,
        &right_quaternions,
        S::quaternion_product,
    );
    S::rotor_rotor(&mut group);
}

fn quaternions<S: Precision>(rotors: &[Rotor<S>]) -> Vec<S::Quaternion> {
    let quaternion = |rotor: &Rotor<S>| {
        let (vector, scalar) = rotor.to_quaternion();
        S::quaternion(vector, scalar)
    };
    rotors.iter().map(quaternion).collect()
}

fn points<S: Rivals>(criterion: &mut Criterion) {
    let triples = inputs::list(1, |numbers| [(); 3].map(|()| numbers.point::<S>()));
    let mut group = Comparison::new(criterion, &format!("product/three-points-{}", S::NAME));
    group.map("nullcone", &triples, |[p, q, r]| circle_through(*p, *q, *r));
    group.map(
        "nullcone, operator by operator",
        &triples,
        |[p, q, r]| -> Circle<S> { *p ^ *q ^ *r },
    );
    S::three_points(&mut group);
    drop(group);

    let quadruples = inputs::list(1, |numbers| [(); 4].map(|()| numbers.point::<S>()));
    let mut group = Comparison::new(criterion, &format!("product/four-points-{}", S::NAME));
    group.map("nullcone", &quadruples, |[p, q, r, s]| {
        sphere_through(*p, *q, *r, *s)
    });
    group.map(
        "nullcone, operator by operator",
        &quadruples,
        |[p, q, r, s]| -> Sphere<S> { *p ^ *q ^ *r ^ *s },
    );
    S::four_points(&mut group);
}

fn dense(criterion: &mut Criterion) {
    let left = inputs::list(1, Numbers::motor::<f64>);
    let right = inputs::list(2, Numbers::motor::<f64>);
    let mut group = Comparison::new(criterion, "product/motor-motor-all-coefficients-f64");
    group.zip("nullcone", &left, &right, |a, b| *a * *b);
    if let (Ok(left), Ok(right)) = (
        nullcone_benches::dense::all(&left),
        nullcone_benches::dense::all(&right),
    ) {
        group.zip("dense reference", &left, &right, |a, b| a.geometric(b));
    }
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = motors::<f32>, motors::<f64>, rotors::<f32>, rotors::<f64>, points::<f32>, points::<f64>, dense
}
criterion_main!(benches);
