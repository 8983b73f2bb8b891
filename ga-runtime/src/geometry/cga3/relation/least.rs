//! The least distance from a circle to a line or to another circle.
//!
//! Along the angle θ of a point on the circle the squared distance g from a line or a circle has a
//! second derivative that is bounded from above, `g'' ≤ K`. So `g − ½Kθ²` is concave and lies above
//! its chords: within a cell of width w, g is nowhere more than `⅛Kw²` below its lesser end. Cells
//! that cannot hold the least value under this bound are dropped; in those where g is convex the
//! zero of g' is found; the others are halved, and a bound of the third derivative makes K tighter
//! as they shrink. Nothing is lost between samples, and the result depends on nothing but the
//! input.

use super::distance::across;
use crate::geometry::vector3::{cross, difference, dot, length, normalized, scaled, sum};
use crate::scalar::Real;
use alloc::vec::Vec;

/// Cells at first.
const CELLS: i64 = 32;
/// No cell is halved while there are more than these: then g is as good as constant.
const MOST_CELLS: usize = 256;
/// Steps to the zero of g' in one cell, every third of them a bisection.
const STEPS: usize = 120;

/// The least distance of a circle from a line of unit direction; `from` leads from the line's
/// nearest point to the centre of the circle.
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
    let bound = twice(radius) * (twice(radius) + length(from));
    let least = least(bound, &|angle, width| {
        let (sine, cosine) = angle.sin_cos();
        let arm = sum(scaled(u, radius * cosine), scaled(v, radius * sine));
        let step = difference(scaled(v, radius * cosine), scaled(u, radius * sine));
        let off = across(sum(from, arm), direction);
        let change = across(step, direction);
        let bend = dot(change, change) - dot(off, arm);
        // g''' is at most 6 r² + 2 r √g.
        let reach = length(off) + radius * width;
        Sample {
            angle,
            value: dot(off, off),
            slope: twice(dot(off, step)),
            bend: twice(bend),
            jerk: twice(radius * (S::from_integer(3) * radius + reach)),
        }
    });
    least.sqrt() * size
}

/// The least distance of a circle from another, fixed one; `from` leads from the centre of the
/// fixed circle to that of the other.
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
    let zero = S::zero();
    // g = |p|² + s² − 2 s ρ with ρ the distance from the axis; ρ'' is nowhere below minus the
    // radius.
    let bound = twice(radius) * (length(from) + fixed_radius);
    let least = least(bound, &|angle, width| {
        let (sine, cosine) = angle.sin_cos();
        let arm = sum(scaled(u, radius * cosine), scaled(v, radius * sine));
        let step = difference(scaled(v, radius * cosine), scaled(u, radius * sine));
        let place = sum(from, arm);
        // Height, distance from the axis, and their derivatives.
        let [z, z1, z2] = [place, step, arm].map(|x| dot(x, fixed_normal));
        let flat = difference(place, scaled(fixed_normal, z));
        let rho = length(flat);
        let short = rho - fixed_radius;
        let value = short * short + z * z;
        let away = rho - radius * width;
        if !zero.less_than(away) {
            // At the axis ρ has a kink upwards, and only the bound holds.
            let change = if zero.less_than(rho) {
                dot(flat, step) / rho
            } else {
                zero
            };
            let slope = twice(short * change + z * z1);
            let jerk = S::one() / zero;
            return Sample {
                angle,
                value,
                slope,
                bend: zero,
                jerk,
            };
        }
        let rho1 = dot(flat, step) / rho;
        let flat_step = difference(step, scaled(fixed_normal, z1));
        let rho2 = (dot(flat_step, flat_step) - dot(flat, arm) - rho1 * rho1) / rho;
        let bend = rho1 * rho1 + short * rho2 + z1 * z1 - z * z2;
        // |ρ'| ≤ r, |ρ''| ≤ r (1 + e) and |ρ'''| ≤ r (1 + 6 e + 6 e²) with e = r/ρ.
        let e = radius / away;
        let (three, six) = (S::from_integer(3), S::from_integer(6));
        let reach = short.abs() + z.abs() + radius * width;
        let wave = reach * (S::one() + six * e * (S::one() + e));
        Sample {
            angle,
            value,
            slope: twice(short * rho1 + z * z1),
            bend: twice(bend),
            jerk: twice(radius * (three * radius * (twice(S::one()) + e) + wave + reach)),
        }
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

/// A function at an angle, with its first and second derivatives and a bound of the third within a
/// width.
#[derive(Clone, Copy)]
struct Sample<S> {
    angle: S,
    value: S,
    slope: S,
    bend: S,
    jerk: S,
}

/// The least value of a function of an angle with `g'' ≤ bound`, which is given with the width that
/// the third derivative is to be bounded in.
fn least<S: Real<Mask = bool>>(bound: S, function: &dyn Fn(S, S) -> Sample<S>) -> S {
    let (zero, half) = (S::zero(), S::from_ratio(1, 2));
    let mut width = S::from_f64(core::f64::consts::TAU) * S::from_ratio(1, CELLS);
    let first = function(zero, width);
    let mut best = first.value;
    let mut cells = Vec::new();
    let mut left = first;
    for k in 1..=CELLS {
        let angle = width * S::from_integer(k);
        let right = if k == CELLS {
            Sample { angle, ..first }
        } else {
            function(angle, width)
        };
        best = best.min(right.value);
        cells.push([left, right]);
        left = right;
    }
    // Values within a cell differ by less than the scalar tells when its squared width is below ε.
    while cells.len() <= MOST_CELLS && S::epsilon().less_than(width * width) {
        let mut rest = Vec::new();
        for [left, right] in cells {
            let sway = left.jerk.max(right.jerk) * width * half;
            let most = bound.min(left.bend.max(right.bend) + sway).max(zero);
            let dip = most * width * width * S::from_ratio(1, 8);
            let is_above = best.less_than(left.value.min(right.value) - dip);
            if is_above || !resolution(best).less_than(dip) {
                continue;
            }
            if zero.less_than(left.bend.min(right.bend) - sway) {
                best = best.min(bottom([left, right], bound, function));
                continue;
            }
            let middle = function((left.angle + right.angle) * half, width);
            best = best.min(middle.value);
            rest.push([left, middle]);
            rest.push([middle, right]);
        }
        cells = rest;
        width *= half;
    }
    for cell in cells {
        best = best.min(bottom(cell, bound, function));
    }
    best
}

/// What makes no difference to a squared distance of figures of size 1: a part ε of it, or ε² where
/// they all but meet.
fn resolution<S: Real<Mask = bool>>(value: S) -> S {
    S::epsilon() * value.max(S::epsilon())
}

/// The least value met on the way to the zero of the derivative, where it rises through it between
/// the ends, or at the ends.
fn bottom<S: Real<Mask = bool>>(
    [mut left, mut right]: [Sample<S>; 2],
    bound: S,
    function: &dyn Fn(S, S) -> Sample<S>,
) -> S {
    let zero = S::zero();
    let mut best = left.value.min(right.value);
    if !left.slope.less_than(zero) || !zero.less_than(right.slope) {
        return best;
    }
    for step in 0..STEPS {
        let width = right.angle - left.angle;
        let dip = bound * width * width * S::from_ratio(1, 8);
        if !resolution(best).less_than(dip) {
            break;
        }
        // The chord of the derivative alone may creep along one side.
        let angle = if step % 3 == 2 {
            left.angle + width * S::from_ratio(1, 2)
        } else {
            left.angle - left.slope * (width / (right.slope - left.slope))
        };
        if !left.angle.less_than(angle) || !angle.less_than(right.angle) {
            continue;
        }
        let middle = function(angle, width);
        best = best.min(middle.value);
        if middle.slope.less_than(zero) {
            left = middle;
        } else if zero.less_than(middle.slope) {
            right = middle;
        } else {
            break;
        }
    }
    best
}
