//! Columns in, columns out, by blocks of lanes.

use ga_runtime::scalar::{Lanes, Mask, Real};

/// How many points are computed side by side.
pub(super) const WIDTH: usize = 4;

/// The numbers of as many points.
pub(super) type Block = Lanes<f64, WIDTH>;

/// Whether each number of a block passed.
pub(super) type Passed = <Block as Real>::Mask;

/// Computes M columns from N columns of the same length. The last block is filled up with copies of
/// the last element. Whether all results passed.
#[inline(always)]
pub(super) fn by_blocks<const N: usize, const M: usize>(
    inputs: [&[f64]; N],
    outputs: [&mut [f64]; M],
    compute: impl Fn([Block; N]) -> ([Block; M], Passed),
) -> bool {
    let count = inputs.iter().map(|column| column.len()).min().unwrap_or(0);
    let blocks = count / WIDTH;
    let whole = inputs.map(|column| &column.as_chunks::<WIDTH>().0[..blocks]);
    let rest = inputs.map(|column| &column[blocks * WIDTH..count]);
    let mut outputs = outputs.map(|column| column[..count].as_chunks_mut::<WIDTH>());

    let mut passed = Passed::splat(true);
    for index in 0..blocks {
        let (results, pass) = compute(whole.map(|column| Lanes::from_array(column[index])));
        passed = passed & pass;
        for (column, result) in outputs.iter_mut().zip(results) {
            column.0[index] = result.to_array();
        }
    }
    if rest.first().is_some_and(|column| !column.is_empty()) {
        let filled = rest.map(|column| {
            let last = column.len() - 1;
            Lanes::from_array(std::array::from_fn(|lane| column[lane.min(last)]))
        });
        let (results, pass) = compute(filled);
        passed = passed & pass;
        for (column, result) in outputs.iter_mut().zip(results) {
            let length = column.1.len();
            column.1.copy_from_slice(&result.as_array()[..length]);
        }
    }
    passed.all()
}
