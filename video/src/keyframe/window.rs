//! The signatures of the last frames.

use std::collections::VecDeque;

use ga_image::plane::Plane;

/// The last signatures of a video, by the number of their frame.
#[derive(Clone, Debug)]
pub struct Window {
    signatures: VecDeque<Plane<f32>>,
    first: usize,
    most: usize,
}

impl Window {
    /// A window of at most this number of frames.
    #[must_use]
    pub fn new(most: usize) -> Self {
        Self {
            signatures: VecDeque::with_capacity(most),
            first: 0,
            most,
        }
    }

    /// Adds the signature of the next frame; the oldest is dropped where the window is full.
    pub fn push(&mut self, signature: Plane<f32>) {
        if self.signatures.len() == self.most {
            self.signatures.pop_front();
            self.first += 1;
        }
        self.signatures.push_back(signature);
    }

    /// The signature of a frame, while it is in the window.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<&Plane<f32>> {
        self.signatures.get(index.checked_sub(self.first)?)
    }

    /// The number of the frame after the last.
    #[must_use]
    pub fn end(&self) -> usize {
        self.first + self.signatures.len()
    }
}
