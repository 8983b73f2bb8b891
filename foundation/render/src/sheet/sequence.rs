//! The frames of an animation one after the other.

use super::framing::{Outline, Stage};
use super::{Frame, Options, SheetError, Subject};
use crate::{Rendering, Style};

/// The cameras of a sequence of frames: with one direction and one scale, chosen so that the whole
/// figure with its shadow is in every picture, as on a [contact sheet](super::contact_sheet).
///
/// The frames are given twice, first for the cameras and then to be drawn, so that only one of them
/// need be in memory at a time.
///
/// ```
/// use ga_render::sheet::{Sequence, Frame, Kind, Options, Subject};
///
/// let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// let corners = |x: f64| [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
/// let mut sequence = Sequence::new(Options::default());
/// for step in 0..3 {
///     let positions = corners(0.1 * f64::from(step));
///     sequence.add(&Frame::new(step as usize, &positions))?;
/// }
/// let shooting = sequence.shoot(Subject::new(&triangles))?;
/// let picture = shooting.picture(2, &Frame::new(2, &corners(0.2)))?;
/// assert_eq!([picture.colour.width(), picture.colour.height()], [240, 320]);
/// # Ok::<(), ga_render::sheet::SheetError>(())
/// ```
pub struct Sequence {
    options: Options,
    outlines: Vec<Outline>,
}

/// A sequence whose cameras are known.
pub struct Shooting<'a> {
    subject: Subject<'a>,
    stage: Stage,
    style: Style,
}

impl Sequence {
    /// A sequence without frames. Of the options, those of the layout have no influence.
    #[must_use]
    pub fn new(options: Options) -> Self {
        Self {
            options,
            outlines: Vec::new(),
        }
    }

    /// Adds a frame.
    ///
    /// # Errors
    ///
    /// [`SheetError::Frame`] for a frame with numbers that are not finite.
    pub fn add(&mut self, frame: &Frame) -> Result<(), SheetError> {
        let outline = Outline::new(frame, &self.options)?;
        self.outlines.push(outline.reduced(&self.options));
        Ok(())
    }

    /// Finds the cameras of all frames.
    ///
    /// # Errors
    ///
    /// [`SheetError::NoFrames`]; [`SheetError::Picture`] where no camera sees the figure.
    pub fn shoot(self, subject: Subject<'_>) -> Result<Shooting<'_>, SheetError> {
        if self.outlines.is_empty() {
            return Err(SheetError::NoFrames);
        }
        Ok(Shooting {
            subject,
            stage: Stage::new(&self.outlines, &self.options)?,
            style: self.options.style,
        })
    }
}

impl Shooting<'_> {
    /// Draws a frame, which was the frame of this index among those added.
    ///
    /// # Errors
    ///
    /// [`SheetError::Frame`] for a frame that cannot be drawn, [`SheetError::NoFrames`] for an
    /// index beyond the frames.
    pub fn picture(&self, index: usize, frame: &Frame) -> Result<Rendering, SheetError> {
        let view = self.stage.views.get(index).ok_or(SheetError::NoFrames)?;
        self.subject
            .picture(frame, self.stage.ground, view, &self.style)
    }
}
