//! The levels of 8 bits of two views: at one exposure, and spread where their contrast is small.

use ga_image::plane::PlaneView;
use ga_image::sample::Sample;
use rayon::join;

/// How the numbers of two views become levels.
pub(super) struct Exposed {
    /// The level of each number of 16 bits of the left and of the right view.
    pub(super) tables: [Vec<u8>; 2],
    /// Whether there are numbers between the levels of 8 bits.
    pub(super) is_fine: bool,
}

impl Exposed {
    /// The levels of the left view, and those of the right one at the exposure of the left.
    pub(super) fn new<T: Sample>([left, right]: [PlaneView<'_, T>; 2]) -> Self {
        let (left, right) = join(|| Histogram::new(left), || Histogram::new(right));
        let is_fine = left.is_fine() || right.is_fine();
        let stretch = match is_fine {
            true => Stretch::new(&left, &right),
            false => Stretch::default(),
        };
        let exposure = Exposure::new(&left, &right, stretch.gain);
        Self {
            tables: [
                table(|level| stretch.apply(level)),
                table(|level| stretch.apply(exposure.apply(level))),
            ],
            is_fine,
        }
    }
}

/// The numbers of 16 bits in a level of 8: 65535 / 255.
pub(super) const IN_A_LEVEL: usize = 257;

/// The level of each number of 16 bits, from the level with its fraction.
fn table(level: impl Fn(f64) -> f64) -> Vec<u8> {
    let levels = (0..=u16::MAX).map(|number| f64::from(number) / IN_A_LEVEL as f64);
    // The conversion saturates.
    levels.map(|before| (level(before) + 0.5) as u8).collect()
}

/// How often each number of 16 bits occurs in a view.
struct Histogram {
    counts: Vec<u32>,
    pixels: usize,
}

impl Histogram {
    fn new<T: Sample>(plane: PlaneView<'_, T>) -> Self {
        let mut counts = vec![0u32; 1 << 16];
        for row in plane.rows() {
            for value in row {
                counts[usize::from(value.to_u16())] += 1;
            }
        }
        Self {
            counts,
            pixels: plane.width() * plane.height(),
        }
    }

    /// Whether there are numbers between the levels of 8 bits.
    fn is_fine(&self) -> bool {
        let mut counts = self.counts.iter().enumerate();
        counts.any(|(number, count)| *count > 0 && number % IN_A_LEVEL != 0)
    }

    /// The levels that occur, with how many pixels have them.
    fn levels(&self) -> impl Iterator<Item = (f64, f64)> {
        let counts = self
            .counts
            .iter()
            .enumerate()
            .filter(|(_, count)| **count > 0);
        counts.map(|(number, count)| (number as f64 / IN_A_LEVEL as f64, f64::from(*count)))
    }

    /// The mean and the standard deviation of the levels.
    fn moments(&self) -> (f64, f64) {
        let count = self.pixels.max(1) as f64;
        let moment = |power: i32, origin: f64| -> f64 {
            let terms = self
                .levels()
                .map(|(level, n)| n * (level - origin).powi(power));
            terms.sum::<f64>() / count
        };
        let mean = moment(1, 0.0);
        (mean, moment(2, mean).sqrt())
    }
}

/// Levels of views whose contrast is below that of usual views of 8 bits are spread, so that what
/// differs in their numbers differs in their levels.
struct Stretch {
    gain: f64,
    low: f64,
    offset: f64,
}

impl Default for Stretch {
    fn default() -> Self {
        Self {
            gain: 1.0,
            low: 0.0,
            offset: 0.0,
        }
    }
}

impl Stretch {
    /// Brings all but 0.1 % at either end of the levels of two views to a range of 128 levels in
    /// the middle, where they have a smaller one.
    fn new(left: &Histogram, right: &Histogram) -> Self {
        const RANGE: f64 = 128.0;
        const BEYOND: f64 = 0.001;
        let beyond = BEYOND * (left.pixels + right.pixels) as f64;
        let counts = || {
            left.counts
                .iter()
                .zip(&right.counts)
                .map(|(a, b)| f64::from(*a + *b))
        };
        let end = |found: Option<usize>| found.unwrap_or(0) as f64 / IN_A_LEVEL as f64;
        let mut below = 0.0;
        let is_low = |count: f64| {
            below += count;
            below > beyond
        };
        let low = end(counts().position(is_low));
        let mut above = 0.0;
        let is_high = |count: f64| {
            above += count;
            above > beyond
        };
        let last = usize::from(u16::MAX);
        let high = end(counts().rev().position(is_high).map(|place| last - place));
        if high <= low || high - low >= RANGE {
            return Self::default();
        }
        Self {
            gain: RANGE / (high - low),
            low,
            offset: 0.5 * (255.0 - RANGE),
        }
    }

    fn apply(&self, level: f64) -> f64 {
        self.offset + self.gain * (level - self.low)
    }
}

/// What brings the right view to the exposure of the left: the gain and the offset for which means
/// and standard deviations agree.
struct Exposure {
    mean_left: f64,
    mean_right: f64,
    gain: f64,
    /// Nothing is changed.
    same: bool,
}

impl Exposure {
    /// Where the gain is within 6 % of 1 and the means are within 6 levels, counted after a
    /// stretch, nothing is changed: such differences come from what only one view shows.
    fn new(left: &Histogram, right: &Histogram, stretch: f64) -> Self {
        let ((mean_left, deviation_left), (mean_right, deviation_right)) =
            join(|| left.moments(), || right.moments());
        let gain = match stretch * deviation_right > 0.5 && stretch * deviation_left > 0.5 {
            true => deviation_left / deviation_right,
            false => 1.0,
        };
        let apart = stretch * (mean_left - mean_right).abs();
        Self {
            mean_left,
            mean_right,
            gain,
            same: (gain - 1.0).abs() <= 0.06 && apart <= 6.0,
        }
    }

    fn apply(&self, level: f64) -> f64 {
        match self.same {
            true => level,
            false => self.mean_left + self.gain * (level - self.mean_right),
        }
    }
}
