//! Strips that only one eye sees, and to which side of them they belong.

use ga_image::plane::Plane;

use super::view::View;

/// The least step of disparity at a strip, in pixels.
const LEAST_STEP: f32 = 2.0;

/// The length of a strip may differ from the step of disparity by this factor and this number of
/// pixels.
const LENGTH_FACTOR: f32 = 1.5;
const LENGTH_MARGIN: f32 = 2.0;

/// The number of pixels on both sides of a strip that have confirmed disparities, and the greatest
/// difference between these in pixels.
const BESIDE: usize = 4;
const FLAT: f32 = 1.5;

/// The greatest length that is compared on each side, in pixels.
const LONGEST: usize = 12;

/// The border of a surface may lie this number of pixels beside the end of a strip.
const NEAR: usize = 2;

/// Columns and rows of the regions for which evidence is kept apart.
const REGIONS: [usize; 2] = [8, 12];
pub(super) const REGION_COUNT: usize = REGIONS[0] * REGIONS[1];

/// How much more strips are like one side than like the other, in two ways: by mean colours, and by
/// the steps at their ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Cues {
    /// Sums over strips of the difference at the side of greater disparity minus that at the other
    /// side.
    pub(super) excess: [f64; 2],
    /// Sums of both differences.
    pub(super) total: [f64; 2],
    /// The number of strips.
    pub(super) strips: f64,
}

impl Cues {
    pub(super) fn add(&mut self, other: &Self) {
        for cue in 0..2 {
            self.excess[cue] += other.excess[cue];
            self.total[cue] += other.total[cue];
        }
        self.strips += other.strips;
    }
}

/// Adds the evidence of all strips of a view to that of its regions. `disparity` is
/// NaN where the other view does not confirm it.
///
/// A strip between a smaller disparity at its left and a greater one at its right is hidden in the
/// other view. If the eyes are in order, the greater disparity is that of the nearer surface, and
/// the strip belongs to the farther one at its left; if they are exchanged, to the one at its
/// right.
pub(super) fn collect(view: &View, disparity: &Plane<f32>, regions: &mut [Cues]) {
    let width = view.width();
    for row in 0..view.height() {
        let (colours, values) = (view.row(row), disparity.row(row));
        let mut start = 1;
        while start < width {
            if !values[start].is_nan() || values[start - 1].is_nan() {
                start += 1;
                continue;
            }
            let run = values[start..].iter().take_while(|v| v.is_nan()).count();
            let end = start + run;
            if is_hidden(values, start, end)
                && let Some(found) = compare(colours, start, end)
            {
                let place = [start * REGIONS[0] / width, row * REGIONS[1] / view.height()];
                regions[place[1] * REGIONS[0] + place[0]].add(&found);
            }
            start = end + 1;
        }
    }
}

/// Whether unconfirmed pixels from `start` to `end` are what a step of disparity hides.
fn is_hidden(values: &[f32], start: usize, end: usize) -> bool {
    let is_flat = |values: &[f32]| {
        let known = values.iter().all(|value| !value.is_nan());
        let least = values.iter().copied().fold(f32::INFINITY, f32::min);
        let most = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        known && most - least < FLAT
    };
    if start < BESIDE || end + BESIDE > values.len() {
        return false;
    }
    let (step, length) = (values[end] - values[start - 1], (end - start) as f32);
    step >= LEAST_STEP
        && length <= LENGTH_FACTOR * step + LENGTH_MARGIN
        && length * LENGTH_FACTOR + LENGTH_MARGIN >= step
        && is_flat(&values[start - BESIDE..start])
        && is_flat(&values[end..end + BESIDE])
}

/// Compares the strip from `start` to `end` with as many pixels on both sides.
fn compare(colours: &[[f32; 3]], start: usize, end: usize) -> Option<Cues> {
    let length = (end - start).min(LONGEST);
    let margin = length.max(NEAR + 2);
    if start < margin || end + margin > colours.len() {
        return None;
    }
    let strip = mean(&colours[start..end]);
    let likeness = [
        difference(mean(&colours[start - length..start]), strip),
        difference(mean(&colours[end..end + length]), strip),
    ];
    let steps = [start, end].map(|place| {
        let near = place - NEAR..=place + NEAR;
        near.map(|place| rise(colours, place)).fold(0.0, f64::max)
    });
    let pair = |[first, last]: [f64; 2]| [last - first, last + first];
    let (likeness, steps) = (pair(likeness), pair(steps));
    Some(Cues {
        excess: [likeness[0], steps[0]],
        total: [likeness[1], steps[1]],
        strips: 1.0,
    })
}

/// How much greater the step of luma to a pixel is than those beside it: a border cuts through a
/// texture, within which steps are alike.
fn rise(colours: &[[f32; 3]], place: usize) -> f64 {
    let step = |place: usize| f64::from((colours[place - 1][0] - colours[place][0]).abs());
    match place >= 2 && place + 1 < colours.len() {
        true => step(place) - 0.5 * (step(place - 1) + step(place + 1)),
        false => 0.0,
    }
}

fn mean(colours: &[[f32; 3]]) -> [f32; 3] {
    let mut sum = [0.0; 3];
    for colour in colours {
        for channel in 0..3 {
            sum[channel] += colour[channel];
        }
    }
    sum.map(|sum| sum / colours.len().max(1) as f32)
}

/// The sum of absolute differences, those of colour differences with double weight.
fn difference(a: [f32; 3], b: [f32; 3]) -> f64 {
    let [luma, cb, cr]: [f32; 3] = std::array::from_fn(|channel| (a[channel] - b[channel]).abs());
    f64::from(luma + 2.0 * (cb + cr))
}
