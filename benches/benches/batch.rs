//! Slices of elements moved at once, compared with loops over glam's types.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_runtime::batch::{Batch, InstructionSet, Moved};
use ga_runtime::cga3::{Direction, Infinity, Line, Motor, Point, Sphere};
use ga_runtime::ga;
use nullcone_benches::comparison::{self, Comparison};
use nullcone_benches::inputs::{self, Numbers};
use nullcone_benches::precision::Precision;

ga! { ga_runtime::cga3;
    /// A motor that moves many points.
    fn moving(uniform m: Motor, p: Point) -> Point { m * p * rev(m) }
}

fn instruction_sets() -> [(InstructionSet, &'static str); 2] {
    [
        (InstructionSet::Baseline, "nullcone baseline"),
        (InstructionSet::best(), "nullcone dispatched"),
    ]
}

fn one_motor_points<S: Precision>(criterion: &mut Criterion) {
    let motor = Numbers::new(1).motor::<S>();
    let points = inputs::list(2, Numbers::point::<S>);
    let vectors: Vec<_> = points.iter().map(|p| S::vector(p.coordinates())).collect();
    let (matrix, affine) = (S::matrix(motor.to_matrix()), S::affine(motor.to_matrix()));

    let name = format!("batch/one-motor-points-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    group.whole("nullcone", &points, &points, |points, moved| {
        let moving = moving(motor);
        for (point, moved) in points.iter().zip(moved) {
            *moved = moving.apply(*point);
        }
    });
    by_instruction_sets(&mut group, motor, &points);
    group.map(S::MATRIX, &vectors, |v| S::by_matrix(&matrix, v));
    group.map(S::AFFINE, &vectors, |v| S::by_affine(&affine, v));
}

fn by_instruction_sets<S: Precision, X: Moved<S>>(
    group: &mut Comparison<'_>,
    motor: Motor<S>,
    things: &[X],
) {
    for (set, name) in instruction_sets() {
        let batch = Batch::on(set);
        group.whole(name, things, things, |things, moved| {
            // The lengths are equal.
            let _ = batch.transform_into(&motor, things, moved);
        });
    }
}

fn one_motor<S: Precision>(criterion: &mut Criterion) {
    let motor = Numbers::new(1).motor::<S>();
    let affine = S::affine(motor.to_matrix());
    let points = inputs::list(3, |numbers| [(); 4].map(|()| numbers.point::<S>()));

    let directions: Vec<_> = points
        .iter()
        .map(|[p, ..]| {
            let [x, y, z] = p.coordinates();
            Direction::new(x, y, z)
        })
        .collect();
    let vectors: Vec<_> = points
        .iter()
        .map(|[p, ..]| S::vector(p.coordinates()))
        .collect();
    let name = format!("batch/one-motor-directions-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    by_instruction_sets(&mut group, motor, &directions);
    group.map(S::AFFINE, &vectors, |v| S::rotated_by_affine(&affine, v));
    drop(group);

    let lines: Vec<Line<S>> = points.iter().map(|[p, q, ..]| *p ^ *q ^ Infinity).collect();
    let name = format!("batch/one-motor-lines-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    by_instruction_sets(&mut group, motor, &lines);
    drop(group);

    let spheres: Vec<Sphere<S>> = points
        .iter()
        .map(|[p, q, r, s]| *p ^ *q ^ *r ^ *s)
        .collect();
    let name = format!("batch/one-motor-spheres-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    by_instruction_sets(&mut group, motor, &spheres);
}

fn each_motor<S: Precision>(criterion: &mut Criterion) {
    let motors = inputs::list(1, Numbers::motor::<S>);
    let pairs = inputs::list(2, |numbers| (numbers.motor::<S>(), numbers.point::<S>()));
    let points: Vec<Point<S>> = pairs.iter().map(|(_, p)| *p).collect();
    let matrices: Vec<_> = motors.iter().map(|m| S::matrix(m.to_matrix())).collect();
    let vectors: Vec<_> = points.iter().map(|p| S::vector(p.coordinates())).collect();
    let name = format!("batch/each-motor-point-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    for (set, name) in instruction_sets() {
        let batch = Batch::on(set);
        group.whole(name, &motors, &points, |motors, moved| {
            let _ = batch.transform_each(motors, &points, moved);
        });
    }
    group.zip(S::MATRIX, &matrices, &vectors, S::by_matrix);
    drop(group);

    let affines: Vec<_> = motors.iter().map(|m| S::affine(m.to_matrix())).collect();
    let name = format!("batch/motor-motor-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    for (set, name) in instruction_sets() {
        let batch = Batch::on(set);
        group.whole(name, &motors, &motors, |motors, products| {
            let _ = batch.compose(motors, motors, products);
        });
    }
    group.zip(S::AFFINE, &affines, &affines, S::affine_product);
}

fn all(criterion: &mut Criterion) {
    one_motor_points::<f32>(criterion);
    one_motor_points::<f64>(criterion);
    one_motor::<f32>(criterion);
    one_motor::<f64>(criterion);
    each_motor::<f32>(criterion);
    each_motor::<f64>(criterion);
}

criterion_group! { name = benches; config = comparison::criterion(); targets = all }
criterion_main!(benches);
