//! Recordings of compressed clips.

use super::resample::checked_frames;
use super::{RecordedJoint, Recording, ScalarTrack};
use crate::clip::compressed::{CompressedClip, Sampler, double_transform};
use crate::recording::RecordingError;
use crate::transform::Transform;

impl Recording {
    /// The frames of a compressed clip as they are decoded.
    ///
    /// # Errors
    ///
    /// [`RecordingError::TooLarge`] where a small file announces very many frames, as one in
    /// which nothing moves can, and [`RecordingError::Transform`] where a number is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::clip::compressed::{Options, compress};
    /// use ga_anim::recording::Recording;
    ///
    /// let motion = ga_anim::bvh::decode(
    ///     b"HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Xposition }
    ///       MOTION Frames: 2 Frame Time: 0.5
    ///       0
    ///       4",
    /// )?;
    /// let recording = Recording::from_bvh(&motion, 1.0)?;
    /// let clip = compress(&recording, &Options::default(), |_, _| {})?;
    /// let decoded = Recording::from_compressed(&clip)?;
    /// let arm = &decoded.frame(1).ok_or("no frame")?[0];
    /// assert!((arm.translation().coordinates()[0] - 4.0).abs() <= 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_compressed(clip: &CompressedClip) -> Result<Self, RecordingError> {
        let joints: Vec<_> = clip
            .names()
            .iter()
            .zip(clip.parents())
            .zip(clip.rest())
            .map(|((name, &parent), rest)| RecordedJoint {
                name: name.clone(),
                parent,
                rest: double_transform(rest),
            })
            .collect();
        // A frame in which every joint moves takes at least some bits of each.
        let warranted = clip.as_bytes().len().saturating_mul(16);
        let frames = checked_frames(clip.frame_count() as f64, joints.len(), warranted)?;
        let mut tracks: Vec<_> = clip
            .track_names()
            .map(|name| ScalarTrack {
                name: name.to_owned(),
                values: Vec::with_capacity(frames),
            })
            .collect();
        let mut locals = vec![Transform::default(); frames * joints.len()];
        let mut sampler = Sampler::new(clip);
        for (frame, locals) in locals.chunks_exact_mut(joints.len().max(1)).enumerate() {
            sampler.sample_frame(frame);
            sampler.locals(locals)?;
            for (track, &value) in tracks.iter_mut().zip(sampler.tracks()) {
                track.values.push(value);
            }
        }
        Self::new(joints, clip.frame_time(), locals, tracks)
    }
}
