//! Columns in, columns out, by blocks of lanes.

use ga_runtime::scalar::{Lanes, Mask, Real};

/// How many points are computed side by side.
pub(super) const WIDTH: usize = 4;

/// The numbers of as many points.
pub(super) type Block = Lanes<f64, WIDTH>;

/// Whether each number of a block passed.
pub(super) type Passed = <Block as Real>::Mask;

/// What is computed for each block. It is a trait, since closures cannot be `#[inline(always)]`,
/// which loops for several sets of instructions need ([`ga_runtime::batch::Work`]).
pub(super) trait Kernel<const N: usize, const M: usize> {
    /// The results of a block, and which of them passed.
    fn compute(&self, inputs: [Block; N]) -> ([Block; M], Passed);
}

/// Computes M columns from N columns of the same length. The last block is filled up with copies of
/// the last element. Whether all results passed.
#[inline(always)]
pub(super) fn by_blocks<const N: usize, const M: usize>(
    inputs: [&[f64]; N],
    outputs: [&mut [f64]; M],
    kernel: &impl Kernel<N, M>,
) -> bool {
    let count = inputs.iter().map(|column| column.len()).min().unwrap_or(0);
    let blocks = count / WIDTH;
    let whole = inputs.map(|column| &column.as_chunks::<WIDTH>().0[..blocks]);
    let rest = inputs.map(|column| &column[blocks * WIDTH..count]);
    let filled = rest.map(|column| {
        let last = column.last().copied().unwrap_or(0.0);
        std::array::from_fn(|lane| column.get(lane).copied().unwrap_or(last))
    });
    let mut outputs = outputs.map(|column| column[..count].as_chunks_mut::<WIDTH>());

    let mut passed = Passed::splat(true);
    for index in 0..count.div_ceil(WIDTH) {
        // Closures given to `array::map` and `array::from_fn` are not always inlined.
        let mut block = [Block::splat(0.0); N];
        for column in 0..N {
            let numbers = whole[column].get(index).unwrap_or(&filled[column]);
            block[column] = Lanes::from_array(*numbers);
        }
        let (results, pass) = kernel.compute(block);
        passed = passed & pass;
        for (column, result) in outputs.iter_mut().zip(results) {
            if let Some(block) = column.0.get_mut(index) {
                *block = result.to_array();
            } else {
                let length = column.1.len();
                column.1.copy_from_slice(&result.as_array()[..length]);
            }
        }
    }
    passed.all()
}
