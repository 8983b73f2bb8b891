//! Segments as bytes: the trends in Rice codes, then the residuals, frame after frame.

use std::ops::Range;

use super::basis::{Basis, SEGMENT, TERMS};
use super::bits::{BitReader, BitWriter, MOST_PARAMETER, best_parameter, rice_bits};
use super::piece::{Encoded, LEAST_RANGE, MOST_BITS, MOST_COEFFICIENT, MOST_RANGE, Piece, range};
use ga_numerics::order_statistics::median_element;

/// How many bits [`Codes::write`] takes.
const OWN_CODES: u64 = 25 + 5 * TERMS as u64;

/// How the pieces of a channel are written: about which values their numbers lie, and how widely
/// they spread. In a file a channel may have those of the channel before it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Codes {
    bits: i32,
    bits_spread: u32,
    range: i32,
    range_spread: u32,
    coefficient_spreads: [u32; TERMS],
}

impl Codes {
    /// The codes for all pieces of a channel.
    pub(super) fn of_pieces<'a>(pieces: impl Iterator<Item = &'a Piece> + Clone) -> Self {
        let bits = usual(pieces.clone().map(|piece| i32::from(piece.bits)));
        let range = usual(pieces.clone().map(|piece| i32::from(piece.range)));
        Self {
            bits,
            bits_spread: best_parameter(
                pieces
                    .clone()
                    .map(move |piece| i32::from(piece.bits) - bits),
            ),
            range,
            range_spread: best_parameter(
                pieces
                    .clone()
                    .map(move |piece| i32::from(piece.range) - range),
            ),
            coefficient_spreads: std::array::from_fn(|term| {
                let with_term = pieces.clone().filter(move |p| usize::from(p.terms) > term);
                best_parameter(with_term.map(move |piece| piece.coefficients[term]))
            }),
        }
    }

    /// The codes of all channels in the order of the file, of which neighbours share theirs where
    /// this takes fewer bits: in short clips own codes take more than they save.
    pub(super) fn of_segments(segments: &[Segment]) -> Vec<Self> {
        let channels = segments.first().map_or(0, |segment| segment.pieces.len());
        let of_channels = |range: Range<usize>| {
            let pieces = segments
                .iter()
                .flat_map(move |segment| &segment.pieces[range.clone()]);
            let codes = Self::of_pieces(pieces.clone());
            let bits: u64 = pieces.map(|piece| codes.piece_bits(piece)).sum();
            (codes, bits)
        };
        let mut all: Vec<Self> = Vec::with_capacity(channels);
        // The first channel of those that share their codes, and how many bits these take.
        let mut shared = (0, 0);
        for channel in 0..channels {
            let (own, own_bits) = of_channels(channel..channel + 1);
            let (together, bits) = of_channels(shared.0..channel + 1);
            if channel > 0 && bits <= shared.1 + own_bits + OWN_CODES {
                all[shared.0..].fill(together.clone());
                all.push(together);
                shared.1 = bits;
            } else {
                all.push(own);
                shared = (channel, own_bits);
            }
        }
        all
    }

    /// Writes the codes of all channels.
    pub(super) fn write_all(codes: &[Self], writer: &mut BitWriter) {
        let mut before = None;
        for codes in codes {
            let is_new = before != Some(codes);
            writer.bits(is_new.into(), 1);
            if is_new {
                codes.write(writer);
            }
            before = Some(codes);
        }
    }

    /// The codes of a channel after those of the channel before it; `None` at the end of the bytes,
    /// or for codes that are not written.
    pub(super) fn read_after(before: Option<&Self>, reader: &mut BitReader) -> Option<Self> {
        match reader.bits(1)? {
            0 => before.cloned(),
            _ => Self::read(reader),
        }
    }

    /// How many bits a piece takes.
    fn piece_bits(&self, piece: &Piece) -> u64 {
        let coefficients = piece.coefficients[..piece.terms.into()].iter();
        let trend = coefficients.zip(&self.coefficient_spreads);
        3 + rice_bits(i32::from(piece.bits) - self.bits, self.bits_spread)
            + rice_bits(i32::from(piece.range) - self.range, self.range_spread)
            + trend.map(|(&n, &spread)| rice_bits(n, spread)).sum::<u64>()
    }

    fn write(&self, writer: &mut BitWriter) {
        writer.bits(self.bits as u32, 5);
        writer.bits(self.bits_spread, 5);
        writer.bits((self.range - i32::from(LEAST_RANGE)) as u32, 10);
        writer.bits(self.range_spread, 5);
        for spread in self.coefficient_spreads {
            writer.bits(spread, 5);
        }
    }

    fn read(reader: &mut BitReader) -> Option<Self> {
        let mut codes = Self {
            bits: reader.bits(5)? as i32,
            bits_spread: reader.bits(5)?,
            range: reader.bits(10)? as i32 + i32::from(LEAST_RANGE),
            range_spread: reader.bits(5)?,
            coefficient_spreads: [0; TERMS],
        };
        for spread in &mut codes.coefficient_spreads {
            *spread = reader.bits(5)?;
        }
        let spreads = codes.coefficient_spreads.iter();
        let is_written = |&spread: &u32| spread <= MOST_PARAMETER;
        let others = [codes.bits_spread, codes.range_spread];
        let all = spreads.chain(&others).all(is_written);
        all.then_some(codes)
    }

    fn write_piece(&self, piece: &Piece, writer: &mut BitWriter) {
        writer.bits(piece.terms.into(), 3);
        writer.rice(i32::from(piece.bits) - self.bits, self.bits_spread);
        writer.rice(i32::from(piece.range) - self.range, self.range_spread);
        let terms = usize::from(piece.terms);
        for (&n, &spread) in piece.coefficients[..terms]
            .iter()
            .zip(&self.coefficient_spreads)
        {
            writer.rice(n, spread);
        }
    }

    fn read_piece(&self, reader: &mut BitReader) -> Option<Piece> {
        let terms = reader.bits(3)?;
        let bits = self.bits.checked_add(reader.rice(self.bits_spread)?)?;
        let range = self.range.checked_add(reader.rice(self.range_spread)?)?;
        let mut piece = Piece {
            terms: terms as u8,
            bits: u8::try_from(bits).ok()?,
            range: i16::try_from(range).ok()?,
            coefficients: [0; TERMS],
        };
        let coefficients = piece.coefficients.get_mut(..terms as usize)?;
        for (n, &spread) in coefficients.iter_mut().zip(&self.coefficient_spreads) {
            *n = reader.rice(spread)?;
        }
        Some(piece)
    }
}

fn usual(values: impl Iterator<Item = i32>) -> i32 {
    median_element(&mut values.collect::<Vec<_>>()).unwrap_or(0)
}

/// A segment whose trends are unpacked and whose residuals are not.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Segment {
    /// One for each channel.
    pub(super) pieces: Vec<Piece>,
    /// For each frame the residuals of all channels; no byte begins anew before the end.
    pub(super) residuals: Vec<u8>,
}

impl Segment {
    /// The segment of these channels.
    pub(super) fn of_channels(channels: &[Encoded], frames: usize) -> Self {
        let mut writer = BitWriter::default();
        for frame in 0..frames {
            for channel in channels {
                writer.bits(channel.residuals[frame], channel.piece.bits.into());
            }
        }
        Self {
            pieces: channels
                .iter()
                .map(|channel| channel.piece.clone())
                .collect(),
            residuals: writer.into_bytes(),
        }
    }

    /// How many bits the residuals of a frame take.
    pub(super) fn frame_bits(&self) -> usize {
        self.pieces
            .iter()
            .map(|piece| usize::from(piece.bits))
            .sum()
    }

    pub(super) fn to_bytes(&self, codes: &[Codes]) -> Vec<u8> {
        let mut writer = BitWriter::default();
        for (piece, codes) in self.pieces.iter().zip(codes) {
            codes.write_piece(piece, &mut writer);
        }
        let mut bytes = writer.into_bytes();
        bytes.extend_from_slice(&self.residuals);
        bytes
    }

    /// `None` unless the bytes are such a segment. `limits` has the greatest value that each
    /// channel may have.
    pub(super) fn from_bytes(
        bytes: &[u8],
        codes: &[Codes],
        limits: &[f64],
        basis: &Basis,
    ) -> Option<Self> {
        let mut reader = BitReader::new(bytes);
        let pieces: Option<Vec<Piece>> = codes
            .iter()
            .zip(limits)
            .map(|(codes, &limit)| {
                let piece = codes.read_piece(&mut reader)?;
                is_sound(&piece, basis, limit).then_some(piece)
            })
            .collect();
        let segment = Self {
            pieces: pieces?,
            residuals: reader.rest().to_vec(),
        };
        let expected = (segment.frame_bits() * basis.frames).div_ceil(8);
        (segment.residuals.len() == expected).then_some(segment)
    }
}

/// Whether a piece is one that the encoder can make and its values stay within a limit.
fn is_sound(piece: &Piece, basis: &Basis, limit: f64) -> bool {
    let coefficients = piece.coefficients.iter().map(|&n| f64::from(n).abs());
    let is_written = usize::from(piece.terms) <= basis.terms()
        && piece.bits <= MOST_BITS
        && (LEAST_RANGE..=MOST_RANGE).contains(&piece.range)
        && coefficients.clone().all(|n| n <= MOST_COEFFICIENT);
    is_written && piece.quantum() * coefficients.sum::<f64>() + range(piece.range) <= limit
}

/// The number of frames of each segment, and how many segments there are.
pub(super) fn segment_count(frames: usize) -> usize {
    frames.div_ceil(SEGMENT)
}

/// How many frames a segment has.
pub(super) fn frames_of(segment: usize, frames: usize) -> usize {
    frames.saturating_sub(segment * SEGMENT).min(SEGMENT)
}
