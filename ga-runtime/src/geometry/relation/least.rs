//! The least distance from a circle to a line or to another circle.
//!
//! Along the unit circle of the angle θ the squared distance g from a line or a circle has a bounded second derivative, `g'' ≤ K`, if not
//! a small one from below. So `g − ½Kθ²` is concave and lies above its chords: within a cell of width w, g is nowhere more than
//! `⅛Kw²` below its lesser end. Cells that cannot hold the least value under this bound are dropped, the others halved. In what is left
//! the zero of g' is bracketed and found. Nothing is lost between samples, and the result depends on nothing but the input.

use super::distance::across;
use crate::geometry::vector3::{cross, difference, dot, length, normalized, scaled, sum};
use crate::scalar::Real;
use alloc::vec::Vec;

/// Cells at first, a power of two.
const CELLS: i64 = 32;
/// No cell is halved more often than this.
const HALVINGS: usize = 14;
/// Nor any while there are more than these: then g is as good as constant.
const MOST_CELLS: usize = 128;
/// Steps to the zero of g' in one cell, every third of them a bisection.
const STEPS: usize = 120;

/// The least distance of a circle from a line of unit direction; `from` leads from the line's nearest point to the centre of the circle.
pub(super) fn line_to_circle<S: Real<Mask = bool>>(
    direction: [S; 3],
    from: [S; 3],
    normal: [S; 3],
    radius: S,
) -> S {
    let size = radius.max(length(from));
    let Some((from, radius)) = in_units(size, from, radius) else {
        return size;
    };
    let [u, v] = frame(normal);
    let bound = (radius + radius) * (radius + radius + length(from));
    let least = least(bound, &|angle: S| {
        let (sine, cosine) = angle.sin_cos();
        let arm = sum(scaled(u, radius * cosine), scaled(v, radius * sine));
        let step = difference(scaled(v, radius * cosine), scaled(u, radius * sine));
        let off = across(sum(from, arm), direction);
        [dot(off, off), twice(dot(off, step))]
    });
    least.sqrt() * size
}

/// The least distance of a circle from another, fixed one; `from` leads from the centre of the fixed circle to that of the other.
pub(super) fn circle_to_circle<S: Real<Mask = bool>>(
    from: [S; 3],
    normal: [S; 3],
    radius: S,
    fixed_normal: [S; 3],
    fixed_radius: S,
) -> S {
    let size = fixed_radius.max(radius).max(length(from));
    let Some((from, radius)) = in_units(size, from, radius) else {
        return size;
    };
    let fixed_radius = fixed_radius / size;
    let [u, v] = frame(normal);
    // g = |p|² + s² − 2 s ρ with ρ the distance from the axis; ρ'' is nowhere below minus the radius.
    let bound = (radius + radius) * (length(from) + fixed_radius);
    let least = least(bound, &|angle: S| {
        let (sine, cosine) = angle.sin_cos();
        let arm = sum(scaled(u, radius * cosine), scaled(v, radius * sine));
        let step = difference(scaled(v, radius * cosine), scaled(u, radius * sine));
        let place = sum(from, arm);
        let height = dot(place, fixed_normal);
        let flat = difference(place, scaled(fixed_normal, height));
        let reach = length(flat);
        let short = reach - fixed_radius;
        let change = if S::zero().less_than(reach) {
            dot(flat, step) / reach
        } else {
            S::zero()
        };
        let slope = short * change + height * dot(fixed_normal, step);
        [short * short + height * height, twice(slope)]
    });
    least.sqrt() * size
}

fn twice<S: Real>(x: S) -> S {
    x + x
}

/// Lengths in units of a size; `None` where that is zero or not finite.
fn in_units<S: Real<Mask = bool>>(size: S, from: [S; 3], radius: S) -> Option<([S; 3], S)> {
    let usable = S::zero().less_than(size) && size.is_finite();
    usable.then(|| (from.map(|x| x / size), radius / size))
}

/// Two unit vectors that make a right-handed frame with a unit normal.
pub(super) fn frame<S: Real<Mask = bool>>(normal: [S; 3]) -> [[S; 3]; 2] {
    // Across the axis that the normal is farthest from.
    let [x, y, z] = normal.map(S::abs);
    let (zero, one) = (S::zero(), S::one());
    let axis = if !y.less_than(x) && !z.less_than(x) {
        [one, zero, zero]
    } else if !z.less_than(y) {
        [zero, one, zero]
    } else {
        [zero, zero, one]
    };
    let u = normalized(cross(axis, normal)).unwrap_or(axis);
    [u, cross(normal, u)]
}

/// One end of a cell: the angle, the value there and its derivative.
type End<S> = [S; 3];

/// The least value of a function of an angle with `g'' ≤ bound`, which gives value and derivative.
fn least<S: Real<Mask = bool>>(bound: S, function: &dyn Fn(S) -> [S; 2]) -> S {
    let end = |angle: S| {
        let [value, slope] = function(angle);
        [angle, value, slope]
    };
    let half = S::from_ratio(1, 2);
    let mut width = S::from_f64(core::f64::consts::TAU) * S::from_ratio(1, CELLS);
    let first = end(S::zero());
    let mut best = first[1];
    let mut cells: Vec<[End<S>; 2]> = Vec::new();
    let mut left = first;
    for k in 1..=CELLS {
        let right = if k == CELLS {
            [width * S::from_integer(CELLS), first[1], first[2]]
        } else {
            end(width * S::from_integer(k))
        };
        best = best.min(right[1]);
        cells.push([left, right]);
        left = right;
    }
    for halving in 0..=HALVINGS {
        let dip = bound * width * width * S::from_ratio(1, 8);
        cells.retain(|[left, right]| !best.less_than(left[1].min(right[1]) - dip));
        let is_flat = !(best * S::epsilon()).less_than(dip);
        if halving == HALVINGS || cells.len() > MOST_CELLS || is_flat {
            break;
        }
        let mut halves = Vec::with_capacity(2 * cells.len());
        for [left, right] in cells {
            let middle = end((left[0] + right[0]) * half);
            best = best.min(middle[1]);
            halves.push([left, middle]);
            halves.push([middle, right]);
        }
        cells = halves;
        width *= half;
    }
    let is_dip =
        |[left, right]: &[End<S>; 2]| left[2].less_than(S::zero()) && S::zero().less_than(right[2]);
    for cell in cells.into_iter().filter(is_dip) {
        best = best.min(bottom(cell, &end));
    }
    best
}

/// The least value met on the way to the zero of the derivative, which rises through it between the ends.
fn bottom<S: Real<Mask = bool>>(
    [mut left, mut right]: [End<S>; 2],
    end: &dyn Fn(S) -> End<S>,
) -> S {
    let half = S::from_ratio(1, 2);
    let mut best = left[1].min(right[1]);
    for step in 0..STEPS {
        let width = right[0] - left[0];
        let bisected = left[0] + width * half;
        let by_chord = left[0] - left[2] * (width / (right[2] - left[2]));
        // The chord alone may creep along one side.
        let angle = if step % 3 == 2 || !by_chord.is_finite() {
            bisected
        } else {
            by_chord
        };
        if !left[0].less_than(angle) || !angle.less_than(right[0]) {
            if step % 3 == 2 {
                break;
            }
            continue;
        }
        let middle = end(angle);
        best = best.min(middle[1]);
        if middle[2].less_than(S::zero()) {
            left = middle;
        } else if S::zero().less_than(middle[2]) {
            right = middle;
        } else {
            break;
        }
    }
    best
}
