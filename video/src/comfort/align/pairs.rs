//! The views that belong together.

use std::collections::VecDeque;
use std::mem;

use crate::stereo::StereoSource;
use crate::{Frame, VideoError};

/// Reads pairs of views: the right eye earlier by a delay.
pub(super) struct Pairs<'a> {
    source: &'a mut StereoSource,
    /// The frames of each eye before its first pair that are still to be left out.
    skipped: [u64; 2],
    /// Views that wait for the frame of the other eye.
    waiting: [VecDeque<Frame>; 2],
    /// Memory of frames.
    read: [Frame; 2],
}

impl<'a> Pairs<'a> {
    /// The right eye of the source is late by `delay` frames.
    pub(super) fn new(source: &'a mut StereoSource, delay: i64) -> Self {
        let late = delay.unsigned_abs();
        Self {
            source,
            skipped: if delay > 0 { [0, late] } else { [late, 0] },
            waiting: Default::default(),
            read: Default::default(),
        }
    }

    /// Reads the next pair. Returns whether there was one.
    pub(super) fn read(&mut self, views: &mut [Frame; 2]) -> Result<bool, VideoError> {
        while self.waiting.iter().any(VecDeque::is_empty) {
            if !self.source.read(&mut self.read)? {
                return Ok(false);
            }
            for (eye, waiting) in self.waiting.iter_mut().enumerate() {
                match self.skipped[eye] {
                    0 => waiting.push_back(mem::take(&mut self.read[eye])),
                    _ => self.skipped[eye] -= 1,
                }
            }
        }
        for (eye, waiting) in self.waiting.iter_mut().enumerate() {
            if let Some(frame) = waiting.pop_front() {
                // The memory of the frame before is used again.
                self.read[eye] = mem::replace(&mut views[eye], frame);
            }
        }
        Ok(true)
    }
}
