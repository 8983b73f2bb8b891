//! Columns in, columns out.

/// How many elements are computed before their results are copied to where they belong. The loop
/// over them reads and writes arrays of its own: their length is known and they do not overlap, so
/// that the compiler takes several elements at once.
const TILE: usize = 64;

/// What is computed for each element. It is a trait, since closures cannot be `#[inline(always)]`,
/// which loops for several sets of instructions need ([`ga_runtime::batch::Work`]).
pub(super) trait Kernel<const N: usize, const M: usize> {
    /// The results of an element, and whether they passed. For several elements at once it has no
    /// branches.
    fn compute(&self, inputs: [f64; N]) -> ([f64; M], bool);
}

/// Computes M columns from N columns of the same length. Whether all results passed.
#[inline(always)]
pub(super) fn by_blocks<const N: usize, const M: usize>(
    inputs: [&[f64]; N],
    outputs: [&mut [f64]; M],
    kernel: &impl Kernel<N, M>,
) -> bool {
    let count = inputs.iter().map(|column| column.len()).min().unwrap_or(0);
    let mut outputs = outputs;
    let mut elements = [[0.0; TILE]; N];
    let mut results = [[0.0; TILE]; M];
    let mut passes = [true; TILE];
    let mut passed = true;
    for start in (0..count).step_by(TILE) {
        let length = TILE.min(count - start);
        for (element, column) in elements.iter_mut().zip(inputs) {
            // The rest of the last tile is filled up with copies of the last element.
            element[..length].copy_from_slice(&column[start..start + length]);
            element[length..].fill(column[start + length - 1]);
        }
        for index in 0..TILE {
            let mut element = [0.0; N];
            for (number, numbers) in element.iter_mut().zip(&elements) {
                *number = numbers[index];
            }
            let (row, pass) = kernel.compute(element);
            // A sum over the loop would keep it from being done for several elements at once.
            passes[index] = pass;
            for (result, number) in results.iter_mut().zip(row) {
                result[index] = number;
            }
        }
        passed &= passes.iter().fold(true, |all, pass| all & pass);
        for (column, result) in outputs.iter_mut().zip(&results) {
            column[start..start + length].copy_from_slice(&result[..length]);
        }
    }
    passed
}
