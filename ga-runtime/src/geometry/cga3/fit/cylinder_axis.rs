//! The axes of cylinders near points, from moments of these.

use alloc::vec::Vec;

use super::cloud::Cloud;
use super::place::Place;
use super::quadric::SquareMoments;
use crate::geometry::cga3::matrix::symmetric;
use crate::scalar::Real;
use crate::vga3::Vector;

/// The number of directions that are tried, on a half of the sphere: about 8° apart.
const DIRECTIONS: i64 = 300;
/// The greatest number of candidates.
const MOST: usize = 4;

/// The places of the cylinders whose directions are the best ones of those that are tried.
pub(super) fn axes<S: Real<Mask = bool>>(cloud: &Cloud<S>) -> Vec<Place<S>> {
    let moments = Moments::of(cloud);
    let principal = cloud.principal.map(|(_, axis)| axis);
    let mut tried: Vec<(S, Vector<S>)> = grid()
        .chain(principal)
        .map(|direction| (moments.error(direction), direction))
        .filter(|(error, _)| error.is_finite())
        .collect();
    tried.sort_by(|(a, _), (b, _)| b.less_than(*a).cmp(&a.less_than(*b)));
    // Directions within this of each other lead to the same axis: the cosine of 20°.
    let near = S::from_f64(0.94);
    let mut best: Vec<(S, Vector<S>)> = Vec::with_capacity(MOST);
    for (error, direction) in tried {
        let is_near = |other: &(S, Vector<S>)| near.less_than(other.1.dot(direction).abs());
        if !best.iter().any(is_near) {
            best.push(moments.improved(error, direction));
        }
        if best.len() == MOST {
            break;
        }
    }
    best.sort_by(|(a, _), (b, _)| b.less_than(*a).cmp(&a.less_than(*b)));
    // The errors are mean squared distances to first order: what is much worse is not the best.
    let limit = best.first().map_or(S::zero(), |&(least, _)| {
        least * S::from_integer(16) + S::epsilon() * S::from_integer(1024)
    });
    best.retain(|(error, _)| error.less_than(limit));
    best.into_iter()
        .filter_map(|(_, direction)| moments.place(direction))
        .collect()
}

/// Unit vectors that are spread evenly over a half of the sphere, on a spiral (Swinbank and Purser,
/// Fibonacci grids, Quarterly Journal of the Royal Meteorological Society 132, 2006).
fn grid<S: Real<Mask = bool>>() -> impl Iterator<Item = Vector<S>> {
    let golden_angle = S::from_f64(2.399_963_229_728_653);
    (0..DIRECTIONS).map(move |k| {
        let z = S::from_ratio(2 * k + 1, 2 * DIRECTIONS);
        let (sine, cosine) = (S::from_integer(k) * golden_angle).sin_cos();
        let width = z.neg_mul_add(z, S::one()).sqrt();
        Vector::new(width * cosine, width * sine, z)
    })
}

/// Means over points x and over their products `p = (x₁², x₁x₂, x₁x₃, x₂², x₂x₃, x₃²)`.
struct Moments<S> {
    /// Of p.
    products: [S; 6],
    /// Of `x xᵀ`, `x pᵀ` and `p pᵀ`, each about the mean.
    second: [Vector<S>; 3],
    third: [[S; 6]; 3],
    fourth: [[S; 6]; 6],
}

impl<S: Real<Mask = bool>> Moments<S> {
    fn of(cloud: &Cloud<S>) -> Self {
        let zero = S::zero();
        let (mut mean, mut sum) = ([zero; 6], [zero; 3]);
        let (mut third, mut fourth) = ([[zero; 6]; 3], [[zero; 6]; 6]);
        for &(weight, place) in &cloud.points {
            let [x, y, z] = place.coordinates();
            let products = [x * x, x * y, x * z, y * y, y * z, z * z];
            let weighted = products.map(|product| product * weight);
            for (row, entry) in [x, y, z].into_iter().enumerate() {
                sum[row] = entry.mul_add(weight, sum[row]);
                for column in 0..6 {
                    third[row][column] = entry.mul_add(weighted[column], third[row][column]);
                }
            }
            for row in 0..6 {
                mean[row] += weighted[row];
                for column in 0..=row {
                    fourth[row][column] =
                        products[row].mul_add(weighted[column], fourth[row][column]);
                }
            }
        }
        mean = mean.map(|entry| entry / cloud.total);
        for row in 0..3 {
            for column in 0..6 {
                third[row][column] =
                    sum[row].neg_mul_add(mean[column], third[row][column]) / cloud.total;
            }
        }
        for row in 0..6 {
            for column in 0..=row {
                fourth[row][column] =
                    mean[row].neg_mul_add(mean[column], fourth[row][column] / cloud.total);
            }
        }
        let second =
            [[0, 1, 2], [1, 3, 4], [2, 4, 5]].map(|row| Vector::from(row.map(|entry| mean[entry])));
        Self {
            products: mean,
            second,
            third,
            fourth: symmetric(fourth),
        }
    }

    /// The moments of the circle under a cylinder along a direction, in the plane of a pair of axes
    /// perpendicular to it. The square of the distance from a line along the unit vector w is
    /// `x² − (w·x)²`, a linear function of the products.
    fn seen_along(&self, w: Vector<S>, [u, v]: [Vector<S>; 2]) -> SquareMoments<S, 3> {
        let (zero, one) = (S::zero(), S::one());
        let twice = w + w;
        let factors = [
            w.e1.neg_mul_add(w.e1, one),
            -twice.e1 * w.e2,
            -twice.e1 * w.e3,
            w.e2.neg_mul_add(w.e2, one),
            -twice.e2 * w.e3,
            w.e3.neg_mul_add(w.e3, one),
        ];
        let along = |row: &[S; 6]| {
            row.iter()
                .zip(factors)
                .fold(zero, |sum, (&a, factor)| a.mul_add(factor, sum))
        };
        let square = along(&self.fourth.map(|row| along(&row)));
        let mixed = Vector::from(self.third.map(|row| along(&row)));
        let [x, y] = [u, v].map(|axis| mixed.dot(axis));
        let image = |axis: Vector<S>| Vector::from(self.second.map(|row| row.dot(axis)));
        let (of_u, of_v) = (image(u), image(v));
        SquareMoments {
            mean: [along(&self.products), zero, zero],
            products: [
                [square, x, y],
                [x, u.dot(of_u), u.dot(of_v)],
                [y, u.dot(of_v), v.dot(of_v)],
            ],
        }
    }

    /// The mean squared distance from the best cylinder along a direction, to first order.
    fn error(&self, direction: Vector<S>) -> S {
        let pair = direction.orthonormal_pair();
        let (_, _, error) = self.seen_along(direction, pair).round();
        error
    }

    /// A better direction nearby, by steps of halved length.
    fn improved(&self, mut error: S, mut direction: Vector<S>) -> (S, Vector<S>) {
        const MOST_STEPS: usize = 60;
        let mut length = S::from_f64(0.07);
        let least = S::from_f64(5e-4);
        for _ in 0..MOST_STEPS {
            let [u, v] = direction.orthonormal_pair();
            let tried = [u, v, -u, -v].map(|side| {
                let moved = (direction + side * length)
                    .normalized()
                    .unwrap_or(direction);
                (self.error(moved), moved)
            });
            let better = tried
                .into_iter()
                .reduce(|best, next| if next.0.less_than(best.0) { next } else { best })
                .filter(|best| best.0.less_than(error));
            match better {
                Some(best) => (error, direction) = best,
                None => length *= S::from_ratio(1, 2),
            }
            if length.less_than(least) {
                break;
            }
        }
        (error, direction)
    }

    fn place(&self, direction: Vector<S>) -> Option<Place<S>> {
        let pair = direction.orthonormal_pair();
        self.seen_along(direction, pair).place(pair, direction)
    }
}
