//! From a recording to segments.

mod hierarchy;
mod joint;
mod search;
mod source;

use std::sync::atomic::{AtomicUsize, Ordering};

use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::basis::{Basis, SEGMENT};
use super::file::Contents;
use super::layout::JointLayout;
use super::options::Options;
use super::pack::{Segment, frames_of, segment_count};
use super::piece::{Encoded, MOST_BITS, Precision, bits_for, encode};
use super::tables::{Channel, channels};
use super::{CompressedClip, Measured, file, measure};
use crate::clip::ClipError;
use crate::recording::{Recording, model_maps};
use search::Search;
use source::Source;

/// Deviations that are left out, in parts of the tolerance. The first is the best for ordinary
/// clips; where small deviations add up along many joints, fewer are left out.
const NEGLIGIBLE: [f64; 3] = [0.05, 0.002, 0.0];

/// The greatest error that the search leaves, in tolerances: single precision takes the rest.
const MARGIN: f64 = 0.998;

/// How often a segment is encoded anew with a smaller bound because single precision took it beyond
/// the first.
const REPETITIONS: usize = 5;

/// The greatest error half-way between frames that is aimed at, in tolerances.
const HALF_FRAME: f64 = 1.1;

/// From this error half-way between frames on, in tolerances, a smaller bound at the frames does
/// not help, as where the rotations of neighbouring frames are nearly opposite.
const HALF_FRAME_OUT_OF_REACH: f64 = 1.5;

/// How often a segment is encoded anew because of its error half-way between frames.
const HALF_FRAME_REPETITIONS: usize = 2;

/// How often each joint of a segment may be encoded on average in the search for fewer bits. In
/// hierarchies of some dozen joints the search ends by itself after about half of it.
const BUDGET: usize = 200;

/// The most joints that a clip may have. The search keeps about 16 kB for each of them.
const MOST_JOINTS: usize = 4096;

/// Compresses a recording so that the bounds of the options hold on every frame.
///
/// They hold for what [`Sampler`](super::Sampler) decodes, transforms relative to the parents in
/// single precision, composed to model space in double precision; [`measure`](super::measure())
/// compares the same. Half-way between frames the error is not bounded, but where it is a little
/// above 1.1 tolerances, frames are encoded more finely.
///
/// `progress` is told how many of how many segments are encoded; there are more where some are
/// encoded again. The result is the same for any number of threads.
///
/// # Errors
///
/// [`ClipError::Setting`], [`ClipError::BoundJoint`], [`ClipError::TooManyJoints`] past 4096
/// joints, and [`ClipError::Bound`] or
/// [`ClipError::Track`] where a bound is too small for the lengths or values at hand.
///
/// # Examples
///
/// ```
/// use ga_anim::clip::compressed::{self, Sampler, Options};
/// use ga_anim::recording::{RecordedJoint, Recording};
/// use ga_anim::transform::Transform;
/// use ga_runtime::cga3::{Motor, Rotor};
///
/// let joint = RecordedJoint { name: "arm".into(), parent: None, rest: Transform::default() };
/// let rotated = |frame: u32| {
///     let angle = (f64::from(frame) * 0.05).sin();
///     let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle)?;
///     Some(Transform::from(Motor::from(rotor)))
/// };
/// let frames = (0..100).filter_map(rotated).collect();
/// let recording = Recording::new(vec![joint], 0.01, frames, vec![])?;
///
/// let clip = compressed::compress(&recording, &Options::default(), |_, _| ())?;
/// assert!(40 * 100 / clip.as_bytes().len() > 12);
/// let mut sampler = Sampler::new(&clip);
/// sampler.sample(0.5);
/// let (_, angle) = sampler.rotors()[0].to_axis_angle();
/// assert!((f64::from(angle) - 2.5f64.sin()).abs() < 1e-4 / 0.03);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compress(
    recording: &Recording,
    options: &Options,
    progress: impl Fn(usize, usize) + Sync,
) -> Result<CompressedClip, ClipError> {
    let joints = recording.joints().len();
    options.check(joints)?;
    if joints > MOST_JOINTS {
        let most = MOST_JOINTS;
        return Err(ClipError::TooManyJoints { joints, most });
    }
    let mut result = Err(ClipError::Bound {
        joint: recording.joints()[0].name.clone(),
        tolerance: options.tolerance,
        error: f64::INFINITY,
    });
    let steps = Steps {
        progress: &progress,
        done: AtomicUsize::new(0),
        all: AtomicUsize::new(0),
    };
    for negligible in NEGLIGIBLE {
        result = compress_with(recording, options, negligible, &steps);
        if !matches!(
            result,
            Err(ClipError::Bound { .. } | ClipError::Precision { .. })
        ) {
            break;
        }
    }
    result
}

fn compress_with(
    recording: &Recording,
    options: &Options,
    negligible: f64,
    steps: &Steps<impl Fn(usize, usize) + Sync>,
) -> Result<CompressedClip, ClipError> {
    let joint_bounds = options.bounds(recording.joints().len());
    let source = Source::new(recording, joint_bounds, negligible)?;
    let frames = recording.frame_count();
    let count = segment_count(frames);
    let bases = [
        Basis::new(SEGMENT),
        Basis::new(frames_of(count - 1, frames)),
    ];
    let tracks = tracks(recording, options, &bases)?;

    let changes = tracks.iter().map(|track| !track.pieces.is_empty());
    let encoder = SegmentEncoder {
        source: &source,
        bases: &bases,
        tracks: &tracks,
        order: channels(&source.layouts, changes),
        segments: count,
    };
    let mut segments = vec![Segment::default(); count];
    let mut bounds = vec![MARGIN; count];
    // Segments, and whether what they are is of no use.
    let mut todo: Vec<(usize, bool)> = (0..count).map(|segment| (segment, true)).collect();
    let mut worst: Option<Measured> = None;
    for repetition in 0..REPETITIONS {
        steps.add(todo.len());
        let encoded: Result<Vec<Option<Segment>>, ClipError> = todo
            .par_iter()
            .map(|&(segment, needed)| {
                let encoded = encoder.encode(segment, bounds[segment]);
                steps.done();
                match encoded {
                    Err(_) if !needed => Ok(None),
                    encoded => encoded.map(Some),
                }
            })
            .collect();
        let encoded = match (encoded, &worst) {
            // A bound that was made smaller for the rounding of single precision, and is too small.
            (Err(ClipError::Bound { .. }), Some(worst)) => {
                let place = (worst.joint, worst.frame);
                return Err(beyond_precision(recording, &source, place));
            }
            (encoded, _) => encoded?,
        };
        for (&(segment, _), encoded) in todo.iter().zip(encoded) {
            if let Some(encoded) = encoded {
                segments[segment] = encoded;
            }
        }
        let contents = contents(recording, options, &source.layouts, &tracks);
        let clip = CompressedClip::decode(file::to_bytes(&contents, &segments)?)?;
        let errors = measure::by_segment(recording, &clip, &source.bounds, &source.sizes);
        check_tracks(recording, options, &errors)?;
        let aims_at_halves = repetition < HALF_FRAME_REPETITIONS;
        let mut again = Vec::new();
        for (segment, found) in errors.iter().enumerate() {
            let half = HALF_FRAME..HALF_FRAME_OUT_OF_REACH;
            if found.ratio > 1.0 {
                bounds[segment] = smaller(bounds[segment], found.ratio - MARGIN);
                again.push((segment, true));
            } else if aims_at_halves && half.contains(&found.half_frame_ratio) {
                bounds[segment] = smaller(bounds[segment], found.half_frame_ratio - HALF_FRAME);
                again.push((segment, false));
            }
        }
        if again.is_empty() {
            return Ok(clip);
        }
        worst = errors.into_iter().find(|found| found.ratio > 1.0);
        todo = again;
    }
    let place = worst.map_or((0, 0), |found| (found.joint, found.frame));
    Err(beyond_precision(recording, &source, place))
}

/// That a joint cannot be kept within its tolerance where it is so far from the origin.
fn beyond_precision(
    recording: &Recording,
    source: &Source,
    (joint, frame): (usize, usize),
) -> ClipError {
    let mut maps = vec![Affine::default(); recording.joints().len()];
    let locals = recording.frame(frame).unwrap_or_default();
    let place = match model_maps(recording.parents(), locals, &mut maps) {
        Ok(()) => Vector::from(maps[joint].translation),
        Err(error) => return error.into(),
    };
    ClipError::Precision {
        joint: recording.joints()[joint].name.clone(),
        frame,
        tolerance: source.bounds[joint].tolerance,
        distance: place.length(),
    }
}

/// How many of how many segments are encoded, over all repetitions.
struct Steps<'a, P> {
    progress: &'a P,
    done: AtomicUsize,
    all: AtomicUsize,
}

impl<P: Fn(usize, usize)> Steps<'_, P> {
    fn add(&self, count: usize) {
        self.all.fetch_add(count, Ordering::Relaxed);
    }

    fn done(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        (self.progress)(done, self.all.load(Ordering::Relaxed));
    }
}

/// Everything that the segments of a clip have in common.
struct SegmentEncoder<'a> {
    source: &'a Source<'a>,
    /// Of all segments but the last, and of the last.
    bases: &'a [Basis; 2],
    tracks: &'a [Track],
    /// The channels in the order of the file.
    order: Vec<(Channel, usize)>,
    segments: usize,
}

impl SegmentEncoder<'_> {
    /// A segment whose errors are within a bound, in tolerances.
    fn encode(&self, segment: usize, bound: f64) -> Result<Segment, ClipError> {
        let source = self.source;
        let basis = &self.bases[usize::from(segment + 1 == self.segments)];
        let budget = BUDGET * source.joints();
        let search = Search::new(source, basis, segment * SEGMENT, bound, budget);
        let joints = search.run().map_err(|(joint, error)| {
            let tolerance = source.bounds[joint].tolerance;
            ClipError::Bound {
                joint: source.recording.joints()[joint].name.clone(),
                tolerance,
                error: error * tolerance,
            }
        })?;
        let encoded = self.order.iter().filter_map(|(channel, _)| match *channel {
            Channel::OfJoint { joint, channel } => joints[joint].get(channel).cloned(),
            Channel::Track(track) => self.tracks[track].pieces.get(segment).cloned(),
        });
        let encoded: Vec<Encoded> = encoded.collect();
        Ok(Segment::of_channels(&encoded, basis.frames))
    }
}

/// Fails where a decoded track is beyond the tolerance.
fn check_tracks(
    recording: &Recording,
    options: &Options,
    errors: &[Measured],
) -> Result<(), ClipError> {
    let tolerance = options.track_tolerance;
    match errors.iter().find(|found| found.track_error > tolerance) {
        Some(found) => Err(ClipError::Track {
            track: recording.tracks()[found.track].name.clone(),
            tolerance,
        }),
        None => Ok(()),
    }
}

/// A bound for the next try, where the error was too great by `excess`, which hardly depends on the
/// bound: the rounding of single precision, or the curvature between frames.
fn smaller(bound: f64, excess: f64) -> f64 {
    (bound - 1.2 * excess).clamp(0.4 * bound, 0.97 * bound)
}

/// A scalar track, encoded.
struct Track {
    constant: f64,
    /// One for each segment, or none where the track is constant.
    pieces: Vec<Encoded>,
}

fn tracks(
    recording: &Recording,
    options: &Options,
    bases: &[Basis; 2],
) -> Result<Vec<Track>, ClipError> {
    // A little is left for single precision.
    let tolerance = 0.99 * options.track_tolerance;
    let mut tracks = Vec::with_capacity(recording.tracks().len());
    for track in recording.tracks() {
        let least = track.values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = track
            .values
            .iter()
            .copied()
            .fold(f64::NEG_INFINITY, f64::max);
        let constant = least / 2.0 + most / 2.0;
        let mut pieces = Vec::new();
        if most - least > 0.0 {
            let count = segment_count(track.values.len());
            for (segment, values) in track.values.chunks(SEGMENT).enumerate() {
                let basis = &bases[usize::from(segment + 1 == count)];
                let mut deviations = [0.0; SEGMENT];
                for (deviation, value) in deviations.iter_mut().zip(values) {
                    *deviation = value - constant;
                }
                let piece =
                    within(basis, &deviations, tolerance).ok_or_else(|| ClipError::Track {
                        track: track.name.clone(),
                        tolerance: options.track_tolerance,
                    })?;
                pieces.push(piece);
            }
        }
        tracks.push(Track { constant, pieces });
    }
    Ok(tracks)
}

/// The values encoded in few bits and decoded within a tolerance in single precision.
fn within(basis: &Basis, values: &[f64; SEGMENT], tolerance: f64) -> Option<Encoded> {
    let holds = |encoded: &Encoded| {
        let mut pairs = encoded.decoded.iter().zip(values).take(basis.frames);
        // Terms of a trend are rounded one by one.
        let rounding = |value: f64| 8.0 * f64::from(f32::EPSILON) * value.abs();
        pairs.all(|(found, value)| (found - value).abs() + rounding(*value) <= tolerance)
    };
    let trend = encode(basis, values, Precision::Trend(tolerance * 0.95));
    if holds(&trend) {
        return Some(trend);
    }
    let least = bits_for(basis, values, tolerance).max(1);
    (least..=MOST_BITS)
        .map(|bits| encode(basis, values, Precision::Bits(bits)))
        .find(holds)
}

fn contents<'a>(
    recording: &'a Recording,
    options: &'a Options,
    layouts: &'a [JointLayout],
    tracks: &[Track],
) -> Contents<'a> {
    Contents {
        recording,
        options,
        layouts,
        tracks: tracks
            .iter()
            .map(|track| (!track.pieces.is_empty(), track.constant))
            .collect(),
    }
}
