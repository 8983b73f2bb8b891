//! Several recordings of the same joints at once, each with a weight.

use ga_runtime::cga3::{Motor, Rotor};
use ga_runtime::vga3::Vector;

use super::played::Played;
use super::resample::{checked_frames, frames_within};
use super::{RecordedJoint, Recording, ScalarTrack};
use crate::recording::RecordingError;
use crate::transform::Transform;

/// The mean of recordings of the same joints, each with its weight. Weights are divided by their
/// sum.
///
/// With the local transforms T_k R_k s_k of a joint and the weights w_k, the mean has
///
/// ```text
/// R = Σ ±w_k R_k / |Σ ±w_k R_k|,   t = Σ w_k t_k,   s = Σ w_k s_k,
/// ```
///
/// with the signs of the shorter rotations to the recording of the greatest weight, so that the sum
/// cannot vanish. For two recordings R is [`Rotor::nlerp`]. The transforms at rest are means in
/// the same way.
///
/// *Time*. All recordings begin together. The mean is as long as the longest one, and a shorter one
/// stays at its last frame; [`blend_played`] is for others. The time between frames is the shortest
/// one. Recordings with a weight of 0 count for nothing, so where only one has a weight, the result
/// is that recording, to the last bit.
///
/// *Scalar tracks* are matched by name; several of the same name in their order. A recording
/// without a track counts as 0 there, which is the weight of a morph target at rest.
///
/// # Errors
///
/// [`RecordingError::Weight`], [`RecordingError::Sum`], [`RecordingError::JointCount`],
/// [`RecordingError::JointName`] and [`RecordingError::JointParent`], and where the frames do not
/// form a recording.
///
/// # Examples
///
/// ```
/// use ga_anim::recording::{Recording, blend};
///
/// let parse = |angle: &str| -> Result<Recording, Box<dyn std::error::Error>> {
///     let motion = format!(
///         "HIERARCHY ROOT arm {{ OFFSET 0 0 0 CHANNELS 1 Zrotation }}
///          MOTION Frames: 1 Frame Time: 0.01
///          {angle}"
///     );
///     Ok(Recording::from_bvh(&ga_anim::bvh::decode(motion.as_bytes())?, 1.0)?)
/// };
/// let (low, high) = (parse("10")?, parse("50")?);
/// let mean = blend(&[(&low, 2.0), (&high, 2.0)])?;
/// let (_, angle) = mean.locals()[0].rotor().to_axis_angle();
/// assert!((angle.to_degrees() - 30.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn blend(recordings: &[(&Recording, f64)]) -> Result<Recording, RecordingError> {
    check(recordings)?;
    let mut weighted = recordings.iter().filter(|(_, weight)| *weight > 0.0);
    if let (Some((only, _)), None) = (weighted.next(), weighted.next()) {
        return Ok((*only).clone());
    }
    let weighted = recordings.iter().filter(|(_, weight)| *weight > 0.0);
    let durations = weighted.map(|(recording, _)| recording.duration());
    let duration = durations.fold(0.0, f64::max);
    let played: Vec<(Played, f64)> = recordings
        .iter()
        .map(|&(recording, weight)| (Played::new(recording), weight))
        .collect();
    blend_played(&played, duration)
}

/// As [`blend`], of recordings as they are [`Played`], from 0 to the last whole step within
/// `duration` seconds.
///
/// # Errors
///
/// As [`blend`].
pub fn blend_played(played: &[(Played, f64)], duration: f64) -> Result<Recording, RecordingError> {
    let recordings = played.iter();
    let recordings: Vec<(&Recording, f64)> = recordings
        .map(|(played, weight)| (played.recording(), *weight))
        .collect();
    let sum = check(&recordings)?;
    let weighted: Vec<(&Played, f64)> = played
        .iter()
        .filter(|(_, weight)| *weight > 0.0)
        .map(|(played, weight)| (played, weight / sum))
        .collect();
    let all = || weighted.iter().map(|&(played, _)| played.recording());
    // There is at least one, since the sum is positive.
    let Some(first) = all().next() else {
        return Err(RecordingError::Sum(sum));
    };
    let frame_time = all().map(|r| r.frame_time).fold(f64::INFINITY, f64::min);
    let count = first.joints.len();
    let source = all().map(|recording| recording.locals.len()).sum();
    let frames = checked_frames(frames_within(duration, frame_time), count, source)?;

    let weights: Vec<f64> = weighted.iter().map(|&(_, weight)| weight).collect();
    let mean = Mean::new(&weights);
    let mut sampled = vec![vec![Transform::default(); count]; weighted.len()];
    let mut locals = Vec::with_capacity(frames * count);
    for frame in 0..frames {
        for ((played, _), sampled) in weighted.iter().zip(&mut sampled) {
            played.fill(frame as f64 * frame_time, sampled);
        }
        locals.extend((0..count).map(|joint| mean.of(|k| sampled[k][joint])));
    }
    let joints = first.joints.iter().enumerate();
    let joints = joints.map(|(joint, described)| RecordedJoint {
        rest: mean.of(|k| weighted[k].0.recording().joints[joint].rest),
        ..described.clone()
    });
    let tracks = blended_tracks(&weighted, frame_time, frames);
    Recording::new(joints.collect(), frame_time, locals, tracks)
}

/// The sum of the weights, where the recordings can be blended.
fn check(recordings: &[(&Recording, f64)]) -> Result<f64, RecordingError> {
    for (recording, &(_, weight)) in recordings.iter().enumerate() {
        if !weight.is_finite() || weight < 0.0 {
            return Err(RecordingError::Weight { recording, weight });
        }
    }
    if let Some(((first, _), others)) = recordings.split_first() {
        for (index, (other, _)) in others.iter().enumerate() {
            check_joints(first, other, index + 1)?;
        }
    }
    let sum: f64 = recordings.iter().map(|&(_, weight)| weight).sum();
    match sum > 0.0 && sum.is_finite() {
        true => Ok(sum),
        false => Err(RecordingError::Sum(sum)),
    }
}

fn check_joints(
    first: &Recording,
    other: &Recording,
    recording: usize,
) -> Result<(), RecordingError> {
    let (expected, found) = (first.joints.len(), other.joints.len());
    if expected != found {
        return Err(RecordingError::JointCount {
            recording,
            expected,
            found,
        });
    }
    for (joint, (a, b)) in first.joints.iter().zip(&other.joints).enumerate() {
        if a.name != b.name {
            return Err(RecordingError::JointName {
                recording,
                joint,
                expected: a.name.clone(),
                found: b.name.clone(),
            });
        }
        if a.parent != b.parent {
            let name = a.name.clone();
            return Err(RecordingError::JointParent { recording, name });
        }
    }
    Ok(())
}

/// Means of transforms with given weights.
struct Mean<'a> {
    weights: &'a [f64],
    /// Which weight is the greatest.
    heaviest: usize,
}

impl<'a> Mean<'a> {
    fn new(weights: &'a [f64]) -> Self {
        let heaviest = (0..weights.len())
            .rev()
            .max_by(|&a, &b| weights[a].total_cmp(&weights[b]));
        Self {
            weights,
            heaviest: heaviest.unwrap_or(0),
        }
    }

    /// The mean of the transforms with the weights, by index.
    fn of(&self, transform: impl Fn(usize) -> Transform<f64>) -> Transform<f64> {
        let reference = transform(self.heaviest).rotor();
        let mut rotation = Motor::from(reference) * 0.0;
        let (mut translation, mut scale) = (Vector::default(), Vector::default());
        for (k, &weight) in self.weights.iter().enumerate() {
            let transform = transform(k);
            let rotor = transform.rotor();
            let sign = 1f64.copysign(cosine(reference, rotor));
            rotation += Motor::from(rotor) * (sign * weight);
            translation += transform.translation() * weight;
            scale += transform.scale * weight;
        }
        let rotor = rotation
            .normalize()
            .map_or(reference, |motor| motor.rotor());
        Transform::from_parts(translation, rotor, scale)
    }
}

/// The cosine of half the angle from one rotor to another.
fn cosine(a: Rotor<f64>, b: Rotor<f64>) -> f64 {
    (a.reverse() * b).scalar()
}

fn blended_tracks(weighted: &[(&Played, f64)], frame_time: f64, frames: usize) -> Vec<ScalarTrack> {
    let mut tracks: Vec<ScalarTrack> = Vec::new();
    for &(played, weight) in weighted {
        let mut is_taken = vec![false; tracks.len()];
        for track in &played.recording().tracks {
            let found = (0..is_taken.len()).find(|&k| !is_taken[k] && tracks[k].name == track.name);
            let place = found.unwrap_or_else(|| {
                tracks.push(ScalarTrack {
                    name: track.name.clone(),
                    values: vec![0.0; frames],
                });
                is_taken.push(false);
                tracks.len() - 1
            });
            is_taken[place] = true;
            for (frame, value) in tracks[place].values.iter_mut().enumerate() {
                *value += weight * played.track_at(track, frame as f64 * frame_time);
            }
        }
    }
    tracks
}
