//! Where frames come from.

use super::{Frame, Properties};
use crate::VideoError;

/// A video that is read frame by frame.
pub trait Source {
    /// What all frames share.
    fn properties(&self) -> &Properties;

    /// Reads the next frame. Its memory is used again, so that a video of any length takes that of
    /// one frame. Returns whether there was a frame; `false` is the end, and after an error too
    /// there are no more frames.
    ///
    /// # Errors
    ///
    /// A [`VideoError`] with the number of the frame; [`VideoError::Empty`] at the end of a video
    /// without frames. What `frame` then holds is not specified.
    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError>;
}

impl<S: Source + ?Sized> Source for Box<S> {
    fn properties(&self) -> &Properties {
        (**self).properties()
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        (**self).read(frame)
    }
}
