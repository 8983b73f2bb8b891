//! What a decoder needs in its loops: numbers in blocks of lanes.

use std::collections::HashMap;

use super::basis::{Basis, SEGMENT, TERMS};
use super::bits::BitReader;
use super::layout::{JointLayout, Part, coefficients, double_rotor};
use super::pack::{Segment, frames_of};
use super::piece::Piece;
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

/// The lanes of a block.
pub(super) const LANES: usize = 8;

/// A number in each lane.
pub(super) type Block = [f32; LANES];

/// Eight channels in a segment: their trends, and where their residuals are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ChannelBlock {
    /// Its first row in [`Tables::rows`]: what residuals are multiplied by, the constant terms,
    /// then the higher terms of the trends.
    pub(super) row: u32,
    /// How many higher terms there are.
    pub(super) terms: u8,
    /// The bytes of a residual: 0, 1, 2 or 4.
    pub(super) width: u8,
    /// Where the residuals begin, in bytes from the begin of a frame.
    pub(super) offset: u32,
}

/// Eight joints that rotate: the rotor at B = 0, and what each channel of B adds to it. By
/// coefficient: scalar, e12, e13, e23.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RotorBlock {
    pub(super) middle: [Block; 4],
    pub(super) along: [[Block; 4]; 3],
    /// How many channels the joints have; those with fewer have zeros beyond.
    pub(super) channels: usize,
    /// The block of values of the first channel; the others follow.
    pub(super) first: usize,
}

/// Where the channels of a part other than a rotation are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct VectorChannels {
    pub(super) joint: usize,
    /// The lane of the first channel.
    pub(super) first: usize,
    pub(super) constant: Vector<f32>,
    /// The axes of the channels.
    pub(super) axes: [Vector<f32>; 3],
    pub(super) live: usize,
}

/// A segment in memory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SegmentTable {
    /// Where its residuals begin, in bytes.
    pub(super) begin: usize,
    /// How many bytes those of a frame take.
    pub(super) frame_bytes: usize,
}

/// The tables of a clip. The values of a frame are in blocks: for each block of rotating joints one
/// for each channel of B, and then those of all other channels.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tables {
    /// The joints that rotate, in the order of the lanes.
    pub(super) rotating: Vec<usize>,
    pub(super) rotors: Vec<RotorBlock>,
    pub(super) translations: Vec<VectorChannels>,
    pub(super) scales: Vec<VectorChannels>,
    /// The lanes of the tracks, and their constants.
    pub(super) tracks: Vec<(Option<usize>, f64)>,
    /// How many channels there are.
    pub(super) channels: usize,
    /// How many blocks of values a frame has.
    pub(super) blocks: usize,
    /// By segment, then by block.
    pub(super) segment_blocks: Vec<ChannelBlock>,
    pub(super) rows: Vec<Block>,
    pub(super) segments: Vec<SegmentTable>,
    /// The residuals by segment, frame and lane, in whole bytes: to read eight at once is faster
    /// than to shift each out of its bits.
    pub(super) residuals: Vec<u8>,
    /// The values of the orthogonal polynomials by frame, for whole segments and for the last one.
    pub(super) bases: [Vec<[f32; TERMS]>; 2],
}

/// Which number of a pose a channel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Channel {
    /// A channel of a joint, counted through translation, scale and rotation.
    OfJoint { joint: usize, channel: usize },
    /// A scalar track that changes.
    Track(usize),
}

/// The joints that rotate, those with the most channels first, so that in a block of eight joints
/// few lanes are empty.
fn rotating(layouts: &[JointLayout]) -> Vec<usize> {
    let rotates = |&joint: &usize| layouts[joint].rotation.live > 0;
    let mut rotating: Vec<usize> = (0..layouts.len()).filter(rotates).collect();
    rotating.sort_by_key(|&joint| std::cmp::Reverse(layouts[joint].rotation.live));
    rotating
}

/// The channels in the order of the file, which is that of the lanes: for each block of eight
/// rotating joints their first channels, their second and their third, then all others.
pub(super) fn channels(
    layouts: &[JointLayout],
    tracks: impl IntoIterator<Item = bool>,
) -> Vec<(Channel, usize)> {
    let mut channels = Vec::new();
    let mut lane = 0;
    for joints in rotating(layouts).chunks(LANES) {
        for k in 0..layouts[joints[0]].rotation.live {
            for (i, &joint) in joints.iter().enumerate() {
                let layout = &layouts[joint];
                if k < layout.rotation.live {
                    let channel = layout.translation.live + layout.scale.live + k;
                    channels.push((Channel::OfJoint { joint, channel }, lane + i));
                }
            }
            lane += LANES;
        }
    }
    for (joint, layout) in layouts.iter().enumerate() {
        for channel in 0..layout.translation.live + layout.scale.live {
            channels.push((Channel::OfJoint { joint, channel }, lane));
            lane += 1;
        }
    }
    for (track, changes) in tracks.into_iter().enumerate() {
        if changes {
            channels.push((Channel::Track(track), lane));
            lane += 1;
        }
    }
    channels
}

impl Tables {
    /// The tables of a clip. Of each track: whether it changes, and its constant.
    pub(super) fn new(
        layouts: &[JointLayout],
        tracks: &[(bool, f64)],
        frames: usize,
        segments: &[Segment],
    ) -> Self {
        let rotating = rotating(layouts);
        let rotors = rotor_blocks(layouts, &rotating);
        let channels = channels(layouts, tracks.iter().map(|track| track.0));
        let lanes_of: HashMap<Channel, usize> = channels.iter().copied().collect();
        let lane_of = |channel: Channel| lanes_of.get(&channel).copied();
        let parts = |part: fn(&JointLayout) -> &Part, before: fn(&JointLayout) -> usize| {
            let of_joint = |(joint, layout): (usize, &JointLayout)| {
                let channel = before(layout);
                let part = *part(layout);
                (part.live > 0).then_some(())?;
                Some(VectorChannels {
                    joint,
                    first: lane_of(Channel::OfJoint { joint, channel })?,
                    constant: part.constant,
                    axes: part.directions().map(super::layout::single),
                    live: part.live,
                })
            };
            layouts.iter().enumerate().filter_map(of_joint).collect()
        };
        let lanes: Vec<usize> = channels.iter().map(|&(_, lane)| lane).collect();
        let mut tables = Self {
            translations: parts(|layout| &layout.translation, |_| 0),
            scales: parts(|layout| &layout.scale, |layout| layout.translation.live),
            tracks: tracks
                .iter()
                .enumerate()
                .map(|(track, &(_, constant))| (lane_of(Channel::Track(track)), constant))
                .collect(),
            channels: lanes.len(),
            blocks: lanes.iter().max().map_or(0, |most| most / LANES + 1),
            rotating,
            rotors,
            segment_blocks: Vec::new(),
            rows: Vec::new(),
            segments: Vec::new(),
            residuals: Vec::new(),
            bases: [SEGMENT, frames_of(segments.len().saturating_sub(1), frames)].map(by_frame),
        };
        for (index, segment) in segments.iter().enumerate() {
            tables.push(segment, &lanes, frames_of(index, frames));
        }
        tables
    }

    fn push(&mut self, segment: &Segment, lanes: &[usize], frames: usize) {
        let mut by_lane: Vec<[Option<&Piece>; LANES]> = vec![[None; LANES]; self.blocks];
        for (piece, &lane) in segment.pieces.iter().zip(lanes) {
            by_lane[lane / LANES][lane % LANES] = Some(piece);
        }
        let first = self.segment_blocks.len();
        let mut offset = 0;
        for pieces in by_lane {
            let block = self.push_block(pieces, offset);
            offset += u32::from(block.width) * LANES as u32;
            self.segment_blocks.push(block);
        }
        let (begin, frame_bytes) = (self.residuals.len(), offset as usize);
        self.segments.push(SegmentTable { begin, frame_bytes });

        self.residuals.resize(begin + frames * frame_bytes, 0);
        let blocks = &self.segment_blocks[first..];
        let mut reader = BitReader::new(&segment.residuals);
        for frame in 0..frames {
            let bytes = &mut self.residuals[begin + frame * frame_bytes..][..frame_bytes];
            for (piece, &lane) in segment.pieces.iter().zip(lanes) {
                let residual = reader.bits(piece.bits.into()).unwrap_or(0).to_le_bytes();
                let (block, width) = (blocks[lane / LANES], blocks[lane / LANES].width as usize);
                let at = block.offset as usize + lane % LANES * width;
                bytes[at..at + width].copy_from_slice(&residual[..width]);
            }
        }
    }

    /// Appends the rows of a block.
    fn push_block(&mut self, pieces: [Option<&Piece>; LANES], offset: u32) -> ChannelBlock {
        let row = self.rows.len();
        let present = || pieces.iter().flatten();
        let terms = present().map(|piece| piece.terms).max().unwrap_or(0).max(1);
        self.rows.resize(row + 1 + usize::from(terms), [0.0; LANES]);
        for (lane, piece) in pieces.iter().enumerate() {
            let Some(piece) = piece else { continue };
            let (quantum, step) = (piece.quantum(), piece.step());
            self.rows[row][lane] = step as f32;
            for (term, values) in self.rows[row + 1..].iter_mut().enumerate() {
                // B₀ is 1, so the constant term takes what is subtracted from the residual.
                let shift = if term == 0 {
                    piece.middle() * step
                } else {
                    0.0
                };
                values[lane] = (f64::from(piece.coefficients[term]) * quantum - shift) as f32;
            }
        }
        let width = match present().map(|piece| piece.bits).max().unwrap_or(0) {
            0 => 0,
            1..=8 => 1,
            9..=16 => 2,
            _ => 4,
        };
        ChannelBlock {
            row: row as u32,
            terms: terms - 1,
            width,
            offset,
        }
    }
}

fn by_frame(frames: usize) -> Vec<[f32; TERMS]> {
    let basis = Basis::new(frames);
    let values = |frame: usize| std::array::from_fn(|term| basis.values[term][frame] as f32);
    (0..frames).map(values).collect()
}

fn rotor_blocks(layouts: &[JointLayout], rotating: &[usize]) -> Vec<RotorBlock> {
    let mut first = 0;
    let block = |joints: &[usize]| {
        let mut block = RotorBlock {
            middle: [[0.0; LANES]; 4],
            along: [[[0.0; LANES]; 4]; 3],
            channels: layouts[joints[0]].rotation.live,
            first,
        };
        first += block.channels;
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
