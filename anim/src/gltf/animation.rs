//! Motions of joints as samplers and channels.

use serde_json::{Value, json};

use super::buffer::{Buffer, Elements, unit};
use super::{Animation, GltfError, JointNode, Track};

/// The animations that move anything.
pub(super) fn animations(
    animations: &[Animation],
    joints: &[JointNode],
    buffer: &mut Buffer,
) -> Result<Vec<Value>, GltfError> {
    animations
        .iter()
        .map(|animation| write(animation, joints, buffer))
        .collect()
}

fn write(
    animation: &Animation,
    joints: &[JointNode],
    buffer: &mut Buffer,
) -> Result<Value, GltfError> {
    let times = times(animation)?;
    let mut seen = vec![false; joints.len()];
    let mut tracks = Vec::with_capacity(animation.tracks.len());
    for track in &animation.tracks {
        match seen.get_mut(track.joint) {
            Some(seen) if !*seen => *seen = true,
            _ => {
                return Err(GltfError::TrackJoint {
                    animation: animation.name.clone(),
                    joint: track.joint,
                });
            }
        }
        tracks.push(SingleTrack::new(animation, track)?);
    }
    let mut first = true;
    for (track, source) in tracks.iter_mut().zip(&animation.tracks) {
        track.drop_rest(&joints[source.joint], first);
        first = false;
    }
    if tracks.is_empty() {
        return Err(GltfError::NoKeys {
            animation: animation.name.clone(),
        });
    }

    let input = buffer.add(None, Elements::bounded_floats(&times));
    let (mut samplers, mut channels) = (Vec::new(), Vec::new());
    let mut connect = |output: usize, joint: usize, path: &str| {
        channels.push(json!({
            "sampler": samplers.len(),
            "target": { "node": joint, "path": path },
        }));
        samplers.push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
    };
    let view = buffer.begin_view();
    for track in &tracks {
        if let Some(rotations) = &track.rotations {
            connect(
                buffer.push(view, Elements::floats(rotations)),
                track.joint,
                "rotation",
            );
        }
        if let Some(translations) = &track.translations {
            connect(
                buffer.push(view, Elements::floats(translations)),
                track.joint,
                "translation",
            );
        }
    }
    buffer.end_view(view, None);
    Ok(json!({ "name": animation.name, "samplers": samplers, "channels": channels }))
}

fn times(animation: &Animation) -> Result<Vec<[f32; 1]>, GltfError> {
    if animation.times.is_empty() {
        return Err(GltfError::NoKeys {
            animation: animation.name.clone(),
        });
    }
    let mut earliest = 0.0;
    let mut times = Vec::with_capacity(animation.times.len());
    for (key, &time) in animation.times.iter().enumerate() {
        let time = time as f32;
        if !(time >= earliest && time.is_finite()) {
            return Err(GltfError::Time {
                animation: animation.name.clone(),
                key,
            });
        }
        earliest = time.next_up();
        times.push([time]);
    }
    Ok(times)
}

/// A track in single precision; what stays at rest is `None`.
struct SingleTrack {
    joint: usize,
    rotations: Option<Vec<[f32; 4]>>,
    translations: Option<Vec<[f32; 3]>>,
}

impl SingleTrack {
    fn new(animation: &Animation, track: &Track) -> Result<Self, GltfError> {
        if track.keys.len() != animation.times.len() {
            return Err(GltfError::TrackLength {
                animation: animation.name.clone(),
                joint: track.joint,
                expected: animation.times.len(),
                found: track.keys.len(),
            });
        }
        let mut rotations = Vec::with_capacity(track.keys.len());
        let mut translations = Vec::with_capacity(track.keys.len());
        let mut before = [0.0, 0.0, 0.0, 1.0];
        for (key, transform) in track.keys.iter().enumerate() {
            let translation = transform.translation.map(|c| c as f32);
            let rotation = unit(transform.rotation);
            let (Some(mut rotation), true) = (rotation, translation.iter().all(|c| c.is_finite()))
            else {
                return Err(GltfError::Key {
                    animation: animation.name.clone(),
                    joint: track.joint,
                    key,
                });
            };
            let cosine: f64 = (0..4).map(|i| rotation[i] * before[i]).sum();
            if cosine < 0.0 {
                rotation = rotation.map(|c| -c);
            }
            before = rotation;
            rotations.push(rotation.map(|c| c as f32));
            translations.push(translation);
        }
        Ok(Self {
            joint: track.joint,
            rotations: Some(rotations),
            translations: Some(translations),
        })
    }

    /// Drops what stays at rest. An animation must have a channel: `keep` keeps the rotations in
    /// any case.
    fn drop_rest(&mut self, joint: &JointNode, keep: bool) {
        let translation = joint.rest.translation.map(|c| c as f32);
        let mut translations = self.translations.iter().flatten();
        if translations.all(|t| are_close(t, &translation)) {
            self.translations = None;
        }
        let rotation = unit(joint.rest.rotation)
            .unwrap_or_default()
            .map(|c| c as f32);
        let opposite = rotation.map(|c| -c);
        let mut rotations = self.rotations.iter().flatten();
        if !keep && rotations.all(|r| are_close(r, &rotation) || are_close(r, &opposite)) {
            self.rotations = None;
        }
    }
}

/// Equal but for rounding.
fn are_close<const N: usize>(a: &[f32; N], b: &[f32; N]) -> bool {
    const TOLERANCE: f32 = 1e-7;
    (0..N).all(|i| (a[i] - b[i]).abs() <= TOLERANCE * (1.0 + b[i].abs()))
}
