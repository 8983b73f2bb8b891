//! Recordings in the form of BVH files.

use std::collections::HashSet;

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::channels::usual;
use super::writer::{depth_first, plain};
use super::{Bvh, BvhJoint};
use crate::motion_file::Loss;
use crate::recording::Recording;
use crate::retarget::Source;
use crate::transform::Transform;

impl Bvh {
    /// A recording in the form of a BVH file of which one unit is `metres_per_unit` long, and what
    /// of it such a file does not hold: scaling, scalar tracks, and axes of joints at rest other
    /// than those of the file. Joints are at the same places in all frames, in so far as their
    /// scaled parents put them there.
    ///
    /// Where `like` has the same joints, a recording with the length of its unit, channels, offsets
    /// and End Sites are like in it. Otherwise joints without others below have an End Site, where
    /// the recording says that their bones [end](Recording::ends), else at the joint.
    ///
    /// ```
    /// use ga_anim::bvh::{self, Bvh};
    /// use ga_anim::recording::Recording;
    ///
    /// let motion = bvh::decode(
    ///     b"HIERARCHY ROOT arm { OFFSET 0 50 0 CHANNELS 1 Xrotation
    ///         JOINT hand { OFFSET 20 0 0 CHANNELS 1 Zrotation } }
    ///       MOTION Frames: 1 Frame Time: 0.01
    ///       30 90",
    /// )?;
    /// let recording = Recording::from_bvh(&motion, 0.01)?;
    /// let (written, losses) = Bvh::from_recording(&recording, 0.01, Some((&motion, 0.01)));
    /// assert!(losses.is_empty());
    /// assert_eq!(written.joints()[1].offset, [20.0, 0.0, 0.0]);
    /// let again = Recording::from_bvh(&bvh::decode(written.encode().as_bytes())?, 0.01)?;
    /// let [before, after] = [&recording, &again].map(|recording| recording.locals()[1].rotor());
    /// assert!((before.reverse() * after).scalar() > 1.0 - 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn from_recording(
        recording: &Recording,
        metres_per_unit: f64,
        like: Option<(&Self, f64)>,
    ) -> (Self, Vec<Loss>) {
        let mut losses = lost(recording);
        let order = depth_first(recording.parents());
        let mut place = vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            place[old] = new;
        }
        let like = like.filter(|(like, _)| has_joints_of(like, recording));
        let rest = Source::rest_positions(recording);
        let names = &mut HashSet::new();
        let joints = order.iter().map(|&old| {
            let joint = &recording.joints()[old];
            let parent = joint.parent.map(|parent| place[parent]);
            if let Some((like, unit)) = like {
                let in_unit = |v: [f64; 3]| match unit == metres_per_unit {
                    true => v,
                    false => v.map(|x| x * (unit / metres_per_unit)),
                };
                let own = &like.joints[old];
                return BvhJoint {
                    parent,
                    offset: in_unit(own.offset),
                    end_site: own.end_site.map(in_unit),
                    ..own.clone()
                };
            }
            let above = joint.parent.map_or([0.0; 3], |parent| rest[parent]);
            let is_leaf = !recording.parents().contains(&Some(old));
            let name = distinct(plain(&joint.name), names);
            if name != joint.name {
                losses.push(Loss::Name {
                    joint: joint.name.clone(),
                    written: name.clone(),
                });
            }
            BvhJoint {
                name,
                parent,
                offset: [0, 1, 2].map(|k| (rest[old][k] - above[k]) / metres_per_unit),
                channels: usual(parent.is_none()),
                first_channel: 0,
                end_site: is_leaf.then(|| {
                    let end = recording.ends()[old].unwrap_or_default();
                    end.map(|x| x / metres_per_unit)
                }),
            }
        });
        let joints: Vec<BvhJoint> = joints.collect();
        let frames = (0..recording.frame_count()).map(|frame| {
            let motions = motions(recording, frame);
            let own = order
                .iter()
                .map(|&old| in_units(motions[old], metres_per_unit));
            own.collect()
        });
        let frames: Vec<Vec<Motor<f64>>> = frames.collect();
        let motion = Self::of_motions(joints, recording.frame_time(), &frames);
        (motion, losses)
    }
}

/// Whether a file has the joints of a recording, in the same order.
fn has_joints_of(file: &Bvh, recording: &Recording) -> bool {
    let joints = recording.joints().iter().zip(file.joints());
    file.joints().len() == recording.joints().len()
        && joints
            .into_iter()
            .all(|(a, b)| a.name == b.name && a.parent == b.parent)
}

/// The motion of each joint relative to its parent in a frame, with the axes of the file at rest.
fn motions(recording: &Recording, frame: usize) -> Vec<Motor<f64>> {
    let locals = recording.frame(frame).unwrap_or_default();
    let rests = recording.joints().iter().map(|joint| &joint.rest);
    let is_plain = rests.clone().all(|rest| !is_rotated(rest.rotor()))
        && rests.chain(locals).all(|local| local.is_rigid());
    if is_plain {
        return locals.iter().map(|local| local.motor).collect();
    }
    let frames = recording.frames_of_joints(frame).unwrap_or_default();
    let joints = recording.joints().iter().zip(&frames);
    let own = joints.map(|(joint, &own)| match joint.parent {
        Some(parent) => frames[parent].reverse() * own,
        None => own,
    });
    own.collect()
}

/// The motor with lengths in metres divided by the length of a unit.
fn in_units(motor: Motor<f64>, metres_per_unit: f64) -> Motor<f64> {
    let place = Vector::from(motor.translator().displacement()) * metres_per_unit.recip();
    Translator::from_displacement(place.coordinates()) * motor.rotor()
}

/// What counts as no rotation and no scaling: the rounding of files in single precision.
const NEGLIGIBLE: f64 = 1e-6;

fn is_rotated(rotor: Rotor<f64>) -> bool {
    let parts = [rotor.e12(), rotor.e13(), rotor.e23()];
    parts.iter().any(|part| part.abs() > NEGLIGIBLE)
}

/// What a BVH file does not hold of a recording.
fn lost(recording: &Recording) -> Vec<Loss> {
    let mut losses = Vec::new();
    let joints = recording.joints();
    let is_scaled = |local: &Transform<f64>| {
        let factors = local.scale.coordinates();
        factors
            .iter()
            .any(|factor| (factor - 1.0).abs() > NEGLIGIBLE)
    };
    let scaled = |joint: usize| {
        let mut locals = recording.locals().iter().skip(joint).step_by(joints.len());
        locals.position(is_scaled)
    };
    let scaled: Vec<(usize, usize)> = (0..joints.len())
        .filter_map(|joint| Some((joint, scaled(joint)?)))
        .collect();
    if let Some(&(joint, frame)) = scaled.first() {
        losses.push(Loss::Scale {
            joints: scaled.len(),
            joint: joints[joint].name.clone(),
            frame,
        });
    }
    let rotated = joints.iter();
    let rotated: Vec<_> = rotated
        .filter(|joint| is_rotated(joint.rest.rotor()))
        .collect();
    if let Some(first) = rotated.first() {
        losses.push(Loss::JointAxes {
            joints: rotated.len(),
            joint: first.name.clone(),
        });
    }
    if !recording.tracks().is_empty() {
        let tracks = recording.tracks().iter().map(|track| track.name.clone());
        losses.push(Loss::Tracks {
            tracks: tracks.collect(),
        });
    }
    losses
}

/// A name that is not among others, with a number behind it where it is.
fn distinct(name: String, others: &mut HashSet<String>) -> String {
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let mut all = std::iter::once(name.clone()).chain(numbered);
    // There are more numbers than names.
    let found = all
        .find(|name| !others.contains(name))
        .unwrap_or(name.clone());
    others.insert(found.clone());
    found
}
