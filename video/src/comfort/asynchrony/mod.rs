//! How many frames one eye is late.
//!
//! The change of the right picture from frame to frame is compared with that of the left one up to
//! 12 frames earlier and later. Both are reduced to 100 × 54 numbers and divided into 6 blocks; in
//! each block the translation of the left picture that explains most of the change is taken, up to
//! 14 % of the width and 3.7 % of the height, since parallax and vertical errors are not known
//! here. A motion that is constant therefore shows no delay: it cannot be told from parallax, or
//! from a vertical error.
//!
//! The delay of a frame is measured over the frames up to 16 before and after it, so it is known 28
//! frames later. No frame counts more than three quarters of them do: encoders refresh the pictures
//! of both eyes at the same moments, however late one of them is. The delay is measured if the left
//! eye explains at least 30 % of the changes, if every delay that differs by two frames or more
//! explains clearly less, and if the result is certain to 0.12 frames: the standard error when
//! parts of the window and blocks are left out in turn (jackknife; Efron and Tibshirani 1993).
//! Measured settings of our own.

mod decision;
mod delay;
mod products;
mod reduction;

use std::collections::VecDeque;

use ga_image::plane::Plane;

use crate::Samples;
pub use decision::REACH;
pub use delay::{Asynchrony, Delay};

use decision::{Row, Window};
use products::{Change, Products};

/// The number of frames before a frame, and after it, that are in its window.
pub const HALF_WINDOW: usize = 16;

/// Measures the delay at each frame of a video. Memory does not depend on its length.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::comfort::asynchrony::AsynchronyMeter;
/// use ga_video::{Planes, Samples};
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
    /// How much the left and the right eye change at the frames from `first_energy` on.
    energies: VecDeque<[f32; 2]>,
    first_energy: usize,
    /// The next frame whose delay is not yet given.
    next: usize,
    /// The frames at which the eyes are exchanged.
    exchanges: VecDeque<usize>,
}

/// An exchange of the eyes counts in a decision if it lies at least this number of frames before
/// the newest frame that the decision waits for: [`AsynchronyMeter::exchange`] may be as late.
const LATE: usize = 4;

impl AsynchronyMeter {
    /// Takes the next frame of both eyes. Returns the delay at the frame 28 before it, if there is
    /// one.
    pub fn push(&mut self, left: &Samples, right: &Samples) -> Option<Asynchrony> {
        let now = [left, right].map(reduction::reduced);
        let before = self.previous.replace(now.clone()).unwrap_or(now.clone());
        for ((changes, before), now) in self.changes.iter_mut().zip(&before).zip(&now) {
            if changes.len() > REACH {
                changes.pop_front();
            }
            changes.push_back(Change::between(before, now));
        }
        let energies = self.changes.each_ref().map(|changes| {
            let newest = changes.back();
            newest.map_or(0.0, |change| change.energy)
        });
        self.energies.push_back(energies);
        self.frames += 1;
        self.compare();
        (self.frames > self.next + HALF_WINDOW + REACH).then(|| self.decide())
    }

    /// Says that the eyes are exchanged from a frame on: what was late is early then, and the
    /// frames before it say nothing on those after it. Frames are counted from 0 in the order in
    /// which they are taken; it may be one of the last four.
    pub fn exchange(&mut self, frame: usize) {
        self.exchanges.push_back(frame);
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
        let frame = self.next;
        self.next += 1;
        let mut start = frame.saturating_sub(HALF_WINDOW);
        while self.first < start {
            self.rows.pop_front();
            self.first += 1;
        }
        while self.first_energy + REACH < start {
            self.energies.pop_front();
            self.first_energy += 1;
        }
        while self.exchanges.get(1).is_some_and(|next| *next <= frame) {
            self.exchanges.pop_front();
        }
        // The change to exchanged eyes belongs to neither side.
        let known = frame + HALF_WINDOW + REACH - LATE;
        let exchanges = self.exchanges.iter().filter(|exchange| **exchange <= known);
        let mut part = 0..usize::MAX;
        for exchange in exchanges {
            match *exchange <= frame {
                true => part.start = exchange + 1,
                false => part.end = part.end.min(*exchange),
            }
        }
        start = start.max(part.start).max(self.first);
        let end = (frame + HALF_WINDOW + 1).min(self.frames).min(part.end);
        let rows = self.rows.iter().skip(start - self.first);
        let window = Window {
            rows: (start..end).zip(rows),
            part,
            energies: &self.energies,
            first_energy: self.first_energy,
        };
        decision::decide(&window)
    }
}
