//! What is said of a video over time.

use super::{Histogram, Parallax, Record, Summary};

/// The rows of the table, and the depth, over equal intervals of time. Memory does not depend on
/// the length of the video.
///
/// Up to [`MOST`](Self::MOST) frames each of them is an interval. In a longer video intervals have
/// a fifth of a second, then a second, then two, four and so on: the shortest of which there are at
/// most [`MOST`](Self::MOST). Three hours have intervals of 32 seconds.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{self, Film};
/// use ga_video::comfort::monitor::{Options, analyse};
/// use ga_video::comfort::{Timeline, Viewing};
/// use ga_video::stereo::{Layout, StereoSource};
/// use ga_video::y4m::Y4mSource;
///
/// // 600 grey frames: 24 seconds in fifths.
/// let wide = Plane::filled(8, 4, [128u8; 3]);
/// let bytes = y4m::encode(vec![&wide; 600], Film::default())?;
/// let video = Y4mSource::new(std::io::Cursor::new(bytes), "grey.y4m")?;
/// let mut views = StereoSource::halves(Box::new(video), Layout::SideBySide)?;
/// let options = Options { viewing: Viewing::default(), layout: None, threads: 1 };
/// let mut timeline = Timeline::default();
/// analyse(&mut views, options, |record| timeline.add(&record))?;
/// assert_eq!(timeline.seconds(), Some(0.2));
/// assert_eq!(timeline.intervals().len(), 120);
/// assert!(timeline.intervals().iter().all(|found| found.summary.frames == 5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Timeline {
    /// The length of intervals in fifths of a second; 0 for single frames.
    fifths: u64,
    intervals: Vec<Interval>,
}

/// The frames of one interval; there is at least one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Interval {
    /// Which interval it is, counted from the beginning of the video; those without frames are
    /// counted too. The number of the frame where intervals are single frames.
    pub place: u64,
    /// The first frame.
    pub first_frame: usize,
    /// When the first frame is shown, in seconds after the first frame of the video.
    pub start_seconds: f64,
    /// The rows.
    pub summary: Summary,
    /// How many points have which parallax.
    pub histogram: Histogram,
    /// The range of parallax; `None` where no frame shows it.
    pub depth: Option<DepthSummary>,
}

/// Parallax over several frames, in per cent of the picture's width; positive behind the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthSummary {
    /// The frames in which it is known.
    pub frames: usize,
    /// The least of their [near ends](Parallax::near_px).
    pub nearest: f64,
    /// The greatest of their [far ends](Parallax::far_px).
    pub farthest: f64,
    sums: [f64; 3],
}

impl Timeline {
    /// The greatest number of intervals.
    pub const MOST: usize = 480;

    /// Adds the next frame.
    pub fn add(&mut self, record: &Record) {
        let place = self.place(record.frame, record.time_seconds);
        let mut interval = Interval {
            place,
            first_frame: record.frame,
            start_seconds: record.time_seconds,
            ..Interval::default()
        };
        interval.summary.add(record);
        if let Some(parallax) = &record.measures.parallax {
            interval.histogram = parallax.histogram.clone();
            interval.depth = Some(DepthSummary::of(parallax));
        }
        push(&mut self.intervals, interval);
        while self.intervals.len() > Self::MOST {
            self.fifths = match self.fifths {
                0 => 1,
                1 => 5,
                more => more.saturating_mul(2),
            };
            for mut interval in std::mem::take(&mut self.intervals) {
                interval.place = self.place(interval.first_frame, interval.start_seconds);
                push(&mut self.intervals, interval);
            }
        }
    }

    /// The intervals that have frames, in their order.
    #[must_use]
    pub fn intervals(&self) -> &[Interval] {
        &self.intervals
    }

    /// The nearest and the farthest points of all, as parallax in per cent of the picture's width;
    /// `None` where no frame shows it.
    #[must_use]
    pub fn ends(&self) -> Option<[f64; 2]> {
        let depths = self.intervals.iter().filter_map(|interval| interval.depth);
        let all = depths.reduce(|all, depth| all.merged(&depth))?;
        Some([all.nearest, all.farthest])
    }

    /// The length of each interval in seconds; `None` where they are single frames.
    #[must_use]
    pub fn seconds(&self) -> Option<f64> {
        (self.fifths > 0).then(|| self.fifths as f64 / 5.0)
    }

    fn place(&self, frame: usize, seconds: f64) -> u64 {
        // Times such as 0.6 are a little less than three fifths. A cast from float saturates.
        match self.fifths {
            0 => frame as u64,
            fifths => (5.0 * seconds + 1e-6) as u64 / fifths,
        }
    }
}

/// Adds an interval, or its frames to the last one where it is the same.
fn push(intervals: &mut Vec<Interval>, interval: Interval) {
    match intervals.last_mut() {
        Some(last) if last.place >= interval.place => last.merge(&interval),
        _ => intervals.push(interval),
    }
}

impl Interval {
    /// Adds later frames.
    fn merge(&mut self, later: &Self) {
        self.summary.merge(&later.summary);
        self.histogram.merge(&later.histogram);
        self.depth = match (self.depth, later.depth) {
            (Some(depth), Some(more)) => Some(depth.merged(&more)),
            (depth, more) => depth.or(more),
        };
    }
}

impl DepthSummary {
    /// The means over the frames of the near end, the median and the far end.
    #[must_use]
    pub fn means(&self) -> [f64; 3] {
        self.sums.map(|sum| sum / self.frames as f64)
    }

    fn of(parallax: &Parallax) -> Self {
        let sums =
            [parallax.near_px, parallax.median_px, parallax.far_px].map(|px| parallax.percent(px));
        Self {
            frames: 1,
            nearest: sums[0],
            farthest: sums[2],
            sums,
        }
    }

    fn merged(&self, other: &Self) -> Self {
        Self {
            frames: self.frames + other.frames,
            nearest: self.nearest.min(other.nearest),
            farthest: self.farthest.max(other.farthest),
            sums: std::array::from_fn(|k| self.sums[k] + other.sums[k]),
        }
    }
}
