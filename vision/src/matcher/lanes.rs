//! Blocks of numbers as wide as a vector register. Loops over their lanes, compiled for a set of
//! instructions by [`Batch::run`](ga_runtime::batch::Batch::run), become single instructions; loops
//! over bytes and over 16-bit numbers are kept apart, since a mixture needs conversions throughout.

/// The bytes of a block.
pub(super) const LANES: usize = 32;

/// A block of bytes.
pub(super) type Block = [u8; LANES];

/// The smallest byte of a block.
#[inline(always)]
pub(super) fn least(block: Block) -> u8 {
    let mut half = [0; LANES / 2];
    for lane in 0..LANES / 2 {
        half[lane] = block[lane].min(block[lane + LANES / 2]);
    }
    let mut width = 8;
    while width > 0 {
        for lane in 0..width {
            half[lane] = half[lane].min(half[lane + width]);
        }
        width /= 2;
    }
    half[0]
}

/// The smallest number of a block.
#[inline(always)]
pub(super) fn least_of_words(block: [u16; LANES]) -> u16 {
    let mut half = [0; LANES / 2];
    for lane in 0..LANES / 2 {
        half[lane] = block[lane].min(block[lane + LANES / 2]);
    }
    let mut width = 8;
    while width > 0 {
        for lane in 0..width {
            half[lane] = half[lane].min(half[lane + width]);
        }
        width /= 2;
    }
    half[0]
}
