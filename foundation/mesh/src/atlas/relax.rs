//! Making the flat image of a chart as isometric as it can be without folding it.

use super::chart::{Chart, Flat, cross, minus};

/// Newton steps at most.
const STEPS: usize = 40;

/// Steps of the conjugate gradients for one Newton step at most.
const INNER: usize = 150;

/// Moves an image in which no triangle is folded towards the minimum of the symmetric Dirichlet
/// energy `Σ area (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)`, where σ₁ and σ₂ are the singular values of the map of
/// each triangle. The energy is infinite where a triangle folds, so none does.
///
/// Newton's method, with the Hessian of each triangle made positive as in Smith, De Goes and Kim
/// 2019, *Analytic eigensystems for isotropic distortion energies*.
pub(super) fn relax(chart: &Chart, image: &mut [Flat]) {
    let rest: Vec<Rest> = (0..chart.faces.len())
        .map(|face| Rest::new(chart.corners(face)))
        .collect();
    let scale = 1.0 / rest.iter().map(|rest| rest.area).sum::<f64>();
    let mut energy = total(chart, &rest, image);
    let mut gradient = vec![[0.0; 2]; image.len()];
    let mut hessians = vec![[[0.0; 4]; 4]; rest.len()];
    for _ in 0..STEPS {
        gradient.fill([0.0; 2]);
        for (face, triangle) in chart.triangles.iter().enumerate() {
            let map = rest[face].map(triangle.map(|v| image[v as usize]));
            let (slope, hessian) = derivatives(map, rest[face].area);
            rest[face].scatter(slope, *triangle, &mut gradient);
            hessians[face] = hessian;
        }
        let direction = solve(chart, &rest, &hessians, &gradient);
        let descent: f64 = dot(&gradient, &direction);
        if descent >= 0.0 || descent.is_nan() {
            return;
        }
        let mut step = (0.9 * first_fold(chart, image, &direction)).min(1.0);
        let before = energy;
        let moved = loop {
            let moved: Vec<Flat> = image
                .iter()
                .zip(&direction)
                .map(|(x, d)| [x[0] + step * d[0], x[1] + step * d[1]])
                .collect();
            let trial = total(chart, &rest, &moved);
            if trial <= before + 1e-4 * step * descent {
                energy = trial;
                break moved;
            }
            step *= 0.5;
            if step < 1e-9 {
                return;
            }
        };
        image.copy_from_slice(&moved);
        if (before - energy) * scale < 1e-5 {
            return;
        }
    }
}

/// A triangle in its own plane: with d₁ and d₂ the sides of its image from the first corner, the
/// columns of the map are p d₁ and q d₁ + r d₂.
struct Rest {
    p: f64,
    q: f64,
    r: f64,
    area: f64,
}

impl Rest {
    fn new([a, b, c]: [super::Vector; 3]) -> Self {
        let (e, f) = (b - a, c - a);
        let length = e.length();
        let double = e.cross(f).length();
        let (x, y) = (e.dot(f) / length, double / length);
        Self {
            p: 1.0 / length,
            q: -x / (length * y),
            r: 1.0 / y,
            area: 0.5 * double,
        }
    }

    /// The matrix of the map, column by column.
    fn map(&self, [a, b, c]: [Flat; 3]) -> [f64; 4] {
        let (d, e) = (minus(b, a), minus(c, a));
        [
            self.p * d[0],
            self.p * d[1],
            self.q * d[0] + self.r * e[0],
            self.q * d[1] + self.r * e[1],
        ]
    }

    /// The transpose of [`Rest::map`]: adds what a covector of maps is at the corners.
    fn scatter(&self, g: [f64; 4], [a, b, c]: [u32; 3], out: &mut [Flat]) {
        for axis in 0..2 {
            let first = self.p * g[axis] + self.q * g[2 + axis];
            let second = self.r * g[2 + axis];
            out[b as usize][axis] += first;
            out[c as usize][axis] += second;
            out[a as usize][axis] -= first + second;
        }
    }
}

fn total(chart: &Chart, rest: &[Rest], image: &[Flat]) -> f64 {
    let faces = chart.triangles.iter().zip(rest);
    faces
        .map(|(triangle, rest)| {
            let [a, b, c, d] = rest.map(triangle.map(|v| image[v as usize]));
            let determinant = a * d - b * c;
            if determinant <= 0.0 {
                return f64::INFINITY;
            }
            let squares = a * a + b * b + c * c + d * d;
            rest.area * squares * (1.0 + 1.0 / (determinant * determinant))
        })
        .sum()
}

/// The gradient and the positive part of the Hessian of the energy of one triangle.
fn derivatives([a, b, c, d]: [f64; 4], area: f64) -> ([f64; 4], [[f64; 4]; 4]) {
    // Singular values of the matrix with columns (a, b) and (c, d).
    let (e, f) = (0.5 * (a + d), 0.5 * (a - d));
    let (g, h) = (0.5 * (b + c), 0.5 * (b - c));
    let (q, r) = (e.hypot(h), f.hypot(g));
    let (large, small) = (q + r, (q - r).max(1e-12));
    let (first, second) = (g.atan2(f), h.atan2(e));
    let (right, left) = (0.5 * (second - first), 0.5 * (second + first));
    let (v, u) = (right.sin_cos(), left.sin_cos());
    let columns = [[u.1, u.0], [-u.0, u.1]];
    let rows = [[v.1, -v.0], [v.0, v.1]];
    let outer = |i: usize, j: usize| -> [f64; 4] {
        let (x, y) = (columns[i], rows[j]);
        [x[0] * y[0], x[1] * y[0], x[0] * y[1], x[1] * y[1]]
    };
    let slope = |s: f64| 2.0 * s - 2.0 / (s * s * s);
    let bend = |s: f64| 2.0 + 6.0 / (s * s * s * s);
    let (first, second) = (outer(0, 0), outer(1, 1));
    let (cross, back) = (outer(1, 0), outer(0, 1));
    let gradient =
        std::array::from_fn(|i| area * (slope(large) * first[i] + slope(small) * second[i]));

    let half = std::f64::consts::FRAC_1_SQRT_2;
    let twist: [f64; 4] = std::array::from_fn(|i| half * (cross[i] - back[i]));
    let flip: [f64; 4] = std::array::from_fn(|i| half * (cross[i] + back[i]));
    let of_twist = ((slope(large) + slope(small)) / (large + small)).max(0.0);
    let gap = large - small;
    let of_flip = if gap > 1e-9 * large {
        (slope(large) - slope(small)) / gap
    } else {
        bend(large)
    };
    let modes = [
        (bend(large), first),
        (bend(small), second),
        (of_twist, twist),
        (of_flip, flip),
    ];
    let mut hessian = [[0.0; 4]; 4];
    for (value, mode) in modes {
        for (row, x) in hessian.iter_mut().zip(mode) {
            for (entry, y) in row.iter_mut().zip(mode) {
                *entry += area * value * x * y;
            }
        }
    }
    (gradient, hessian)
}

/// The Newton direction `−H⁻¹ g`, by conjugate gradients.
fn solve(chart: &Chart, rest: &[Rest], hessians: &[[[f64; 4]; 4]], gradient: &[Flat]) -> Vec<Flat> {
    let mut diagonal = vec![[0.0; 2]; gradient.len()];
    for ((triangle, rest), h) in chart.triangles.iter().zip(rest).zip(hessians) {
        // How the two columns of the map change with each corner.
        let factors = [[-rest.p, -rest.q - rest.r], [rest.p, rest.q], [0.0, rest.r]];
        for (&vertex, [x, y]) in triangle.iter().zip(factors) {
            for axis in 0..2 {
                diagonal[vertex as usize][axis] += x * x * h[axis][axis]
                    + 2.0 * x * y * h[axis][2 + axis]
                    + y * y * h[2 + axis][2 + axis];
            }
        }
    }
    let apply = |x: &[Flat], out: &mut [Flat]| {
        out.fill([0.0; 2]);
        for ((triangle, rest), h) in chart.triangles.iter().zip(rest).zip(hessians) {
            let map = rest.map(triangle.map(|v| x[v as usize]));
            let force = std::array::from_fn(|i| (0..4).map(|j| h[i][j] * map[j]).sum());
            rest.scatter(force, *triangle, out);
        }
    };
    let precondition = |residual: &[Flat], out: &mut [Flat]| {
        for ((out, r), d) in out.iter_mut().zip(residual).zip(&diagonal) {
            *out = [0, 1].map(|axis| {
                if d[axis] > 0.0 {
                    r[axis] / d[axis]
                } else {
                    0.0
                }
            });
        }
    };
    let mut x = vec![[0.0; 2]; gradient.len()];
    let mut residual: Vec<Flat> = gradient.iter().map(|g| [-g[0], -g[1]]).collect();
    let mut conditioned = vec![[0.0; 2]; gradient.len()];
    precondition(&residual, &mut conditioned);
    let mut direction = conditioned.clone();
    let mut product = vec![[0.0; 2]; gradient.len()];
    let mut measure = dot(&residual, &conditioned);
    let enough = 1e-6 * measure;
    for _ in 0..INNER {
        if measure <= enough || measure.is_nan() {
            break;
        }
        apply(&direction, &mut product);
        let curvature = dot(&direction, &product);
        if curvature <= 0.0 || curvature.is_nan() {
            break;
        }
        let step = measure / curvature;
        for vertex in 0..x.len() {
            for axis in 0..2 {
                x[vertex][axis] += step * direction[vertex][axis];
                residual[vertex][axis] -= step * product[vertex][axis];
            }
        }
        precondition(&residual, &mut conditioned);
        let before = std::mem::replace(&mut measure, dot(&residual, &conditioned));
        let share = measure / before;
        for (direction, conditioned) in direction.iter_mut().zip(&conditioned) {
            for axis in 0..2 {
                direction[axis] = conditioned[axis] + share * direction[axis];
            }
        }
    }
    x
}

/// How far along a direction the first triangle folds.
fn first_fold(chart: &Chart, image: &[Flat], direction: &[Flat]) -> f64 {
    let mut first = f64::INFINITY;
    for triangle in &chart.triangles {
        let [a, b, c] = triangle.map(|v| image[v as usize]);
        let [p, q, r] = triangle.map(|v| direction[v as usize]);
        let (d, e) = (minus(b, a), minus(c, a));
        let (s, t) = (minus(q, p), minus(r, p));
        // The doubled area along the way: x t² + y t + z, positive at t = 0.
        let (x, y, z) = (cross(s, t), cross(d, t) + cross(s, e), cross(d, e));
        let discriminant = y * y - 4.0 * x * z;
        if discriminant < 0.0 {
            continue;
        }
        // The least positive root is 2 z / (√… − y) in the form that does not cancel.
        let denominator = -y + discriminant.sqrt();
        if denominator > 0.0 {
            first = first.min(2.0 * z / denominator);
        }
    }
    first
}

fn dot(a: &[Flat], b: &[Flat]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| a[0] * b[0] + a[1] * b[1])
        .sum()
}
