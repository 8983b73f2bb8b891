//! Motions of joints as channels.

use super::super as gltf;
use super::super::{Channel, Interpolation, Keys};
use super::rigid::{normalized, rotation, translation};
use super::{Animation, JointNode, ModelProblem, Track};

/// An animation of these joints, whose nodes have their numbers.
pub(super) fn animation(
    animation: &Animation,
    joints: &[JointNode],
) -> Result<gltf::Animation, ModelProblem> {
    let times = times(animation)?;
    let channel = |node, keys| Channel {
        node,
        times: times.clone(),
        interpolation: Interpolation::Linear,
        keys,
        extras: None,
    };
    let mut channels = Vec::new();
    for track in tracks(animation, joints)? {
        let rotations = track.rotations.map(Keys::Rotation);
        let translations = track.translations.map(Keys::Translation);
        let keys = [rotations, translations].into_iter().flatten();
        channels.extend(keys.map(|keys| channel(track.joint, keys)));
    }
    Ok(gltf::Animation {
        name: Some(animation.name.clone()),
        channels,
        extras: None,
    })
}

/// The times of the keys in single precision.
fn times(animation: &Animation) -> Result<Vec<f32>, ModelProblem> {
    if animation.times.is_empty() {
        return Err(ModelProblem::NoKeys {
            animation: animation.name.clone(),
        });
    }
    let mut earliest = 0.0;
    let mut times = Vec::with_capacity(animation.times.len());
    for (key, &time) in animation.times.iter().enumerate() {
        let time = time as f32;
        if !(time >= earliest && time.is_finite()) {
            return Err(ModelProblem::Time {
                animation: animation.name.clone(),
                key,
            });
        }
        earliest = time.next_up();
        times.push(time);
    }
    Ok(times)
}

/// The tracks in single precision, at least one of them with rotations or translations.
fn tracks(animation: &Animation, joints: &[JointNode]) -> Result<Vec<SingleTrack>, ModelProblem> {
    let mut seen = vec![false; joints.len()];
    let mut tracks = Vec::with_capacity(animation.tracks.len());
    for track in &animation.tracks {
        match seen.get_mut(track.joint) {
            Some(seen) if !*seen => *seen = true,
            _ => {
                return Err(ModelProblem::TrackJoint {
                    animation: animation.name.clone(),
                    joint: track.joint,
                });
            }
        }
        tracks.push(SingleTrack::new(animation, track)?);
    }
    if tracks.is_empty() {
        return Err(ModelProblem::NoKeys {
            animation: animation.name.clone(),
        });
    }
    for (index, track) in tracks.iter_mut().enumerate() {
        // An animation must have a channel, so the first track keeps its rotations.
        track.drop_rest(&joints[track.joint], index == 0);
    }
    Ok(tracks)
}

/// A track in single precision; a part that stays at rest is `None`.
struct SingleTrack {
    joint: usize,
    rotations: Option<Vec<[f32; 4]>>,
    translations: Option<Vec<[f32; 3]>>,
}

impl SingleTrack {
    fn new(animation: &Animation, track: &Track) -> Result<Self, ModelProblem> {
        if track.keys.len() != animation.times.len() {
            return Err(ModelProblem::TrackLength {
                animation: animation.name.clone(),
                joint: track.joint,
                expected: animation.times.len(),
                found: track.keys.len(),
            });
        }
        let mut rotations = Vec::with_capacity(track.keys.len());
        let mut translations = Vec::with_capacity(track.keys.len());
        let mut before = [0.0, 0.0, 0.0, 1.0];
        for (key, &motor) in track.keys.iter().enumerate() {
            let bad_key = || ModelProblem::Key {
                animation: animation.name.clone(),
                joint: track.joint,
                key,
            };
            let motor = normalized(motor).ok_or_else(bad_key)?;
            let place = translation(motor).map(|c| c as f32);
            if !place.iter().all(|c| c.is_finite()) {
                return Err(bad_key());
            }
            let mut quaternion = rotation(motor);
            let cosine: f64 = (0..4).map(|i| quaternion[i] * before[i]).sum();
            if cosine < 0.0 {
                quaternion = quaternion.map(|c| -c);
            }
            before = quaternion;
            rotations.push(quaternion.map(|c| c as f32));
            translations.push(place);
        }
        Ok(Self {
            joint: track.joint,
            rotations: Some(rotations),
            translations: Some(translations),
        })
    }

    /// Drops the translations and, unless `keep_rotations`, the rotations if they stay at rest.
    fn drop_rest(&mut self, joint: &JointNode, keep_rotations: bool) {
        let rest_translation = translation(joint.rest).map(|c| c as f32);
        let mut translations = self.translations.iter().flatten();
        if translations.all(|t| are_close(t, &rest_translation)) {
            self.translations = None;
        }
        let rest = normalized(joint.rest).unwrap_or_default();
        let rest_rotation = rotation(rest).map(|c| c as f32);
        let opposite = rest_rotation.map(|c| -c);
        let is_at_rest = |r: &[f32; 4]| are_close(r, &rest_rotation) || are_close(r, &opposite);
        if !keep_rotations && self.rotations.iter().flatten().all(is_at_rest) {
            self.rotations = None;
        }
    }
}

/// Equal except for rounding.
fn are_close<const N: usize>(a: &[f32; N], b: &[f32; N]) -> bool {
    const TOLERANCE: f32 = 1e-7;
    (0..N).all(|i| (a[i] - b[i]).abs() <= TOLERANCE * (1.0 + b[i].abs()))
}
