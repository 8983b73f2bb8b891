//! Recordings as animations of glTF documents.

use ga_mesh::gltf::{
    Animation, Channel, Document, Interpolation, Keys, Node, Scene, Transform as NodeTransform,
};
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::Recording;
use super::from_gltf::{GltfMotion, Source};
use crate::file_error::MotionFileError;
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
            let before = keys.channels.len();
            keys.add(&mut document, joint, joint, locals.copied());
            // Readers know the joints of a document without skins by what an animation moves.
            if keys.channels.len() == before
                && let NodeTransform::Decomposed { rotation, .. } = document.nodes[joint].transform
            {
                keys.channels.push(Channel {
                    node: joint,
                    times: vec![0.0],
                    interpolation: Interpolation::Linear,
                    keys: Keys::Rotation(vec![rotation]),
                    extras: None,
                });
            }
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
    /// joints.
    pub fn with_recording(
        &self,
        recording: &Recording,
    ) -> Result<(Document, Vec<Loss>), MotionFileError> {
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
            keys.add(&mut document, source.node, joint, own);
        }
        let mut left: Vec<&super::ScalarTrack> = recording.tracks.iter().collect();
        for &node in &self.morphed {
            let names: Vec<String> = self.track_names(node).collect();
            let tracks = names.iter().map(|name| {
                let place = left.iter().position(|track| track.name == *name);
                place.map(|place| left.remove(place))
            });
            let tracks: Vec<Option<&super::ScalarTrack>> = tracks.collect();
            let frames = 0..recording.frame_count();
            let weights = frames.flat_map(|frame| {
                let weight = |track: &Option<&super::ScalarTrack>| {
                    track.map_or(0.0, |track| track.values[frame] as f32)
                };
                tracks.iter().map(weight).collect::<Vec<f32>>()
            });
            keys.push(node, Keys::Weights(weights.collect()));
        }
        let mut losses = keys.losses(recording);
        if !left.is_empty() {
            let tracks = left.iter().map(|track| track.name.clone()).collect();
            losses.push(Loss::Tracks { tracks });
        }
        document.animations[self.animation].channels = keys.channels;
        Ok((document, losses))
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

/// The channels of an animation with a key in every frame.
struct NodeKeys {
    times: Vec<f32>,
    channels: Vec<Channel>,
    /// The joint whose place is rounded most, by how much in its node's unit, and how far it is.
    rounded: Option<(usize, f64, f64)>,
}

impl NodeKeys {
    fn new(recording: &Recording) -> Self {
        let frames = 0..recording.frame_count();
        let time = |frame: usize| (frame as f64 * recording.frame_time) as f32;
        Self {
            times: frames.map(time).collect(),
            channels: Vec::new(),
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

    /// Adds the channels of a node for what it does not have by itself in all frames.
    fn add(
        &mut self,
        document: &mut Document,
        node: usize,
        joint: usize,
        locals: impl Iterator<Item = Transform<f64>>,
    ) {
        let (mut translations, mut rotations, mut scales) = (Vec::new(), Vec::new(), Vec::new());
        let mut first = None;
        for local in locals {
            let place = local.translation();
            let rounded = place.coordinates().map(|x| x as f32);
            let error = place.distance(Vector::from(rounded.map(f64::from)));
            if self.rounded.is_none_or(|(_, most, _)| error > most) {
                self.rounded = Some((joint, error, place.length()));
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
        if is_matrix && is_still && first.as_ref().is_some_and(stays) {
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
        if translations.iter().any(|key| *key != translation) {
            self.push(node, Keys::Translation(translations));
        }
        let same = |key: &[f32; 4]| *key == rotation || key.map(|x| -x) == rotation;
        if !rotations.iter().all(same) {
            self.push(node, Keys::Rotation(rotations));
        }
        if scales.iter().any(|key| *key != scale) {
            self.push(node, Keys::Scale(scales));
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

fn to_node(local: &Transform<f64>) -> NodeTransform {
    let single = |v: Vector<f64>| v.coordinates().map(|x| x as f32);
    NodeTransform::Decomposed {
        translation: single(local.translation()),
        rotation: quaternion(local.rotor(), None),
        scale: single(local.scale),
    }
}

/// The quaternion of a rotor, with the sign that is nearer to the one before.
fn quaternion(rotor: Rotor<f64>, before: Option<&[f32; 4]>) -> [f32; 4] {
    let ([x, y, z], w) = rotor.to_quaternion();
    let key = [x, y, z, w].map(|x| x as f32);
    let along = before.map_or(1.0, |before| {
        before.iter().zip(key).map(|(a, b)| a * b).sum::<f32>()
    });
    if along < 0.0 { key.map(|x| -x) } else { key }
}
