//! Pictures between the ends of a dissolve as blends of both.

use std::ops::Range;

use ga_image::plane::Plane;

use super::difference::after_motion;
use super::layout::{CELL_COUNT, Layout, Rectangle, cell, without_bars};
use super::window::Window;

/// The number of frames before the first end, and after the second, that say how the camera moves
/// there.
pub(super) const MOTION: usize = 5;

/// The farthest motion over which this is measured, in boxes.
const FARTHEST: f32 = 5.0;

/// The part of cells that a blend need not explain.
const LEFT_OUT: f32 = 0.3;

/// The frames at both ends of a dissolve, and how the camera moves at each.
pub(super) struct Ends<'a> {
    pictures: [&'a Plane<f32>; 2],
    at: [usize; 2],
    velocities: [[f32; 2]; 2],
    part: Rectangle<usize>,
}

impl<'a> Ends<'a> {
    pub(super) fn new(at: [usize; 2], window: &'a Window, layout: Layout) -> Option<Self> {
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

    /// How the picture of a frame is blended from both ends, each moved to its place: u A + v B by
    /// least squares, where u + v is the brightness and u / (u + v) the fraction of the first end.
    /// The cells that are explained worst are left out: captions and logos. Every second box of
    /// every second row counts, where both moved ends have boxes.
    pub(super) fn blend(&self, picture: &Plane<f32>, index: usize) -> Blend {
        let moved = [0, 1].map(|end| {
            let frames = index as f32 - self.at[end] as f32;
            self.velocities[end].map(|velocity| velocity * frames)
        });
        let mut cells = [Products::default(); CELL_COUNT];
        for (index, products) in cells.iter_mut().enumerate() {
            let place = cell(self.part, index);
            for row in (place.top..place.bottom).step_by(2) {
                let line = picture.row(row);
                for column in (place.left..place.right).step_by(2) {
                    let ends = [0, 1].map(|end| {
                        let (x, y) = (column as f32 - moved[end][0], row as f32 - moved[end][1]);
                        self.between(self.pictures[end], x, y)
                    });
                    if let [Some(a), Some(b)] = ends {
                        products.add(a, b, line[column]);
                    }
                }
            }
        }
        let mut kept: Vec<&Products> = cells.iter().filter(|cell| cell.count > 0.0).collect();
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

    /// The change from frame to frame in the middle of a dissolve, after the motion of the camera.
    /// A camera that moves over one scene shows different pictures at its two ends, but in the
    /// middle nothing other than motion.
    pub(super) fn change(&self, frames: &Range<usize>, window: &Window, layout: Layout) -> f32 {
        let speeds = self.velocities.iter();
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
            .map(|index| {
                let place = cell(self.part, index);
                let mut sums = [0.0; 6];
                for row in place.top..place.bottom {
                    let columns = place.left..place.right;
                    for (a, b) in a.row(row)[columns.clone()].iter().zip(&b.row(row)[columns]) {
                        let (a, b) = (f64::from(*a), f64::from(*b));
                        let terms = [1.0, a, b, a * a, a * b, b * b];
                        sums.iter_mut()
                            .zip(terms)
                            .for_each(|(sum, term)| *sum += term);
                    }
                }
                sums
            })
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
