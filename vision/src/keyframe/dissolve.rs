//! Dissolves: shots that are blended into each other.

use std::ops::Range;

use ga_image::plane::Plane;

use super::difference::{after_motion, moments};
use super::layout::{Layout, Rectangle, without_bars};
use super::window::Window;

/// The distances of the two ends from the middle that are tried, in frames.
const HALF_SPANS: [usize; 13] = [3, 4, 5, 6, 8, 10, 12, 14, 17, 20, 26, 32, 40];

/// The greatest of them.
pub const REACH: usize = 40;

/// So many signatures are needed.
pub const WINDOW: usize = 2 * REACH + 2 * MOTION + 2;

/// The greatest correlation of the two ends.
const CORRELATION: f32 = 0.6;

/// The fraction of the first end in the middle.
const FRACTION: Range<f32> = 0.25..0.75;

/// The greatest residual of the blend.
const RESIDUAL: f32 = 0.6;

/// The least fall of the variance in the middle.
const DIP: f32 = 0.12;

/// The least difference of the ends after the motion of the camera: of most blocks, and of all. A
/// title that appears changes only some.
const DIFFERENT: f32 = 0.45;
const EVERYWHERE: f32 = 0.22;

/// The least frames of a dissolve.
const LEAST: usize = 3;

/// So many frames before the first end, and after the second, say how the camera moves there.
const MOTION: usize = 5;

/// Finds dissolves while frames come in.
///
/// The middle frame of a dissolve is a blend α A + (1 − α) B of the frames A and B at its ends,
/// each moved as the camera moved before and after. A place is reported if the ends are different
/// pictures, if a blend with α between ¼ and ¾ explains the middle, if the variance falls there, as
/// it does in means of pictures that are not alike, and if α falls steadily from end to end. The
/// line through α is 1 at the first frame of the dissolve and 0 after its last. Settings of our
/// own, measured on real and on synthetic clips.
#[derive(Clone, Debug, Default)]
pub struct DissolveDetector {
    deviations: Vec<f32>,
    next: usize,
    found: Vec<Dissolve>,
}

/// A dissolve with how well it is explained.
#[derive(Clone, Debug, PartialEq)]
pub struct Dissolve {
    /// The blended frames, half-open.
    pub frames: Range<usize>,
    /// The part of the middle that the blend does not explain.
    pub residual: f32,
}

impl DissolveDetector {
    /// Examines the frames for which enough later frames are known, after the last frame of the
    /// window was added to it.
    pub fn advance(&mut self, window: &Window, layout: Layout) {
        let end = window.end();
        for index in self.deviations.len()..end {
            let deviation = window.get(index).and_then(|signature| {
                Some(moments(signature, without_bars(signature, signature)?)[1])
            });
            self.deviations.push(deviation.unwrap_or(0.0));
        }
        while self.next + REACH + MOTION < end {
            self.examine(self.next, window, layout);
        }
    }

    /// The dissolves found so far, in order.
    #[must_use]
    pub fn found(&self) -> &[Dissolve] {
        &self.found
    }

    /// Examines the last frames and gives all dissolves.
    #[must_use]
    pub fn finish(mut self, window: &Window, layout: Layout) -> Vec<Dissolve> {
        while self.next < self.deviations.len() {
            self.examine(self.next, window, layout);
        }
        self.found
    }

    fn examine(&mut self, middle: usize, window: &Window, layout: Layout) {
        self.next = middle + 1;
        for half in HALF_SPANS {
            let Some(dissolve) = self.blend(middle, half, window, layout) else {
                continue;
            };
            match self.found.last_mut() {
                Some(other) if other.frames.end > dissolve.frames.start => {
                    if dissolve.residual < other.residual {
                        *other = dissolve;
                    }
                }
                _ => self.found.push(dissolve),
            }
        }
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
        let deviation = |index: usize| self.deviations.get(index).copied();
        let [a, m, b] = [deviation(start)?, deviation(middle)?, deviation(end)?];
        // A flat end is a fade.
        if a.min(b) < 2.0 || 2.0 * m * m > (1.0 - DIP) * (a * a + b * b) {
            return None;
        }
        let ends = Ends::new([start, end], window, layout)?;
        if ends.correlation() > CORRELATION {
            return None;
        }
        let [fraction, residual] = ends.fraction(window.get(middle)?, middle);
        if !FRACTION.contains(&fraction) || residual > RESIDUAL {
            return None;
        }
        let fractions: Option<Vec<f32>> = (start..=end)
            .map(|index| Some(ends.fraction(window.get(index)?, index)[0]))
            .collect();
        let [first, last] = ramp(&fractions?)?;
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
        (frames.len() >= LEAST).then_some(Dissolve { frames, residual })
    }
}

/// The frames at both ends of a dissolve, and how the camera moves at each.
struct Ends<'a> {
    pictures: [&'a Plane<f32>; 2],
    at: [usize; 2],
    velocities: [[f32; 2]; 2],
    part: Rectangle<usize>,
}

impl<'a> Ends<'a> {
    fn new(at: [usize; 2], window: &'a Window, layout: Layout) -> Option<Self> {
        let pictures = [window.get(at[0])?, window.get(at[1])?];
        let velocity = |start: usize, end: usize| {
            let (Some(a), Some(b)) = (window.get(start), window.get(end)) else {
                return [0.0; 2];
            };
            let frames = end.saturating_sub(start).max(1) as f32;
            let motion = after_motion(a, b, layout).motion;
            motion.map(|boxes| boxes as f32 / frames)
        };
        let before = (0..=MOTION.min(at[0]))
            .rev()
            .map(|back| at[0] - back)
            .find(|index| window.get(*index).is_some())?;
        let after = (at[1] + MOTION).min(window.end() - 1);
        Some(Self {
            pictures,
            at,
            velocities: [velocity(before, at[0]), velocity(at[1], after)],
            part: without_bars(pictures[0], pictures[1])?,
        })
    }

    /// The fraction of the first end in the picture of a frame by least squares, and the root mean
    /// square of what remains, relative to half the difference of the ends. Every second box of
    /// every second row counts, where both moved ends have boxes.
    fn fraction(&self, picture: &Plane<f32>, index: usize) -> [f32; 2] {
        let moved = [0, 1].map(|end| {
            let frames = index as f32 - self.at[end] as f32;
            self.velocities[end].map(|velocity| velocity * frames)
        });
        let (mut squared, mut along, mut rest) = (1e-6, 0.0, 0.0);
        for row in (self.part.top..self.part.bottom).step_by(2) {
            let line = picture.row(row);
            for column in (self.part.left..self.part.right).step_by(2) {
                let ends = [0, 1].map(|end| {
                    let (x, y) = (column as f32 - moved[end][0], row as f32 - moved[end][1]);
                    self.between(self.pictures[end], x, y)
                });
                let [Some(a), Some(b)] = ends else { continue };
                let (difference, value) = (a - b, line[column] - b);
                squared += difference * difference;
                along += value * difference;
                rest += value * value;
            }
        }
        let fraction = along / squared;
        let rest: f32 = rest - fraction * along;
        [fraction, 2.0 * (rest.max(0.0) / squared).sqrt()]
    }

    /// The bilinear value between boxes, where all of them belong to the picture.
    fn between(&self, picture: &Plane<f32>, x: f32, y: f32) -> Option<f32> {
        let part = self.part;
        let inside = x >= part.left as f32
            && y >= part.top as f32
            && x <= (part.right - 1) as f32
            && y <= (part.bottom - 1) as f32;
        if !inside {
            return None;
        }
        let (column, row) = (x as usize, y as usize);
        let (right, below) = (
            (column + 1).min(part.right - 1),
            (row + 1).min(part.bottom - 1),
        );
        let (s, t) = (x - column as f32, y - row as f32);
        let (upper, lower) = (picture.row(row), picture.row(below));
        let mix = |line: &[f32]| line[column] + s * (line[right] - line[column]);
        Some(mix(upper) + t * (mix(lower) - mix(upper)))
    }

    /// The correlation of both ends.
    fn correlation(&self) -> f32 {
        let [a, b] = self.pictures;
        let [[mean_a, sigma_a], [mean_b, sigma_b]] = [a, b].map(|end| moments(end, self.part));
        let columns = self.part.left..self.part.right;
        let (mut sum, mut count) = (0.0, 0.0);
        for row in self.part.top..self.part.bottom {
            let pairs = a.row(row)[columns.clone()]
                .iter()
                .zip(&b.row(row)[columns.clone()]);
            for (a, b) in pairs {
                sum += (a - mean_a) * (b - mean_b);
                count += 1.0;
            }
        }
        sum / (count * sigma_a * sigma_b).max(1e-6)
    }
}

/// Where the line through falling fractions is 1 and 0, if they fall steadily.
fn ramp(fractions: &[f32]) -> Option<[f32; 2]> {
    let inside: Vec<[f32; 2]> = fractions
        .iter()
        .enumerate()
        .filter(|(_, fraction)| (0.12..0.88).contains(*fraction))
        .map(|(index, fraction)| [index as f32, *fraction])
        .collect();
    let count = inside.len() as f32;
    let contiguous = inside.windows(2).all(|pair| pair[1][0] - pair[0][0] < 1.5);
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
    (slope < -1e-3).then(|| [1.0, 0.0].map(|level| mean[0] + (level - mean[1]) / slope))
}
