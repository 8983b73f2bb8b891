//! Joints in model space at a moment.

use ga_runtime::geometry::Affine;
use serde::Serialize;

use crate::MotionFileError;
use crate::clip::compressed::{CompressedClip, Sampler};
use crate::recording::{GltfMotion, RecordedJoint, Recording, RecordingError, model_maps};
use crate::transform::Transform;

/// The joints and the scalar tracks of a motion at a moment.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sample {
    /// The time in seconds.
    pub time: f64,
    /// The joints, parents before children.
    pub joints: Vec<JointSample>,
    /// The scalar tracks, such as the weights of morph targets.
    pub tracks: Vec<TrackSample>,
}

/// A joint at a moment.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JointSample {
    /// Its name.
    pub joint: String,
    /// The three rows of the matrix that takes a place in the joint's own coordinates, with a 1
    /// behind it, to model space, in metres.
    pub matrix: [[f64; 4]; 3],
}

/// A scalar track at a moment.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TrackSample {
    /// Its name.
    pub track: String,
    /// Its value.
    pub value: f64,
}

impl Sample {
    fn new<'a>(
        time: f64,
        names: impl Iterator<Item = &'a String>,
        maps: &[Affine<f64>],
        tracks: impl Iterator<Item = (String, f64)>,
    ) -> Self {
        let joint = |(name, map): (&String, &Affine<f64>)| JointSample {
            joint: name.clone(),
            matrix: std::array::from_fn(|row| {
                let [x, y, z] = map.linear[row];
                [x, y, z, map.translation[row]]
            }),
        };
        Self {
            time,
            joints: names.zip(maps).map(joint).collect(),
            tracks: tracks
                .map(|(track, value)| TrackSample { track, value })
                .collect(),
        }
    }
}

/// The samples of a compressed clip as its sampler decodes it.
pub(super) fn of_clip(
    clip: &CompressedClip,
    times: &[f64],
) -> Result<Vec<Sample>, MotionFileError> {
    let count = clip.parents().len();
    let mut sampler = Sampler::new(clip);
    let mut locals = vec![Transform::default(); count];
    let mut maps = vec![Affine::default(); count];
    let mut sample = |&time: &f64| {
        sampler.sample(time);
        sampler
            .locals(&mut locals)
            .and_then(|()| model_maps(clip.parents(), &locals, &mut maps))
            .map_err(RecordingError::from)?;
        let names = clip.track_names().map(ToOwned::to_owned);
        let tracks = names.zip(sampler.tracks().iter().copied());
        Ok(Sample::new(time, clip.names().iter(), &maps, tracks))
    };
    times.iter().map(&mut sample).collect()
}

/// The samples of a recording at its frames and between them.
pub(super) fn of_recording(
    recording: &Recording,
    times: &[f64],
) -> Result<Vec<Sample>, MotionFileError> {
    let count = recording.joints().len();
    let mut locals = vec![Transform::default(); count];
    let mut maps = vec![Affine::default(); count];
    let mut sample = |&time: &f64| {
        recording
            .sample(time, &mut locals)
            .and_then(|()| model_maps(recording.parents(), &locals, &mut maps))
            .map_err(RecordingError::from)?;
        let tracks = recording.tracks().iter().enumerate();
        let tracks = tracks.filter_map(|(index, track)| {
            Some((track.name.clone(), recording.sample_track(index, time)?))
        });
        Ok(Sample::new(time, names(recording.joints()), &maps, tracks))
    };
    times.iter().map(&mut sample).collect()
}

/// The samples of an animation of glTF by its own curves, without frames in between.
pub(super) fn of_gltf(motion: &GltfMotion, times: &[f64]) -> Result<Vec<Sample>, MotionFileError> {
    let sample = |&time: &f64| {
        let maps = motion.model_maps(time)?;
        let tracks = motion.track_values(time)?.into_iter();
        Ok(Sample::new(time, names(motion.joints()), &maps, tracks))
    };
    times.iter().map(sample).collect()
}

fn names(joints: &[RecordedJoint]) -> impl Iterator<Item = &String> {
    joints.iter().map(|joint| &joint.name)
}
