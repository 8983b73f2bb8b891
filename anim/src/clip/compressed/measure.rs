//! The error of a decoded clip.

use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::CompressedClip;
use super::basis::SEGMENT;
use super::options::JointBound;
use super::pack::{frames_of, segment_count};
use super::sampler::Sampler;
use super::shell::{Sizes, relative_difference};
use crate::recording::{Recording, model_maps};
use crate::transform::Transform;

/// How far a compressed clip is from its recording, measured on what the decoder makes of it in
/// single precision, composed to model space in double precision.
///
/// Errors are ‖Δt‖ + shell ‖ΔL L⁻¹‖ in model space, as [`Options`](super::Options) describes: an
/// upper bound of the greatest distance of any point within the shell of a joint from its true
/// place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The greatest error of a joint in a frame, in metres.
    pub error: f64,
    /// The joint that has it.
    pub joint: usize,
    /// The frame in which it has it.
    pub frame: usize,
    /// The greatest error of a joint in a frame, divided by the joint's tolerance.
    pub ratio: f64,
    /// The greatest error half-way between two frames, in metres, against rotations by slerp and
    /// linear translations and factors between the frames of the recording.
    pub half_frame_error: f64,
    /// The greatest error half-way between two frames, divided by the joint's tolerance.
    pub half_frame_ratio: f64,
    /// The greatest deviation of a scalar track in a frame.
    pub track_error: f64,
    /// The track that has it.
    pub track: usize,
}

const NOTHING: Measured = Measured {
    error: 0.0,
    joint: 0,
    frame: 0,
    ratio: 0.0,
    half_frame_error: 0.0,
    half_frame_ratio: 0.0,
    track_error: 0.0,
    track: 0,
};

/// Decodes every frame and every half-way time and compares them with a recording. `None` unless
/// the recording has the joints, frames and tracks of the clip.
#[must_use]
pub fn measure(recording: &Recording, clip: &CompressedClip) -> Option<Measured> {
    let fits = recording.parents() == clip.parents()
        && recording.frame_count() == clip.frame_count()
        && recording.tracks().len() == clip.track_names().len();
    if !fits {
        return None;
    }
    let bounds = clip.options().bounds(recording.joints().len());
    let sizes = Sizes::new(recording).ok()?;
    let segments = by_segment(recording, clip, &bounds, &sizes);
    Some(segments.into_iter().fold(NOTHING, greater))
}

/// The errors of each segment, up to half-way to the next.
pub(super) fn by_segment(
    recording: &Recording,
    clip: &CompressedClip,
    bounds: &[JointBound],
    sizes: &Sizes,
) -> Vec<Measured> {
    let frames = recording.frame_count();
    (0..segment_count(frames))
        .into_par_iter()
        .map(|segment| {
            let mut comparison = Comparison::new(recording, clip, bounds, sizes);
            let first = segment * SEGMENT;
            let mut greatest = NOTHING;
            for frame in first..first + frames_of(segment, frames) {
                comparison.frame(frame, &mut greatest);
            }
            greatest
        })
        .collect()
}

fn greater(a: Measured, b: Measured) -> Measured {
    let mut greatest = if b.error > a.error { b } else { a };
    greatest.ratio = a.ratio.max(b.ratio);
    greatest.half_frame_error = a.half_frame_error.max(b.half_frame_error);
    greatest.half_frame_ratio = a.half_frame_ratio.max(b.half_frame_ratio);
    let of_track = if b.track_error > a.track_error { b } else { a };
    (greatest.track_error, greatest.track) = (of_track.track_error, of_track.track);
    greatest
}

struct Comparison<'a> {
    recording: &'a Recording,
    bounds: &'a [JointBound],
    sizes: &'a Sizes,
    sampler: Sampler<'a>,
    found: Vec<Transform<f64>>,
    found_maps: Vec<Affine<f64>>,
    truth: Vec<Transform<f64>>,
    truth_maps: Vec<Affine<f64>>,
}

impl<'a> Comparison<'a> {
    fn new(
        recording: &'a Recording,
        clip: &'a CompressedClip,
        bounds: &'a [JointBound],
        sizes: &'a Sizes,
    ) -> Self {
        let count = recording.joints().len();
        Self {
            recording,
            bounds,
            sizes,
            sampler: Sampler::new(clip),
            found: vec![Transform::default(); count],
            found_maps: vec![Affine::default(); count],
            truth: vec![Transform::default(); count],
            truth_maps: vec![Affine::default(); count],
        }
    }

    /// Compares a frame and the time half-way to the next.
    fn frame(&mut self, frame: usize, greatest: &mut Measured) {
        let (recording, count) = (self.recording, self.found.len());
        let locals = &recording.locals()[frame * count..];
        self.truth.copy_from_slice(&locals[..count]);
        self.sampler.sample_frame(frame);
        let tracks = recording.tracks().iter().zip(self.sampler.tracks());
        for (index, (track, &found)) in tracks.enumerate() {
            let error = (track.values[frame] - found).abs();
            if error > greatest.track_error {
                (greatest.track_error, greatest.track) = (error, index);
            }
        }
        for (joint, error) in self.errors().into_iter().enumerate() {
            if error > greatest.error {
                *greatest = Measured {
                    error,
                    joint,
                    frame,
                    ..*greatest
                };
            }
            greatest.ratio = greatest.ratio.max(error / self.bounds[joint].tolerance);
        }
        let Some(after) = locals.get(count..2 * count) else {
            return;
        };
        for (truth, after) in self.truth.iter_mut().zip(after) {
            *truth = truth.interpolate(after, 0.5);
        }
        self.sampler.go_to(frame, 0.5);
        for (error, bound) in self.errors().into_iter().zip(self.bounds) {
            greatest.half_frame_error = greatest.half_frame_error.max(error);
            greatest.half_frame_ratio = greatest.half_frame_ratio.max(error / bound.tolerance);
        }
    }

    /// The error of each joint where the sampler is; infinite instead of a NaN.
    fn errors(&mut self) -> Vec<f64> {
        let parents = self.recording.parents();
        let maps = self
            .sampler
            .locals(&mut self.found)
            .and_then(|()| model_maps(parents, &self.found, &mut self.found_maps))
            .and_then(|()| model_maps(parents, &self.truth, &mut self.truth_maps));
        let pairs = self
            .found_maps
            .iter()
            .zip(&self.truth_maps)
            .zip(self.bounds);
        pairs
            .enumerate()
            .map(|(joint, ((found, truth), bound))| {
                let place = Vector::from(found.translation);
                let least = self.sizes.least(joint);
                let error = place.distance(truth.translation.into())
                    + bound.shell * relative_difference(found.linear, truth.linear, least);
                if maps.is_ok() && error.is_finite() {
                    error
                } else {
                    f64::INFINITY
                }
            })
            .collect()
    }
}
