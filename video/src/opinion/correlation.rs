//! How strongly two rows of numbers depend on each other.
//!
//! Each function takes two rows of the same length, with finite numbers; where the lengths differ,
//! the longer row counts as far as the shorter one goes. The result lies between −1 and 1. It is
//! `None` where there are fewer than two pairs, or where all numbers of a row are equal.

/// The linear correlation coefficient of K. Pearson (PLCC),
/// `Σ (x − x̄)(y − ȳ) / √(Σ (x − x̄)² Σ (y − ȳ)²)`.
///
/// ```
/// use ga_video::opinion::correlation::pearson;
///
/// assert_eq!(pearson(&[1.0, 2.0, 3.0], &[5.0, 7.0, 9.0]), Some(1.0));
/// assert_eq!(pearson(&[1.0, 1.0, 1.0], &[5.0, 7.0, 9.0]), None);
/// ```
#[must_use]
pub fn pearson(first: &[f64], second: &[f64]) -> Option<f64> {
    let count = first.len().min(second.len());
    let (first, second) = (centred(&first[..count])?, centred(&second[..count])?);
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let squares = sum(&first, &first) * sum(&second, &second);
    Some((sum(&first, &second) / squares.sqrt()).clamp(-1.0, 1.0))
}

/// The rank correlation coefficient of C. Spearman (SROCC): [`pearson`] of the [`ranks`].
///
/// ```
/// use ga_video::opinion::correlation::spearman;
///
/// assert_eq!(spearman(&[1.0, 10.0, 100.0], &[-5.0, 0.0, 0.1]), Some(1.0));
/// assert_eq!(spearman(&[1.0, 2.0, 3.0], &[3.0, 2.0, 1.0]), Some(-1.0));
/// ```
#[must_use]
pub fn spearman(first: &[f64], second: &[f64]) -> Option<f64> {
    let count = first.len().min(second.len());
    pearson(&ranks(&first[..count]), &ranks(&second[..count]))
}

/// The rank correlation coefficient of M. Kendall (KROCC) with his correction for ties, τ_b:
/// `(C − D) / √((P − T₁)(P − T₂))` with the numbers C of pairs in the same order in both rows, D in
/// opposite order, P of all pairs, T₁ and T₂ of pairs that are equal in the first and second row.
///
/// It takes `n log n` steps (W. R. Knight, "A computer method for calculating Kendall's tau with
/// ungrouped data", 1966).
///
/// ```
/// use ga_video::opinion::correlation::kendall;
///
/// // Of the three pairs, two have the same order.
/// assert_eq!(kendall(&[1.0, 2.0, 3.0], &[1.0, 3.0, 2.0]), Some(1.0 / 3.0));
/// ```
#[must_use]
pub fn kendall(first: &[f64], second: &[f64]) -> Option<f64> {
    let mut pairs: Vec<[f64; 2]> = first.iter().zip(second).map(|(a, b)| [*a, *b]).collect();
    pairs.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let all = pairs_of(pairs.len());
    let tied_in_first = tied(&pairs, |a, b| a[0] == b[0]);
    let tied_in_both = tied(&pairs, |a, b| a == b);
    let mut values: Vec<f64> = pairs.iter().map(|pair| pair[1]).collect();
    let mut buffer = values.clone();
    let exchanged = inversions(&mut values, &mut buffer);
    let tied_in_second = tied(&values, |a, b| a == b);
    let (first, second) = (all - tied_in_first, all - tied_in_second);
    if first == 0 || second == 0 {
        return None;
    }
    // Of the pairs that are equal in neither row, those that are not exchanged have the same order.
    let in_order = all + tied_in_both - tied_in_first - tied_in_second - exchanged;
    let difference = in_order as f64 - exchanged as f64;
    Some((difference / (first as f64 * second as f64).sqrt()).clamp(-1.0, 1.0))
}

/// The rank of each number among all, from 1 for the least; equal numbers share the mean of their
/// ranks.
///
/// ```
/// use ga_video::opinion::correlation::ranks;
///
/// assert_eq!(ranks(&[7.0, 3.0, 7.0, 9.0]), [2.5, 1.0, 2.5, 4.0]);
/// ```
#[must_use]
pub fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut below = 0;
    for equal in order.chunk_by(|a, b| values[*a] == values[*b]) {
        let rank = below as f64 + (equal.len() + 1) as f64 / 2.0;
        equal.iter().for_each(|place| ranks[*place] = rank);
        below += equal.len();
    }
    ranks
}

/// The numbers without their mean; `None` where there are fewer than two, or where they are equal.
fn centred(values: &[f64]) -> Option<Vec<f64>> {
    let different = values.windows(2).any(|pair| pair[0] != pair[1]);
    different.then(|| {
        // Scaled by a power of two, so that neither sums nor squares overflow or vanish.
        let greatest = values.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let greatest = greatest.log2().floor().min(1023.0).exp2();
        let mean = values.iter().map(|v| v / greatest).sum::<f64>() / values.len() as f64;
        values.iter().map(|v| v / greatest - mean).collect()
    })
}

/// The number of pairs of `count` things.
fn pairs_of(count: usize) -> usize {
    count * count.saturating_sub(1) / 2
}

/// How many pairs of neighbours in a sorted row are equal.
fn tied<T>(sorted: &[T], equal: impl Fn(&T, &T) -> bool) -> usize {
    sorted
        .chunk_by(equal)
        .map(|chunk| pairs_of(chunk.len()))
        .sum()
}

/// Sorts numbers by merging, and says how many pairs were in the wrong order.
fn inversions(values: &mut [f64], buffer: &mut [f64]) -> usize {
    let middle = values.len() / 2;
    if middle == 0 {
        return 0;
    }
    let (left, right) = values.split_at_mut(middle);
    let mut count = inversions(left, &mut buffer[..middle]);
    count += inversions(right, &mut buffer[middle..]);
    let (mut i, mut j) = (0, 0);
    for place in &mut *buffer {
        let from_right = i == left.len() || (j < right.len() && right[j] < left[i]);
        if from_right {
            *place = right[j];
            j += 1;
            count += left.len() - i;
        } else {
            *place = left[i];
            i += 1;
        }
    }
    values.copy_from_slice(buffer);
    count
}
