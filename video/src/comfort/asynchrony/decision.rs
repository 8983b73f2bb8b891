//! The delay that a window of frames shows, if it shows one.

use std::collections::VecDeque;
use std::ops::{Range, RangeInclusive};

use super::super::jackknife::standard_error;
use super::delay::{Asynchrony, Delay};
use super::products::{BLOCKS, Explained, Products};
use ga_numerics::order_statistics::Sorted;

/// The greatest delay that is tried, in frames either way.
pub const REACH: usize = 12;

pub(super) const LAGS: usize = 2 * REACH + 1;

/// The least part of the changes of the right eye that the left one must explain.
const LEAST_EXPLAINED: f64 = 0.3;

/// By how much, and by which factor, less must remain unexplained at the best delay than at delays
/// of two frames more or less and beyond.
const MARGIN: f64 = 0.1;
const FACTOR: f64 = 1.3;

/// The mean motion from one frame to the next that is not told from parallax, in columns and rows
/// of the reduced picture.
const PAN: f32 = 0.5;

/// Where eyes in step explain most, this part must remain unexplained on average at delays that
/// differ by these numbers of frames.
const LEAST_BESIDE: f64 = 0.7;
const BESIDE: RangeInclusive<usize> = 2..=6;

/// The greatest standard error of a delay.
const GREATEST_ERROR_FRAMES: f64 = 0.12;

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

/// The frames over which a delay is measured.
pub(super) struct Window<'a, I> {
    /// Their numbers and products.
    pub(super) rows: I,
    /// The frames that may be compared with them.
    pub(super) part: Range<usize>,
    /// How much the eyes change at frames, from `first_energy` on.
    pub(super) energies: &'a VecDeque<[f32; 2]>,
    pub(super) first_energy: usize,
}

impl<'a, I: Iterator<Item = (usize, &'a Row)> + Clone> Window<'a, I> {
    /// How much an eye changes at a frame.
    fn energy(&self, frame: usize, eye: usize) -> Option<f32> {
        let index = frame.checked_sub(self.first_energy)?;
        self.energies.get(index).map(|energies| energies[eye])
    }

    /// The factors of the changes of an eye at a frame that bring those above the third quartile
    /// of the window down to it.
    fn factor(&self, eye: usize) -> impl Fn(usize) -> Option<f32> {
        let energies = self.rows.clone().map(|(frame, _)| self.energy(frame, eye));
        let mut sorted: Vec<f32> = energies.flatten().collect();
        let quartile = Sorted::new(&mut sorted).map_or(0.0, |sorted| sorted.quantile(0.75));
        move |frame| {
            let energy = self
                .energy(frame, eye)
                .filter(|_| self.part.contains(&frame))?;
            Some(match energy > quartile {
                true => (quartile / energy).sqrt(),
                false => 1.0,
            })
        }
    }
}

/// What the products of the frames of a window say.
pub(super) fn decide<'a>(
    window: &Window<'a, impl Iterator<Item = (usize, &'a Row)> + Clone>,
) -> Asynchrony {
    let mut parts: VecDeque<(usize, Vec<(Products, usize)>)> = VecDeque::new();
    let (mut energies, mut count) = (Vec::new(), 0_usize);
    let (of_left, of_right) = (window.factor(0), window.factor(1));
    for (frame, row) in window.rows.clone() {
        let number = frame / PART;
        if parts.back().is_none_or(|part| part.0 != number) {
            parts.push_back((number, vec![Default::default(); LAGS]));
        }
        let (Some((_, sums)), Some(right)) = (parts.back_mut(), of_right(frame)) else {
            continue;
        };
        for (lag, (sum, products)) in sums.iter_mut().zip(row).enumerate() {
            let left = (frame + REACH).checked_sub(lag).and_then(&of_left);
            if let (Some(products), Some(left)) = (products, left) {
                sum.0.add(products, [left, right]);
                sum.1 += 1;
            }
        }
        let energy = window.energy(frame, 1).unwrap_or(0.0);
        energies.push(f64::from(right * right * energy));
        count += 1;
    }
    let total: f64 = energies.iter().sum();
    let squares: f64 = energies.iter().map(|energy| energy * energy).sum();
    if total <= LEAST_ENERGY * count as f64 || total * total < LEAST_MOVING * squares {
        return Asynchrony::NoMotion;
    }
    let parts: Vec<_> = parts.into_iter().map(|part| part.1).collect();
    combined(&parts, count)
}

fn combined(parts: &[Vec<(Products, usize)>], count: usize) -> Asynchrony {
    let mut sums: Vec<(Products, usize)> = vec![Default::default(); LAGS];
    for part in parts {
        for (sum, other) in sums.iter_mut().zip(part) {
            sum.0.add(&other.0, [1.0; 2]);
            sum.1 += other.1;
        }
    }
    let all: Vec<_> = sums.iter().map(|sum| sum.0.explained()).collect();
    // Delays at which less than half of the window has a frame of the left eye do not count.
    let usable: Vec<bool> = sums.iter().map(|sum| 2 * sum.1 > count).collect();
    let curve = unexplained(&all, &usable, None);
    let Some(peak) = Peak::of(&curve) else {
        return Asynchrony::Unrelated;
    };
    if 1.0 - peak.least < LEAST_EXPLAINED {
        return Asynchrony::Unrelated;
    }
    if parts.len() < LEAST_PARTS
        || !peak.is_distinct(&curve)
        || peak.is_pan(&curve, &all)
        || peak.is_shared_noise(&curve)
    {
        return Asynchrony::Ambiguous;
    }
    // The jackknife: the delay without one part of the window, and without one block.
    let without_part = parts.iter().map(|part| {
        let rest = sums.iter().zip(part);
        let explained: Vec<_> = rest
            .map(|(sum, part)| sum.0.without(&part.0).explained())
            .collect();
        unexplained(&explained, &usable, None)
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
    if uncertainty_frames > GREATEST_ERROR_FRAMES {
        return Asynchrony::Ambiguous;
    }
    Asynchrony::Measured(Delay {
        frames: peak.frames,
        uncertainty_frames,
    })
}

/// The part of the changes that the left eye leaves unexplained, at each delay where it is known.
fn unexplained(
    all: &[[Explained; BLOCKS]],
    usable: &[bool],
    without: Option<usize>,
) -> Vec<Option<f64>> {
    let part = |(blocks, usable): (&[Explained; BLOCKS], &bool)| {
        let (mut size, mut explained) = (0.0, 0.0);
        for (block, found) in blocks.iter().enumerate() {
            if Some(block) != without {
                size += f64::from(found.right);
                explained += f64::from(found.part);
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
        (0..curve.len()).all(|index| index.abs_diff(self.index) < 2 || self.exceeds(curve, index))
            && (self.exceeds(curve, self.index - 1) || self.exceeds(curve, self.index + 1))
    }

    /// Whether another delay explains nearly as much, with pictures that lie elsewhere: the motion
    /// is constant, so that it looks like parallax or like a vertical error. Where a delay lies
    /// between two frames, both explain as much with pictures in about the same place.
    fn is_pan(&self, curve: &[Option<f64>], all: &[[Explained; BLOCKS]]) -> bool {
        let beside = [self.index - 1, self.index + 1];
        beside
            .into_iter()
            .filter(|index| !self.exceeds(curve, *index))
            .any(|index| {
                let (mut moved, mut total) = (0.0, 0.0);
                for (here, there) in all[self.index].iter().zip(&all[index]) {
                    let [x, y] =
                        [0, 1].map(|axis| here.translation[axis] - there.translation[axis]);
                    moved += here.right * x.hypot(y);
                    total += here.right;
                }
                moved > PAN * total
            })
    }

    /// Whether eyes in step may be an appearance: encoders that treat the frames of both eyes alike
    /// leave errors that coincide, however late one of them is. They stand out where the motion is
    /// nearly constant, so that other delays explain much as well.
    fn is_shared_noise(&self, curve: &[Option<f64>]) -> bool {
        let beside = (0..curve.len()).filter(|index| BESIDE.contains(&index.abs_diff(self.index)));
        let known: Vec<f64> = beside.filter_map(|index| curve[index]).collect();
        self.index == REACH && known.iter().sum::<f64>() < LEAST_BESIDE * known.len() as f64
    }

    /// Whether clearly more remains unexplained at a delay than at the best one, if it is known.
    fn exceeds(&self, curve: &[Option<f64>], index: usize) -> bool {
        curve[index].is_none_or(|value| value >= FACTOR * self.least + MARGIN)
    }
}
