//! Whether rotations lie so close together that they have one mean.

use alloc::vec::Vec;

use crate::geometry::cga3::matrix::{Matrix, identity, solve};
use crate::scalar::Real;

/// The method terminates in exact arithmetic; this bound is for rounding in borderline cases, where
/// neither answer can be established.
const MOST_STEPS: usize = 1000;

/// Whether some rotation is within a quarter turn of every one of these. They are unit quaternions,
/// with signs such that the product with the one of the largest weight is not negative; the search
/// starts at a given centre. If there are only two different rotations, half a turn apart, the
/// answer is no: two different rotations are within a quarter turn of both.
///
/// The search is for a vector q with `q·p ≥ 1` for all points p. The shortest one points to the
/// centre of the smallest ball around them, and its length is one over the cosine of half the
/// radius. It is found by adding points one at a time, by the dual method of Goldfarb and Idnani (A
/// numerically stable dual method for solving strictly convex quadratic programs, Mathematical
/// Programming 27, 1983). The length only grows, so a vector that is too long proves that there is
/// no such rotation, and a centre within a quarter turn of all points proves that there is one.
pub(super) fn lie_in_quarter_ball<S: Real<Mask = bool>>(points: &[[S; 4]], centre: [S; 4]) -> bool {
    let rounding = S::epsilon() * S::from_integer(64);
    if are_two_opposites(points, rounding) {
        return false;
    }
    let least = S::from_ratio(1, 2).sqrt() * (S::one() - rounding);
    let is_centre = |product: S, vector: [S; 4]| {
        let size = product_of(vector, vector).sqrt();
        !product.less_than(least * size)
    };
    let (mut farthest_point, product) = farthest(points, centre);
    if is_centre(product, centre) {
        return true;
    }
    let mut nearest = Nearest {
        vector: [S::zero(); 4],
        supports: Vec::new(),
    };
    for _ in 0..MOST_STEPS {
        if !nearest.take(points[farthest_point]) {
            return false;
        }
        let square = product_of(nearest.vector, nearest.vector);
        if S::one().less_than(square * least * least) {
            return false;
        }
        let (index, product) = farthest(points, nearest.vector);
        if is_centre(product, nearest.vector) {
            return true;
        }
        farthest_point = index;
    }
    false
}

/// The shortest vector whose product with some points is at least 1, as a linear combination of the
/// points where the product is exactly 1.
struct Nearest<S> {
    vector: [S; 4],
    /// At most four linearly independent points, with their coefficients in the sum, which are not
    /// negative.
    supports: Vec<([S; 4], S)>,
}

impl<S: Real<Mask = bool>> Nearest<S> {
    /// Changes it to the shortest vector that also has a product of at least 1 with this point;
    /// returns false if there is none.
    fn take(&mut self, point: [S; 4]) -> bool {
        let mut factor = S::zero();
        loop {
            let Some(shares) = self.shares_of(point) else {
                return false;
            };
            let beside =
                self.supports
                    .iter()
                    .zip(shares)
                    .fold(point, |rest, ((support, _), share)| {
                        core::array::from_fn(|k| support[k].neg_mul_add(share, rest[k]))
                    });
            // The step at which the product with the point becomes 1.
            let square = product_of(beside, beside);
            let noise = S::epsilon() * S::from_integer(8);
            let can_move = self.supports.len() < 4 && (noise * noise).less_than(square);
            let missing = S::one() - product_of(self.vector, point);
            let whole = can_move.then(|| missing / square);
            // The step at which the coefficient of a support becomes zero.
            let mut blocked = None;
            for (k, ((_, factor), share)) in self.supports.iter().zip(shares).enumerate() {
                let reach = *factor / share;
                let is_first = blocked.is_none_or(|(_, least)| reach.less_than(least));
                if S::zero().less_than(share) && is_first {
                    blocked = Some((k, reach));
                }
            }
            let (lost, step) = match (whole, blocked) {
                (None, None) => return false,
                (Some(whole), Some((k, reach))) if reach.less_than(whole) => (Some(k), reach),
                (Some(whole), _) => (None, whole),
                (None, Some((k, reach))) => (Some(k), reach),
            };
            factor += step;
            for ((_, factor), share) in self.supports.iter_mut().zip(shares) {
                *factor = share.neg_mul_add(step, *factor).max(S::zero());
            }
            if can_move {
                self.vector = core::array::from_fn(|k| beside[k].mul_add(step, self.vector[k]));
            }
            match lost {
                Some(k) => {
                    self.supports.remove(k);
                }
                None => {
                    self.supports.push((point, factor));
                    return true;
                }
            }
        }
    }

    /// The coefficients of the linear combination of the supports that is nearest to a point.
    fn shares_of(&self, point: [S; 4]) -> Option<[S; 4]> {
        let mut products: Matrix<S, 4> = identity();
        let mut with_point = [S::zero(); 4];
        for (row, (a, _)) in self.supports.iter().enumerate() {
            with_point[row] = product_of(*a, point);
            for (column, (b, _)) in self.supports.iter().enumerate() {
                products[row][column] = product_of(*a, *b);
            }
        }
        solve(products, with_point)
    }
}

/// Whether the points are only two different rotations, half a turn apart.
fn are_two_opposites<S: Real<Mask = bool>>(points: &[[S; 4]], rounding: S) -> bool {
    let Some(&one) = points.first() else {
        return false;
    };
    let (index, product) = farthest(points, one);
    let other = points[index];
    !rounding.less_than(product.abs())
        && points.iter().all(|&point| {
            let is_at = |place| (S::one() - rounding).less_than(product_of(point, place).abs());
            is_at(one) || is_at(other)
        })
}

/// The index of the point with the least product with the centre, and the product.
fn farthest<S: Real<Mask = bool>>(points: &[[S; 4]], centre: [S; 4]) -> (usize, S) {
    let products = points.iter().map(|&point| product_of(point, centre));
    products
        .enumerate()
        .reduce(|least, next| {
            if next.1.less_than(least.1) {
                next
            } else {
                least
            }
        })
        .unwrap_or((0, S::zero()))
}

fn product_of<S: Real>(a: [S; 4], b: [S; 4]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
}
