//! Who is told what a video shows while it is analysed.

use super::{FrameMeasures, Record};
use crate::Frame;

/// Is told of each frame of a video twice: when its views have been measured, and when its record
/// is complete. Both come in the order of the frames.
///
/// ```
/// use ga_video::comfort::{FrameMeasures, Observer, Record};
/// use ga_video::Frame;
///
/// /// Keeps the frames whose record is not known yet.
/// #[derive(Default)]
/// struct Waiting(Vec<[Frame; 2]>);
///
/// impl Observer for Waiting {
///     fn measured(&mut self, views: &[Frame; 2], _: &FrameMeasures) {
///         self.0.push(views.clone());
///     }
///
///     fn complete(&mut self, record: Record) {
///         self.0.retain(|views| views[0].index > record.frame);
///     }
/// }
/// # let _ = Waiting::default();
/// ```
pub trait Observer {
    /// The views of a frame, left and right, and what they show by themselves. The record of the
    /// frame comes up to 28 frames later; it does not come if an error ends the analysis at this
    /// frame.
    fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures);

    /// All that is said of a frame.
    fn complete(&mut self, record: Record);
}

/// An observer that hands over records only.
pub(super) struct Each<F>(pub(super) F);

impl<F: FnMut(Record)> Observer for Each<F> {
    fn measured(&mut self, _: &[Frame; 2], _: &FrameMeasures) {}

    fn complete(&mut self, record: Record) {
        self.0(record);
    }
}
