//! Motions that can be transferred.

use std::fmt::Debug;

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::geometry::Affine;

use crate::bvh::Bvh;
use crate::recording::{Recording, model_maps};

/// A motion of a hierarchy of joints, in any unit: a [`Bvh`] or a [`Recording`].
///
/// The axes of every joint at rest are those of model space, y up.
pub trait Source: Debug {
    /// The names of the joints, parents before children.
    fn names(&self) -> Vec<&str>;

    /// The parents of the joints.
    fn parents(&self) -> Vec<Option<usize>>;

    /// Where the joints are at rest.
    fn rest_positions(&self) -> Vec<[f64; 3]>;

    /// Where the bones of joints end on which no other joint hangs, such as the top of the head at
    /// an End Site: relative to the joint, at rest. All are unknown by default.
    fn ends(&self) -> Vec<Option<[f64; 3]>> {
        vec![None; self.parents().len()]
    }

    /// How many frames there are.
    fn frame_count(&self) -> usize;

    /// The time from one frame to the next, in seconds.
    fn frame_time(&self) -> f64;

    /// The motion of each joint's frame in one frame of time, from the origin: T(position) R with
    /// the rotation R since rest. `None` when there is no such frame.
    fn frames_of_joints(&self, frame: usize) -> Option<Vec<Motor<f64>>>;
}

impl Source for Bvh {
    fn names(&self) -> Vec<&str> {
        self.joints()
            .iter()
            .map(|joint| joint.name.as_str())
            .collect()
    }

    fn parents(&self) -> Vec<Option<usize>> {
        self.joints().iter().map(|joint| joint.parent).collect()
    }

    fn rest_positions(&self) -> Vec<[f64; 3]> {
        Bvh::rest_positions(self)
    }

    fn ends(&self) -> Vec<Option<[f64; 3]>> {
        self.joints().iter().map(|joint| joint.end_site).collect()
    }

    fn frame_count(&self) -> usize {
        Bvh::frame_count(self)
    }

    fn frame_time(&self) -> f64 {
        Bvh::frame_time(self)
    }

    fn frames_of_joints(&self, frame: usize) -> Option<Vec<Motor<f64>>> {
        Bvh::frames_of_joints(self, frame)
    }
}

/// Joints that are scaled are where their scaled parents put them; their rotations are those of
/// their rotors.
impl Source for Recording {
    fn names(&self) -> Vec<&str> {
        self.joints()
            .iter()
            .map(|joint| joint.name.as_str())
            .collect()
    }

    fn parents(&self) -> Vec<Option<usize>> {
        Recording::parents(self).to_vec()
    }

    fn rest_positions(&self) -> Vec<[f64; 3]> {
        let rest: Vec<_> = self.joints().iter().map(|joint| joint.rest).collect();
        maps(self, &rest)
            .iter()
            .map(|map| map.translation)
            .collect()
    }

    fn ends(&self) -> Vec<Option<[f64; 3]>> {
        Recording::ends(self).to_vec()
    }

    fn frame_count(&self) -> usize {
        Recording::frame_count(self)
    }

    fn frame_time(&self) -> f64 {
        Recording::frame_time(self)
    }

    fn frames_of_joints(&self, frame: usize) -> Option<Vec<Motor<f64>>> {
        let locals = self.frame(frame)?;
        let maps = maps(self, locals);
        let mut rotors: Vec<[Rotor<f64>; 2]> = Vec::with_capacity(locals.len());
        let mut frames = Vec::with_capacity(locals.len());
        for ((joint, local), map) in self.joints().iter().zip(locals).zip(maps) {
            let own = [joint.rest.rotor(), local.rotor()];
            let [rest, now] = match joint.parent {
                Some(parent) => [0, 1].map(|k| rotors[parent][k] * own[k]),
                None => own,
            };
            rotors.push([rest, now]);
            let since_rest = now * rest.reverse();
            let rotor = Rotor::normalize(since_rest.into()).unwrap_or(since_rest);
            frames.push(Translator::from_displacement(map.translation) * rotor);
        }
        Some(frames)
    }
}

fn maps(recording: &Recording, locals: &[crate::transform::Transform<f64>]) -> Vec<Affine<f64>> {
    let mut maps = vec![Affine::from_translation([0.0; 3]); locals.len()];
    // A recording has one transform for each joint, parents first.
    let done = model_maps(Recording::parents(recording), locals, &mut maps);
    debug_assert!(done.is_ok());
    maps
}
