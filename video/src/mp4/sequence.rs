//! What all pictures of a video in H.264 share: the configuration in the file (ISO/IEC 14496-15,
//! 5.3.3.1) and the sequence parameter set (ITU-T H.264, 7.3.2.1.1 and E.1.1).

use ga_image::grey::Luma;
use ga_image::ycbcr::{Range, YCbCr};

/// The contents of the box `avcC`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Configuration {
    /// Bytes of the lengths before units.
    pub(super) length_bytes: usize,
    /// Sequence parameter sets, then picture parameter sets.
    pub(super) sets: Vec<Vec<u8>>,
}

impl Configuration {
    /// `None` where the bytes end within a set.
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        // Version, profile in three bytes; then 6 and 3 bits that are set.
        let [_, _, _, _, length, sequences, rest @ ..] = bytes else {
            return None;
        };
        let (mut rest, mut sets) = (rest, Vec::new());
        read_sets(&mut rest, sequences & 31, &mut sets)?;
        let (pictures, mut rest) = rest.split_first()?;
        read_sets(&mut rest, *pictures, &mut sets)?;
        Some(Self {
            length_bytes: usize::from(length & 3) + 1,
            sets,
        })
    }
}

fn read_sets(rest: &mut &[u8], count: u8, sets: &mut Vec<Vec<u8>>) -> Option<()> {
    for _ in 0..count {
        let (length, others) = rest.split_first_chunk::<2>()?;
        let length = usize::from(u16::from_be_bytes(*length));
        let (set, others) = others.split_at_checked(length)?;
        sets.push(set.to_vec());
        *rest = others;
    }
    Some(())
}

/// What a sequence parameter set says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Sequence {
    /// Columns and rows, after cropping.
    pub(super) size: [usize; 2],
    /// 0: grey, 1: 4:2:0, 2: 4:2:2, 3: 4:4:4.
    pub(super) chroma: u32,
    pub(super) bit_depth: u32,
    pub(super) is_interlaced: bool,
    pub(super) colours: YCbCr,
}

/// Profiles whose parameter sets say how colours are sampled.
const WITH_CHROMA: [u32; 13] = [100, 110, 122, 244, 44, 83, 86, 118, 128, 138, 139, 134, 135];

impl Sequence {
    /// Reads a unit with its header of one byte; `None` where it ends early or is wrong.
    pub(super) fn read(unit: &[u8]) -> Option<Self> {
        let mut bits = Bits::new(unit.get(1..)?);
        let profile = bits.take(8)?;
        bits.take(16)?;
        bits.unsigned()?;
        let (mut chroma, mut bit_depth) = (1, 8);
        if WITH_CHROMA.contains(&profile) {
            chroma = bits.unsigned()?;
            if chroma == 3 {
                bits.take(1)?;
            }
            // More than 14 bits are not allowed, and a wrong number must not overflow.
            bit_depth = 8 + bits.unsigned()?.max(bits.unsigned()?).min(8);
            bits.take(1)?;
            if bits.take(1)? == 1 {
                bits.skip_scaling(if chroma == 3 { 12 } else { 8 })?;
            }
        }
        bits.unsigned()?;
        match bits.unsigned()? {
            0 => {
                bits.unsigned()?;
            }
            1 => {
                bits.take(1)?;
                bits.signed()?;
                bits.signed()?;
                for _ in 0..bits.unsigned()?.min(255) {
                    bits.signed()?;
                }
            }
            _ => {}
        }
        bits.unsigned()?;
        bits.take(1)?;
        let mut blocks = [bits.unsigned()?, bits.unsigned()?].map(|n| u64::from(n) + 1);
        let is_interlaced = bits.take(1)? == 0;
        if is_interlaced {
            bits.take(1)?;
            blocks[1] *= 2;
        }
        bits.take(1)?;
        let mut cropped = [0; 4];
        if bits.take(1)? == 1 {
            for side in &mut cropped {
                *side = u64::from(bits.unsigned()?);
            }
        }
        let [left, right, top, bottom] = cropped;
        let unit = [
            if matches!(chroma, 1 | 2) { 2 } else { 1 },
            (1 + u64::from(chroma == 1)) * (1 + u64::from(is_interlaced)),
        ];
        let width = (16 * blocks[0]).checked_sub(unit[0] * (left + right))?;
        let height = (16 * blocks[1]).checked_sub(unit[1] * (top + bottom))?;
        Some(Self {
            size: [usize::try_from(width).ok()?, usize::try_from(height).ok()?],
            chroma,
            bit_depth,
            is_interlaced,
            // What is after the size may be left out.
            colours: bits.colours().unwrap_or_default(),
        })
    }
}

/// Bits from the highest of each byte on.
struct Bits {
    bytes: Vec<u8>,
    at: usize,
}

impl Bits {
    /// Without the bytes 3 that keep two zeros from looking like the start of a unit.
    fn new(unit: &[u8]) -> Self {
        let mut bytes = Vec::with_capacity(unit.len());
        let mut zeros = 0;
        for &byte in unit {
            if zeros >= 2 && byte == 3 {
                zeros = 0;
                continue;
            }
            zeros = if byte == 0 { zeros + 1 } else { 0 };
            bytes.push(byte);
        }
        Self { bytes, at: 0 }
    }

    /// A number of `count` bits, at most 32.
    fn take(&mut self, count: usize) -> Option<u32> {
        let mut number = 0;
        for _ in 0..count {
            let byte = *self.bytes.get(self.at / 8)?;
            number = number << 1 | u32::from(byte >> (7 - self.at % 8) & 1);
            self.at += 1;
        }
        Some(number)
    }

    /// A number in the code ue(v).
    fn unsigned(&mut self) -> Option<u32> {
        let mut zeros = 0;
        while self.take(1)? == 0 {
            zeros += 1;
        }
        if zeros > 31 {
            return None;
        }
        Some((1 << zeros) - 1 + self.take(zeros)?)
    }

    /// A number in the code se(v).
    fn signed(&mut self) -> Option<i64> {
        let code = i64::from(self.unsigned()?);
        Some(if code % 2 == 0 {
            -code / 2
        } else {
            (code + 1) / 2
        })
    }

    fn skip_scaling(&mut self, lists: usize) -> Option<()> {
        for list in 0..lists {
            if self.take(1)? == 0 {
                continue;
            }
            let (mut last, mut next) = (8, 8);
            for _ in 0..if list < 6 { 16 } else { 64 } {
                if next != 0 {
                    next = (last + self.signed()?).rem_euclid(256);
                }
                if next != 0 {
                    last = next;
                }
            }
        }
        Some(())
    }

    /// Range and weights from the information on usability.
    fn colours(&mut self) -> Option<YCbCr> {
        let mut colours = YCbCr::default();
        if self.take(1)? == 0 {
            return None;
        }
        // 255: the shape of a pixel is written out.
        if self.take(1)? == 1 && self.take(8)? == 255 {
            self.take(32)?;
        }
        if self.take(1)? == 1 {
            self.take(1)?;
        }
        if self.take(1)? == 1 {
            self.take(3)?;
            if self.take(1)? == 1 {
                colours.range = Range::Full;
            }
            if self.take(1)? == 1 {
                self.take(16)?;
                if self.take(8)? == 1 {
                    colours.luma = Luma::Bt709;
                }
            }
        }
        Some(colours)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bytes of ones and zeros, after the header of a unit and the profile 100.
    fn unit(bits: &str) -> Vec<u8> {
        let bits: Vec<u8> = bits.bytes().map(|bit| bit - b'0').collect();
        let bytes = bits.chunks(8).map(|bits| {
            let places = bits.iter().enumerate();
            places.map(|(place, bit)| bit << (7 - place)).sum::<u8>()
        });
        [0x67, 100, 0, 31].into_iter().chain(bytes).collect()
    }

    /// The greatest number that the code has: 2³² − 2.
    #[test]
    fn no_number_overflows() {
        let greatest = format!("{}1{}", "0".repeat(31), "1".repeat(31));
        // The number of the set, 4:2:0, the depth of luma, and that of colour differences, no
        // transform bypass, no lists, 4 bits of a frame number, order of frames by type 2.
        let start = ["1", "010", &greatest, &greatest, "0", "0", "1", "011"].concat();
        let size = ["1", "0", &greatest, &greatest, "0", "0"].concat();
        for cropping in ["0".to_owned(), format!("1{}", greatest.repeat(4))] {
            let end = format!("{cropping}00000000");
            let found = Sequence::read(&unit(&[&start[..], &size, &end].concat()));
            if let Some(found) = found {
                assert!(found.bit_depth > 8 && found.size[0] > 1 << 32);
            } else {
                assert!(cropping.len() > 1);
            }
        }
    }
}
