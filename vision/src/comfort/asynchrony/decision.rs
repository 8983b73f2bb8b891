//! The delay that a window of frames shows, if it shows one.

use std::collections::VecDeque;

use super::super::jackknife::standard_error;
use super::products::{BLOCKS, CELLS, Products};
use super::{Asynchrony, Delay, LAGS, REACH};

/// The least part of the changes of the right eye that the left one must explain.
const LEAST_EXPLAINED: f64 = 0.3;

/// By how much, and by which factor, less must remain unexplained at the best delay than at delays
/// of two frames more or less and beyond.
const MARGIN: f64 = 0.1;
const FACTOR: f64 = 1.3;

/// The greatest standard error of a delay.
const LEAST_CERTAINTY_FRAMES: f64 = 0.12;

/// The least number of frames with motion, as the reciprocal of the sum of squares of the parts
/// that frames have in the energy of all changes.
const LEAST_MOVING: f64 = 6.0;

/// The least parts of a window of which each is left out once.
const LEAST_PARTS: usize = 3;

/// The frames of a part.
const PART: usize = 6;

/// The least size of the changes: about a tenth of that of a frame with clear motion, on average.
const LEAST_ENERGY: f64 = 0.02;

/// The products of one frame of the right eye with the frames of the left one at all delays.
pub(super) type Row = [Option<Products>; LAGS];

/// What the products of the frames of a window say; `first` is the number of the first frame.
pub(super) fn decide<'a>(rows: impl Iterator<Item = (usize, &'a Row)> + Clone) -> Asynchrony {
    let mut parts: VecDeque<(usize, Vec<(Products, usize)>)> = VecDeque::new();
    let (mut energies, mut count) = (Vec::new(), 0_usize);
    for (frame, row) in rows {
        let number = frame / PART;
        if parts.back().is_none_or(|part| part.0 != number) {
            parts.push_back((number, vec![Default::default(); LAGS]));
        }
        let Some((_, sums)) = parts.back_mut() else {
            continue;
        };
        for (sum, products) in sums.iter_mut().zip(row) {
            if let Some(products) = products {
                sum.0.add(products, 1.0);
                sum.1 += 1;
            }
        }
        let energy = row[REACH].as_ref().map_or(0.0, Products::energy);
        energies.push(f64::from(energy));
        count += 1;
    }
    let total: f64 = energies.iter().sum();
    let squares: f64 = energies.iter().map(|energy| energy * energy).sum();
    if total < LEAST_ENERGY * CELLS as f64 * count as f64 || total * total < LEAST_MOVING * squares
    {
        return Asynchrony::NoMotion;
    }
    let parts: Vec<_> = parts.into_iter().map(|part| part.1).collect();
    combined(&parts, count)
}

fn combined(parts: &[Vec<(Products, usize)>], count: usize) -> Asynchrony {
    let mut sums: Vec<(Products, usize)> = vec![Default::default(); LAGS];
    for part in parts {
        for (sum, other) in sums.iter_mut().zip(part) {
            sum.0.add(&other.0, 1.0);
            sum.1 += other.1;
        }
    }
    let explained = |sums: &[(Products, usize)]| -> Vec<[[f32; 2]; BLOCKS]> {
        sums.iter().map(|sum| sum.0.explained()).collect()
    };
    let all = explained(&sums);
    // Delays at which less than half of the window has a frame of the left eye do not count.
    let usable: Vec<bool> = sums.iter().map(|sum| 2 * sum.1 > count).collect();
    let curve = unexplained(&all, &usable, None);
    let Some(peak) = Peak::of(&curve) else {
        return Asynchrony::Unrelated;
    };
    if 1.0 - peak.least < LEAST_EXPLAINED {
        return Asynchrony::Unrelated;
    }
    if !peak.is_distinct(&curve) || parts.len() < LEAST_PARTS {
        return Asynchrony::Ambiguous;
    }
    // The jackknife: the delay without one part of the window, and without one block.
    let without_part = parts.iter().map(|part| {
        let mut rest = sums.clone();
        for (sum, other) in rest.iter_mut().zip(part) {
            sum.0.add(&other.0, -1.0);
        }
        unexplained(&explained(&rest), &usable, None)
    });
    let without_block = (0..BLOCKS).map(|block| unexplained(&all, &usable, Some(block)));
    let frames = |curves: Vec<Vec<Option<f64>>>| -> Option<Vec<f64>> {
        let peak =
            |curve: &Vec<Option<f64>>| Peak::of(curve).filter(|peak| peak.is_distinct(curve));
        curves
            .iter()
            .map(|curve| Some(peak(curve)?.frames))
            .collect()
    };
    let frames = (
        frames(without_part.collect()),
        frames(without_block.collect()),
    );
    let (Some(without_part), Some(without_block)) = frames else {
        return Asynchrony::Ambiguous;
    };
    let uncertainty_frames = standard_error(&without_part).max(standard_error(&without_block));
    if uncertainty_frames > LEAST_CERTAINTY_FRAMES {
        return Asynchrony::Ambiguous;
    }
    Asynchrony::Measured(Delay {
        frames: peak.frames,
        uncertainty_frames,
    })
}

/// The part of the changes that the left eye leaves unexplained, at each delay where it is known.
fn unexplained(
    all: &[[[f32; 2]; BLOCKS]],
    usable: &[bool],
    without: Option<usize>,
) -> Vec<Option<f64>> {
    let part = |(blocks, usable): (&[[f32; 2]; BLOCKS], &bool)| {
        let (mut size, mut explained) = (0.0, 0.0);
        for (block, [right, part]) in blocks.iter().enumerate() {
            if Some(block) != without {
                size += f64::from(*right);
                explained += f64::from(*part);
            }
        }
        (*usable && size > 0.0).then(|| 1.0 - explained / size)
    };
    all.iter().zip(usable).map(part).collect()
}

/// The delay at which least remains unexplained.
struct Peak {
    index: usize,
    least: f64,
    frames: f64,
}

impl Peak {
    /// Between whole frames by the parabola through three values. What remains unexplained at its
    /// lowest point cannot be negative, which bounds the fraction where the best value is near 0.
    fn of(curve: &[Option<f64>]) -> Option<Self> {
        let known = (0..curve.len()).filter_map(|index| Some((index, curve[index]?)));
        let (index, least) = known.reduce(|a, b| if b.1 < a.1 { b } else { a })?;
        let beside = |index: Option<usize>| curve.get(index?).copied().flatten();
        let before = beside(index.checked_sub(1))?;
        let after = beside(Some(index + 1))?;
        let bend = 0.5 * (before + after) - least;
        let fraction = match bend > 1e-9 {
            true => {
                let bound = (least.max(0.0) / bend).sqrt();
                (0.25 * (before - after) / bend).clamp(-bound, bound)
            }
            false => 0.0,
        };
        Some(Self {
            index,
            least,
            frames: index as f64 - REACH as f64 + fraction,
        })
    }

    /// Whether clearly more remains unexplained beyond one frame more or less, and on one side
    /// already there: the delay itself may lie between two frames.
    fn is_distinct(&self, curve: &[Option<f64>]) -> bool {
        let least = FACTOR * self.least + MARGIN;
        let is_greater = |index: usize| curve[index].is_none_or(|value| value >= least);
        (0..curve.len()).all(|index| index.abs_diff(self.index) < 2 || is_greater(index))
            && (is_greater(self.index - 1) || is_greater(self.index + 1))
    }
}
