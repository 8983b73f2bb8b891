//! The least distance from a circle to a line or to another circle.
//!
//! Along the angle θ of a point on the circle the squared distance g from a line or a circle has a
//! second derivative that is bounded from above, `g'' ≤ K`. So `g − ½Kθ²` is concave and lies above
//! its chords: within a cell of width w, g is nowhere more than `⅛Kw²` below the smaller of its
//! values at the ends. Cells that cannot contain the least value under this bound are dropped; in
//! those where g is convex the zero of g' is found; the others are halved, and a bound of the third
//! derivative makes K tighter as they shrink. So no minimum between samples is missed, and the
//! result depends only on the input.

use crate::scalar::Real;
use crate::vga3::Vector;
use alloc::vec::Vec;

/// The number of cells at the start.
const CELLS: i64 = 32;
/// If there are more cells than this, none is halved further: g is then almost constant.
const MOST_CELLS: usize = 256;
/// The greatest number of steps to the zero of g' in one cell; every third is a bisection.
const STEPS: usize = 120;

/// The least distance of a circle from a line of unit direction; `from` is the vector from the
/// line's nearest point to the centre of the circle.
pub(super) fn line_to_circle<S: Real<Mask = bool>>(
    direction: Vector<S>,
    from: Vector<S>,
    normal: Vector<S>,
    radius: S,
) -> S {
    let size = radius.max(from.length());
    let Some((from, radius)) = in_units(size, from, radius) else {
        return size;
    };
    let [u, v] = normal.orthonormal_pair();
    let bound = twice(radius) * (twice(radius) + from.length());
    let least = least(bound, &|angle, width| {
        let (sine, cosine) = angle.sin_cos();
        let arm = u * (radius * cosine) + v * (radius * sine);
        let step = v * (radius * cosine) - u * (radius * sine);
        let off = (from + arm).across(direction);
        let change = step.across(direction);
        let bend = change.dot(change) - off.dot(arm);
        // g''' is at most 6 r² + 2 r √g.
        let reach = off.length() + radius * width;
        Sample {
            angle,
            value: off.dot(off),
            slope: twice(off.dot(step)),
            bend: twice(bend),
            jerk: twice(radius * (S::from_integer(3) * radius + reach)),
        }
    });
    least.sqrt() * size
}

/// The least distance of a circle from another, fixed one; `from` is the vector from the centre of
/// the fixed circle to that of the other.
pub(super) fn circle_to_circle<S: Real<Mask = bool>>(
    from: Vector<S>,
    normal: Vector<S>,
    radius: S,
    fixed_normal: Vector<S>,
    fixed_radius: S,
) -> S {
    let size = fixed_radius.max(radius).max(from.length());
    let Some((from, radius)) = in_units(size, from, radius) else {
        return size;
    };
    let fixed_radius = fixed_radius / size;
    let [u, v] = normal.orthonormal_pair();
    let zero = S::zero();
    // g = |p|² + s² − 2 s ρ with ρ the distance from the axis; ρ'' is nowhere below minus the
    // radius.
    let bound = twice(radius) * (from.length() + fixed_radius);
    let least = least(bound, &|angle, width| {
        let (sine, cosine) = angle.sin_cos();
        let arm = u * (radius * cosine) + v * (radius * sine);
        let step = v * (radius * cosine) - u * (radius * sine);
        let place = from + arm;
        // Height, distance from the axis, and their derivatives.
        let [z, z1, z2] = [place, step, arm].map(|x| x.dot(fixed_normal));
        let flat = place - fixed_normal * z;
        let rho = flat.length();
        let short = rho - fixed_radius;
        let value = short * short + z * z;
        let away = rho - radius * width;
        if !zero.less_than(away) {
            // At the axis ρ has a kink upwards, and only the bound holds.
            let change = if zero.less_than(rho) {
                flat.dot(step) / rho
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
        let rho1 = flat.dot(step) / rho;
        let flat_step = step - fixed_normal * z1;
        let rho2 = (flat_step.dot(flat_step) - flat.dot(arm) - rho1 * rho1) / rho;
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

/// Lengths divided by a size; `None` where that is zero or not finite.
fn in_units<S: Real<Mask = bool>>(size: S, from: Vector<S>, radius: S) -> Option<(Vector<S>, S)> {
    let usable = S::zero().less_than(size) && size.is_finite();
    usable.then(|| (from.divided(size), radius / size))
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

/// The least value of a function of an angle with `g'' ≤ bound`. The function takes the angle and
/// the width in which it has to bound the third derivative.
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
    // Where the squared width of a cell is below ε, values within it differ by less than the
    // precision of the scalar.
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

/// The change of a squared distance that is negligible for figures of size 1: ε times the squared
/// distance, or ε² where they almost meet.
fn resolution<S: Real<Mask = bool>>(value: S) -> S {
    S::epsilon() * value.max(S::epsilon())
}

/// The least value found: at the ends, or in the search for the zero of the derivative, where the
/// derivative changes from negative to positive between the ends.
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
        // Steps along the chord of the derivative alone may approach from one side only, slowly.
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
