//! The starts of fits of primitives to points: algebraic fits, and moments for flat ones.

use std::f64::consts::TAU;

use criterion::Criterion;
use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
use ga_runtime::geometry::fit::Cylinder;
use nalgebra_035::{Matrix3, Matrix4, Point3, Vector3, Vector4};
use nullcone_benches::inputs::Numbers;

use super::group;

const COUNT: usize = 10_000;

/// Points with an error of a hundredth, made of three numbers each.
fn points(mut place: impl FnMut([f64; 3]) -> [f64; 3]) -> Vec<Point<f64>> {
    let mut numbers = Numbers::new(7);
    (0..COUNT)
        .map(|_| {
            let [x, y, z] = place(numbers.numbers());
            let [a, b, c] = numbers.numbers::<f64, 3>().map(|e| 0.01 * e);
            Point::new(4.0 + x + a, 5.0 + y + b, 6.0 + z + c)
        })
        .collect()
}

fn theirs(points: &[Point<f64>]) -> Vec<Point3<f64>> {
    let places = points.iter().map(|point| point.coordinates());
    places.map(Point3::from).collect()
}

/// The centroid and the moments about it, in two passes.
fn moments(points: &[Point3<f64>]) -> (Vector3<f64>, Matrix3<f64>) {
    let sum = points
        .iter()
        .fold(Vector3::zeros(), |sum, p| sum + p.coords);
    let centroid = sum / points.len() as f64;
    let moments = points.iter().fold(Matrix3::zeros(), |moments, p| {
        let away = p.coords - centroid;
        moments + away * away.transpose()
    });
    (centroid, moments)
}

/// The principal axis of the least or the greatest variance.
fn axis(moments: Matrix3<f64>, greatest: bool) -> Vector3<f64> {
    let eigen = moments.symmetric_eigen();
    let place = if greatest {
        eigen.eigenvalues.imax()
    } else {
        eigen.eigenvalues.imin()
    };
    eigen.eigenvectors.column(place).into()
}

/// Centre and radius by linear least squares on `2 c·x + (r² − c²) = x²` (Kåsa, 1976).
fn sphere(points: &[Point3<f64>]) -> Option<(Vector3<f64>, f64)> {
    let sum = points
        .iter()
        .fold(Vector3::zeros(), |sum, p| sum + p.coords);
    let centroid = sum / points.len() as f64;
    let (mut matrix, mut right) = (Matrix4::zeros(), Vector4::zeros());
    for p in points {
        let away = p.coords - centroid;
        let row = Vector4::new(2.0 * away.x, 2.0 * away.y, 2.0 * away.z, 1.0);
        matrix += row * row.transpose();
        right += row * away.norm_squared();
    }
    let solution = matrix.cholesky()?.solve(&right);
    let centre = solution.xyz();
    let radius = (solution.w + centre.norm_squared()).sqrt();
    Some((centroid + centre, radius))
}

/// The centre and radius in the plane perpendicular to a normal, in the same way.
fn circle(
    points: &[Point3<f64>],
    normal: Vector3<f64>,
    centroid: Vector3<f64>,
) -> Option<(Vector3<f64>, f64)> {
    let side = if normal.x.abs() < 0.6 {
        Vector3::x()
    } else {
        Vector3::y()
    };
    let u = normal.cross(&side).normalize();
    let v = normal.cross(&u);
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for p in points {
        let away = p.coords - centroid;
        let (x, y) = (away.dot(&u), away.dot(&v));
        let row = Vector3::new(2.0 * x, 2.0 * y, 1.0);
        matrix += row * row.transpose();
        right += row * (x * x + y * y);
    }
    let solution = matrix.cholesky()?.solve(&right);
    let (x, y) = (solution.x, solution.y);
    let radius = (solution.z + x * x + y * y).sqrt();
    Some((centroid + u * x + v * y, radius))
}

pub(crate) fn all(criterion: &mut Criterion) {
    let on_sphere = |[a, z, _]: [f64; 3]| {
        let ((s, c), width) = ((TAU * a).sin_cos(), (1.0 - z * z).sqrt());
        [width * c, width * s, z]
    };
    let ours = points(on_sphere);
    let mut g = group(criterion, &format!("sphere from {COUNT} points"));
    g.once("nullcone", &ours, Sphere::fit_algebraically);
    g.once("nalgebra, linear equations", &theirs(&ours), sphere);
    drop(g);

    let ours = points(|[a, ..]| [(TAU * a).cos(), (TAU * a).sin(), 0.0]);
    let mut g = group(criterion, &format!("circle from {COUNT} points"));
    g.once("nullcone", &ours, Circle::fit_algebraically);
    g.once("nalgebra, linear equations", &theirs(&ours), |points| {
        let (centroid, moments) = moments(points);
        circle(points, axis(moments, false), centroid)
    });
    drop(g);

    let ours = points(|[x, y, _]| [x, y, 0.0]);
    let mut g = group(criterion, &format!("plane from {COUNT} points"));
    g.once("nullcone", &ours, Plane::fit);
    g.once("nalgebra, moments", &theirs(&ours), |points| {
        let (centroid, moments) = moments(points);
        (centroid, axis(moments, false))
    });
    drop(g);

    let ours = points(|[x, ..]| [x, 0.0, 0.0]);
    let mut g = group(criterion, &format!("line from {COUNT} points"));
    g.once("nullcone", &ours, Line::fit);
    g.once("nalgebra, moments", &theirs(&ours), |points| {
        let (centroid, moments) = moments(points);
        (centroid, axis(moments, true))
    });
    drop(g);

    let ours = points(|[a, z, _]| [(TAU * a).cos(), (TAU * a).sin(), 2.0 * z]);
    let mut g = group(criterion, &format!("cylinder from {COUNT} points"));
    g.once("nullcone", &ours, Cylinder::fit_algebraically);
    // One direction only, which must be known.
    g.once(
        "nalgebra, linear equations, known axis",
        &theirs(&ours),
        |points| {
            let (centroid, _) = moments(points);
            circle(points, Vector3::z(), centroid)
        },
    );
}
