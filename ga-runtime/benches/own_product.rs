//! A microbenchmark, as a crate that builds on ga-runtime would write it: products of an algebra
//! that it declares, compared with other ways to compute the same.
//!
//! The crate has these lines in Cargo.toml:
//!
//! ```toml
//! [dev-dependencies]
//! criterion = "0.8"
//! ga-runtime = { version = "0.1", features = ["testing"] }
//!
//! [[bench]]
//! name = "own_product"
//! harness = false
//! ```
//!
//! Run it with `cargo bench -p ga-runtime --bench own_product --features testing`.

use criterion::{Criterion, criterion_group, criterion_main};
use ga_runtime::testing::bench_product;

ga_runtime::algebra! {
    /// The projective algebra of the plane.
    mod pga2 {
        basis e1, e2, e0;
        signature 2, 0, 1;
        /// A point: `e12 + x e20 − y e10`.
        #[hull(WeightedPoint)]
        #[facts(weight(e12))]
        struct Point { e12 = 1, e10, e20 }
        /// A sum of points.
        struct WeightedPoint { e12, e10, e20 }
        /// Sums of motors.
        struct Even { scalar, e12, e10, e20 }
        /// A rigid motion of the plane.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Motor { scalar, e12, e10, e20 }
        products {
            geometric(Motor, Motor) -> Motor;
            sandwich(Motor, Point) -> Self;
        }
    }
}
use pga2::{Motor, Point};

/// The rival: two rows of a matrix, `[R | t]`.
type Matrix = [[f64; 3]; 2];

fn matrix(motor: Motor<f64>) -> Matrix {
    let image = |x: f64, y: f64| coordinates(motor.transform(Point::new(-y, x)));
    let ([x, y], [x1, y1], [x2, y2]) = (image(0.0, 0.0), image(1.0, 0.0), image(0.0, 1.0));
    [[x1 - x, x2 - x, x], [y1 - y, y2 - y, y]]
}

fn coordinates(point: Point<f64>) -> [f64; 2] {
    [point.e20(), -point.e10()]
}

fn applied(m: &Matrix, p: [f64; 2]) -> [f64; 2] {
    m.map(|row| row[0] * p[0] + row[1] * p[1] + row[2])
}

fn composed(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|[x, y, t]| {
        [
            x * b[0][0] + y * b[1][0],
            x * b[0][1] + y * b[1][1],
            x * b[0][2] + y * b[1][2] + t,
        ]
    })
}

fn products(criterion: &mut Criterion) {
    bench_product!(
        criterion,
        "motor * motor",
        |a: Motor<f64>, b: Motor<f64>| a * b,
        rival "matrix" with left = matrix(a), right = matrix(b) => composed(left, right),
    );
    bench_product!(
        criterion,
        "motor, point",
        seed = 2,
        |motor: Motor<f64>, point: Point<f64>| motor.transform(point),
        rival "matrix" with rows = matrix(motor), place = coordinates(point) => applied(rows, *place),
    );
}

criterion_group!(benches, products);
criterion_main!(benches);
