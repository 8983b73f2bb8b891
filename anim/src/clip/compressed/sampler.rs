//! Poses of a compressed clip at any time.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::CompressedClip;
use super::basis::SEGMENT;
use super::layout::{double, double_rotor};
use super::tables::{Block, LANES, RotorBlock, Tables, VectorChannels};
use crate::frame_position::frame_at;
use crate::kinematics::KinematicsError;
use crate::transform::Transform;

/// Where the cosine of half the angle from one frame to the next is above this in all joints, a
/// polynomial with few terms is enough: up to 23° from frame to frame.
const NEAR: f32 = 0.98;

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
    between: RotorRows,
    /// The frame that `is_near` is about, with the next.
    compared: Option<usize>,
    /// Whether all rotations to the next frame are by small angles.
    is_near: bool,
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
    /// Those of the rotating joints.
    rotors: RotorRows,
}

/// The coefficients of rotors, by coefficient and then by lane: loops over long rows become vector
/// instructions.
type RotorRows = [Vec<Block>; 4];

impl<'a> Sampler<'a> {
    /// A sampler at the first frame.
    #[must_use]
    pub fn new(clip: &'a CompressedClip) -> Self {
        let tables = clip.tables();
        let frame = Frame {
            index: None,
            values: vec![[0.0; LANES]; tables.blocks],
            rotors: [(); 4].map(|()| vec![[0.0; LANES]; tables.rotors.len()]),
        };
        let layouts = clip.layouts();
        let mut sampler = Self {
            clip,
            batch: Batch::new(),
            between: frame.rotors.clone(),
            compared: None,
            is_near: false,
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
        let (frame, part) = frame_at(time / self.clip.frame_time(), last);
        self.go_to(frame, part as f32);
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
    /// [`KinematicsError::SliceLength`] unless `locals` has one place for each joint.
    pub fn locals(&self, locals: &mut [Transform<f64>]) -> Result<(), KinematicsError> {
        let (expected, found) = (self.rotors.len(), locals.len());
        if expected != found {
            return Err(KinematicsError::SliceLength { expected, found });
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
        let rows = if part > 0.0 {
            if sampler.compared != here {
                (sampler.compared, sampler.is_near) = (here, are_near(&a.rotors, &b.rotors));
            }
            let (rotors, between) = ([&a.rotors, &b.rotors], &mut sampler.between);
            if sampler.is_near {
                interpolate::<4>(rotors, part, between);
            } else {
                interpolate::<9>(rotors, part, between);
                normalise(between);
            }
            &sampler.between
        } else {
            &a.rotors
        };
        put(rows, &tables.rotating, &mut sampler.rotors);
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
        for (block, constants) in tables.rotors.iter().enumerate() {
            let bivectors = &values[constants.first..];
            let [a, b, c, d] = frame.rotors.each_mut();
            let rotors = [&mut a[block], &mut b[block], &mut c[block], &mut d[block]];
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

/// The rotors of eight joints with up to K channels, by coefficient.
///
/// A loop over the lanes for each array: with two in one, or with results by value, the compiler
/// leaves the lanes apart.
#[inline(always)]
fn rotate<const K: usize>(constants: &RotorBlock, bivectors: &[Block], rotors: [&mut Block; 4]) {
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
    for (k, row) in rotors.into_iter().enumerate() {
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
/// accurate algorithm for computing slerp", 2011): the first N coefficients at t, times t, from the
/// constant one on. The coefficient n is that before times t² / (n (2n + 1)) − n / (2n + 1).
///
/// With four, the factor is within 10⁻⁸ for cosines from [`NEAR`] on. With nine, of which the last
/// is weighted, the angle is within 10⁻⁸ of slerp up to θ = π/4, where rotations are a right angle
/// apart, and within 2·10⁻⁵ up to θ = π/2, where they are opposite.
#[inline(always)]
fn slerp_coefficients<const N: usize>(t: f32) -> [f32; N] {
    const LAST: f32 = 1.901_107_5;
    let square = t * t;
    let mut coefficients = [t; N];
    for n in 1..N {
        let (number, weight) = (n as f32, if n == 8 { LAST } else { 1.0 });
        // Quotients of constants, once the loop is unrolled.
        let of_square = weight / (number * (2.0 * number + 1.0));
        let constant = weight * number / (2.0 * number + 1.0);
        coefficients[n] = coefficients[n - 1] * (square * of_square - constant);
    }
    coefficients
}

/// The polynomial with these coefficients, from the constant one on.
#[inline(always)]
fn polynomial<const N: usize>(coefficients: &[f32; N], x: f32) -> f32 {
    let Some((&last, others)) = coefficients.split_last() else {
        return 0.0;
    };
    let others = others.iter().rev();
    others.fold(last, |sum, &coefficient| sum * x + coefficient)
}

/// Whether all rotors are so near to others that their cosines are above [`NEAR`].
#[inline(always)]
fn are_near(a: &RotorRows, b: &RotorRows) -> bool {
    let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (numbers(a), numbers(b));
    let lanes = a0.len();
    let (a1, a2, a3) = (&a1[..lanes], &a2[..lanes], &a3[..lanes]);
    let (b0, b1, b2, b3) = (&b0[..lanes], &b1[..lanes], &b2[..lanes], &b3[..lanes]);
    // A count becomes vector instructions, a conjunction does not.
    let mut far = 0u32;
    for i in 0..lanes {
        let cosine = a0[i] * b0[i] + a1[i] * b1[i] + a2[i] * b2[i] + a3[i] * b3[i];
        far += u32::from(cosine.abs() < NEAR);
    }
    far == 0
}

/// The rows as numbers, all of the same length. Methods of arrays such as `map` would not be
/// compiled as part of the loop.
#[inline(always)]
fn numbers<'a>(rows: &'a RotorRows) -> [&'a [f32]; 4] {
    let lanes = LANES * rows[0].len();
    let [a, b, c, d] = rows.each_ref();
    let row = |row: &'a Vec<Block>| &row.as_flattened()[..lanes];
    [row(a), row(b), row(c), row(d)]
}

#[inline(always)]
fn numbers_mut(rows: &mut RotorRows) -> [&mut [f32]; 4] {
    let lanes = LANES * rows[0].len();
    let [a, b, c, d] = rows.each_mut();
    [
        &mut a.as_flattened_mut()[..lanes],
        &mut b.as_flattened_mut()[..lanes],
        &mut c.as_flattened_mut()[..lanes],
        &mut d.as_flattened_mut()[..lanes],
    ]
}

/// Rotors at a part of the shorter arcs between others, by N terms of slerp.
#[inline(always)]
fn interpolate<const N: usize>(rotors: [&RotorRows; 2], part: f32, between: &mut RotorRows) {
    let (of_a, of_b) = (
        slerp_coefficients::<N>(1.0 - part),
        slerp_coefficients::<N>(part),
    );
    let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (numbers(rotors[0]), numbers(rotors[1]));
    let [r0, r1, r2, r3] = numbers_mut(between);
    let lanes = r0.len();
    // Equal lengths, seen by the compiler, leave the loop without checks.
    let (a0, a1, a2, a3) = (&a0[..lanes], &a1[..lanes], &a2[..lanes], &a3[..lanes]);
    let (b0, b1, b2, b3) = (&b0[..lanes], &b1[..lanes], &b2[..lanes], &b3[..lanes]);
    let (r1, r2, r3) = (&mut r1[..lanes], &mut r2[..lanes], &mut r3[..lanes]);
    for i in 0..lanes {
        let cosine = a0[i] * b0[i] + a1[i] * b1[i] + a2[i] * b2[i] + a3[i] * b3[i];
        let x = cosine.abs() - 1.0;
        let from = polynomial(&of_a, x);
        let to = polynomial(&of_b, x).copysign(cosine);
        r0[i] = a0[i] * from + b0[i] * to;
        r1[i] = a1[i] * from + b1[i] * to;
        r2[i] = a2[i] * from + b2[i] * to;
        r3[i] = a3[i] * from + b3[i] * to;
    }
}

/// Makes rotors whose squares are within 10⁻⁴ of 1 unit rotors, by a step of Newton's method for
/// the inverse square root.
#[inline(always)]
fn normalise(rotors: &mut RotorRows) {
    let [r0, r1, r2, r3] = numbers_mut(rotors);
    let lanes = r0.len();
    let (r1, r2, r3) = (&mut r1[..lanes], &mut r2[..lanes], &mut r3[..lanes]);
    for i in 0..lanes {
        let square = r0[i] * r0[i] + r1[i] * r1[i] + r2[i] * r2[i] + r3[i] * r3[i];
        let factor = 1.5 - 0.5 * square;
        r0[i] *= factor;
        r1[i] *= factor;
        r2[i] *= factor;
        r3[i] *= factor;
    }
}

/// Puts rotors from the lanes to their joints.
#[inline(always)]
fn put(rows: &RotorRows, joints: &[usize], rotors: &mut [Rotor<f32>]) {
    let [s, e12, e13, e23] = numbers(rows);
    let lanes = s.iter().zip(e12).zip(e13.iter().zip(e23));
    for (&joint, ((&s, &e12), (&e13, &e23))) in joints.iter().zip(lanes) {
        if let Some(rotor) = rotors.get_mut(joint) {
            *rotor = Rotor::new_unchecked(s, e12, e13, e23);
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
