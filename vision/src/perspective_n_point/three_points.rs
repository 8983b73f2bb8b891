//! Poses of three points.

use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

use ga_numerics::polynomial::real_roots;

/// Two second radii of which both miss the square of the third side by less than this part of it
/// belong to two poses, as where the rays and the sides are alike in a mirror. The root is double
/// then, and known to half of its digits or less.
const EQUAL: f64 = 1e-4;

/// The motions from the world to a camera's frame that take three points onto three rays from the
/// camera's centre, by the unit directions of the rays: up to four.
///
/// The three points are on spheres about the centre whose radii s, u s and v s satisfy the law of
/// cosines for each pair of them. Eliminating u and s leaves a polynomial of degree four in v (J.
/// A. Grunert, 1841, in the form of R. M. Haralick and others, "Review and analysis of solutions of
/// the three point perspective pose estimation problem", International Journal of Computer Vision
/// 13, 1994). Newton steps then make the radii exact. None for points on a line.
#[must_use]
pub fn three_points(points: [Point<f64>; 3], directions: [Vector<f64>; 3]) -> Vec<Motor<f64>> {
    let [p, q, r] = points;
    // Opposite to each point: the squared distance of the two others and the cosine of their rays.
    let squares = [q.distance(r), p.distance(r), p.distance(q)].map(|x| x * x);
    let [a, b, c] = directions;
    let cosines = [b.dot(c), a.dot(c), a.dot(b)];
    let mut found = Vec::new();
    for v in real_roots(&quartic(squares, cosines)) {
        let denominator = 1.0 + v * v - 2.0 * v * cosines[1];
        let s = (squares[1] / denominator).sqrt();
        if !s.is_finite() || v <= 0.0 {
            continue;
        }
        // Both second radii on the first two rays. The third side selects: from the other one,
        // Newton steps would walk to the pose of another root, and not always all the way.
        let half = (cosines[2] * cosines[2] - 1.0 + squares[2] / (s * s))
            .max(0.0)
            .sqrt();
        let missed = |u: f64| {
            let squared = (u * u + v * v - 2.0 * u * v * cosines[0]) * s * s;
            (squared - squares[0]).abs()
        };
        let both = [cosines[2] + half, cosines[2] - half];
        let limit = (EQUAL * squares[0]).max(missed(both[0]).min(missed(both[1])));
        for u in both.into_iter().filter(|u| missed(*u) <= limit) {
            let Some(radii) = polished([s, u * s, v * s], squares, cosines) else {
                continue;
            };
            let images: [Point<f64>; 3] =
                std::array::from_fn(|k| Point::from(directions[k] * radii[k]));
            let pairs = [(p, images[0]), (q, images[1]), (r, images[2])];
            let is_new = |motor: &Motor<f64>| {
                !found.iter().any(|other: &Motor<f64>| {
                    let limit = 1e-9 * radii[0];
                    pairs.iter().all(|pair| {
                        motor.transform(pair.0).distance(other.transform(pair.0)) < limit
                    })
                })
            };
            let fit = Motor::from_point_pairs(&pairs).map(|fit| fit.motion);
            found.extend(fit.ok().filter(is_new));
        }
    }
    found
}

/// The polynomial in v, the constant term first.
fn quartic(squares: [f64; 3], cosines: [f64; 3]) -> [f64; 5] {
    let [a, b, c] = squares;
    let [alpha, beta, gamma] = cosines;
    let difference = (a - c) / b;
    let sum = (a + c) / b;
    [
        (1.0 + difference).powi(2) - 4.0 * a / b * gamma * gamma,
        4.0 * (-difference * (1.0 + difference) * beta + 2.0 * a / b * gamma * gamma * beta
            - (1.0 - sum) * alpha * gamma),
        2.0 * (difference * difference - 1.0
            + 2.0 * difference * difference * beta * beta
            + 2.0 * (b - c) / b * alpha * alpha
            - 4.0 * sum * alpha * beta * gamma
            + 2.0 * (b - a) / b * gamma * gamma),
        4.0 * (difference * (1.0 - difference) * beta - (1.0 - sum) * alpha * gamma
            + 2.0 * c / b * alpha * alpha * beta),
        (difference - 1.0).powi(2) - 4.0 * c / b * alpha * alpha,
    ]
}

/// The radii after Newton steps for the three laws of cosines; `None` where these do not hold in
/// the end, or a radius is not positive.
fn polished(mut radii: [f64; 3], squares: [f64; 3], cosines: [f64; 3]) -> Option<[f64; 3]> {
    const STEPS: usize = 10;
    const TOLERANCE: f64 = 1e-8;
    let largest = squares.iter().fold(0.0, |most: f64, x| most.max(*x));
    let mut left = f64::INFINITY;
    for _ in 0..STEPS {
        let mut rows = [Vector::ZERO; 3];
        let mut errors = [0.0; 3];
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let (x, y) = (radii[i], radii[j]);
            errors[k] = x * x + y * y - 2.0 * x * y * cosines[k] - squares[k];
            let mut row = [0.0; 3];
            row[i] = 2.0 * (x - y * cosines[k]);
            row[j] = 2.0 * (y - x * cosines[k]);
            rows[k] = row.into();
        }
        left = errors.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // Cramer's rule, by the reciprocal vectors of the rows.
        let [a, b, c] = rows;
        let volume = a.dot(b.cross(c));
        let step = b.cross(c) * errors[0] + c.cross(a) * errors[1] + a.cross(b) * errors[2];
        let step = step / volume;
        if !step.is_finite() {
            break;
        }
        for (radius, change) in radii.iter_mut().zip(step.coordinates()) {
            *radius -= change;
        }
    }
    let is_solved = left <= TOLERANCE * largest && radii.iter().all(|x| x.is_finite() && *x > 0.0);
    is_solved.then_some(radii)
}
