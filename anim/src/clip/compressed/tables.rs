//! What a decoder needs in its loops: numbers in blocks of lanes.

use super::basis::{Basis, SEGMENT, TERMS};
use super::layout::{JointLayout, coefficients, double_rotor};
use super::pack::{Segment, frames_of};
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

/// The lanes of a block.
pub(super) const LANES: usize = 8;

/// A number in each lane.
pub(super) type Block = [f32; LANES];

/// The trends of the channels of a block in a segment, and the steps of their residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TrendBlock {
    pub(super) terms: [Block; TERMS],
    pub(super) step: Block,
}

/// Eight joints that rotate: the rotor at B = 0, and what each channel of B adds to it. By
/// coefficient: scalar, e12, e13, e23.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RotorBlock {
    pub(super) middle: [Block; 4],
    pub(super) along: [[Block; 4]; 3],
}

/// Where the channels of a part other than a rotation are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct VectorChannels {
    pub(super) joint: usize,
    /// The place of the first channel among the [extra](Tables::extra) ones.
    pub(super) first: usize,
    pub(super) constant: Vector<f32>,
    /// The axes of the channels; 0 beyond them.
    pub(super) axes: [Vector<f32>; 3],
    pub(super) live: usize,
}

/// A segment in memory.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SegmentTable {
    /// Where its residuals begin, in bytes.
    pub(super) begin: usize,
    /// How many bits those of a frame take.
    pub(super) frame_bits: usize,
}

/// The tables of a clip. The values of a frame are in blocks: for each block of rotating joints
/// three, one for each channel of B, and then the extra ones of all other channels.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tables {
    /// The joints that rotate, in the order of the lanes.
    pub(super) rotating: Vec<usize>,
    pub(super) rotors: Vec<RotorBlock>,
    pub(super) translations: Vec<VectorChannels>,
    pub(super) scales: Vec<VectorChannels>,
    /// The places of the channels of the tracks among the extra ones, and their constants.
    pub(super) tracks: Vec<(Option<usize>, f64)>,
    /// The lane of each channel, in the order of the file.
    pub(super) lanes: Vec<u32>,
    /// How many blocks of values a frame has.
    pub(super) blocks: usize,
    /// By segment, then by block.
    pub(super) trends: Vec<TrendBlock>,
    /// By segment, then by channel: the bits of a residual.
    pub(super) bits: Vec<u8>,
    pub(super) segments: Vec<SegmentTable>,
    /// The residuals of all segments and a few bytes behind them, so that a word can be read at any
    /// place.
    pub(super) residuals: Vec<u8>,
    /// The values of the orthogonal polynomials by frame, for whole segments and for the last one.
    pub(super) bases: [Vec<[f32; TERMS]>; 2],
}

impl Tables {
    /// The tables of a clip. Of each track: whether it changes, and its constant.
    pub(super) fn new(
        layouts: &[JointLayout],
        tracks: &[(bool, f64)],
        frames: usize,
        segments: &[Segment],
    ) -> Self {
        let rotating: Vec<usize> = (0..layouts.len())
            .filter(|&joint| layouts[joint].rotation.live > 0)
            .collect();
        let rotors = rotor_blocks(layouts, &rotating);
        let extra_begin = rotors.len() * 3 * LANES;
        let mut lanes = Vec::new();
        let mut extra = 0;
        let (mut translations, mut scales) = (Vec::new(), Vec::new());
        let mut rotor_lane = 0;
        for (joint, layout) in layouts.iter().enumerate() {
            for (part, list) in [
                (&layout.translation, &mut translations),
                (&layout.scale, &mut scales),
            ] {
                if part.live > 0 {
                    let axes = part.directions().map(super::layout::single);
                    let (first, live, constant) = (extra, part.live, part.constant);
                    list.push(VectorChannels {
                        joint,
                        first,
                        constant,
                        axes,
                        live,
                    });
                    lanes.extend((0..part.live).map(|k| extra_begin + extra + k));
                    extra += part.live;
                }
            }
            if layout.rotation.live > 0 {
                let (block, lane) = (rotor_lane / LANES, rotor_lane % LANES);
                lanes.extend((0..layout.rotation.live).map(|k| (3 * block + k) * LANES + lane));
                rotor_lane += 1;
            }
        }
        let mut track_places = Vec::new();
        for &(changes, constant) in tracks {
            track_places.push((changes.then_some(extra), constant));
            if changes {
                lanes.push(extra_begin + extra);
                extra += 1;
            }
        }
        let mut tables = Self {
            blocks: rotors.len() * 3 + extra.div_ceil(LANES),
            rotating,
            rotors,
            translations,
            scales,
            tracks: track_places,
            lanes: lanes.into_iter().map(|lane: usize| lane as u32).collect(),
            trends: Vec::new(),
            bits: Vec::new(),
            segments: Vec::new(),
            residuals: Vec::new(),
            bases: [SEGMENT, frames_of(segments.len().saturating_sub(1), frames)].map(by_frame),
        };
        for segment in segments {
            tables.push(segment);
        }
        tables.residuals.extend([0; 8]);
        tables
    }

    fn push(&mut self, segment: &Segment) {
        let empty = TrendBlock {
            terms: [[0.0; LANES]; TERMS],
            step: [0.0; LANES],
        };
        let begin = self.trends.len();
        self.trends.resize(begin + self.blocks, empty);
        for (piece, &lane) in segment.pieces.iter().zip(&self.lanes) {
            let block = &mut self.trends[begin + lane as usize / LANES];
            let lane = lane as usize % LANES;
            let (quantum, step) = (piece.quantum(), piece.step());
            for (term, block) in block.terms.iter_mut().enumerate() {
                // B₀ is 1, so the constant term takes what is subtracted from the residual.
                let shift = if term == 0 {
                    piece.middle() * step
                } else {
                    0.0
                };
                block[lane] = (f64::from(piece.coefficients[term]) * quantum - shift) as f32;
            }
            block.step[lane] = step as f32;
            self.bits.push(piece.bits);
        }
        self.segments.push(SegmentTable {
            begin: self.residuals.len(),
            frame_bits: segment.frame_bits(),
        });
        self.residuals.extend_from_slice(&segment.residuals);
    }

    /// The first block of the extra channels.
    pub(super) fn extra(&self) -> usize {
        self.rotors.len() * 3
    }
}

fn by_frame(frames: usize) -> Vec<[f32; TERMS]> {
    let basis = Basis::new(frames);
    let values = |frame: usize| std::array::from_fn(|term| basis.values[term][frame] as f32);
    (0..frames).map(values).collect()
}

fn rotor_blocks(layouts: &[JointLayout], rotating: &[usize]) -> Vec<RotorBlock> {
    let block = |joints: &[usize]| {
        let mut block = RotorBlock {
            middle: [[0.0; LANES]; 4],
            along: [[[0.0; LANES]; 4]; 3],
        };
        // Lanes without a joint hold the identity, so that they stay finite.
        block.middle[0] = [1.0; LANES];
        for (lane, &joint) in joints.iter().enumerate() {
            let layout = &layouts[joint];
            let middle = double_rotor(layout.middle);
            for (row, value) in block.middle.iter_mut().zip(coefficients(middle)) {
                row[lane] = value as f32;
            }
            let axes = layout.rotation.directions();
            for (along, axis) in block.along.iter_mut().zip(axes).take(layout.rotation.live) {
                let [e12, e13, e23] = axis.coordinates();
                // A unit bivector is the rotor of a half turn.
                let product = middle * Rotor::new_unchecked(0.0, e12, e13, e23);
                for (row, value) in along.iter_mut().zip(coefficients(product)) {
                    row[lane] = (2.0 * value) as f32;
                }
            }
        }
        block
    };
    rotating.chunks(LANES).map(block).collect()
}
