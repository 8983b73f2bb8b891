//! How the axes of a joint and of its counterpart on the other side belong together.

use std::f64::consts::{PI, TAU};

use ga_runtime::cga3::{Direction, DualPlane, Motor, Rotor};
use ga_runtime::vga3::Vector;

use super::Recording;
use crate::clip::reflected;

/// The greatest mean angle, in degrees, between a bone at rest and the reflected one of the other
/// side in a body that is nearly its own mirror image.
const ALIKE: f64 = 20.0;
/// What is known without the bones weighs this part of them, in so many rounds, each of which
/// begins with the result of the one before, so that only what the bones leave open remains of it.
const FAINT: f64 = 1e-3;
const ROUNDS: usize = 16;

const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A bone as the joint has it at which it begins, and its counterpart as that one's joint has it.
type Bones = [Vector<f64>; 2];

/// For each joint the rotor Q, with which `π Q` takes vectors in the axes of the joint to their
/// mirror images in those of its counterpart.
///
/// `π Q` and that of the counterpart are each other's inverses, so that the mirror image of a
/// mirror image is the motion itself.
pub(super) fn mirror_axes(
    recording: &Recording,
    counterparts: &[usize],
    plane: DualPlane<f64>,
) -> Vec<Rotor<f64>> {
    let bones = bones(recording, counterparts);
    let at_rest = axes_at_rest(recording, counterparts, plane);
    let is_alike = mean_angle(&bones, &at_rest, plane) <= ALIKE;
    let mut axes: Vec<Rotor<f64>> = Vec::with_capacity(bones.len());
    for (joint, bones) in bones.iter().enumerate() {
        let other = counterparts[joint];
        let next = if other < joint {
            mirrored(plane, axes[other].reverse())
        } else {
            let known = match recording.joints[joint].parent {
                Some(parent) if !is_alike => {
                    // π Q = ~L_o (π Q_p) L for the mean rotations L and L_o of both joints.
                    let [own, there] = [joint, other].map(|joint| mean_rotation(recording, joint));
                    mirrored(plane, there.reverse()) * axes[parent] * own
                }
                _ => at_rest[joint],
            };
            let found = fitted(bones, known, plane);
            match other == joint {
                true => between(found, mirrored(plane, found.reverse())),
                false => found,
            }
        };
        axes.push(next);
    }
    axes
}

/// The rotor half-way between two that are near each other.
fn between(a: Rotor<f64>, b: Rotor<f64>) -> Rotor<f64> {
    let (axis, angle) = (b * a.reverse()).to_axis_angle();
    let angle = if angle > PI { angle - TAU } else { angle };
    Rotor::from_axis_angle(axis, 0.5 * angle).map_or(a, |half| half * a)
}

/// The bones that begin at each joint.
fn bones(recording: &Recording, counterparts: &[usize]) -> Vec<Vec<Bones>> {
    let mut bones = vec![Vec::new(); counterparts.len()];
    for (joint, own) in recording.joints.iter().enumerate() {
        let other = &recording.joints[counterparts[joint]];
        if let Some(parent) = own.parent {
            bones[parent].push([own.rest.translation(), other.rest.translation()]);
        }
    }
    bones
}

/// `Q = π ~B π A` with the axes at rest in model space.
fn axes_at_rest(
    recording: &Recording,
    counterparts: &[usize],
    plane: DualPlane<f64>,
) -> Vec<Rotor<f64>> {
    let mut rotors: Vec<Rotor<f64>> = Vec::with_capacity(counterparts.len());
    for joint in &recording.joints {
        let above = joint
            .parent
            .map_or(Rotor::default(), |parent| rotors[parent]);
        rotors.push(above * joint.rest.rotor());
    }
    let pairs = rotors.iter().zip(counterparts);
    pairs
        .map(|(own, &other)| mirrored(plane, rotors[other].reverse()) * *own)
        .collect()
}

/// The mean angle between bones after `π Q` and their counterparts, by their lengths.
fn mean_angle(bones: &[Vec<Bones>], axes: &[Rotor<f64>], plane: DualPlane<f64>) -> f64 {
    let (mut sum, mut length) = (0.0, 0.0);
    for (bones, axes) in bones.iter().zip(axes) {
        for bone in bones {
            sum += angle(bone, *axes, plane) * bone[0].length();
            length += bone[0].length();
        }
    }
    if length > 0.0 { sum / length } else { 0.0 }
}

/// The angle in degrees between a bone after `π Q` and its counterpart; 0 for one without length.
fn angle([own, other]: &Bones, axes: Rotor<f64>, plane: DualPlane<f64>) -> f64 {
    let found = rotated(axes, *own);
    let angle = found.angle(reflection(plane, *other));
    angle.map_or(0.0, f64::to_degrees)
}

/// The rotor Q with which `π Q` takes bones to their counterparts as well as it can, and which is
/// otherwise as near to a known one as can be.
fn fitted(bones: &[Bones], known: Rotor<f64>, plane: DualPlane<f64>) -> Rotor<f64> {
    let mut pairs = Vec::with_capacity(bones.len() + 3);
    let mut whole = 0.0;
    for &[own, other] in bones {
        let other = reflection(plane, other);
        let weight = own.length() * other.length();
        if weight > 0.0 {
            whole += weight;
            pairs.push((weight, own.coordinates(), other.coordinates()));
        }
    }
    if pairs.is_empty() {
        return known;
    }
    let mut found = known;
    for _ in 0..ROUNDS {
        let mut pairs = pairs.clone();
        for own in AXES {
            let there = rotated(found, own.into());
            pairs.push((FAINT * whole, own, there.coordinates()));
        }
        match Rotor::from_weighted_direction_pairs(&pairs) {
            Ok(fit) => found = fit.motion,
            Err(_) => break,
        }
    }
    found
}

/// The mean of a joint's rotations relative to its parent over all frames.
fn mean_rotation(recording: &Recording, joint: usize) -> Rotor<f64> {
    let mut sums = [Vector::default(); 3];
    let count = recording.joints.len();
    for frame in recording.locals.chunks_exact(count) {
        for (axis, sum) in AXES.into_iter().zip(&mut sums) {
            *sum += rotated(frame[joint].rotor(), axis.into());
        }
    }
    let pairs = AXES.into_iter().zip(sums);
    let pairs = pairs.map(|(axis, sum)| (sum.length(), axis, sum.coordinates()));
    let fit = Rotor::from_weighted_direction_pairs(&pairs.collect::<Vec<_>>());
    fit.map_or_else(|_| recording.joints[joint].rest.rotor(), |fit| fit.motion)
}

fn rotated(rotor: Rotor<f64>, v: Vector<f64>) -> Vector<f64> {
    rotor.transform(Direction::from(v)).into()
}

/// π R π.
fn mirrored(plane: DualPlane<f64>, rotor: Rotor<f64>) -> Rotor<f64> {
    reflected(plane, Motor::from(rotor)).rotor()
}

/// The mirror image of a vector.
fn reflection(plane: DualPlane<f64>, v: Vector<f64>) -> Vector<f64> {
    let normal = Vector::new(plane.e1, plane.e2, plane.e3);
    v - normal * (2.0 * normal.dot(v))
}
