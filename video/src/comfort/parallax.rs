//! How far in front of the screen and behind it points appear.

use super::geometry::median_deviation;
use super::matching::Match;
use super::viewing::Viewing;
use ga_numerics::order_statistics::Sorted;

/// The parallax x_R − x_L of points that both views show, in pixels: negative, or crossed, in front
/// of the screen, positive, or uncrossed, behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct Parallax {
    /// The parallax below which 2 % of the points are: the nearest ones.
    pub near_px: f64,
    /// The median.
    pub median_px: f64,
    /// The parallax below which 98 % of the points are: the farthest ones.
    pub far_px: f64,
    /// Columns of the picture.
    width: usize,
    /// How many points have which parallax.
    pub histogram: Histogram,
}

impl Parallax {
    /// The parallax of matches, with the distance in pixels of their rows from what they should be.
    /// Matches that are clearly farther than others are confused points: they count elsewhere, but
    /// the nearest and the farthest points are few.
    pub(super) fn new(
        matches: &[Match],
        distances: &[f64],
        width: usize,
        memory: &mut Vec<f64>,
    ) -> Option<Self> {
        const DEVIATIONS: f64 = 5.0;
        const LEAST_DEVIATION: f64 = 0.05;
        let deviation = median_deviation(distances.to_vec()).max(LEAST_DEVIATION);
        let pairs = matches.iter().zip(distances);
        let clear = pairs.filter(|(_, distance)| **distance <= DEVIATIONS * deviation);
        memory.clear();
        memory.extend(clear.map(|(found, _)| found.right[0] - found.left[0]));
        let sorted = Sorted::new(memory).filter(|_| width > 0)?;
        let mut histogram = Histogram::default();
        for parallax in sorted.values() {
            histogram.add(100.0 * parallax / width as f64);
        }
        let [near_px, median_px, far_px] = [0.02, 0.5, 0.98].map(|share| sorted.quantile(share));
        Some(Self {
            near_px,
            median_px,
            far_px,
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

/// Counts of points by parallax, in equal intervals of the picture's width.
#[derive(Clone, Debug, PartialEq, Eq)]
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
