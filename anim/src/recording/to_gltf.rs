//! Recordings as animations of glTF documents.

use ga_mesh::gltf::{
    Animation, Channel, Document, Interpolation, Keys, Node, Scene, Transform as NodeTransform,
};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::Recording;
use super::from_gltf::{GltfMotion, Source};
use super::model_space::model_maps;
use crate::file_error::MotionFileError;
use crate::gltf::{quaternion, to_node};
use crate::motion_file::Loss;
use crate::recording::RecordingError;
use crate::transform::Transform;

/// By how much a place may be rounded in silence, in metres.
const ROUNDING: f64 = 1e-6;

impl Recording {
    /// The recording as the only animation of a document with a node for each joint, in metres, and
    /// what of it is not there: scalar tracks, and places beyond single precision.
    #[must_use]
    pub fn to_gltf(&self, name: &str) -> (Document, Vec<Loss>) {
        let node = |(index, joint): (usize, &super::RecordedJoint)| Node {
            name: Some(joint.name.clone()),
            children: (0..self.joints.len())
                .filter(|&child| self.parents[child] == Some(index))
                .collect(),
            transform: to_node(&joint.rest),
            ..Node::default()
        };
        let roots = (0..self.joints.len()).filter(|&joint| self.parents[joint].is_none());
        let mut document = Document {
            scene: Some(0),
            scenes: vec![Scene {
                nodes: roots.collect(),
                ..Scene::default()
            }],
            nodes: self.joints.iter().enumerate().map(node).collect(),
            ..Document::default()
        };
        let mut keys = NodeKeys::new(self);
        for joint in 0..self.joints.len() {
            let locals = self.locals.iter().skip(joint).step_by(self.joints.len());
            keys.add(&mut document, joint, (joint, 1.0), locals.copied());
        }
        let mut losses = keys.losses(self);
        if !self.tracks.is_empty() {
            let tracks = self.tracks.iter().map(|track| track.name.clone());
            losses.push(Loss::Tracks {
                tracks: tracks.collect(),
            });
        }
        document.animations.push(Animation {
            name: Some(name.to_owned()),
            channels: keys.channels,
            extras: None,
        });
        (document, losses)
    }
}

impl GltfMotion<'_> {
    /// The document with a recording of the same joints in place of the animation, and what of the
    /// recording is not there. Everything else of the document stays.
    ///
    /// # Errors
    ///
    /// [`RecordingError::JointCount`] and [`RecordingError::JointName`] for a recording of other
    /// joints, and [`MotionFileError::NoAnimation`] where there is none.
    pub fn with_recording(
        &self,
        recording: &Recording,
    ) -> Result<(Document, Vec<Loss>), MotionFileError> {
        let (mut document, channels, losses) = self.moved(recording)?;
        let count = document.animations.len();
        let animation = self.animation.unwrap_or(count);
        let replaced = document.animations.get_mut(animation);
        let replaced = replaced.ok_or(MotionFileError::NoAnimation { animation, count })?;
        replaced.channels = channels;
        Ok((document, losses))
    }

    /// The document with a recording of the same joints as its first animation, and what of the
    /// recording is not there. Its own animations follow unless `keeps` is false; where one of them
    /// has the name already, the new one gets a number at the end of its name.
    ///
    /// # Errors
    ///
    /// [`RecordingError::JointCount`] and [`RecordingError::JointName`].
    pub fn with_first(
        &self,
        name: &str,
        recording: &Recording,
        keeps: bool,
    ) -> Result<(Document, Vec<Loss>), MotionFileError> {
        let (mut document, channels, losses) = self.moved(recording)?;
        if !keeps {
            document.animations.clear();
        }
        let first = Animation {
            name: Some(unused_name(name, &document.animations)),
            channels,
            extras: None,
        };
        document.animations.insert(0, first);
        Ok((document, losses))
    }

    /// The document, channels of an animation that moves its nodes as a recording does, and what of
    /// that is not there.
    fn moved(
        &self,
        recording: &Recording,
    ) -> Result<(Document, Vec<Channel>, Vec<Loss>), MotionFileError> {
        let (expected, found) = (self.joints.len(), recording.joints.len());
        if expected != found {
            return Err(RecordingError::JointCount {
                recording: 1,
                expected,
                found,
            }
            .into());
        }
        for (joint, (own, other)) in self.joints.iter().zip(&recording.joints).enumerate() {
            if own.name != other.name {
                return Err(RecordingError::JointName {
                    recording: 1,
                    joint,
                    expected: own.name.clone(),
                    found: other.name.clone(),
                }
                .into());
            }
        }
        let mut document = self.player.document().clone();
        let mut keys = NodeKeys::new(recording);
        for (joint, source) in self.sources.iter().enumerate() {
            let locals = recording.locals.iter().skip(joint).step_by(found);
            let own = locals.map(|local| self.own(source, local));
            let unit = self.metres_per_unit * source.above.scale.e1;
            keys.add(&mut document, source.node, (joint, unit), own);
        }
        let mut left: Vec<&super::ScalarTrack> = recording.tracks.iter().collect();
        let rest = self.player.pose(None, 0.0)?;
        for &node in &self.morphed {
            let names: Vec<String> = self.track_names(node).collect();
            let tracks = names.iter().map(|name| {
                let place = left.iter().position(|track| track.name == *name);
                place.map(|place| left.remove(place))
            });
            let tracks: Vec<Option<&super::ScalarTrack>> = tracks.collect();
            // What the recording does not know stays as the node has it.
            if self.animation.is_none() && tracks.iter().all(Option::is_none) {
                continue;
            }
            let own = rest.weights(node);
            let frames = 0..recording.frame_count();
            let weights = frames.flat_map(|frame| {
                let of_targets = tracks.iter().zip(own);
                of_targets
                    .map(move |(track, own)| track.map_or(*own, |track| track.values[frame]) as f32)
            });
            keys.push(node, Keys::Weights(weights.collect()));
        }
        let mut losses = keys.losses(recording);
        if !left.is_empty() {
            let tracks = left.iter().map(|track| track.name.clone()).collect();
            losses.push(Loss::Tracks { tracks });
        }
        Ok((document, keys.channels, losses))
    }

    /// The transform of a node whose joint has a transform in metres: the inverse of what lies
    /// above, and then it.
    fn own(&self, source: &Source, local: &Transform<f64>) -> Transform<f64> {
        let above = &source.above;
        let place = local.translation() * self.metres_per_unit.recip() - above.translation();
        let back = above.rotor().reverse();
        let place: Vector<f64> = back
            .transform(ga_runtime::cga3::Direction::from(place))
            .into();
        let quotient = |v: Vector<f64>| {
            let (v, by) = (v.coordinates(), above.scale.coordinates());
            Vector::from([0, 1, 2].map(|axis| v[axis] / by[axis]))
        };
        Transform::from_parts(quotient(place), back * local.rotor(), quotient(local.scale))
    }
}

/// The name, or where an animation has it the first name with a number that none has.
fn unused_name(name: &str, animations: &[Animation]) -> String {
    let numbered = (2..).map(|number| format!("{name} {number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    let is_used = |name: &String| animations.iter().any(|it| it.name.as_ref() == Some(name));
    names.find(|name| !is_used(name)).unwrap_or_default()
}

/// The channels of an animation with a key in every frame.
struct NodeKeys {
    times: Vec<f32>,
    channels: Vec<Channel>,
    /// For each joint the factor of the joints above it at rest.
    factors: Vec<f64>,
    /// The joint whose place is rounded most, by how much, and how far it is, in metres.
    rounded: Option<(usize, f64, f64)>,
}

impl NodeKeys {
    fn new(recording: &Recording) -> Self {
        let frames = 0..recording.frame_count();
        let time = |frame: usize| (frame as f64 * recording.frame_time) as f32;
        let rest: Vec<_> = recording.joints.iter().map(|joint| joint.rest).collect();
        let mut maps = vec![Affine::default(); rest.len()];
        // A recording has one transform for each joint, parents first.
        let done = model_maps(&recording.parents, &rest, &mut maps);
        debug_assert!(done.is_ok());
        let factor = |parent: usize| maps[parent].determinant().abs().cbrt();
        let parents = recording.parents.iter();
        Self {
            times: frames.map(time).collect(),
            channels: Vec::new(),
            factors: parents.map(|parent| parent.map_or(1.0, factor)).collect(),
            rounded: None,
        }
    }

    fn push(&mut self, node: usize, keys: Keys) {
        self.channels.push(Channel {
            node,
            times: self.times.clone(),
            interpolation: Interpolation::Linear,
            keys,
            extras: None,
        });
    }

    /// Adds the channels of a node for what it does not have by itself in all frames, and in a
    /// document without skins at least one: readers know its joints by what an animation moves. A
    /// unit of the document above the joints is `unit` metres long.
    fn add(
        &mut self,
        document: &mut Document,
        node: usize,
        (joint, unit): (usize, f64),
        locals: impl Iterator<Item = Transform<f64>>,
    ) {
        let metres = unit * self.factors[joint];
        let needs_key = document.skins.is_empty();
        let before = self.channels.len();
        let (mut translations, mut rotations, mut scales) = (Vec::new(), Vec::new(), Vec::new());
        let mut first = None;
        for local in locals {
            let place = local.translation();
            let rounded = place.coordinates().map(|x| x as f32);
            let error = metres * place.distance(Vector::from(rounded.map(f64::from)));
            if self.rounded.is_none_or(|(_, most, _)| error > most) {
                self.rounded = Some((joint, error, metres * place.length()));
            }
            translations.push(rounded);
            rotations.push(quaternion(local.rotor(), rotations.last()));
            scales.push(local.scale.coordinates().map(|x| x as f32));
            first.get_or_insert(local);
        }
        let transform = &mut document.nodes[node].transform;
        let is_matrix = matches!(transform, NodeTransform::Matrix(_));
        let found = transform.to_matrix();
        let stays = |local: &Transform<f64>| {
            let numbers = local.to_matrix();
            let pairs = numbers.as_flattened().iter().zip(found.as_flattened());
            pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-6)
        };
        let constant = |keys: &[[f32; 3]]| keys.iter().all(|key| *key == keys[0]);
        let is_still = constant(&translations)
            && constant(&scales)
            && rotations.iter().all(|key| *key == rotations[0]);
        if is_matrix && is_still && !needs_key && first.as_ref().is_some_and(stays) {
            return;
        }
        if is_matrix && let Some(first) = &first {
            *transform = to_node(first);
        }
        let NodeTransform::Decomposed {
            translation,
            rotation,
            scale,
        } = *transform
        else {
            return;
        };
        // What the rounding of single precision is to the place is no way.
        let place = Vector::from(translation.map(f64::from));
        let near = f64::from(f32::EPSILON) * place.length();
        let stays = |key: &[f32; 3]| Vector::from(key.map(f64::from)).distance(place) <= near;
        if !translations.iter().all(stays) {
            self.push(node, Keys::Translation(translations));
        }
        let same = |key: &[f32; 4]| *key == rotation || key.map(|x| -x) == rotation;
        if !rotations.iter().all(same) {
            self.push(node, Keys::Rotation(rotations));
        }
        if scales.iter().any(|key| *key != scale) {
            self.push(node, Keys::Scale(scales));
        }
        if needs_key && self.channels.len() == before {
            self.channels.push(Channel {
                node,
                times: vec![0.0],
                interpolation: Interpolation::Linear,
                keys: Keys::Rotation(vec![rotation]),
                extras: None,
            });
        }
    }

    fn losses(&self, recording: &Recording) -> Vec<Loss> {
        let rounded = self.rounded.filter(|&(_, most, _)| most > ROUNDING);
        let loss = rounded.map(|(joint, rounding, distance)| Loss::Precision {
            joint: recording.joints[joint].name.clone(),
            distance,
            rounding,
        });
        loss.into_iter().collect()
    }
}
