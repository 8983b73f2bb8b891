//! Poses of a compressed clip at any time.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::CompressedClip;
use super::basis::SEGMENT;
use super::layout::{double, double_rotor};
use super::tables::{Block, LANES, RotorBlock, Tables, VectorChannels};
use crate::recording::ModelSpaceError;
use crate::transform::Transform;

/// A time this near to a frame, in frames, is that of the frame: the product of a number of frames
/// and the time between them is rounded.
const SAME_FRAME: f64 = 1e-7;

/// Samples a [`CompressedClip`] forward, backward or at random, into slices of its own.
///
/// A frame is decoded without its predecessors. The two frames around the last time are kept, so
/// that small steps decode little. Sampling allocates nothing.
///
/// Between frames rotations move along the shorter arc at constant speed (slerp within single
/// precision where neighbouring frames are less than a right angle apart, and within 2·10⁻⁵ radians
/// up to half a rotation), translations, factors and tracks linearly.
///
/// What it decodes are transforms relative to the parents in single precision, and the bounds of
/// the clip hold for those composed to model space in double precision, as
/// [`locals`](Self::locals) and [`model_maps`](crate::recording::model_maps) do. Composing them in
/// single precision adds the rounding of the products, about 10⁻⁷ of the distance from the origin
/// for each joint of the chain.
#[derive(Clone, Debug)]
pub struct Sampler<'a> {
    clip: &'a CompressedClip,
    batch: Batch,
    frames: [Frame; 2],
    /// Rotors between the two frames, as in [`Frame::rotors`].
    between: Vec<[Block; 4]>,
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
    /// The values of all channels.
    values: Vec<Block>,
    /// By block of rotating joints, then by coefficient.
    rotors: Vec<[Block; 4]>,
}

impl<'a> Sampler<'a> {
    /// A sampler at the first frame.
    #[must_use]
    pub fn new(clip: &'a CompressedClip) -> Self {
        let tables = clip.tables();
        let frame = Frame {
            index: None,
            values: vec![[0.0; LANES]; tables.blocks],
            rotors: vec![[[0.0; LANES]; 4]; tables.rotors.len()],
        };
        let layouts = clip.layouts();
        let mut sampler = Self {
            clip,
            batch: Batch::new(),
            between: frame.rotors.clone(),
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
        let nearest = position.round();
        if (position - nearest).abs() < SAME_FRAME {
            self.go_to(nearest as usize, 0.0);
        } else {
            let before = position as usize;
            self.go_to(before, (position - before as f64) as f32);
        }
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
    /// [`model_maps`](crate::recording::model_maps). The numbers are those of the slices above, in
    /// double precision, since products of motors in single precision would add an error of their
    /// own far from the origin.
    ///
    /// # Errors
    ///
    /// [`ModelSpaceError::Length`] unless `locals` has one place for each joint.
    pub fn locals(&self, locals: &mut [Transform<f64>]) -> Result<(), ModelSpaceError> {
        let (expected, found) = (self.rotors.len(), locals.len());
        if expected != found {
            return Err(ModelSpaceError::Length { expected, found });
        }
        for (joint, local) in locals.iter_mut().enumerate() {
            *local = Transform::from_parts(
                double(self.translations[joint]),
                double_rotor(self.rotors[joint]),
                double(self.scales[joint]),
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
        if tables.channels == 0 {
            return;
        }
        // The frame after becomes the one before on the way forward, and the other way round.
        let [a, b] = &mut sampler.frames;
        let (here, next) = (Some(frame), Some(frame + 1));
        if a.index != here && (b.index == here || a.index == next) {
            std::mem::swap(a, b);
        }
        let (lacks_a, lacks_b) = (a.index != here, part > 0.0 && b.index != next);
        if lacks_a && lacks_b && (frame + 1) % SEGMENT != 0 {
            decode(tables, frame, [a, b]);
        } else {
            if lacks_a {
                decode(tables, frame, [a]);
            }
            if lacks_b {
                decode(tables, frame + 1, [b]);
            }
        }
        let [a, b] = &sampler.frames;
        let blocks = if part > 0.0 {
            let coefficients = [1.0 - part, part].map(slerp_coefficients);
            let pairs = a.rotors.iter().zip(&b.rotors);
            for (between, (a, b)) in sampler.between.iter_mut().zip(pairs) {
                interpolate([a, b], &coefficients, between);
            }
            &sampler.between
        } else {
            &a.rotors
        };
        for (block, joints) in blocks.iter().zip(tables.rotating.chunks(LANES)) {
            put(block, joints, &mut sampler.rotors);
        }
        let (from, to) = (a.values.as_flattened(), b.values.as_flattened());
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

/// Decodes consecutive frames of one segment.
#[inline(always)]
fn decode<const N: usize>(tables: &Tables, index: usize, mut frames: [&mut Frame; N]) {
    let (segment, within) = (index / SEGMENT, index % SEGMENT);
    let table = tables.segments[segment];
    let begin = table.begin + within * table.frame_bytes;
    let bytes = &tables.residuals[begin..begin + N * table.frame_bytes];
    let last = segment + 1 == tables.segments.len();
    let bases = &tables.bases[usize::from(last)][within..within + N];
    let blocks = &tables.segment_blocks[segment * tables.blocks..][..tables.blocks];
    for (place, block) in blocks.iter().enumerate() {
        let rows = &tables.rows[block.row as usize..][..2 + usize::from(block.terms)];
        let [step, constant, terms @ ..] = rows else {
            return;
        };
        for (n, (frame, basis)) in frames.iter_mut().zip(bases).enumerate() {
            let at = n * table.frame_bytes + block.offset as usize;
            let mut sum = *constant;
            if let Some(residuals) = residuals(bytes, at, block.width) {
                for i in 0..LANES {
                    sum[i] += residuals[i] * step[i];
                }
            }
            for (terms, &basis) in terms.iter().zip(&basis[1..]) {
                for i in 0..LANES {
                    sum[i] += terms[i] * basis;
                }
            }
            if let Some(value) = frame.values.get_mut(place) {
                *value = sum;
            }
        }
    }
    for (n, frame) in frames.into_iter().enumerate() {
        let values = &frame.values;
        for (rotors, constants) in frame.rotors.iter_mut().zip(&tables.rotors) {
            let bivectors = &values[constants.first..];
            match constants.channels {
                1 => rotate::<1>(constants, bivectors, rotors),
                2 => rotate::<2>(constants, bivectors, rotors),
                _ => rotate::<3>(constants, bivectors, rotors),
            }
        }
        frame.index = Some(index + n);
    }
}

/// Eight residuals of 1, 2 or 4 bytes.
#[inline(always)]
fn residuals(bytes: &[u8], at: usize, width: u8) -> Option<Block> {
    let bytes = bytes.get(at..)?;
    match width {
        1 => Some(bytes.first_chunk::<LANES>()?.map(f32::from)),
        2 => {
            let (pairs, _) = bytes.first_chunk::<{ 2 * LANES }>()?.as_chunks::<2>();
            let pairs = pairs.first_chunk::<LANES>()?;
            Some(pairs.map(|pair| f32::from(u16::from_le_bytes(pair))))
        }
        4 => {
            let (words, _) = bytes.first_chunk::<{ 4 * LANES }>()?.as_chunks::<4>();
            let words = words.first_chunk::<LANES>()?;
            // At most 24 bits, which single precision holds.
            Some(words.map(|word| i32::from_le_bytes(word) as f32))
        }
        _ => None,
    }
}

/// The rotors of eight joints with up to K channels.
#[inline(always)]
fn rotate<const K: usize>(constants: &RotorBlock, bivectors: &[Block], rotors: &mut [Block; 4]) {
    let Some(b) = bivectors.first_chunk::<K>() else {
        return;
    };
    let mut square = [0.0; LANES];
    for b in b {
        for i in 0..LANES {
            square[i] += b[i] * b[i];
        }
    }
    let (mut scale, mut scalar) = ([0.0; LANES], [0.0; LANES]);
    for i in 0..LANES {
        scale[i] = 1.0 / (1.0 + square[i]);
        scalar[i] = 1.0 - square[i];
    }
    for (k, row) in rotors.iter_mut().enumerate() {
        let mut sum = [0.0; LANES];
        for i in 0..LANES {
            sum[i] = constants.middle[k][i] * scalar[i];
        }
        for (b, along) in b.iter().zip(&constants.along) {
            for i in 0..LANES {
                sum[i] += along[k][i] * b[i];
            }
        }
        for i in 0..LANES {
            row[i] = sum[i] * scale[i];
        }
    }
}

/// Of slerp, the factor sin(tθ) / (t sin θ) as a polynomial in cos θ − 1 (D. Eberly, "A fast and
/// accurate algorithm for computing slerp", 2011): its coefficients at t, from the constant one on.
///
/// With the last one weighted so, the angle is within 10⁻⁸ of slerp up to θ = π/4, where rotations
/// are a right angle apart, and within 2·10⁻⁵ up to θ = π/2, where they are opposite.
#[inline(always)]
fn slerp_coefficients(t: f32) -> [f32; 9] {
    const LAST: f32 = 1.901_107_5;
    let mut coefficients = [1.0; 9];
    for i in 1..coefficients.len() {
        let n = i as f32;
        let weight = if i == 8 { LAST } else { 1.0 };
        let factor = (t * t / (n * (2.0 * n + 1.0)) - n / (2.0 * n + 1.0)) * weight;
        coefficients[i] = coefficients[i - 1] * factor;
    }
    coefficients.map(|coefficient| coefficient * t)
}

/// The polynomial with these coefficients, from the constant one on, in each lane.
#[inline(always)]
fn polynomial(coefficients: &[f32; 9], x: &Block) -> Block {
    let mut sum = [coefficients[8]; LANES];
    for &coefficient in coefficients[..8].iter().rev() {
        for i in 0..LANES {
            sum[i] = sum[i] * x[i] + coefficient;
        }
    }
    sum
}

/// Eight rotors between others along the shorter arcs, by the coefficients of slerp for both.
///
/// A loop over the lanes for each array: with two in one, the compiler leaves lanes apart.
#[inline(always)]
fn interpolate([a, b]: [&[Block; 4]; 2], [of_a, of_b]: &[[f32; 9]; 2], result: &mut [Block; 4]) {
    let mut cosine = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for i in 0..LANES {
            cosine[i] += a[i] * b[i];
        }
    }
    let mut x = [0.0; LANES];
    for i in 0..LANES {
        x[i] = cosine[i].abs() - 1.0;
    }
    let (from, mut to) = (polynomial(of_a, &x), polynomial(of_b, &x));
    for i in 0..LANES {
        to[i] = to[i].copysign(cosine[i]);
    }
    let mut mean = [[0.0; LANES]; 4];
    let mut squares = [0.0; LANES];
    for (mean, (a, b)) in mean.iter_mut().zip(a.iter().zip(b)) {
        for i in 0..LANES {
            mean[i] = a[i] * from[i] + b[i] * to[i];
        }
        for i in 0..LANES {
            squares[i] += mean[i] * mean[i];
        }
    }
    // A step of Newton's method for the inverse square root: the squares are within 10⁻⁴ of 1.
    let mut factor = [0.0; LANES];
    for i in 0..LANES {
        factor[i] = 1.5 - 0.5 * squares[i];
    }
    for (row, mean) in result.iter_mut().zip(&mean) {
        for i in 0..LANES {
            row[i] = mean[i] * factor[i];
        }
    }
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
        // The constant may be large, so it is added last and rounds the sum once.
        let mut deviation = Vector::default();
        for (k, &axis) in part.axes.iter().enumerate().take(part.live) {
            deviation += axis * value(part.first + k);
        }
        if let Some(place) = vectors.get_mut(part.joint) {
            *place = part.constant + deviation;
        }
    }
}
