//! Pictures between the ends of a dissolve as blends of both.

use std::ops::Range;

use ga_image::plane::Plane;

use super::difference::{after_motion, products};
use super::layout::{CELL_COUNT, Layout, Rectangle, cell, without_bars};
use super::window::Window;

/// The number of frames before the first end, and after the second, that say how the camera moves
/// there.
pub(super) const MOTION: usize = 5;

/// The farthest motion over which this is measured, in boxes.
const FARTHEST: f32 = 5.0;

/// The part of cells that a blend need not explain.
const LEFT_OUT: f32 = 0.3;

/// Motions are refined by steps of this number of boxes in the middle of a dissolve, each at most
/// this often; boxes at this distance from the middle of the picture move so by growth.
const STEPS: [f32; 3] = [2.0, 1.0, 0.5];
const ROUNDS: usize = 4;
const GROWING: f32 = 20.0;

/// Boxes and rows that are this far apart are enough for that.
const COARSE: usize = 4;

/// One cell of this number has to be in both moved ends at least.
const LEAST_SEEN: usize = 3;

/// The frames at both ends of a dissolve, and how the camera moves at each.
#[derive(Clone, Copy)]
pub(super) struct Ends<'a> {
    pictures: [&'a Plane<f32>; 2],
    at: [usize; 2],
    motions: [Motion; 2],
    part: Rectangle<usize>,
}

/// How a picture moves in a frame: its translation in boxes, and by what part it grows.
#[derive(Clone, Copy, Debug, Default)]
struct Motion {
    velocity: [f32; 2],
    growth: f32,
}

impl<'a> Ends<'a> {
    pub(super) fn new(at: [usize; 2], window: &'a Window, layout: Layout) -> Option<Self> {
        let pictures = [window.get(at[0])?, window.get(at[1])?];
        let velocity = |start: usize, end: usize| {
            let (Some(a), Some(b)) = (window.get(start), window.get(end)) else {
                return Motion::default();
            };
            let frames = end.saturating_sub(start).max(1) as f32;
            let motion = after_motion(a, b, layout).motion;
            Motion {
                velocity: motion.map(|boxes| boxes as f32 / frames),
                growth: 0.0,
            }
        };
        let before = (0..=MOTION.min(at[0]))
            .rev()
            .map(|back| at[0] - back)
            .find(|index| window.get(*index).is_some())?;
        let after = (at[1] + MOTION).min(window.end() - 1);
        Some(Self {
            pictures,
            at,
            motions: [velocity(before, at[0]), velocity(at[1], after)],
            part: without_bars(pictures[0], pictures[1])?,
        })
    }

    /// How the picture of a frame is blended from both ends, each moved to its place: u A + v B by
    /// least squares, where u + v is the brightness and u / (u + v) the fraction of the first end.
    /// The cells that are explained worst are left out: captions and logos. Every second box of
    /// every second row counts, where both moved ends have boxes.
    pub(super) fn blend(&self, picture: &Plane<f32>, index: usize) -> Blend {
        self.blend_of(picture, index, 2)
    }

    /// The same of boxes and rows that are this far apart.
    fn blend_of(&self, picture: &Plane<f32>, index: usize, apart: usize) -> Blend {
        let part = self.part;
        let middle = [part.left + part.right, part.top + part.bottom].map(|sum| 0.5 * sum as f32);
        let moved = [0, 1].map(|end| {
            let frames = index as f32 - self.at[end] as f32;
            let Motion { velocity, growth } = self.motions[end];
            let scale = 1.0 / (1.0 + growth * frames).max(0.5);
            let shift =
                [0, 1].map(|axis| middle[axis] - scale * (middle[axis] + velocity[axis] * frames));
            (scale, shift)
        });
        let mut cells = [Products::default(); CELL_COUNT];
        for (index, products) in cells.iter_mut().enumerate() {
            let place = cell(self.part, index);
            for row in (place.top..place.bottom).step_by(apart) {
                let line = picture.row(row);
                for column in (place.left..place.right).step_by(apart) {
                    let ends = [0, 1].map(|end| {
                        let (scale, [right, down]) = moved[end];
                        let (x, y) = (scale * column as f32 + right, scale * row as f32 + down);
                        self.between(self.pictures[end], x, y)
                    });
                    if let [Some(a), Some(b)] = ends {
                        products.add(a, b, line[column]);
                    }
                }
            }
        }
        let mut kept: Vec<&Products> = cells.iter().filter(|cell| cell.count > 0.0).collect();
        if kept.len() < CELL_COUNT / LEAST_SEEN {
            return Blend::UNEXPLAINED;
        }
        let mut weights = Products::fit(&kept);
        let most = (kept.len() as f32 * (1.0 - LEFT_OUT)).ceil() as usize;
        for _ in 0..2 {
            kept = cells.iter().filter(|cell| cell.count > 0.0).collect();
            kept.sort_by(|a, b| a.mean_rest(weights).total_cmp(&b.mean_rest(weights)));
            kept.truncate(most);
            weights = Products::fit(&kept);
        }
        let gain = (weights[0] + weights[1]).max(0.1);
        let rest: f32 = kept.iter().map(|cell| cell.rest(weights)).sum();
        let squared = Products::difference(&kept);
        Blend {
            fraction: weights[0] / gain,
            residual: 2.0 * (rest.max(0.0) / squared.max(1e-6)).sqrt() / gain,
        }
    }

    /// Changes the motions of both ends so that the pictures between them are explained best: those
    /// outside of a long dissolve say too little of where its middle is. Each number is changed in
    /// turn, by steps that become smaller.
    pub(super) fn refine(&mut self, window: &Window) {
        let span = (self.at[1] - self.at[0]) as f32;
        let frames = [0.3, 0.5, 0.7].map(|part| self.at[0] + (part * span).round() as usize);
        let Some(seen) = frames
            .map(|frame| window.get(frame))
            .into_iter()
            .collect::<Option<Vec<_>>>()
        else {
            return;
        };
        let unexplained = |ends: &Self| -> f32 {
            let pictures = seen.iter().zip(frames);
            let blends = pictures.map(|(picture, frame)| ends.blend_of(picture, frame, COARSE));
            blends.map(|blend| blend.residual.powi(2)).sum()
        };
        let mut least = unexplained(self);
        for boxes in STEPS {
            for _ in 0..ROUNDS {
                let before = least;
                for (end, number) in (0..6).map(|number| (number % 2, number / 2)) {
                    let step = boxes / (0.5 * span);
                    for step in [step, -step] {
                        let mut motions = self.motions;
                        match number {
                            2 => motions[end].growth += step / GROWING,
                            axis => motions[end].velocity[axis] += step,
                        }
                        let changed = Self { motions, ..*self };
                        let rest = unexplained(&changed);
                        if rest < least {
                            least = rest;
                            self.motions = motions;
                            break;
                        }
                    }
                }
                if least > 0.98 * before {
                    break;
                }
            }
        }
    }

    /// The change from frame to frame in the middle of a dissolve, after the motion of the camera.
    /// A camera that moves over one scene shows different pictures at its two ends, but in the
    /// middle nothing other than motion.
    pub(super) fn change(&self, frames: &Range<usize>, window: &Window, layout: Layout) -> f32 {
        let speeds = self.motions.iter().map(|motion| motion.velocity);
        let speed = speeds
            .map(|[x, y]| x.abs().max(1.25 * y.abs()))
            .fold(0.1, f32::max);
        let span = (frames.len() / 3).min((FARTHEST / speed) as usize).max(1);
        let start = (frames.start + frames.end - span) / 2;
        match (window.get(start), window.get(start + span)) {
            (Some(a), Some(b)) => after_motion(a, b, layout).typical() / span as f32,
            _ => 0.0,
        }
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

    /// The correlation of both ends where they differ most: a logo or a box that stands over both
    /// shots is left out.
    pub(super) fn correlation(&self) -> f32 {
        let [a, b] = self.pictures;
        let mut cells: Vec<[f64; 6]> = (0..CELL_COUNT)
            .map(|index| products(a, b, cell(self.part, index)))
            .filter(|sums| sums[0] > 0.0)
            .collect();
        let apart = |[count, .., aa, ab, bb]: &[f64; 6]| (aa - 2.0 * ab + bb) / count;
        cells.sort_by(|first, second| apart(second).total_cmp(&apart(first)));
        cells.truncate((cells.len() as f32 * (1.0 - LEFT_OUT)).ceil() as usize);
        let sum = |term: usize| cells.iter().map(|sums| sums[term]).sum::<f64>();
        let [count, a, b, aa, ab, bb] = [0, 1, 2, 3, 4, 5].map(sum);
        let variances = (aa - a * a / count) * (bb - b * b / count);
        ((ab - a * b / count) / variances.max(1e-9).sqrt()) as f32
    }
}

/// How a picture is blended from two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blend {
    /// The fraction of the first.
    pub(super) fraction: f32,
    /// The root mean square of what the blend does not explain, relative to half the difference of
    /// the two pictures.
    pub(super) residual: f32,
}

impl Blend {
    /// Of a picture of which the ends show too little.
    const UNEXPLAINED: Self = Self {
        fraction: 0.5,
        residual: 2.0,
    };
}

/// Sums of products of the values a and b of both ends and of the value p of a picture.
#[derive(Clone, Copy, Debug, Default)]
struct Products {
    count: f32,
    aa: f32,
    ab: f32,
    bb: f32,
    pa: f32,
    pb: f32,
    pp: f32,
}

impl Products {
    fn add(&mut self, a: f32, b: f32, p: f32) {
        self.count += 1.0;
        self.aa += a * a;
        self.ab += a * b;
        self.bb += b * b;
        self.pa += p * a;
        self.pb += p * b;
        self.pp += p * p;
    }

    /// The weights u and v for which u a + v b is nearest to p over all.
    fn fit(all: &[&Self]) -> [f32; 2] {
        let sum = |value: fn(&Self) -> f32| -> f64 {
            all.iter().map(|cell| f64::from(value(cell))).sum()
        };
        let (aa, ab, bb) = (sum(|c| c.aa), sum(|c| c.ab), sum(|c| c.bb));
        let (pa, pb) = (sum(|c| c.pa), sum(|c| c.pb));
        let determinant = (aa * bb - ab * ab).max(1e-9 * (aa * bb).max(1e-9));
        let u = (pa * bb - pb * ab) / determinant;
        let v = (pb * aa - pa * ab) / determinant;
        [u as f32, v as f32]
    }

    /// The sum of (p − u a − v b)².
    fn rest(&self, [u, v]: [f32; 2]) -> f32 {
        let explained = u * (2.0 * self.pa - u * self.aa) + v * (2.0 * self.pb - v * self.bb);
        (self.pp - explained + 2.0 * u * v * self.ab).max(0.0)
    }

    fn mean_rest(&self, weights: [f32; 2]) -> f32 {
        self.rest(weights) / self.count
    }

    /// The sum of (a − b)² over all, after both were made equally bright.
    fn difference(all: &[&Self]) -> f32 {
        let sum = |value: fn(&Self) -> f32| -> f64 {
            all.iter().map(|cell| f64::from(value(cell))).sum()
        };
        let (aa, ab, bb) = (sum(|c| c.aa), sum(|c| c.ab), sum(|c| c.bb));
        ((aa + bb) * (1.0 - ab / (aa * bb).max(1e-12).sqrt())) as f32
    }
}
