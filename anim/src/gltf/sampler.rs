//! The value of a channel of an animation at a time (glTF 2.0, appendix C).

use std::ops::{Add, Mul};

use ga_mesh::gltf::{Channel, Interpolation};
use ga_runtime::cga3::{Quaternion, Rotor};
use ga_runtime::vga3::Vector;

/// The translation or scale of a channel whose keys are these.
pub(super) fn vector(channel: &Channel, keys: &[[f32; 3]], time: f64) -> Vector<f64> {
    let key = |index: usize| Vector::from(keys[index].map(f64::from));
    sample(channel, key, |a, b, part| a.lerp(b, part), time)
}

/// The rotation of a channel whose keys are these quaternions (x, y, z, w); `None` where it is the
/// zero quaternion.
pub(super) fn rotation(channel: &Channel, keys: &[[f32; 4]], time: f64) -> Option<Rotor<f64>> {
    let key = |index: usize| quaternion(keys[index]);
    Rotor::normalize(sample(channel, key, slerp, time))
}

/// The weights of morph targets of a channel whose keys are these: one for each key and target.
pub(super) fn weights(channel: &Channel, keys: &[f32], time: f64, weights: &mut [f64]) {
    let targets = weights.len();
    for (target, weight) in weights.iter_mut().enumerate() {
        let key = |index: usize| f64::from(keys[index * targets + target]);
        *weight = sample(channel, key, |a, b, part| a + (b - a) * part, time);
    }
}

/// The sum of rotors that a quaternion (x, y, z, w) of any length is.
pub(super) fn quaternion(numbers: [f32; 4]) -> Quaternion<f64> {
    let [x, y, z, w] = numbers.map(f64::from);
    Quaternion::new(w, -z, y, -x)
}

/// Where a time lies among the times of keys.
enum Place {
    /// At a key, or before the first or after the last.
    Key(usize),
    /// After a key: the part of the interval to the next that has passed, and its length.
    After(usize, f64, f64),
}

fn place(times: &[f32], time: f64) -> Place {
    let passed = times.partition_point(|&key| f64::from(key) <= time);
    if passed == 0 || passed == times.len() {
        return Place::Key(passed.saturating_sub(1));
    }
    let [start, end] = [times[passed - 1], times[passed]].map(f64::from);
    Place::After(passed - 1, (time - start) / (end - start), end - start)
}

/// The value at a time. `value` has the numbers of the channel by their index in the file, and
/// `linear` is what lies between two keys of [`Interpolation::Linear`].
fn sample<V>(
    channel: &Channel,
    value: impl Fn(usize) -> V,
    linear: impl Fn(V, V, f64) -> V,
    time: f64,
) -> V
where
    V: Copy + Add<Output = V> + Mul<f64, Output = V>,
{
    let interpolation = channel.interpolation;
    let per_key = interpolation.values_per_key();
    // The value of a key of a spline stands between the tangent into it and the one out of it.
    let key = |index: usize| value(per_key * index + per_key / 2);
    match place(&channel.times, time) {
        Place::Key(index) => key(index),
        Place::After(before, part, interval) => match interpolation {
            Interpolation::Step => key(before),
            Interpolation::Linear => linear(key(before), key(before + 1), part),
            Interpolation::CubicSpline => {
                let out_of = value(per_key * before + 2) * interval;
                let into = value(per_key * (before + 1)) * interval;
                hermite([key(before), out_of], [key(before + 1), into], part)
            }
        },
    }
}

/// Hermite's cubic from one value and tangent at part 0 to another at part 1.
fn hermite<V>([from, out_of]: [V; 2], [to, into]: [V; 2], part: f64) -> V
where
    V: Add<Output = V> + Mul<f64, Output = V>,
{
    let (square, cube) = (part * part, part * part * part);
    from * (2.0 * cube - 3.0 * square + 1.0)
        + out_of * (cube - 2.0 * square + part)
        + to * (3.0 * square - 2.0 * cube)
        + into * (cube - square)
}

/// Slerp by the shorter arc, up to a factor, with the keys as they are in the file, whose lengths
/// are near 1. The angle between a and b is 2 atan2(|a − b|, |a + b|); arccos (a · b) would lose
/// the angles of keys nearer than the rounding of their numbers.
///
/// [`Rotor::interpolate`] takes rotors, so the keys would have to be normalised first. The result
/// would then differ from what every player shows by as much as the keys do from unit length, which
/// is 1e-4 in files with three digits.
fn slerp(a: Quaternion<f64>, b: Quaternion<f64>, part: f64) -> Quaternion<f64> {
    let length = |q: Quaternion<f64>| q.scalar.hypot(q.e12).hypot(q.e13).hypot(q.e23);
    let cosine = a.scalar * b.scalar + a.e12 * b.e12 + a.e13 * b.e13 + a.e23 * b.e23;
    let b = if cosine < 0.0 { b * -1.0 } else { b };
    let angle = 2.0 * length(a - b).atan2(length(a + b));
    if angle == 0.0 {
        return a;
    }
    a * ((1.0 - part) * angle).sin() + b * (part * angle).sin()
}
