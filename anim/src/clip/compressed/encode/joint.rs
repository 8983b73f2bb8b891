//! One joint in one segment, encoded against its decoded parent.

use ga_runtime::cga3::Rotor;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, Vector3};

use super::super::basis::{Basis, SEGMENT};
use super::super::layout::{self, Part};
use super::super::piece::{self, Encoded, Precision};
use super::super::shell::relative_difference;
use super::source::Source;
use crate::transform::Transform;

/// The weight of a joint's own orientation beside the places of the joints that it carries.
const OWN_ORIENTATION: f64 = 0.05;

/// The greatest number of channels of a joint: translation, scale, rotation.
pub(super) const CHANNELS: usize = 9;

/// A joint in a segment as a decoder has it.
#[derive(Clone)]
pub(super) struct JointState {
    pub(super) models: [Affine<f64>; SEGMENT],
    pub(super) rotors: [Rotor<f64>; SEGMENT],
    /// The channels: translation, then scale, then rotation.
    pub(super) channels: Vec<Encoded>,
    /// The greatest error in the segment, in tolerances.
    pub(super) error: f64,
    /// About how many bits the trends take.
    pub(super) trend_bits: u32,
}

impl Default for JointState {
    fn default() -> Self {
        Self {
            models: [Affine::default(); SEGMENT],
            rotors: [Rotor::default(); SEGMENT],
            channels: Vec::new(),
            error: f64::INFINITY,
            trend_bits: 0,
        }
    }
}

/// How precisely a channel is encoded: above 0 the bits of its residual, below ever coarser trends.
pub(super) type Level = i8;

/// A segment of a recording.
pub(super) struct Segment<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) basis: &'a Basis,
    pub(super) first_frame: usize,
}

impl Segment<'_> {
    /// Encodes a joint against its parent at given levels.
    pub(super) fn encode(
        &self,
        joint: usize,
        levels: &[Level; CHANNELS],
        parent: Option<&JointState>,
        state: &mut JointState,
    ) {
        let mut levels = *levels;
        self.encode_with(joint, &mut levels, None, parent, state);
    }

    /// Encodes a joint and chooses levels with which each channel moves no point by more than a
    /// `part` of the tolerance.
    pub(super) fn encode_within(
        &self,
        joint: usize,
        part: f64,
        parent: Option<&JointState>,
        state: &mut JointState,
    ) -> [Level; CHANNELS] {
        let mut levels = [0; CHANNELS];
        self.encode_with(joint, &mut levels, Some(part), parent, state);
        levels
    }

    fn encode_with(
        &self,
        joint: usize,
        levels: &mut [Level; CHANNELS],
        part: Option<f64>,
        parent: Option<&JointState>,
        state: &mut JointState,
    ) {
        let layout = &self.source.layouts[joint];
        let levers = self.source.levers[joint];
        state.channels.clear();
        state.trend_bits = 0;
        let mut channels = Channels {
            basis: self.basis,
            tolerance: self.source.tolerances[joint],
            share: part,
            levels: levels.iter_mut(),
            state,
        };

        // Place and scale.
        let frames = self.basis.frames;
        let mut translations = [layout::double(layout.translation.constant); SEGMENT];
        channels.add(
            (&layout.translation, levers.translation),
            frames,
            |frame| self.translation(joint, frame, parent),
            &mut translations,
        );
        let mut scales = [layout::double(layout.scale.constant); SEGMENT];
        channels.add(
            (&layout.scale, levers.scale),
            frames,
            |frame| self.local(joint, frame).scale,
            &mut scales,
        );

        // Rotation, so that what the joint carries comes where it should.
        let middle = layout::double_rotor(layout.middle);
        let mut rotations = [middle; SEGMENT];
        if layout.rotation.live > 0 {
            let targets = self.rotation_targets(joint, parent, &translations, middle);
            let mut bivectors = [Vector::default(); SEGMENT];
            channels.add(
                (&layout.rotation, 4.0 * levers.rotation),
                frames,
                |frame| targets[frame].into(),
                &mut bivectors,
            );
            for (rotation, b) in rotations.iter_mut().zip(bivectors) {
                *rotation = middle * layout::from_stereographic(b);
            }
        }
        for frame in 0..frames {
            let rows = rotations[frame].to_matrix();
            let factors = scales[frame].coordinates();
            let linear = rows.map(|row| [0, 1, 2].map(|k| row[k] * factors[k]));
            let local = Affine::new(linear, translations[frame].coordinates());
            state.models[frame] = parent.map_or(local, |parent| parent.models[frame] * local);
            state.rotors[frame] = parent.map_or(rotations[frame], |parent| {
                parent.rotors[frame] * rotations[frame]
            });
        }
        state.error = self.error(joint, state);
    }

    fn local(&self, joint: usize, frame: usize) -> &Transform<f64> {
        &self.source.recording.locals()[(self.first_frame + frame) * self.source.joints() + joint]
    }

    fn truth(&self, joint: usize, frame: usize) -> (&Affine<f64>, Rotor<f64>) {
        let at = (self.first_frame + frame) * self.source.joints() + joint;
        (&self.source.models[at], self.source.rotors[at])
    }

    /// The translation relative to the decoded parent that puts the joint in its true place.
    fn translation(&self, joint: usize, frame: usize, parent: Option<&JointState>) -> Vector<f64> {
        let (truth, _) = self.truth(joint, frame);
        let place = Vector::from(truth.translation);
        let Some(parent) = parent else { return place };
        match parent.models[frame].inverse() {
            Some(inverse) => inverse
                .transform(place.coordinates().into())
                .coordinates()
                .into(),
            // Nothing below a factor of 0 has a place that its translation decides.
            None => self.local(joint, frame).translation(),
        }
    }

    /// The bivectors of the rotations to be encoded.
    fn rotation_targets(
        &self,
        joint: usize,
        parent: Option<&JointState>,
        translations: &[Vector<f64>; SEGMENT],
        middle: Rotor<f64>,
    ) -> [[f64; 3]; SEGMENT] {
        let frames = self.basis.frames;
        let mut targets = [Rotor::default(); SEGMENT];
        let back = middle.reverse();
        for frame in 0..frames {
            let rotor = if self.source.conformal[joint] {
                let own = self.corrected(joint, frame, parent, translations[frame]);
                parent.map_or(own, |parent| parent.rotors[frame].reverse() * own)
            } else {
                self.local(joint, frame).rotor()
            };
            targets[frame] = back * rotor;
        }
        // The signs follow one another where that stays far from the pole of the projection.
        let mut continuous = targets;
        continuous[0] = targets[0].canonical();
        for frame in 1..frames {
            let before = layout::coefficients(continuous[frame - 1]);
            if layout::dot4(before, layout::coefficients(targets[frame])) < 0.0 {
                continuous[frame] = -targets[frame];
            }
        }
        let is_far = |rotor: &Rotor<f64>| rotor.scalar() > -0.5;
        if continuous[..frames].iter().all(is_far) {
            continuous.map(layout::stereographic)
        } else {
            targets.map(Rotor::canonical).map(layout::stereographic)
        }
    }

    /// The rotation in model space that brings what the joint carries nearest to its true places,
    /// with the least rotation from the true orientation.
    fn corrected(
        &self,
        joint: usize,
        frame: usize,
        parent: Option<&JointState>,
        translation: Vector<f64>,
    ) -> Rotor<f64> {
        let (truth, rotor) = self.truth(joint, frame);
        let carried = &self.source.carried[joint];
        if carried.is_empty() {
            return rotor;
        }
        let place: Vector<f64> = parent.map_or(translation, |parent| {
            parent.models[frame]
                .transform(translation.coordinates().into())
                .coordinates()
                .into()
        });
        let missing = Vector::from(truth.translation) - place;
        let shell = self.source.bounds[joint].shell;
        // Of Σ |ω × y − d|² + w |ω|², with y from the joint to a carried one and d what is missing.
        let mut normal = Matrix3::from_diagonal_element(OWN_ORIENTATION * shell * shell);
        let mut right = Vector3::zeros();
        for &place in carried {
            let y = truth.linear.map(|row| Vector::from(row).dot(place));
            let y = Vector3::from(y);
            normal += Matrix3::from_diagonal_element(y.norm_squared()) - y * y.transpose();
            right += y.cross(&Vector3::from(missing.coordinates()));
        }
        let Some(inverse) = normal.try_inverse() else {
            return rotor;
        };
        let omega: [f64; 3] = (inverse * right).into();
        match Rotor::from_rotation_vector(omega) {
            Some(correction) => correction * rotor,
            None => rotor,
        }
    }

    /// The greatest error of the joint in the segment, in tolerances.
    fn error(&self, joint: usize, state: &JointState) -> f64 {
        let bound = &self.source.bounds[joint];
        let least = self.source.sizes.least(joint);
        let mut greatest = 0.0f64;
        for frame in 0..self.basis.frames {
            let (truth, rotor) = self.truth(joint, frame);
            let found = &state.models[frame];
            let moved = Vector::from(found.translation) - Vector::from(truth.translation);
            let size = Vector::from(truth.linear[0]).length();
            let other = Vector::from(found.linear[0]).length();
            // Where a factor changes here or above this joint, the general norm is needed.
            let is_rotation = self.source.conformal[joint]
                && self.source.layouts[joint].scale.live == 0
                && (size - other).abs() <= 1e-12 * size;
            let difference = if is_rotation {
                chord(rotor, state.rotors[frame]) * size / size.max(least)
            } else {
                relative_difference(found.linear, truth.linear, least)
            };
            greatest = greatest.max(moved.length() + bound.shell * difference);
        }
        // A NaN is not within the bound.
        if greatest.is_nan() {
            f64::INFINITY
        } else {
            greatest / bound.tolerance
        }
    }
}

/// The distance of the ends of the unit vector that two rotations take farthest apart.
fn chord(a: Rotor<f64>, b: Rotor<f64>) -> f64 {
    let (a, b) = (layout::coefficients(a), layout::coefficients(b));
    let sign = layout::dot4(a, b).signum();
    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - sign * b).powi(2)).sum();
    2.0 * (square * (1.0 - square / 4.0)).max(0.0).sqrt()
}

/// The channels of a joint, encoded one after the other.
struct Channels<'a> {
    basis: &'a Basis,
    tolerance: f64,
    /// Where levels are to be chosen, the part of the tolerance by which a channel may move a
    /// point.
    share: Option<f64>,
    /// Those of the channels to come.
    levels: std::slice::IterMut<'a, Level>,
    state: &'a mut JointState,
}

impl Channels<'_> {
    /// Encodes the deviations of vectors from the constant of a part of the transform, and adds
    /// what a decoder makes of them. A change by 1 moves points by up to `lever`.
    fn add(
        &mut self,
        (part, lever): (&Part, f64),
        frames: usize,
        value: impl Fn(usize) -> Vector<f64>,
        vectors: &mut [Vector<f64>; SEGMENT],
    ) {
        if part.live == 0 {
            return;
        }
        let directions = part.directions();
        let values = along(part, &directions, frames, value);
        let levels = self.levels.by_ref().take(part.live);
        for ((level, values), &direction) in levels.zip(&values).zip(&directions) {
            let finest = 0.1 * self.tolerance / lever.max(1e-12);
            if let Some(share) = self.share {
                let deviation = share * self.tolerance / lever.max(1e-12);
                *level = piece::bits_for(self.basis, values, deviation) as Level;
            }
            let precision = match *level {
                bits @ 1.. => Precision::Bits(bits as u8),
                coarse => Precision::Trend(finest * 2f64.powf(-f64::from(coarse) / 2.0)),
            };
            let encoded = piece::encode(self.basis, values, precision);
            self.state.trend_bits += encoded.piece.trend_bits();
            for (vector, &decoded) in vectors.iter_mut().zip(&encoded.decoded) {
                *vector += direction * decoded;
            }
            self.state.channels.push(encoded);
        }
    }
}

/// The coordinates of deviations along the axes of their channels.
fn along(
    part: &Part,
    directions: &[Vector<f64>; 3],
    frames: usize,
    value: impl Fn(usize) -> Vector<f64>,
) -> [[f64; SEGMENT]; 3] {
    let constant = layout::double(part.constant);
    let mut values = [[0.0; SEGMENT]; 3];
    for frame in 0..frames {
        let deviation = value(frame) - constant;
        for (row, &direction) in values[..part.live].iter_mut().zip(directions) {
            row[frame] = deviation.dot(direction);
        }
    }
    values
}
