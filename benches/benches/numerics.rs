//! What the general search for least squares costs beside a loop written out for one problem.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use ga_numerics::least_squares::{
    Attempt, Columns, Damping, Descent, Equations, Options, Problem, Search, minimise,
};
use nalgebra_035::{Matrix3, Vector3};

/// Points near a circle of radius 2 about (1, −0.5).
const POINTS: usize = 16;
const STEPS: usize = 50;
const DAMPING: Damping = Damping {
    first: 1e-3,
    least: 1e-12,
    greatest: 1e12,
};
/// A step ends the search where its square is below this.
const SMALL: f64 = 1e-20;

struct Circle([[f64; 2]; POINTS]);

/// The sum of squares at a circle, with its equations.
#[derive(Clone, Copy)]
struct Normal {
    cost: f64,
    matrix: Matrix3<f64>,
    gradient: Vector3<f64>,
}

impl Circle {
    fn new() -> Self {
        Self(std::array::from_fn(|k| {
            let (sine, cosine) = (k as f64 * 0.4).sin_cos();
            let radius = 2.0 + 0.1 * (k as f64 * 1.7).sin();
            [1.0 + radius * cosine, radius * sine - 0.5]
        }))
    }

    fn rows(&self, circle: &Vector3<f64>) -> impl Iterator<Item = (f64, Vector3<f64>)> {
        self.0.iter().map(|point| {
            let [x, y] = [point[0] - circle.x, point[1] - circle.y];
            let distance = (x * x + y * y).sqrt();
            let row = Vector3::new(-x / distance, -y / distance, -1.0);
            (distance - circle.z, row)
        })
    }

    fn normal(&self, circle: &Vector3<f64>) -> Normal {
        let mut normal = Normal {
            cost: 0.0,
            matrix: Matrix3::zeros(),
            gradient: Vector3::zeros(),
        };
        for (residual, row) in self.rows(circle) {
            normal.cost += residual * residual;
            normal.matrix += row * row.transpose();
            normal.gradient += row * residual;
        }
        normal
    }
}

impl Normal {
    /// A step, its square, and what it promises.
    fn step(&self, damping: f64) -> Option<[f64; 5]> {
        let diagonal = self.matrix.diagonal() * damping;
        let factor = (self.matrix + Matrix3::from_diagonal(&diagonal)).cholesky()?;
        let step = -factor.solve(&self.gradient);
        let damped = diagonal.dot(&step.component_mul(&step));
        let predicted = damped - self.gradient.dot(&step);
        Some([step.x, step.y, step.z, step.norm_squared(), predicted])
    }
}

fn by_hand(points: &Circle, start: Vector3<f64>) -> Vector3<f64> {
    let (mut circle, mut normal) = (start, points.normal(&start));
    let (mut damping, mut growth, mut last_size) = (DAMPING.first, 2.0, f64::INFINITY);
    for _ in 0..STEPS {
        let Some([x, y, z, size, predicted]) = normal.step(damping) else {
            (damping, growth) = (damping * growth, 2.0 * growth);
            continue;
        };
        let next = circle + Vector3::new(x, y, z);
        let found = points.normal(&next);
        let (fell, rounding) = (normal.cost - found.cost, 1e-12 * normal.cost);
        let is_lost = predicted <= rounding && size < last_size;
        let is_accepted = fell > 0.0 || (is_lost && -fell <= rounding);
        if is_accepted {
            let gain = if is_lost { 1.0 } else { fell / predicted };
            damping *= (1.0 - (2.0 * gain - 1.0).powi(3)).clamp(0.1, 2.0);
            (damping, growth) = (damping.max(DAMPING.least), 2.0);
            (circle, normal, last_size) = (next, found, size);
        } else {
            (damping, growth) = (damping * growth, 2.0 * growth);
        }
        if size <= SMALL || predicted <= f64::EPSILON * normal.cost {
            break;
        }
    }
    circle
}

/// The same as a [`Descent`].
struct Searching<'a> {
    points: &'a Circle,
    place: (Vector3<f64>, Normal),
    next: (Vector3<f64>, Normal),
}

impl Descent for Searching<'_> {
    #[inline]
    fn attempt(&mut self, damping: f64) -> Attempt {
        let Some([x, y, z, size, predicted]) = self.place.1.step(damping) else {
            return Attempt::NONE;
        };
        let next = self.place.0 + Vector3::new(x, y, z);
        self.next = (next, self.points.normal(&next));
        Attempt {
            size,
            predicted,
            is_small: size <= SMALL || predicted <= f64::EPSILON * self.place.1.cost,
            cost: self.next.1.cost,
        }
    }

    #[inline]
    fn accept(&mut self) {
        self.place = self.next;
    }
}

fn by_search(points: &Circle, start: Vector3<f64>) -> Vector3<f64> {
    let place = (start, points.normal(&start));
    let mut descent = Searching {
        points,
        place,
        next: place,
    };
    Search::new(place.1.cost, DAMPING).run(&mut descent, STEPS);
    descent.place.0
}

/// The same with equations for any number of unknowns.
impl Problem for Circle {
    type State = Vector3<f64>;

    fn columns(&self) -> Columns {
        Columns::dense(3)
    }

    fn evaluate(&self, circle: &Vector3<f64>, equations: &mut Equations) -> Option<()> {
        for (residual, row) in self.rows(circle) {
            equations.add([residual], &[(0, [row.x]), (1, [row.y]), (2, [row.z])]);
        }
        Some(())
    }

    fn stepped(&self, circle: &Vector3<f64>, step: &[f64]) -> Option<Vector3<f64>> {
        Some(circle + Vector3::from_row_slice(step))
    }
}

fn circle_of_points(criterion: &mut Criterion) {
    let points = Circle::new();
    let start = Vector3::new(0.2, 0.3, 1.0);
    let mut group = criterion.benchmark_group("numerics/least squares of 3 unknowns");
    group.bench_function("loop by hand", |bencher| {
        bencher.iter(|| by_hand(black_box(&points), black_box(start)));
    });
    group.bench_function("Search", |bencher| {
        bencher.iter(|| by_search(black_box(&points), black_box(start)));
    });
    group.bench_function("minimise", |bencher| {
        let options = Options::default();
        bencher.iter(|| minimise(black_box(&points), black_box(start), &options));
    });
    group.finish();
}

criterion_group!(benches, circle_of_points);
criterion_main!(benches);
