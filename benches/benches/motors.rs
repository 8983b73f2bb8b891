//! Motors beside what a user would otherwise pick: matrices.

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use nullcone_benches::{INPUTS, Numbers};

fn each<A, B, R>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    left: &[A],
    right: &[B],
    operation: impl Fn(&A, &B) -> R,
) {
    group.throughput(Throughput::Elements(INPUTS as u64));
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            for (a, b) in left.iter().zip(right) {
                black_box(operation(black_box(a), black_box(b)));
            }
        });
    });
}

struct Inputs {
    motors: Vec<Motor<f64>>,
    points: Vec<Point<f64>>,
}

impl Inputs {
    fn new() -> Self {
        let mut numbers = Numbers::new(1);
        let motors = (0..INPUTS).map(|_| {
            let rotor = Rotor::from_axis_angle(numbers.vector(), 3.0 * numbers.number());
            let displacement = numbers.vector();
            Translator::from_displacement(displacement) * rotor.unwrap_or_default()
        });
        let motors = motors.collect();
        let points = (0..INPUTS).map(|_| Point::from(numbers.vector())).collect();
        Self { motors, points }
    }
}

fn single(m: &Motor<f64>) -> Motor<f32> {
    Motor::new_unchecked(
        m.scalar() as f32,
        m.e12() as f32,
        m.e13() as f32,
        m.e23() as f32,
        m.e1i() as f32,
        m.e2i() as f32,
        m.e3i() as f32,
        m.e123i() as f32,
    )
}

fn matrix(m: &Motor<f64>) -> glam::DMat4 {
    let [x, y, z] = m.to_matrix();
    glam::DMat4::from_cols_array_2d(&[x, y, z, [0.0, 0.0, 0.0, 1.0]]).transpose()
}

fn sandwich(criterion: &mut Criterion) {
    let Inputs { motors, points } = Inputs::new();
    let matrices: Vec<_> = motors.iter().map(matrix).collect();
    let vectors: Vec<_> = points
        .iter()
        .map(|p| glam::DVec3::from(p.coordinates()))
        .collect();
    let mut group = criterion.benchmark_group("sandwich/motor-point-f64");
    each(&mut group, "nullcone", &motors, &points, |m, p| {
        m.transform(*p)
    });
    each(&mut group, "glam DMat4", &matrices, &vectors, |m, p| {
        m.transform_point3(*p)
    });
    group.finish();

    let motors: Vec<_> = motors.iter().map(single).collect();
    let points: Vec<_> = points
        .iter()
        .map(|p| Point::from(p.coordinates().map(|x| x as f32)))
        .collect();
    let matrices: Vec<_> = matrices.iter().map(glam::DMat4::as_mat4).collect();
    let vectors: Vec<_> = points
        .iter()
        .map(|p| glam::Vec3::from(p.coordinates()))
        .collect();
    let mut group = criterion.benchmark_group("sandwich/motor-point-f32");
    each(&mut group, "nullcone", &motors, &points, |m, p| {
        m.transform(*p)
    });
    each(&mut group, "glam Mat4", &matrices, &vectors, |m, p| {
        m.transform_point3(*p)
    });
    group.finish();
}

fn product(criterion: &mut Criterion) {
    let Inputs { motors, .. } = Inputs::new();
    let motors: Vec<_> = motors.iter().map(single).collect();
    let affine = |m: &Motor<f32>| {
        let [x, y, z] = m.to_matrix();
        let matrix = glam::Mat4::from_cols_array_2d(&[x, y, z, [0.0, 0.0, 0.0, 1.0]]);
        glam::Affine3A::from_mat4(matrix.transpose())
    };
    let affines: Vec<_> = motors.iter().map(affine).collect();
    let mut group = criterion.benchmark_group("product/motor-motor-f32");
    each(&mut group, "nullcone", &motors, &motors, |a, b| *a * *b);
    each(&mut group, "glam Affine3A", &affines, &affines, |a, b| {
        *a * *b
    });
    group.finish();
}

criterion_group!(benches, sandwich, product);
criterion_main!(benches);
