//! What two frames have in common although they differ: the same scene behind an object that comes
//! or leaves, or in other light.

use ga_image::plane::Plane;

use super::difference::products;
use super::layout::{CELL_COUNT, Rectangle, cell, without_bars};

/// The least standard deviation of a cell with a structure, in numbers of 8 bits.
const STRUCTURE: f64 = 2.0;

/// The greatest root mean square difference of a cell that is unchanged, relative to its deviation.
const UNCHANGED: f64 = 0.4;

/// The greatest difference of the means of even cells that are unchanged.
const EVEN: f64 = 1.0;

/// Means beyond these are black or white, which says nothing about a scene.
const TONES: [f64; 2] = [16.0, 245.0];

/// The part of all cells that is unchanged behind an object, and the part that has a structure too.
/// A banner fills a sixth.
const BEHIND: f32 = 0.3;
const BEHIND_STRUCTURE: f32 = 0.2;

/// The least correlation of a cell in other light.
const ALIKE: f64 = 0.6;

/// The part of cells with a structure that is alike in other light, and the part of all cells that
/// have one.
const LIT: f32 = 0.6;
const LIT_STRUCTURE: f32 = 0.2;

/// How much brighter boxes are, at least, where light was added; numbers of 8 bits.
const ROUNDING: f32 = 2.0;

/// The part of boxes that added light does not darken.
const BRIGHTER: f32 = 0.9;

/// Whether two frames, at rest, show one scene behind an object or in other light: whether enough
/// of their cells are unchanged, or have one structure whatever its brightness and contrast are.
pub(super) fn is_one_scene(a: &Plane<f32>, b: &Plane<f32>) -> bool {
    let part = without_bars(a, b).unwrap_or(Rectangle::of(a));
    let (mut unchanged, mut even, mut alike, mut structured) = (0, 0, 0, 0);
    for index in 0..CELL_COUNT {
        let cell = Moments::of(a, b, cell(part, index));
        let [least, greatest] =
            [f64::min, f64::max].map(|of| of(cell.deviations[0], cell.deviations[1]));
        let is_grey = cell
            .means
            .iter()
            .all(|mean| (TONES[0]..TONES[1]).contains(mean));
        if greatest < STRUCTURE {
            even += usize::from(is_grey && (cell.means[0] - cell.means[1]).abs() < EVEN);
            continue;
        }
        let is_saturated = least < STRUCTURE && cell.means.iter().any(|mean| *mean > TONES[1]);
        structured += usize::from(!is_saturated);
        alike += usize::from(!is_saturated && cell.correlation > ALIKE);
        unchanged += usize::from(cell.apart < UNCHANGED * least);
    }
    let share = |count: usize, of: usize| count as f32 / of.max(1) as f32;
    let is_behind = share(unchanged, CELL_COUNT) > BEHIND_STRUCTURE
        && share(unchanged + even, CELL_COUNT) > BEHIND;
    let is_lit = share(alike, structured) > LIT && share(structured, CELL_COUNT) > LIT_STRUCTURE;
    is_behind || is_lit
}

/// Whether a picture differs from another by light that was added: hardly any place is darker.
pub(super) fn is_brighter(dark: &Plane<f32>, bright: &Plane<f32>) -> bool {
    let pairs = dark.values().iter().zip(bright.values());
    let lit = pairs.filter(|(dark, bright)| **bright > **dark - ROUNDING);
    lit.count() as f32 > BRIGHTER * dark.values().len() as f32
}

/// What is measured of a cell of two frames.
struct Moments {
    means: [f64; 2],
    deviations: [f64; 2],
    correlation: f64,
    /// The root mean square of the difference.
    apart: f64,
}

impl Moments {
    fn of(a: &Plane<f32>, b: &Plane<f32>, place: Rectangle<usize>) -> Self {
        let [count, a, b, aa, ab, bb] = products(a, b, place);
        let count = f64::max(count, 1.0);
        let [aa_rest, ab_rest, bb_rest] =
            [aa - a * a / count, ab - a * b / count, bb - b * b / count];
        Self {
            means: [a, b].map(|sum| sum / count),
            deviations: [aa_rest, bb_rest].map(|rest| (rest / count).max(0.0).sqrt()),
            correlation: ab_rest / (aa_rest * bb_rest).max(1e-9).sqrt(),
            apart: ((aa - 2.0 * ab + bb) / count).max(0.0).sqrt(),
        }
    }
}
