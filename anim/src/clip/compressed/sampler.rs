//! Poses of a compressed clip at any time.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::CompressedClip;
use super::basis::{SEGMENT, TERMS};
use super::tables::{Block, LANES, Tables, VectorChannels};
use crate::recording::ModelSpaceError;
use crate::transform::Transform;

/// Samples a [`CompressedClip`] forward, backward or at random, into slices of its own.
///
/// A frame is decoded without its predecessors. The two frames around the last time are kept, so
/// that small steps decode little. Sampling allocates nothing.
///
/// Between frames rotations move along the shorter arc at constant speed (slerp within 0.0005
/// radians where neighbouring frames are less than a right angle apart, and exactly half-way),
/// translations, factors and tracks linearly.
#[derive(Clone, Debug)]
pub struct Sampler<'a> {
    clip: &'a CompressedClip,
    batch: Batch,
    residuals: Vec<Block>,
    values: Vec<Block>,
    frames: [Frame; 2],
    rotors: Vec<Rotor<f32>>,
    translations: Vec<Vector<f32>>,
    scales: Vec<Vector<f32>>,
    tracks: Vec<f64>,
}

/// A decoded frame.
#[derive(Clone, Debug)]
struct Frame {
    /// Which one; `None` before the first.
    index: Option<usize>,
    /// By block of rotating joints, then by coefficient.
    rotors: Vec<[Block; 4]>,
    /// The values of all other channels.
    extra: Vec<Block>,
}

impl<'a> Sampler<'a> {
    /// A sampler at the first frame.
    #[must_use]
    pub fn new(clip: &'a CompressedClip) -> Self {
        let tables = clip.tables();
        let frame = Frame {
            index: None,
            rotors: vec![[[0.0; LANES]; 4]; tables.rotors.len()],
            extra: vec![[0.0; LANES]; tables.blocks - tables.extra()],
        };
        let layouts = clip.layouts();
        let mut sampler = Self {
            clip,
            batch: Batch::new(),
            residuals: vec![[0.0; LANES]; tables.blocks],
            values: vec![[0.0; LANES]; tables.blocks],
            frames: [frame.clone(), frame],
            rotors: layouts.iter().map(|layout| layout.middle).collect(),
            translations: layouts
                .iter()
                .map(|layout| layout.translation.constant)
                .collect(),
            scales: layouts.iter().map(|layout| layout.scale.constant).collect(),
            tracks: tables
                .tracks
                .iter()
                .map(|&(_, constant)| constant)
                .collect(),
        };
        sampler.sample(0.0);
        sampler
    }

    /// Goes to a time in seconds. Before the first frame and after the last one the pose is that of
    /// the frame; a time that is not a number is that of the first frame.
    #[inline]
    pub fn sample(&mut self, time: f64) {
        let last = self.clip.frame_count() - 1;
        let position = (time / self.clip.frame_time()).max(0.0).min(last as f64);
        let before = position as usize;
        let part = if before < last {
            (position - before as f64) as f32
        } else {
            0.0
        };
        self.go_to(before, part);
    }

    /// Goes to a frame, counted from 0, or to the last one where there are fewer.
    #[inline]
    pub fn sample_frame(&mut self, frame: usize) {
        self.go_to(frame.min(self.clip.frame_count() - 1), 0.0);
    }

    /// Goes to a part of the way, from 0 to 1, from a frame to the next. The part is
    /// 0 at the last frame.
    #[inline]
    pub(super) fn go_to(&mut self, frame: usize, part: f32) {
        let batch = self.batch;
        batch.run(Step {
            sampler: self,
            frame,
            part,
        });
    }

    /// The rotation of each joint relative to its parent.
    #[must_use]
    pub fn rotors(&self) -> &[Rotor<f32>] {
        &self.rotors
    }

    /// The place of each joint relative to its parent.
    #[must_use]
    pub fn translations(&self) -> &[Vector<f32>] {
        &self.translations
    }

    /// The factors of each joint.
    #[must_use]
    pub fn scales(&self) -> &[Vector<f32>] {
        &self.scales
    }

    /// The values of the scalar tracks.
    #[must_use]
    pub fn tracks(&self) -> &[f64] {
        &self.tracks
    }

    /// The transform of each joint relative to its parent, for
    /// [`model_maps`](crate::recording::model_maps).
    ///
    /// # Errors
    ///
    /// [`ModelSpaceError::Length`] unless `locals` has one place for each joint.
    pub fn locals(&self, locals: &mut [Transform<f32>]) -> Result<(), ModelSpaceError> {
        let (expected, found) = (self.rotors.len(), locals.len());
        if expected != found {
            return Err(ModelSpaceError::Length { expected, found });
        }
        for (joint, local) in locals.iter_mut().enumerate() {
            *local = Transform::from_parts(
                self.translations[joint],
                self.rotors[joint],
                self.scales[joint],
            );
        }
        Ok(())
    }
}

/// One step to a frame and a part of the way to the next.
struct Step<'s, 'a> {
    sampler: &'s mut Sampler<'a>,
    frame: usize,
    part: f32,
}

impl Work for Step<'_, '_> {
    #[inline(always)]
    fn run(self) {
        let Self {
            sampler,
            frame,
            part,
        } = self;
        let tables = sampler.clip.tables();
        if tables.lanes.is_empty() {
            return;
        }
        let Sampler {
            residuals,
            values,
            frames,
            ..
        } = sampler;
        // The frame after becomes the one before on the way forward, and the other way round.
        let [a, b] = frames;
        if a.index != Some(frame) && (b.index == Some(frame) || a.index == Some(frame + 1)) {
            std::mem::swap(a, b);
        }
        if a.index != Some(frame) {
            decode(tables, frame, residuals, values, a);
        }
        if part > 0.0 && b.index != Some(frame + 1) {
            decode(tables, frame + 1, residuals, values, b);
        }
        let [a, b] = &sampler.frames;
        if part > 0.0 {
            for (block, (a, b)) in a.rotors.iter().zip(&b.rotors).enumerate() {
                let joints = &tables.rotating[block * LANES..];
                put(&between(a, b, part), joints, &mut sampler.rotors);
            }
        } else {
            for (block, a) in a.rotors.iter().enumerate() {
                put(a, &tables.rotating[block * LANES..], &mut sampler.rotors);
            }
        }
        let (from, to) = (a.extra.as_flattened(), b.extra.as_flattened());
        let value = |place: usize| match part > 0.0 {
            true => from[place] + (to[place] - from[place]) * part,
            false => from[place],
        };
        put_vectors(&tables.translations, &mut sampler.translations, value);
        put_vectors(&tables.scales, &mut sampler.scales, value);
        for (track, &(place, constant)) in sampler.tracks.iter_mut().zip(&tables.tracks) {
            if let Some(place) = place {
                *track = constant + f64::from(value(place));
            }
        }
    }
}

#[inline(always)]
fn decode(
    tables: &Tables,
    index: usize,
    residuals: &mut [Block],
    values: &mut [Block],
    frame: &mut Frame,
) {
    let (segment, within) = (index / SEGMENT, index % SEGMENT);
    unpack(tables, segment, within, residuals);
    let last = segment + 1 == tables.segments.len();
    let basis = &tables.bases[usize::from(last)][within];
    let trends = &tables.trends[segment * tables.blocks..][..tables.blocks];
    for ((value, trend), residual) in values.iter_mut().zip(trends).zip(residuals.iter()) {
        let mut sum: Block =
            std::array::from_fn(|i| trend.terms[0][i] + residual[i] * trend.step[i]);
        for term in 1..TERMS {
            for i in 0..LANES {
                sum[i] += trend.terms[term][i] * basis[term];
            }
        }
        *value = sum;
    }
    let (bivectors, extra) = values.split_at(tables.extra());
    let (bivectors, _) = bivectors.as_chunks::<3>();
    for ((rotor, constants), b) in frame.rotors.iter_mut().zip(&tables.rotors).zip(bivectors) {
        let mut scale = [0.0; LANES];
        let mut scalar = [0.0; LANES];
        for i in 0..LANES {
            let square = b[0][i] * b[0][i] + b[1][i] * b[1][i] + b[2][i] * b[2][i];
            scale[i] = 1.0 / (1.0 + square);
            scalar[i] = 1.0 - square;
        }
        for (k, row) in rotor.iter_mut().enumerate() {
            for i in 0..LANES {
                let sum = constants.middle[k][i] * scalar[i]
                    + constants.along[0][k][i] * b[0][i]
                    + constants.along[1][k][i] * b[1][i]
                    + constants.along[2][k][i] * b[2][i];
                row[i] = sum * scale[i];
            }
        }
    }
    frame.extra.copy_from_slice(extra);
    frame.index = Some(index);
}

/// The residuals of a frame, each in the lane of its channel.
#[inline(always)]
fn unpack(tables: &Tables, segment: usize, within: usize, residuals: &mut [Block]) {
    let table = &tables.segments[segment];
    let channels = tables.lanes.len();
    let bits = &tables.bits[segment * channels..][..channels];
    let first = within * table.frame_bits;
    let bytes = &tables.residuals[table.begin..];
    let residuals = residuals.as_flattened_mut();
    let mut position = first;
    for (&lane, &bits) in tables.lanes.iter().zip(bits) {
        let at = position / 8;
        // A residual and the bits of its first byte before it are at most 31 bits.
        let word = match bytes.get(at..at + 4) {
            Some(&[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]),
            _ => 0,
        };
        let value = (word >> (position % 8)) & ((1 << bits) - 1);
        if let Some(residual) = residuals.get_mut(lane as usize) {
            // At most 24 bits, which single precision holds.
            *residual = value as i32 as f32;
        }
        position += usize::from(bits);
    }
}

/// Eight rotors between others along the shorter arcs.
///
/// The mean of unit quaternions moves faster in the middle; the part is corrected by a polynomial
/// (A. Kapoulkine, "Approximating slerp", 2018) that leaves 0, ½ and 1 as they are.
#[inline(always)]
fn between(a: &[Block; 4], b: &[Block; 4], t: f32) -> [Block; 4] {
    let mut result = [[0.0; LANES]; 4];
    for i in 0..LANES {
        let cosine = a[0][i] * b[0][i] + a[1][i] * b[1][i] + a[2][i] * b[2][i] + a[3][i] * b[3][i];
        let d = cosine.abs();
        let quadratic = 1.0904 + d * (-3.2452 + d * (3.55645 - d * 1.43519));
        let constant = 0.848_013 + d * (-1.06021 + d * 0.215_638);
        let from_half = t - 0.5;
        let k = quadratic * from_half * from_half + constant;
        let t = t + t * from_half * (t - 1.0) * k;
        let (from, to) = (1.0 - t, t.copysign(cosine));
        let sum = [0, 1, 2, 3].map(|k| a[k][i] * from + b[k][i] * to);
        let square = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2] + sum[3] * sum[3];
        let scale = 1.0 / square.sqrt();
        for k in 0..4 {
            result[k][i] = sum[k] * scale;
        }
    }
    result
}

#[inline(always)]
fn put(block: &[Block; 4], joints: &[usize], rotors: &mut [Rotor<f32>]) {
    let [s, e12, e13, e23] = block;
    for (i, &joint) in joints.iter().enumerate().take(LANES) {
        if let Some(rotor) = rotors.get_mut(joint) {
            *rotor = Rotor::new_unchecked(s[i], e12[i], e13[i], e23[i]);
        }
    }
}

#[inline(always)]
fn put_vectors(
    channels: &[VectorChannels],
    vectors: &mut [Vector<f32>],
    value: impl Fn(usize) -> f32,
) {
    for part in channels {
        let mut vector = part.constant;
        for (k, &axis) in part.axes.iter().enumerate().take(part.live) {
            vector += axis * value(part.first + k);
        }
        if let Some(place) = vectors.get_mut(part.joint) {
            *place = vector;
        }
    }
}
