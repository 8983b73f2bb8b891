//! Corrections that do not flicker.

use std::ops::Range;

use ga_numerics::order_statistics::median;

/// Frames on either side of a place at which a step may be, by whose medians it is seen; at least
/// the second number.
const BESIDE: [usize; 2] = [5, 3];

/// A step is at least these multiples of the noise and of what is tolerated.
const OVER_NOISE: f64 = 5.0;
const OVER_TOLERANCE: f64 = 2.0;

/// The least part of a step that is made from one frame to the next.
const ABRUPT: f64 = 0.5;

/// Where numbers change slowly, the median and the mean are taken over this number of frames on
/// either side.
const AROUND: usize = 12;

/// Steady numbers for frames that are measured with noise, or not at all.
///
/// Frames are divided where `begins` says so and where the numbers make a step that lasts. In each
/// part the numbers are their medians, the same for all frames, as long as moving medians and means
/// over a second differ from these by no more than `tolerance`; else they are those moving
/// means. A part without measured frames has the last numbers of the part before it, or the first
/// ones of that after it, and zeros where no frame is measured.
pub(super) fn steady<const N: usize>(
    measured: &[Option<[f64; N]>],
    begins: impl Fn(usize) -> bool,
    tolerance: f64,
) -> Vec<[f64; N]> {
    let mut found: Vec<Option<[f64; N]>> = Vec::with_capacity(measured.len());
    let mut start = 0;
    while start < measured.len() {
        let inside = (start + 1..measured.len()).take_while(|frame| !begins(*frame));
        let end = start + 1 + inside.count();
        let mut first = start;
        for step in steps(measured, start..end, tolerance)
            .into_iter()
            .chain([end])
        {
            found.extend(of_part(&measured[first..step], tolerance));
            first = step;
        }
        start = end;
    }
    let mut last = found.iter().flatten().next().copied().unwrap_or([0.0; N]);
    found
        .into_iter()
        .map(|numbers| {
            last = numbers.unwrap_or(last);
            last
        })
        .collect()
}

/// The frames of a range at which the numbers make a step, in order.
fn steps<const N: usize>(
    measured: &[Option<[f64; N]>],
    range: Range<usize>,
    tolerance: f64,
) -> Vec<usize> {
    let [most, least] = BESIDE;
    let known: Vec<(usize, [f64; N])> = range
        .filter_map(|frame| Some((frame, measured[frame]?)))
        .collect();
    let limits: [f64; N] = std::array::from_fn(|axis| {
        let change = |pair: &[(usize, [f64; N])]| (pair[1].1[axis] - pair[0].1[axis]).abs();
        // The median of absolute differences of two normal errors is 0.954 standard deviations.
        let changes = median(&mut known.windows(2).map(change).collect::<Vec<_>>());
        let noise = changes.unwrap_or(0.0) / 0.954;
        (OVER_TOLERANCE * tolerance).max(OVER_NOISE * noise)
    });
    let mut candidates = Vec::new();
    for index in least..(known.len() + 1).saturating_sub(least) {
        let before = &known[index.saturating_sub(most)..index];
        let after = &known[index..(index + most).min(known.len())];
        let size = |axis: usize| {
            let middle = |part: &[(usize, [f64; N])]| {
                let mut values: Vec<f64> = part.iter().map(|(_, numbers)| numbers[axis]).collect();
                median(&mut values).unwrap_or(f64::NAN)
            };
            let step = (middle(after) - middle(before)).abs();
            let at_once = (known[index].1[axis] - known[index - 1].1[axis]).abs();
            match at_once >= ABRUPT * step {
                true => step / limits[axis],
                false => 0.0,
            }
        };
        let greatest = (0..N).map(size).fold(0.0, f64::max);
        if greatest > 1.0 {
            candidates.push((index, greatest));
        }
    }
    // The greatest first; none in the neighbourhood of another.
    candidates.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut chosen: Vec<usize> = Vec::new();
    for (index, _) in candidates {
        if chosen.iter().all(|other| index.abs_diff(*other) >= least) {
            chosen.push(index);
        }
    }
    chosen.sort_unstable();
    chosen.into_iter().map(|index| known[index].0).collect()
}

/// The numbers of a part without steps.
fn of_part<const N: usize>(measured: &[Option<[f64; N]>], tolerance: f64) -> Vec<Option<[f64; N]>> {
    let count = measured.len();
    if measured.iter().all(Option::is_none) {
        return vec![None; count];
    }
    let around = |frame: usize| frame.saturating_sub(AROUND)..(frame + AROUND + 1).min(count);
    let mut result = vec![[0.0; N]; count];
    for axis in 0..N {
        let values = |range: Range<usize>| -> Vec<f64> {
            let known = measured[range].iter().flatten();
            known.map(|numbers| numbers[axis]).collect()
        };
        let middle = |range| median(&mut values(range)).unwrap_or(f64::NAN);
        let usual = middle(0..count);
        let mut medians: Vec<f64> = (0..count).map(|frame| middle(around(frame))).collect();
        fill(&mut medians);
        let means = (0..count).map(|frame| {
            let near = &medians[around(frame)];
            near.iter().sum::<f64>() / near.len() as f64
        });
        let means: Vec<f64> = means.collect();
        let is_constant = means.iter().all(|mean| (mean - usual).abs() <= tolerance);
        for (numbers, mean) in result.iter_mut().zip(means) {
            numbers[axis] = if is_constant { usual } else { mean };
        }
    }
    result.into_iter().map(Some).collect()
}

/// Replaces what is not a number by numbers between the nearest that are, at least one.
fn fill(values: &mut [f64]) {
    let known: Vec<usize> = (0..values.len()).filter(|i| !values[*i].is_nan()).collect();
    for index in 0..values.len() {
        let next = known.partition_point(|place| *place < index);
        let (after, before) = (known.get(next), next.checked_sub(1).map(|i| known[i]));
        values[index] = match (before, after) {
            (Some(a), Some(&b)) if b > index => {
                let part = (index - a) as f64 / (b - a) as f64;
                values[a] + part * (values[b] - values[a])
            }
            (_, Some(&b)) => values[b],
            (Some(a), None) => values[a],
            (None, None) => 0.0,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::steady;

    /// Numbers with a mean of 0 and a standard deviation of about 1.
    fn noise(index: usize) -> f64 {
        let mixed = (index as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        (0..4)
            .map(|k| ((mixed >> (16 * k)) & 0xffff) as f64 / 65_535.0 - 0.5)
            .sum::<f64>()
            * 1.7
    }

    fn of(count: usize, value: impl Fn(usize) -> f64) -> Vec<Option<[f64; 1]>> {
        (0..count).map(|index| Some([value(index)])).collect()
    }

    #[test]
    fn noise_is_not_followed() {
        let found = steady(&of(200, |i| 3.0 + 0.3 * noise(i)), |_| false, 0.3);
        assert!(found.iter().all(|value| *value == found[0]));
        assert!((found[0][0] - 3.0).abs() < 0.08, "{:?}", found[0]);
    }

    #[test]
    fn steps_are_followed_at_once_and_outliers_are_not() {
        let truth = |i: usize| {
            if (40..46).contains(&i) || i >= 90 {
                5.0
            } else {
                1.0
            }
        };
        let is_outlier = |i: usize| i == 20 || i == 70;
        let measured = of(120, |i| {
            truth(i) + 0.1 * noise(i) + if is_outlier(i) { 9.0 } else { 0.0 }
        });
        let found = steady(&measured, |_| false, 0.3);
        for (index, value) in found.iter().enumerate() {
            assert!((value[0] - truth(index)).abs() < 0.12, "{index}: {value:?}");
        }
    }

    #[test]
    fn slow_changes_are_followed_without_steps() {
        let truth = |i: usize| 0.02 * i as f64;
        let found = steady(&of(300, |i| truth(i) + 0.2 * noise(i)), |_| false, 0.3);
        for (index, pair) in found.windows(2).enumerate() {
            assert!((pair[1][0] - pair[0][0]).abs() < 0.05, "{index}: {pair:?}");
        }
        for (index, value) in found.iter().enumerate() {
            assert!((value[0] - truth(index)).abs() < 0.35, "{index}: {value:?}");
        }
    }

    #[test]
    fn what_is_not_measured_is_as_beside_it() {
        let mut measured = of(60, |i| if i < 30 { 1.0 } else { 4.0 });
        for index in (0..5).chain(10..25).chain(30..34).chain(50..60) {
            measured[index] = None;
        }
        let found = steady(&measured, |i| [30, 50].contains(&i), 0.3);
        let expected = (0..60).map(|i| if i < 30 { [1.0] } else { [4.0] });
        assert!(found.iter().copied().eq(expected), "{found:?}");
        assert_eq!(steady::<2>(&[None; 3], |_| false, 0.3), [[0.0; 2]; 3]);
        assert!(steady::<1>(&[], |_| false, 0.3).is_empty());
    }
}
