//! Motors that move elements, compared with matrices and the motors of other crates.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_runtime::cga3::{
    Circle, Infinity, Line, Motor, Plane, Point, PointPair, RoundVector, Sphere,
};
use ga_runtime::products::Sandwich;
use nullcone_benches::comparison::{self, Comparison};
use nullcone_benches::inputs::{self, Numbers};
use nullcone_benches::precision::Precision;
use nullcone_benches::rivals::Rivals;

fn point<S: Rivals>(criterion: &mut Criterion) {
    let motors = inputs::list(1, Numbers::motor::<S>);
    let points = inputs::list(2, Numbers::point::<S>);
    let matrices: Vec<_> = motors.iter().map(|m| S::matrix(m.to_matrix())).collect();
    let affines: Vec<_> = motors.iter().map(|m| S::affine(m.to_matrix())).collect();
    let vectors: Vec<_> = points.iter().map(|p| S::vector(p.coordinates())).collect();
    let quaternions: Vec<_> = motors.iter().map(quaternion_and_translation).collect();

    let mut group = Comparison::new(criterion, &format!("sandwich/motor-point-{}", S::NAME));
    group.zip("nullcone", &motors, &points, |m, p| m.transform(*p));
    group.zip(S::MATRIX, &matrices, &vectors, S::by_matrix);
    group.zip(S::AFFINE, &affines, &vectors, S::by_affine);
    let name = format!("{} and translation", S::QUATERNION);
    group.zip(&name, &quaternions, &vectors, |(q, t), p| {
        S::by_quaternion(q, t, p)
    });
    S::motor_point(&mut group);
    drop(group);

    let name = format!("sandwich/motor-point-one-by-one-{}", S::NAME);
    let mut group = Comparison::new(criterion, &name);
    group.one_by_one("nullcone", &motors, &points, |m, p| m.transform(*p));
    group.one_by_one(S::MATRIX, &matrices, &vectors, S::by_matrix);
    group.one_by_one(S::AFFINE, &affines, &vectors, S::by_affine);
}

fn quaternion_and_translation<S: Precision>(motor: &Motor<S>) -> (S::Quaternion, S::Vector) {
    let (vector, scalar) = motor.rotor().to_quaternion();
    let translation = motor.translator().displacement();
    (S::quaternion(vector, scalar), S::vector(translation))
}

/// Motors that move elements of one type; `others` adds the rivals.
fn moved<S, X>(
    criterion: &mut Criterion,
    what: &str,
    things: &[X],
    others: impl FnOnce(&mut Comparison<'_>),
) where
    S: Precision,
    X: Copy,
    Motor<S>: Sandwich<X>,
{
    let motors = inputs::list(1, Numbers::motor::<S>);
    let mut group = Comparison::new(criterion, &format!("sandwich/motor-{what}-{}", S::NAME));
    group.zip("nullcone", &motors, things, |m, x| m.sandwich(*x));
    others(&mut group);
}

fn everything_else<S: Rivals>(criterion: &mut Criterion) {
    let round_vectors = inputs::list(3, |numbers| {
        let [e1, e2, e3, eo, ei] = numbers.numbers::<S, 5>();
        RoundVector { e1, e2, e3, eo, ei }
    });
    moved::<S, _>(
        criterion,
        "round-vector",
        &round_vectors,
        S::motor_round_vector,
    );

    let points = inputs::list(4, |numbers| [(); 4].map(|()| numbers.point::<S>()));
    let plane = |[p, q, r, _]: &[Point<S>; 4]| -> Plane<S> { *p ^ *q ^ *r ^ Infinity };
    let planes: Vec<_> = points.iter().map(plane).collect();
    moved::<S, _>(criterion, "plane", &planes, S::motor_plane);

    let sphere = |[p, q, r, s]: &[Point<S>; 4]| -> Sphere<S> { *p ^ *q ^ *r ^ *s };
    let spheres: Vec<_> = points.iter().map(sphere).collect();
    moved::<S, _>(criterion, "sphere", &spheres, S::motor_sphere);

    let lines: Vec<_> = points
        .iter()
        .map(|[p, q, ..]| Line::through(*p, *q))
        .collect();
    moved::<S, _>(criterion, "line", &lines, |group| {
        points_and_directions::<S>(group, &points);
        S::motor_line(group);
    });

    let circle = |[p, q, r, _]: &[Point<S>; 4]| -> Circle<S> { *p ^ *q ^ *r };
    let circles: Vec<_> = points.iter().map(circle).collect();
    moved::<S, _>(criterion, "circle", &circles, S::motor_circle);

    let pair = |[p, q, ..]: &[Point<S>; 4]| -> PointPair<S> { *p ^ *q };
    let pairs: Vec<_> = points.iter().map(pair).collect();
    moved::<S, _>(criterion, "point-pair", &pairs, S::motor_point_pair);
}

/// A line as users of matrices represent it: a point and a direction, each moved in its own way.
fn points_and_directions<S: Precision>(group: &mut Comparison<'_>, points: &[[Point<S>; 4]]) {
    let motors = inputs::list(1, Numbers::motor::<S>);
    let affines: Vec<_> = motors.iter().map(|m| S::affine(m.to_matrix())).collect();
    let ray = |[p, q, ..]: &[Point<S>; 4]| {
        let direction = Line::through(*p, *q).direction();
        (S::vector(p.coordinates()), S::vector(direction))
    };
    let rays: Vec<_> = points.iter().map(ray).collect();
    let name = format!("{}, point and direction", S::AFFINE);
    group.zip(&name, &affines, &rays, |m, (point, direction)| {
        (S::by_affine(m, point), S::rotated_by_affine(m, direction))
    });
}

fn dense(criterion: &mut Criterion) {
    let motors = inputs::list(1, Numbers::motor::<f64>);
    let points = inputs::list(2, Numbers::point::<f64>);
    let mut group = Comparison::new(criterion, "sandwich/motor-point-all-coefficients-f64");
    group.zip("nullcone", &motors, &points, |m, p| m.transform(*p));
    if let (Ok(motors), Ok(points)) = (
        nullcone_benches::dense::all(&motors),
        nullcone_benches::dense::all(&points),
    ) {
        group.zip("dense reference", &motors, &points, |m, p| m.sandwich(p));
    }
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = point::<f32>, point::<f64>, everything_else::<f32>, everything_else::<f64>, dense
}
criterion_main!(benches);
