//! Fades from and to one colour.

use std::collections::VecDeque;
use std::ops::Range;

use ga_image::plane::Plane;
use ga_numerics::order_statistics::Sorted;
use serde::Serialize;

use super::colour::Colour;
use super::cut::usual;
use super::difference::moments;
use super::layout::{CELL_COUNT, Rectangle, cell, without_bars};
use super::window::Window;

/// The greatest standard deviation of a frame without a picture, in numbers of 8 bits.
const FLAT: f32 = 1.5;

/// The least number of frames of a fade.
const LEAST: usize = 4;

/// No fade is longer, in frames.
const LONGEST: usize = 600;

/// The least contrast that a fade reaches.
const LEAST_RISE: f32 = 4.5;

/// A frame without a picture has at most this part of the usual deviation, where that is less than
/// the greatest; the deviation that rounding leaves counts in no case.
const FLAT_PART: f32 = 0.1;
const FLATTEST: f32 = 0.4;

/// Frames of this number say what is usual.
const USUAL: usize = 60;

/// The rise continues if it does so within this number of frames.
const AHEAD: usize = 4;

/// The number of frames before a frame, and after it, that show where the bars are.
const AROUND: usize = 40;

/// The number of cells of a frame that count, those that are nearest to its level. A caption or a
/// station label lies in the others.
const MOST: usize = CELL_COUNT * 2 / 3;

/// How different the rises of cells with little and with much contrast may be.
const UNEVEN: f32 = 0.3;

/// A fade, as a half-open interval of frames.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fade {
    /// The frames in which brightness changes; where the video begins or ends with flat frames,
    /// with these.
    #[serde(flatten)]
    pub frames: Range<usize>,
    /// Whether the picture appears or disappears.
    pub direction: Direction,
    /// What it fades from or to.
    pub colour: Colour,
}

/// Whether a picture appears or disappears.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// The picture appears.
    In,
    /// The picture disappears.
    Out,
}

/// The mean and the standard deviation of a signature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Level {
    /// The mean of red, from 0 to 255.
    pub mean: f32,
    /// Its standard deviation.
    pub deviation: f32,
}

impl Level {
    /// Whether there is no picture.
    #[must_use]
    pub fn is_flat(self) -> bool {
        self.deviation < FLAT
    }

    /// The root of the mean squared difference from a level.
    fn contrast(self, level: f32) -> f32 {
        (self.mean - level).hypot(self.deviation)
    }
}

/// Finds fades while frames come in, for whole frames and for most of each frame, so that neither
/// bars nor captions hide them.
#[derive(Clone, Debug, Default)]
pub struct FadeDetector {
    extents: VecDeque<Option<Rectangle<usize>>>,
    whole: Vec<Level>,
    most: Vec<Level>,
    cells: Vec<[u8; CELL_COUNT]>,
    colours: Vec<[u8; 3]>,
}

impl FadeDetector {
    /// Measures the frames for which enough later frames are known, after the last frame of the
    /// window, whose [usual colour](super::colour::usual_colour) is given, was added to it.
    pub fn advance(&mut self, window: &Window, colour: [u8; 3]) {
        self.colours.push(colour);
        let last = window.end().checked_sub(1);
        if let Some(signature) = last.and_then(|last| window.get(last)) {
            if self.extents.len() > 2 * AROUND {
                self.extents.pop_front();
            }
            self.extents.push_back(without_bars(signature, signature));
        }
        self.measure_before(window.end().saturating_sub(AROUND), window);
    }

    /// Measures the frames before one that were not measured yet. What is black in all of the
    /// frames around one is a bar.
    fn measure_before(&mut self, end: usize, window: &Window) {
        let first = window.end() - self.extents.len();
        while self.whole.len() < end {
            let index = self.whole.len();
            let near =
                index.saturating_sub(AROUND).max(first)..window.end().min(index + AROUND + 1);
            let extents = near.filter_map(|frame| self.extents[frame - first]);
            let part = extents.reduce(Rectangle::around);
            let Some(signature) = window.get(index) else {
                return;
            };
            self.measure(signature, part.unwrap_or(Rectangle::of(signature)));
        }
    }

    fn measure(&mut self, signature: &Plane<f32>, part: Rectangle<usize>) {
        let [mean, deviation] = moments(signature, part);
        self.whole.push(Level { mean, deviation });
        // Means over cells have little noise.
        let cells: [f32; CELL_COUNT] =
            std::array::from_fn(|index| moments(signature, cell(part, index))[0]);
        let mean = usual(cells.to_vec());
        let mut apart = cells.map(|other| (other - mean).abs());
        apart.sort_unstable_by(f32::total_cmp);
        let kept = &apart[..MOST];
        let squares: f32 = kept.iter().map(|value| value * value).sum();
        let deviation = (squares / MOST as f32).sqrt();
        self.most.push(Level { mean, deviation });
        self.cells.push(cells.map(|mean| mean.round() as u8));
    }

    /// Measures the last frames and gives all fades.
    #[must_use]
    pub fn finish(mut self, window: &Window) -> Vec<Fade> {
        self.measure_before(window.end(), window);
        let mut found = fades(&self.whole, &self.colours);
        found.retain(|fade| self.unevenness(fade).is_none_or(|uneven| uneven < UNEVEN));
        for fade in fades(&self.most, &self.colours) {
            let known = |other: &Fade| overlap(&other.frames, &fade.frames);
            let even = self.unevenness(&fade).is_some_and(|uneven| uneven < UNEVEN);
            if even && !found.iter().any(known) {
                found.push(fade);
            }
        }
        found.sort_by_key(|fade| fade.frames.start);
        found
    }

    /// How differently the parts of the picture with little and with much contrast fade, where most
    /// of the picture takes part. Where the camera comes to an object from an even background, the
    /// contrast rises as well, but in one cell after another.
    fn unevenness(&self, fade: &Fade) -> Option<f32> {
        let (flat, full) = match fade.direction {
            Direction::In => (fade.frames.start, fade.frames.end - 1),
            Direction::Out => (fade.frames.end - 1, fade.frames.start),
        };
        let level = self.most[flat].mean;
        let contrasts = |frame: usize| {
            let mut apart = self.cells[frame].map(|cell| (f32::from(cell) - level).abs());
            let sorted = Sorted::new(&mut apart);
            [0.25, 2.0 / 3.0].map(|share| sorted.map_or(f32::NAN, |apart| apart.quantile(share)))
        };
        let [low, high] = contrasts(full);
        let (mut apart, mut count) = (0.0, 0.0);
        for frame in fade.frames.clone() {
            let [a, b] = contrasts(frame);
            let [a, b] = [a / low.max(1.0), b / high.max(1.0)];
            if (0.2..0.8).contains(&b) {
                apart += (a - b).abs();
                count += 1.0;
            }
        }
        (count > 0.0).then(|| apart / count)
    }
}

/// The fades of a video, in order, from the level and the usual colour of each frame.
#[must_use]
pub fn fades(levels: &[Level], colours: &[[u8; 3]]) -> Vec<Fade> {
    let flat = flat(levels);
    let mut found = Vec::new();
    let mut start = 0;
    while start < levels.len() {
        if !flat[start] {
            start += 1;
            continue;
        }
        let length = flat[start..].iter().take_while(|flat| **flat).count();
        let end = start + length;
        let middle = colours.get((start + end) / 2).copied().unwrap_or_default();
        let colour = Colour::of(middle);
        let backwards = levels[..start].iter().rev().take(LONGEST).copied();
        if let Some(length) = rise(backwards, levels[start].mean) {
            let end = if end == levels.len() { end } else { start };
            found.push(Fade {
                frames: start - length..end,
                direction: Direction::Out,
                colour,
            });
        }
        let forwards = levels[end..].iter().take(LONGEST).copied();
        if let Some(length) = rise(forwards, levels[end - 1].mean) {
            let start = if start == 0 { 0 } else { end };
            found.push(Fade {
                frames: start..end + length,
                direction: Direction::In,
                colour,
            });
        }
        start = end;
    }
    // Under flicker a fade may be found twice.
    found.dedup_by(|next, fade| next.frames.start < fade.frames.end);
    found
}

/// Which frames have no picture: their deviation is small, also in comparison with that of the
/// frames around them.
fn flat(levels: &[Level]) -> Vec<bool> {
    let usual: Vec<f32> = levels
        .chunks(USUAL)
        .map(|chunk| {
            let mut sorted: Vec<f32> = chunk.iter().map(|level| level.deviation).collect();
            Sorted::new(&mut sorted).map_or(f32::NAN, |sorted| sorted.quantile(0.75))
        })
        .collect();
    let is_flat = |(index, level): (usize, &Level)| {
        let chunk = index / USUAL;
        let near = &usual[chunk.saturating_sub(1)..(chunk + 2).min(usual.len())];
        let usual = near.iter().copied().fold(0.0, f32::max);
        level.deviation < FLAT.min(FLAT_PART * usual).max(FLATTEST)
    };
    levels.iter().enumerate().map(is_flat).collect()
}

/// The number of frames in which pictures rise from a flat level. Flicker of a bright level changes
/// its brightness from frame to frame, but not its deviation.
fn rise(levels: impl Iterator<Item = Level> + Clone, flat: f32) -> Option<usize> {
    let contrast: Vec<f32> = levels.clone().map(|level| level.contrast(flat)).collect();
    ramp(&smoothed(&contrast)).or_else(|| {
        let deviation: Vec<f32> = levels.map(|level| level.deviation).collect();
        ramp(&smoothed(&deviation))
    })
}

/// The median of each number and up to two on each side, as many on both.
fn smoothed(values: &[f32]) -> Vec<f32> {
    (0..values.len())
        .map(|index| {
            let reach = 2.min(index).min(values.len() - 1 - index);
            usual(values[index - reach..=index + reach].to_vec())
        })
        .collect()
}

/// The number of frames in which the contrast rises from almost nothing, where it rises steadily
/// and not at once.
fn ramp(contrast: &[f32]) -> Option<usize> {
    let mut length = 0;
    for index in 0..contrast.len() {
        let ahead = AHEAD.min(contrast.len() - 1 - index);
        let slope = contrast[index] / (index + 1) as f32;
        length = index + 1;
        // What is left of the rise is slower by far than what was.
        if contrast[index + ahead] - contrast[index] < 0.25 * slope * ahead as f32 {
            break;
        }
    }
    let rise = *contrast.get(length.checked_sub(1)?)?;
    let steps = contrast[..length].windows(2).map(|pair| pair[1] - pair[0]);
    let greatest = steps.fold(contrast[0], f32::max);
    (length >= LEAST && rise > LEAST_RISE && greatest < 0.5 * rise).then_some(length)
}

fn overlap(a: &Range<usize>, b: &Range<usize>) -> bool {
    a.start < b.end && b.start < a.end
}
