//! One channel in one segment: a trend and what remains.

use super::basis::{Basis, SEGMENT, TERMS};

/// The greatest number of bits of a residual.
pub(super) const MOST_BITS: u8 = 24;

/// The quantum of the trend's coefficients is the range of the residual over this.
const FINENESS: f64 = 16.0;

/// A channel in a segment,
///
/// ```text
/// v(i) = S/16 Σ n_k B_k(i) + S (r(i) + ½ − 2^(b−1)) / 2^b,   S = 2^(e/8),
/// ```
///
/// with integers n_k for the trend and, where b > 0, a residual r(i) of b bits for each frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Piece {
    /// How many coefficients the trend has.
    pub(super) terms: u8,
    /// b.
    pub(super) bits: u8,
    /// e.
    pub(super) range: i16,
    /// n_k.
    pub(super) coefficients: [i32; TERMS],
}

/// 2^(e/8).
pub(super) fn range(exponent: i16) -> f64 {
    // The eight roots as products of square roots, which every machine rounds alike.
    let half = 2f64.sqrt();
    let quarter = half.sqrt();
    let eighth = quarter.sqrt();
    let part = exponent.rem_euclid(8);
    let mut value = if part & 4 != 0 { half } else { 1.0 };
    if part & 2 != 0 {
        value *= quarter;
    }
    if part & 1 != 0 {
        value *= eighth;
    }
    value * 2f64.powi(i32::from(exponent.div_euclid(8)))
}

/// The least exponent whose range is at least `value`.
pub(super) fn exponent_above(value: f64) -> i16 {
    let guess = (8.0 * value.log2()).ceil();
    guess.clamp(f64::from(LEAST_RANGE), f64::from(MOST_RANGE)) as i16
}

/// The exponents that a file may have: ranges from 2⁻⁶⁰ to 2⁶⁰.
pub(super) const LEAST_RANGE: i16 = -480;
pub(super) const MOST_RANGE: i16 = 480;

impl Piece {
    pub(super) fn quantum(&self) -> f64 {
        range(self.range) / FINENESS
    }

    pub(super) fn step(&self) -> f64 {
        match self.bits {
            0 => 0.0,
            bits => range(self.range) / f64::from(1u32 << bits),
        }
    }

    /// What is subtracted from a residual before it is multiplied by the step.
    pub(super) fn middle(&self) -> f64 {
        match self.bits {
            0 => 0.0,
            bits => f64::from(1u32 << (bits - 1)) - 0.5,
        }
    }

    /// About how many bits the trend takes in a file.
    pub(super) fn trend_bits(&self) -> u32 {
        let coefficients = &self.coefficients[..self.terms.into()];
        coefficients
            .iter()
            .map(|&n| 2 + bit_length(n.unsigned_abs()))
            .sum()
    }
}

fn bit_length(n: u32) -> u32 {
    u32::BITS - n.leading_zeros()
}

/// How a channel is to be encoded in a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Precision {
    /// With this number of bits of residual, at least 1.
    Bits(u8),
    /// Without residual, with at most this deviation from the trend where a trend allows it.
    Trend(f64),
}

/// Values with their piece, and what a decoder makes of it.
#[derive(Clone, Debug)]
pub(super) struct Encoded {
    pub(super) piece: Piece,
    pub(super) residuals: [u32; SEGMENT],
    pub(super) decoded: [f64; SEGMENT],
}

impl Default for Encoded {
    fn default() -> Self {
        Self {
            piece: Piece::default(),
            residuals: [0; SEGMENT],
            decoded: [0.0; SEGMENT],
        }
    }
}

/// The half-width of what remains of the values when the first terms of the trend are removed, by
/// the number of terms. The constant term, if there is one, is in the middle of the range.
fn remainders(
    basis: &Basis,
    values: &[f64; SEGMENT],
    coefficients: &[f64; TERMS],
) -> [f64; TERMS + 1] {
    let frames = basis.frames;
    let mut remains = *values;
    let mut widths = [0.0; TERMS + 1];
    widths[0] = remains[..frames]
        .iter()
        .fold(0.0f64, |most, x| most.max(x.abs()));
    for term in 0..TERMS {
        for (x, b) in remains.iter_mut().zip(&basis.values[term]) {
            *x -= coefficients[term] * b;
        }
        let (least, most) = extremes(&remains[..frames]);
        widths[term + 1] = (most - least) / 2.0;
    }
    widths
}

fn extremes(values: &[f64]) -> (f64, f64) {
    values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), &x| {
            (least.min(x), most.max(x))
        })
}

/// The fewest bits with which the residual is within `deviation`; 0 where the trend alone is.
pub(super) fn bits_for(basis: &Basis, values: &[f64; SEGMENT], deviation: f64) -> u8 {
    let coefficients = basis.project(values);
    let widths = remainders(basis, values, &coefficients);
    let width = widths[basis.terms()];
    let bits = (width / deviation).log2().ceil();
    // A width of 0 gives an infinite negative number of bits, and a NaN none.
    bits.max(0.0).min(f64::from(MOST_BITS)) as u8
}

/// Encodes the values of a segment; those beyond its frames are ignored.
pub(super) fn encode(basis: &Basis, values: &[f64; SEGMENT], precision: Precision) -> Encoded {
    let coefficients = basis.project(values);
    let widths = remainders(basis, values, &coefficients);
    let (terms, mut exponent, bits) = match precision {
        Precision::Bits(bits) => {
            let terms = cheapest(basis, &coefficients, &widths);
            (terms, exponent_above(2.0 * widths[terms]), bits)
        }
        Precision::Trend(deviation) => {
            let least = exponent_above(2.0 * deviation);
            let fits = widths.iter().position(|&width| width <= deviation * 0.9);
            match fits.filter(|&terms| terms <= basis.terms()) {
                Some(terms) => (terms, least, 0),
                None => {
                    let terms = basis.terms();
                    (terms, least.max(exponent_above(2.0 * widths[terms])), 0)
                }
            }
        }
    };
    loop {
        let piece = Piece {
            terms: terms as u8,
            bits,
            range: exponent,
            coefficients: [0; TERMS],
        };
        match quantise(basis, values, &coefficients, piece) {
            Some(encoded) => return encoded,
            None if exponent >= MOST_RANGE => return Encoded::default(),
            None => exponent += 1,
        }
    }
}

/// The number of terms with which trend and residual take the fewest bits, whatever the precision:
/// half the width of the residual saves a bit in every frame.
fn cheapest(basis: &Basis, coefficients: &[f64; TERMS], widths: &[f64; TERMS + 1]) -> usize {
    let cost = |terms: usize| {
        let width = widths[terms].max(1e-18);
        let trend: f64 = coefficients[..terms]
            .iter()
            .map(|a| 2.5 + (a.abs() * FINENESS / (2.0 * width) + 0.5).log2().max(0.0))
            .sum();
        trend + basis.frames as f64 * width.log2()
    };
    let mut best = (0, cost(0));
    for terms in 1..=basis.terms() {
        let cost = cost(terms);
        if cost < best.1 {
            best = (terms, cost);
        }
    }
    best.0
}

/// `None` where the quantised trend leaves more than the range, or a coefficient is too large.
fn quantise(
    basis: &Basis,
    values: &[f64; SEGMENT],
    coefficients: &[f64; TERMS],
    mut piece: Piece,
) -> Option<Encoded> {
    let (quantum, range, frames) = (piece.quantum(), range(piece.range), basis.frames);
    let mut remains = *values;
    for term in (0..piece.terms.into()).rev() {
        let coefficient = match term {
            0 => {
                let (least, most) = extremes(&remains[..frames]);
                (least + most) / 2.0
            }
            _ => coefficients[term],
        };
        let multiple = (coefficient / quantum).round();
        if multiple.abs() > MOST_COEFFICIENT {
            return None;
        }
        piece.coefficients[term] = multiple as i32;
        for (x, b) in remains.iter_mut().zip(&basis.values[term]) {
            *x -= multiple * quantum * b;
        }
    }
    let (least, most) = extremes(&remains[..frames]);
    if least.abs().max(most.abs()) > range / 2.0 && piece.bits > 0 {
        return None;
    }
    let (step, middle) = (piece.step(), piece.middle());
    let mut encoded = Encoded::default();
    for frame in 0..frames {
        let value = values[frame] - remains[frame];
        encoded.decoded[frame] = value;
        if piece.bits > 0 {
            let most = f64::from((1u32 << piece.bits) - 1);
            let residual = (remains[frame] / step + middle).round().clamp(0.0, most);
            encoded.residuals[frame] = residual as u32;
            encoded.decoded[frame] = value + (residual - middle) * step;
        }
    }
    encoded.piece = piece;
    Some(encoded)
}

/// Coefficients stay exact in single precision.
pub(super) const MOST_COEFFICIENT: f64 = 8_388_607.0;
