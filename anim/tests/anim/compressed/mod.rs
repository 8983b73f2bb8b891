//! Compressed clips: their bound on made and real recordings, and damaged files.

mod bound;
mod damage;
mod real;
mod sampling;

use ga_anim::clip::compressed::{CompressedClip, Options, Sampler, compress};
use ga_anim::recording::{RecordedJoint, Recording};
use ga_anim::transform::Transform;
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;
use glam::{DAffine3, DQuat, DVec3};

/// A recording of a hierarchy given by its parents, with local transforms by frame and joint.
fn recording(
    parents: &[Option<usize>],
    frame_time: f64,
    frames: usize,
    local: impl Fn(usize, usize) -> Transform<f64>,
) -> Recording {
    let joints = parents
        .iter()
        .enumerate()
        .map(|(joint, &parent)| RecordedJoint {
            name: format!("joint {joint}"),
            parent,
            rest: local(0, joint),
        });
    let locals = (0..frames).flat_map(|frame| (0..parents.len()).map(move |joint| (frame, joint)));
    let locals = locals.map(|(frame, joint)| local(frame, joint)).collect();
    Recording::new(joints.collect(), frame_time, locals, Vec::new()).unwrap()
}

fn rotation(rotation: [f64; 3]) -> Rotor<f64> {
    Rotor::from_rotation_vector(rotation).unwrap()
}

fn rigid(place: [f64; 3], rotor: Rotor<f64>) -> Transform<f64> {
    Transform::from_parts(Vector::from(place), rotor, Vector::new(1.0, 1.0, 1.0))
}

fn chain(count: usize) -> Vec<Option<usize>> {
    (0..count).map(|joint| joint.checked_sub(1)).collect()
}

/// Parents of a tree with two children of most joints.
fn tree(count: usize) -> Vec<Option<usize>> {
    (0..count)
        .map(|joint| (joint > 0).then(|| (joint - 1) / 2))
        .collect()
}

/// Numbers between −1 and 1 that are the same in every run and look like noise.
fn noise(a: usize, b: usize, c: usize) -> f64 {
    let mut x = (a as u64) << 40 ^ (b as u64) << 20 ^ c as u64 ^ 0x9e37_79b9_7f4a_7c15;
    for _ in 0..3 {
        x ^= x >> 33;
        x = x.wrapping_mul(0xff51_afd7_ed55_8ccd);
    }
    (x >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

fn compressed(recording: &Recording, options: &Options) -> CompressedClip {
    compress(recording, options, |_, _| ()).unwrap()
}

/// The ratio of 40 bytes for each joint and frame to the file without the names of joints.
fn ratio(clip: &CompressedClip) -> f64 {
    let bytes = clip.as_bytes().len() - clip.name_bytes();
    (40 * clip.frame_count() * clip.parents().len()) as f64 / bytes as f64
}

fn affine(scale: [f64; 3], ([x, y, z], w): ([f64; 3], f64), place: [f64; 3]) -> DAffine3 {
    let rotation = DQuat::from_xyzw(x, y, z, w);
    DAffine3::from_scale_rotation_translation(scale.into(), rotation, place.into())
}

fn in_model_space(parents: &[Option<usize>], locals: Vec<DAffine3>) -> Vec<DAffine3> {
    let mut models: Vec<DAffine3> = Vec::new();
    for (local, parent) in locals.into_iter().zip(parents) {
        models.push(parent.map_or(local, |parent| models[parent] * local));
    }
    models
}

/// The frames of a recording in model space, by matrices apart from any motor.
fn truth(recording: &Recording, frame: usize) -> Vec<DAffine3> {
    let locals = recording.frame(frame).unwrap().iter().map(|local| {
        affine(
            local.scale.coordinates(),
            local.rotor().to_quaternion(),
            local.translation().coordinates(),
        )
    });
    in_model_space(recording.parents(), locals.collect())
}

/// The same of what a sampler holds.
fn found(sampler: &Sampler, parents: &[Option<usize>]) -> Vec<DAffine3> {
    let parts = sampler
        .rotors()
        .iter()
        .zip(sampler.translations())
        .zip(sampler.scales());
    let locals = parts.map(|((rotor, place), scale)| {
        let ([x, y, z], w) = rotor.to_quaternion();
        affine(
            scale.coordinates().map(f64::from),
            ([x, y, z].map(f64::from), f64::from(w)),
            place.coordinates().map(f64::from),
        )
    });
    in_model_space(parents, locals.collect())
}

/// The greatest distance from their true places of many points on the ball about a joint in model
/// space.
fn shell_error(found: &DAffine3, truth: &DAffine3, shell: f64) -> f64 {
    let mut greatest = 0.0f64;
    for a in 0..12 {
        for b in 0..24 {
            let (polar, around) = (f64::from(a) * 0.27, f64::from(b) * 0.27);
            let direction = DVec3::new(
                polar.sin() * around.cos(),
                polar.sin() * around.sin(),
                polar.cos(),
            );
            // Of the joint's own coordinates, where its frame is scaled.
            let point = truth.matrix3.inverse() * (direction * shell);
            let error = found
                .transform_point3(point)
                .distance(truth.transform_point3(point));
            greatest = greatest.max(error);
        }
    }
    greatest
}

/// The greatest error of any joint in any frame, by points on the balls about the joints.
fn greatest_error(recording: &Recording, clip: &CompressedClip, shell: f64) -> f64 {
    let mut sampler = Sampler::new(clip);
    let mut greatest = 0.0f64;
    for frame in 0..recording.frame_count() {
        sampler.sample(frame as f64 * recording.frame_time());
        let found = found(&sampler, clip.parents());
        for (found, truth) in found.iter().zip(truth(recording, frame)) {
            greatest = greatest.max(shell_error(found, &truth, shell));
        }
    }
    greatest
}
