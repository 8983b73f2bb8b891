//! How far in front of the screen and behind it points appear.

use super::geometry::median_deviation;
use super::matching::Match;
use super::viewing::Viewing;
use ga_numerics::order_statistics::median;
use serde::{Deserialize, Serialize};

/// The parallax x_R − x_L of points that both views show, in pixels: negative, or crossed, in front
/// of the screen, positive, or uncrossed, behind it.
///
/// Points count whose parallax agrees with that of points near them, since those of repeated
/// textures are confused singly. The ends are reached by enough points in several parts of the
/// picture: by 2 % of all, four at least, in four of 16 × 9 parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Parallax {
    /// The greatest parallax of the nearest points.
    pub near_px: f64,
    /// The median.
    pub median_px: f64,
    /// The least parallax of the farthest points.
    pub far_px: f64,
    /// Columns of the picture.
    width: usize,
    /// How many points have which parallax.
    pub histogram: Histogram,
}

/// How many points count as those near a point, and how many of them must agree with it.
const NEAR: usize = 8;
const LEAST_AGREEING: usize = 2;

/// Parallaxes agree that differ by at most this part of the width, or by this part of the distance
/// of the points: surfaces that are seen well are not steeper.
const SAME: f64 = 0.01;
const STEEPEST: f64 = 0.2;

/// The part of the points that reach an end, their least number, and in how many of how many parts
/// of the picture they are at least.
const END: f64 = 0.02;
const LEAST_POINTS: usize = 4;
const LEAST_PARTS: usize = 4;
const PARTS: [usize; 2] = [16, 9];

/// A point of the left view, and its parallax.
#[derive(Clone, Copy)]
struct Point {
    place: [f64; 2],
    parallax: f64,
}

impl Parallax {
    /// The parallax of matches in views of this size, with the distance of their rows from what
    /// they should be. Matches that are clearly farther than others are confused points. `None`
    /// where less than half of the rest agree with those near them.
    pub(super) fn new(matches: &[Match], distances: &[f64], size: [usize; 2]) -> Option<Self> {
        const DEVIATIONS: f64 = 5.0;
        const LEAST_DEVIATION: f64 = 0.05;
        let deviation = median_deviation(distances.to_vec()).max(LEAST_DEVIATION);
        let pairs = matches.iter().zip(distances);
        let clear = pairs.filter(|(_, distance)| **distance <= DEVIATIONS * deviation);
        let all: Vec<Point> = clear
            .map(|(found, _)| Point {
                place: found.left,
                parallax: found.right[0] - found.left[0],
            })
            .collect();
        let width = size[0];
        let agrees = |point: &&Point| agrees(point, &all, width as f64);
        let mut points: Vec<Point> = all.iter().filter(agrees).copied().collect();
        if points.is_empty() || 2 * points.len() < all.len() {
            return None;
        }
        points.sort_by(|a, b| a.parallax.total_cmp(&b.parallax));
        let mut histogram = Histogram::default();
        for point in &points {
            histogram.add(100.0 * point.parallax / width as f64);
        }
        let mut numbers: Vec<f64> = points.iter().map(|point| point.parallax).collect();
        Some(Self {
            near_px: end(points.iter(), size)?,
            median_px: median(&mut numbers)?,
            far_px: end(points.iter().rev(), size)?,
            width,
            histogram,
        })
    }

    /// The median disparity x_L − x_R in pixels, as matchers of rectified views count it: the
    /// negative of the median parallax.
    #[must_use]
    pub fn median_disparity_px(&self) -> f64 {
        // Not −0.
        0.0 - self.median_px
    }

    /// A length in pixels of the picture, in per cent of its width.
    #[must_use]
    pub fn percent(&self, pixels: f64) -> f64 {
        100.0 * pixels / self.width as f64
    }

    /// The range from the nearest to the farthest points, in per cent of the picture's width.
    #[must_use]
    pub fn range_percent(&self) -> f64 {
        self.percent(self.far_px - self.near_px)
    }

    /// By how much the eyes converge more on the nearest points than on the screen, in degrees; 0
    /// where none is in front of it.
    #[must_use]
    pub fn crossed_degrees(&self, viewing: &Viewing) -> f64 {
        (-viewing.degrees_of_parallax(self.percent(self.near_px))).max(0.0)
    }

    /// By how much the eyes converge less on the farthest points than on the screen, in degrees; 0
    /// where none is behind it.
    #[must_use]
    pub fn uncrossed_degrees(&self, viewing: &Viewing) -> f64 {
        viewing
            .degrees_of_parallax(self.percent(self.far_px))
            .max(0.0)
    }
}

/// Whether enough of the points nearest to a point agree with it.
fn agrees(point: &Point, all: &[Point], width: f64) -> bool {
    // Squared distances and parallaxes, from the nearest one; the first is the point itself.
    let mut near = [(f64::INFINITY, f64::NAN); NEAR + 1];
    for other in all {
        let [x, y] = [0, 1].map(|axis| other.place[axis] - point.place[axis]);
        let squared = x * x + y * y;
        if squared < near[NEAR].0 {
            let index = near.partition_point(|(before, _)| *before <= squared);
            near[index..].rotate_right(1);
            near[index] = (squared, other.parallax);
        }
    }
    let is_same = |(squared, parallax): &&(f64, f64)| {
        let tolerated = (SAME * width).max(STEEPEST * squared.sqrt());
        (parallax - point.parallax).abs() <= tolerated
    };
    near[1..].iter().filter(is_same).count() >= LEAST_AGREEING
}

/// The parallax at which enough points, from an end on, have been passed in enough parts of the
/// picture.
fn end<'a>(
    points: impl ExactSizeIterator<Item = &'a Point> + Clone,
    size: [usize; 2],
) -> Option<f64> {
    let part = |point: &Point| {
        let [column, row] = [0, 1].map(|axis| {
            let part = point.place[axis] / size[axis] as f64 * PARTS[axis] as f64;
            // A cast from float saturates.
            (part as usize).min(PARTS[axis] - 1)
        });
        row * PARTS[0] + column
    };
    let mut seen = [false; PARTS[0] * PARTS[1]];
    points.clone().for_each(|point| seen[part(point)] = true);
    let occupied = seen.iter().filter(|seen| **seen).count();
    let parts = LEAST_PARTS.min(occupied.div_ceil(2));
    let least = ((END * points.len() as f64).ceil() as usize).max(LEAST_POINTS);
    let least = least.min(points.len().div_ceil(2));
    seen.fill(false);
    let (mut count, mut passed) = (0, 0);
    let last = points.clone().find(|point| {
        passed += usize::from(!std::mem::replace(&mut seen[part(point)], true));
        count += 1;
        count >= least && passed >= parts
    });
    last.map(|point| point.parallax)
}

/// Counts of points by parallax, in equal intervals of the picture's width.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Vec<u32>", into = "Vec<u32>")]
pub struct Histogram {
    counts: [u32; Self::INTERVALS],
}

impl Default for Histogram {
    fn default() -> Self {
        Self {
            counts: [0; Self::INTERVALS],
        }
    }
}

impl From<Histogram> for Vec<u32> {
    fn from(histogram: Histogram) -> Self {
        histogram.counts.to_vec()
    }
}

impl TryFrom<Vec<u32>> for Histogram {
    type Error = String;

    fn try_from(counts: Vec<u32>) -> Result<Self, String> {
        let counts = counts.try_into();
        let counts = counts.map_err(|other: Vec<u32>| format!("{} intervals", other.len()))?;
        Ok(Self { counts })
    }
}

impl Histogram {
    /// The number of intervals.
    pub const INTERVALS: usize = 176;

    /// The parallax at which the first interval begins, and the last one ends at its negative, in
    /// per cent of the picture's width. What is outside counts in the first and in the last one.
    pub const FIRST_PERCENT: f64 = -22.0;

    /// The length of an interval in per cent of the picture's width.
    pub const INTERVAL_PERCENT: f64 = -2.0 * Self::FIRST_PERCENT / Self::INTERVALS as f64;

    /// The number of points in each interval, from crossed to uncrossed parallax.
    #[must_use]
    pub fn counts(&self) -> &[u32; Self::INTERVALS] {
        &self.counts
    }

    /// The parallax in the middle of an interval, in per cent of the picture's width.
    #[must_use]
    pub fn middle_percent(index: usize) -> f64 {
        Self::FIRST_PERCENT + (index as f64 + 0.5) * Self::INTERVAL_PERCENT
    }

    /// Adds the counts of another histogram.
    pub fn merge(&mut self, other: &Self) {
        for (count, more) in self.counts.iter_mut().zip(other.counts) {
            *count = count.saturating_add(more);
        }
    }

    fn add(&mut self, percent: f64) {
        let index = (percent - Self::FIRST_PERCENT) / Self::INTERVAL_PERCENT;
        // A negative number becomes 0.
        self.counts[(index as usize).min(Self::INTERVALS - 1)] += 1;
    }
}
