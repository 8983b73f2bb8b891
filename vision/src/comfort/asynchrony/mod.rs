//! How many frames one eye is late.
//!
//! The change of the right picture from frame to frame is compared with that of the left one up to
//! 12 frames earlier and later. Both are reduced to 100 × 54 boxes and divided into 6 blocks; in
//! each block the translation of the left picture that explains most of the change is taken, up to
//! 14 % of the width and 3.7 % of the height, since parallax and vertical errors are not known
//! here. A motion that is constant and horizontal therefore shows no delay: it cannot be told from
//! parallax.
//!
//! The delay of a frame is measured over the frames up to 16 before and after it, so it is known 28
//! frames later. It is measured if the left eye explains at least 30 % of the changes, if every
//! delay that differs by two frames or more explains clearly less, and if the result is certain to
//! 0.12 frames: the standard error when parts of the window and blocks are left out in turn
//! (jackknife; Efron and Tibshirani 1993). Measured settings of our own.

mod decision;
mod products;

use std::collections::VecDeque;

use ga_image::plane::Plane;

use crate::video::Samples;
use decision::Row;
use products::{Change, Products};

/// The greatest delay that is tried, in frames either way.
pub const REACH: usize = 12;
const LAGS: usize = 2 * REACH + 1;

/// So many frames before and after a frame are in its window.
pub const HALF_WINDOW: usize = 16;

/// The delay of the right eye at a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Asynchrony {
    /// It is known.
    Measured(Delay),
    /// The pictures hardly change, or in a few frames only.
    NoMotion,
    /// The changes of one eye do not explain those of the other.
    Unrelated,
    /// Several delays explain them nearly equally well, as in repeated or constant motion.
    Ambiguous,
}

/// A measured delay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delay {
    /// How many frames the right eye is late; negative when the left one is late.
    pub frames: f64,
    /// The standard error, without that of the interpolation between frames.
    pub uncertainty_frames: f64,
}

impl Asynchrony {
    /// The delay, where it is known.
    #[must_use]
    pub fn delay(&self) -> Option<Delay> {
        match self {
            Self::Measured(delay) => Some(*delay),
            Self::NoMotion | Self::Unrelated | Self::Ambiguous => None,
        }
    }
}

/// Measures the delay at each frame of a video. Memory does not depend on its length.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::comfort::asynchrony::AsynchronyMeter;
/// use ga_vision::video::{Planes, Samples};
///
/// // A texture that moves to and fro and up and down; the right eye is two frames late.
/// let view = |frame: f64| {
///     let (x, y) = (9.0 * (0.3 * frame).sin(), 7.0 * (0.23 * frame).cos());
///     let luma = Plane::from_fn(200, 108, |column, row| {
///         let (u, v) = (column as f64 + x, row as f64 + y);
///         (128.0 + 50.0 * (0.31 * u + 2.0 * (0.07 * v).sin()).sin() * (0.23 * v).cos()) as u8
///     });
///     Samples::Eight(Planes { luma, ..Planes::default() })
/// };
/// let mut meter = AsynchronyMeter::default();
/// let mut delays = Vec::new();
/// for frame in 0..40 {
///     let frame = f64::from(frame);
///     delays.extend(meter.push(&view(frame), &view(frame - 2.0)));
/// }
/// delays.extend(meter.finish());
/// assert_eq!(delays.len(), 40);
/// let delay = delays[20].delay().unwrap();
/// assert!((delay.frames - 2.0).abs() < 0.1);
/// ```
#[derive(Debug, Default)]
pub struct AsynchronyMeter {
    previous: Option<[Plane<f32>; 2]>,
    /// The last changes of the left and of the right eye; the newest is last.
    changes: [VecDeque<Change>; 2],
    /// The number of frames so far.
    frames: usize,
    rows: VecDeque<Row>,
    /// The number of the frame of the first row.
    first: usize,
    /// The next frame whose delay is not yet given.
    next: usize,
}

impl AsynchronyMeter {
    /// Takes the next frame of both eyes. Returns the delay at the frame 28 before it, if there is
    /// one.
    pub fn push(&mut self, left: &Samples, right: &Samples) -> Option<Asynchrony> {
        let now = [products::reduced(left), products::reduced(right)];
        let before = self.previous.replace(now.clone()).unwrap_or(now.clone());
        for ((changes, before), now) in self.changes.iter_mut().zip(&before).zip(&now) {
            if changes.len() > REACH {
                changes.pop_front();
            }
            changes.push_back(Change::between(before, now));
        }
        self.frames += 1;
        self.compare();
        (self.frames > self.next + HALF_WINDOW + REACH).then(|| self.decide())
    }

    /// The delays at the frames that were not given yet, in order; for the end of the video.
    pub fn finish(&mut self) -> Vec<Asynchrony> {
        let rest = self.next..self.frames;
        rest.map(|_| self.decide()).collect()
    }

    /// Multiplies the changes of the newest frame with those before it.
    fn compare(&mut self) {
        self.rows.push_back(Default::default());
        let [lefts, rights] = &self.changes;
        let (Some(left), Some(right)) = (lefts.back(), rights.back()) else {
            return;
        };
        let newest = self.rows.len() - 1;
        for (lag, earlier) in lefts.iter().rev().enumerate() {
            self.rows[newest][REACH + lag] = Some(Products::of(earlier, right));
        }
        for (lag, earlier) in rights.iter().rev().enumerate().skip(1) {
            if let Some(row) = newest.checked_sub(lag) {
                self.rows[row][REACH - lag] = Some(Products::of(left, earlier));
            }
        }
    }

    /// The delay at the next frame.
    fn decide(&mut self) -> Asynchrony {
        let (start, end) = (
            self.next.saturating_sub(HALF_WINDOW),
            self.next + HALF_WINDOW + 1,
        );
        while self.first < start {
            self.rows.pop_front();
            self.first += 1;
        }
        self.next += 1;
        let rows = self.rows.iter().take(end - self.first).enumerate();
        decision::decide(rows.map(|(index, row)| (self.first + index, row)))
    }
}
