//! Dissolves: shots that are blended into each other.

use std::collections::VecDeque;
use std::ops::Range;

use ga_image::plane::Plane;
use serde::Serialize;

use super::blend::{Blend, Ends, MOTION};
use super::difference::{after_motion, moments};
use super::layout::{CELL_COUNT, Layout, Rectangle, cell, without_bars};
use super::window::Window;

/// The distances of the two ends from the middle that are tried, in frames.
const HALF_SPANS: [usize; 15] = [3, 4, 5, 6, 8, 10, 12, 14, 17, 20, 26, 32, 40, 50, 64];

/// The greatest of them.
pub const REACH: usize = 64;

/// The number of signatures that are needed.
pub const WINDOW: usize = 2 * REACH + 2 * MOTION + 2;

/// The greatest correlation of the two ends.
const CORRELATION: f32 = 0.8;

/// The fraction of the first end in the middle.
const FRACTION: Range<f32> = 0.25..0.75;

/// From this half span on the motions of the ends are refined.
const LONG: usize = 12;

/// With a greater residual they are.
const MOVED: f32 = 0.1;
const LOST: f32 = 1.2;

/// Of half spans that are so many times longer or more, not every frame is tried as the middle.
const APART: usize = 6;

/// The number of frames between the ends of a dissolve at which the blend is looked at, about.
const LOOKS: usize = 40;

/// The greatest residual of the blend.
const RESIDUAL: f32 = 0.55;

/// The least fall of the variance in the middle.
const DIP: f32 = 0.12;

/// The least difference of the ends after the motion of the camera: of most blocks, and of all. A
/// title that appears changes only some.
const DIFFERENT: f32 = 0.36;
const EVERYWHERE: f32 = 0.13;

/// A dissolve needs at least this number of pairs of ends that show it, and one for each time that
/// many of its frames.
const PAIRS: usize = 3;

/// So many are enough for the longest.
const MOST_PAIRS: usize = 10;

/// The least number of frames of a dissolve.
const LEAST: usize = 3;

/// The least change in the middle of a dissolve, in comparison with that between its ends.
const CHANGES: f32 = 0.85;

/// With a smaller residual, the middle need change less.
const EXPLAINED: f32 = 0.3;

/// A frame with a greater residual is a flash.
const FLASH: f32 = 1.0;

/// The greatest root mean square of the distances of fractions from their line.
const BENT: f32 = 0.08;

/// The part of cells in which the variance falls, at least.
const MOST: f32 = 0.5;

/// The standard deviation of a picture that is flat.
const FLAT: f32 = 2.0;

/// Finds dissolves while frames come in.
///
/// The middle frame of a dissolve is a blend u A + v B of the frames A and B at its ends, each
/// moved as the camera moved before and after. The brightness u + v is free, so that flicker does
/// not count, and so are the three tenths of the picture that are explained worst, where captions
/// and logos are. A place is reported if the ends are different pictures, if a blend with a
/// fraction α = u / (u + v) between ¼ and ¾ explains the middle, if the variance falls in most
/// cells of the picture, as it does in means of pictures that are not alike, if α falls steadily
/// from end to end, if other ends say so too, and if the middle itself changes after the motion of
/// the camera. The line through α is 1 at the first frame of the dissolve and 0 after its last.
/// Settings of our own, measured on synthetic clips.
#[derive(Clone, Debug, Default)]
pub struct DissolveDetector {
    contrasts: VecDeque<Contrast>,
    first: usize,
    next: usize,
    found: Vec<Dissolve>,
    /// For each, how many pairs of ends say so.
    pairs: Vec<usize>,
}

/// A dissolve with how well it is explained.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Dissolve {
    /// The blended frames, half-open.
    #[serde(flatten)]
    pub frames: Range<usize>,
    /// The part of the middle that the blend does not explain.
    #[serde(skip)]
    pub residual: f32,
}

impl DissolveDetector {
    /// Examines the frames for which enough later frames are known, after the last frame of the
    /// window was added to it.
    pub fn advance(&mut self, window: &Window, layout: Layout) {
        while self.first + self.contrasts.len() < window.end() {
            let index = self.first + self.contrasts.len();
            let contrast = window.get(index).map(Contrast::of).unwrap_or_default();
            if self.contrasts.len() == WINDOW {
                self.contrasts.pop_front();
                self.first += 1;
            }
            self.contrasts.push_back(contrast);
        }
        while self.next + REACH + MOTION < window.end() {
            self.examine(self.next, window, layout);
        }
    }

    /// The dissolves that were found so far, in order; some may turn out to be none.
    #[must_use]
    pub fn found(&self) -> &[Dissolve] {
        &self.found
    }

    /// Examines the last frames and gives all dissolves.
    #[must_use]
    pub fn finish(mut self, window: &Window, layout: Layout) -> Vec<Dissolve> {
        while self.next < window.end() {
            self.examine(self.next, window, layout);
        }
        let found = self.found.into_iter().zip(self.pairs);
        found
            .filter(|(dissolve, pairs)| {
                *pairs >= PAIRS.max(dissolve.frames.len() / PAIRS).min(MOST_PAIRS)
            })
            .map(|(dissolve, _)| dissolve)
            .collect()
    }

    fn examine(&mut self, middle: usize, window: &Window, layout: Layout) {
        self.next = middle + 1;
        for half in HALF_SPANS {
            // Near the middle of a long dissolve one frame is like the next.
            let apart = (half / APART).max(1);
            if !middle.is_multiple_of(apart) {
                continue;
            }
            let Some(dissolve) = self.blend(middle, half, window, layout) else {
                continue;
            };
            match (self.found.last_mut(), self.pairs.last_mut()) {
                (Some(other), Some(pairs)) if other.frames.end > dissolve.frames.start => {
                    *pairs += apart;
                    if dissolve.residual < other.residual {
                        *other = dissolve;
                    }
                }
                _ => {
                    self.found.push(dissolve);
                    self.pairs.push(apart);
                }
            }
        }
    }

    fn contrast(&self, index: usize) -> Option<&Contrast> {
        self.contrasts.get(index.checked_sub(self.first)?)
    }

    /// The dissolve around a middle between two ends, if it is one.
    fn blend(
        &self,
        middle: usize,
        half: usize,
        window: &Window,
        layout: Layout,
    ) -> Option<Dissolve> {
        let (start, end) = (middle.checked_sub(half)?, middle + half);
        let [first, last] = [self.contrast(start)?, self.contrast(end)?];
        if !self.contrast(middle)?.falls_between(first, last) {
            return None;
        }
        let mut ends = Ends::new([start, end], window, layout)?;
        if ends.correlation() > CORRELATION {
            return None;
        }
        let picture = window.get(middle)?;
        let mut blend = ends.blend(picture, middle);
        if half >= LONG && (MOVED..LOST).contains(&blend.residual) {
            ends.refine(window);
            blend = ends.blend(picture, middle);
        }
        let Blend { fraction, residual } = blend;
        if !FRACTION.contains(&fraction) || residual > RESIDUAL {
            return None;
        }
        let step = (2 * half / LOOKS).max(1);
        let blends: Option<Vec<(f32, Blend)>> = (start..=end)
            .step_by(step)
            .map(|index| {
                Some((
                    (index - start) as f32,
                    ends.blend(window.get(index)?, index),
                ))
            })
            .collect();
        let [first, last] = ramp(&blends?, step as f32)?;
        // Both ends are outside of the blended frames.
        if first < 0.5 || last > 2.0 * half as f32 - 0.5 {
            return None;
        }
        // The same picture, moved by the camera, is not another one.
        let (first_end, last_end) = (window.get(start)?, window.get(end)?);
        let difference = after_motion(first_end, last_end, layout);
        let least = difference
            .blocks
            .iter()
            .copied()
            .fold(f32::INFINITY, f32::min);
        if difference.typical() < DIFFERENT || least < EVERYWHERE {
            return None;
        }
        let frames = start + first.round() as usize..start + last.round() as usize;
        let apart = difference.typical() / frames.len() as f32;
        let least = CHANGES * (residual / EXPLAINED).min(1.0);
        let changes = || ends.change(&frames, window, layout) > least * apart;
        (frames.len() >= LEAST && changes()).then_some(Dissolve { frames, residual })
    }
}

/// The mean of a signature, its standard deviation, and the variance within each of its cells.
#[derive(Clone, Debug)]
struct Contrast {
    mean: f32,
    deviation: f32,
    cells: [f32; CELL_COUNT],
}

impl Default for Contrast {
    fn default() -> Self {
        Self {
            mean: 0.0,
            deviation: 0.0,
            cells: [0.0; CELL_COUNT],
        }
    }
}

impl Contrast {
    fn of(signature: &Plane<f32>) -> Self {
        let Some(part) = without_bars(signature, signature) else {
            return Self::default();
        };
        let [mean, deviation] = moments(signature, part);
        let whole = Rectangle::of(signature);
        let mut cells = [0.0; CELL_COUNT];
        for (index, variance) in cells.iter_mut().enumerate() {
            let [_, deviation] = moments(signature, cell(whole, index));
            *variance = deviation * deviation;
        }
        Self {
            mean,
            deviation,
            cells,
        }
    }

    /// Whether the variance is less than that of both ends in most cells that have any, after the
    /// brightness was made that of the ends. A flat end belongs to a fade.
    fn falls_between(&self, first: &Self, last: &Self) -> bool {
        if first.deviation.min(last.deviation) < FLAT {
            return false;
        }
        let gain = (self.mean + 0.5) / (0.5 * (first.mean + last.mean) + 0.5);
        let least = (1.0 - DIP) * (gain * gain).clamp(0.4, 2.5);
        let (mut lower, mut all) = (0, 0);
        for (middle, (a, b)) in self.cells.iter().zip(first.cells.iter().zip(&last.cells)) {
            if a.max(*b) > FLAT * FLAT {
                all += 1;
                lower += usize::from(2.0 * middle < least * (a + b));
            }
        }
        lower as f32 > MOST * all as f32
    }
}

/// Where the line through falling fractions is 1 and 0, if they fall steadily. Each has its time in
/// frames; they are `step` frames apart.
fn ramp(blends: &[(f32, Blend)], step: f32) -> Option<[f32; 2]> {
    let inside: Vec<[f32; 2]> = blends
        .iter()
        .filter(|(_, blend)| (0.12..0.88).contains(&blend.fraction) && blend.residual < FLASH)
        .map(|(time, blend)| [*time, blend.fraction])
        .collect();
    let count = inside.len() as f32;
    let contiguous = inside
        .windows(2)
        .all(|pair| pair[1][0] - pair[0][0] < 2.5 * step);
    let falling = inside.windows(2).all(|pair| pair[1][1] < pair[0][1] + 0.05);
    if inside.len() < 2 || !contiguous || !falling {
        return None;
    }
    let mean = [0, 1].map(|axis| inside.iter().map(|point| point[axis]).sum::<f32>() / count);
    let product = |axis: usize| {
        let terms = inside
            .iter()
            .map(|p| (p[0] - mean[0]) * (p[axis] - mean[axis]));
        terms.sum::<f32>()
    };
    let slope = product(1) / product(0);
    let rest = inside
        .iter()
        .map(|p| p[1] - mean[1] - slope * (p[0] - mean[0]));
    let rest = (rest.map(|rest| rest * rest).sum::<f32>() / count).sqrt();
    let steady = slope < -1e-3 && rest < BENT;
    steady.then(|| [1.0, 0.0].map(|level| mean[0] + (level - mean[1]) / slope))
}
