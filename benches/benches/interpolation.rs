//! Interpolation of rotations and motions, one pair after another and in slices, and blends of two
//! layers of motions.
//!
//! A point moved by a matrix is the unit of measurement for the speed of the machine.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_runtime::batch::{self, Batch, InstructionSet};
use ga_runtime::cga3::{Motor, Rotor};
use ga_runtime::scalar::Lanes;
use glam::{DMat4, DVec3, Quat, Vec3};
use nullcone_benches::comparison::{self, Comparison};
use nullcone_benches::inputs::{self, Numbers};
use nullcone_benches::precision::Precision;

const SETS: [(InstructionSet, &str); 2] = [
    (InstructionSet::Baseline, "nullcone slices, baseline"),
    (InstructionSet::Avx2, "nullcone slices, dispatched"),
];

fn unit_interval<S: Precision>(numbers: &mut Numbers) -> S {
    (numbers.number::<S>() + S::one()) * S::from_ratio(1, 2)
}

fn quaternion<S: Precision>(rotor: Rotor<S>) -> S::Quaternion {
    let (vector, scalar) = rotor.to_quaternion();
    S::quaternion(vector, scalar)
}

fn rotors<S: Precision>(criterion: &mut Criterion) {
    let rotors = inputs::list(1, |numbers| {
        let pair = [(); 2].map(|()| numbers.rotor::<S>());
        (pair, unit_interval::<S>(numbers))
    });
    let quaternions: Vec<_> = rotors
        .iter()
        .map(|(pair, t)| (pair.map(quaternion::<S>), *t))
        .collect();
    let mut group = Comparison::new(criterion, &format!("interpolation/rotors-{}", S::NAME));
    group.map("nullcone", &rotors, |([a, b], t)| a.interpolate(*b, *t));
    group.map("nullcone nlerp", &rotors, |([a, b], t)| a.nlerp(*b, *t));
    group.map(
        &format!("{} slerp", S::QUATERNION),
        &quaternions,
        |([a, b], t)| S::slerp(a, b, *t),
    );
}

fn motors<S: Precision>(criterion: &mut Criterion) {
    let from = inputs::list(1, Numbers::motor::<S>);
    let to = inputs::list(2, Numbers::motor::<S>);
    let times = inputs::list(3, unit_interval::<S>);
    let triples: Vec<_> = from
        .iter()
        .zip(&to)
        .zip(&times)
        .map(|((a, b), t)| (*a, *b, *t))
        .collect();
    let mut group = Comparison::new(criterion, &format!("interpolation/motors-{}", S::NAME));
    group.map("nullcone", &triples, |(a, b, t)| a.interpolate(*b, *t));
    for (set, name) in SETS {
        let batch = Batch::on(set);
        group.whole(name, &from, &from, |from, between| {
            // The lengths are equal.
            let _ = batch.interpolate(from, &to, &times, between);
        });
    }
    group.map("nullcone nlerp", &triples, |(a, b, t)| a.nlerp(*b, *t));
    let matrices = inputs::list(4, |numbers| {
        let matrix: DMat4 = f64::matrix(numbers.motor::<f64>().to_matrix());
        (matrix, DVec3::from_array(numbers.numbers()))
    });
    group.map("glam DMat4 of a point", &matrices, |(matrix, point)| {
        matrix.transform_point3(*point)
    });
}

/// Two layers of motions with a weight for each.
fn layers(criterion: &mut Criterion) {
    let below = inputs::list(1, Numbers::motor::<f32>);
    let above = inputs::list(2, Numbers::motor::<f32>);
    let weights = inputs::list(3, unit_interval::<f32>);
    let isometries = |motors: &[Motor<f32>]| -> Vec<(Quat, Vec3)> {
        let isometry = |motor: &Motor<f32>| {
            let displacement = motor.translator().displacement();
            (quaternion::<f32>(motor.rotor()), displacement.into())
        };
        motors.iter().map(isometry).collect()
    };
    let pairs: Vec<_> = isometries(&below)
        .into_iter()
        .zip(isometries(&above))
        .collect();

    let mut group = Comparison::new(criterion, "interpolation/two-layers-f32");
    group.whole("nullcone slices", &below, &below, |below, blended| {
        let _ = batch::nlerp(below, &above, &weights, blended);
    });
    let [below, above] = [&below, &above].map(|motors| in_lanes(motors));
    let weights_in_lanes: Vec<_> = weights
        .as_chunks::<8>()
        .0
        .iter()
        .map(|weights| Lanes::from_array(*weights))
        .collect();
    group.whole("nullcone in lanes", &below, &below, |below, blended| {
        let _ = batch::nlerp(below, &above, &weights_in_lanes, blended);
    });
    group.zip(
        "glam Quat nlerp, Vec3 lerp",
        &pairs,
        &weights,
        |((a, p), (b, q)), weight| (a.lerp(*b, *weight), p.lerp(*q, *weight)),
    );
}

fn in_lanes(motors: &[Motor<f32>]) -> Vec<Motor<Lanes<f32, 8>>> {
    let (blocks, _) = motors.as_chunks::<8>();
    blocks.iter().map(Motor::from_lanes).collect()
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = rotors::<f32>, rotors::<f64>, motors::<f32>, motors::<f64>, layers
}
criterion_main!(benches);
