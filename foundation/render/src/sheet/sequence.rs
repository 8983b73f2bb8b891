//! The frames of an animation one after the other.

use super::framing::{Outline, Stage};
use super::plan::Plan;
use super::{Caption, Frame, Options, SheetError};
use crate::{Rendering, Scene, render};

/// The cameras of a sequence of frames: with one direction and one scale, chosen so that the whole
/// figure with its shadow is in every picture, as on a [contact sheet](super::contact_sheet).
///
/// The frames are given twice, first for the cameras and then to be drawn, so that only one of them
/// need be in memory at a time.
///
/// ```
/// use ga_render::Scene;
/// use ga_render::sheet::{Caption, Frame, Options, Sequence};
///
/// let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// let corners = |x: f64| [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
/// let mut sequence = Sequence::new(Options::default());
/// for step in 0..3 {
///     let positions = corners(0.1 * f64::from(step));
///     let caption = Caption::new(step as usize);
///     sequence.add(&Frame { caption, positions: &positions, bones: &[] })?;
/// }
/// let shooting = sequence.shoot()?;
/// let picture = shooting.picture(2, &Scene::new(&corners(0.2), &triangles))?;
/// assert_eq!([picture.colour.width(), picture.colour.height()], [240, 320]);
/// # Ok::<(), ga_render::sheet::SheetError>(())
/// ```
pub struct Sequence {
    options: Options,
    captions: Vec<Caption>,
    outlines: Vec<Outline>,
}

/// A sequence whose cameras are known.
pub struct Shooting {
    options: Options,
    captions: Vec<Caption>,
    stage: Stage,
}

impl Sequence {
    /// A sequence without frames. In a film, those options that are about layout and captions have
    /// no influence.
    #[must_use]
    pub fn new(options: Options) -> Self {
        Self {
            options,
            captions: Vec::new(),
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
        self.captions.push(frame.caption);
        Ok(())
    }

    /// Finds the cameras of all frames.
    ///
    /// # Errors
    ///
    /// [`SheetError::NoFrames`]; [`SheetError::Picture`] where no camera sees the figure.
    pub fn shoot(self) -> Result<Shooting, SheetError> {
        if self.outlines.is_empty() {
            return Err(SheetError::NoFrames);
        }
        Ok(Shooting {
            stage: Stage::new(&self.outlines, &self.options)?,
            options: self.options,
            captions: self.captions,
        })
    }
}

impl Shooting {
    /// Draws the scene of the frame of this index among those added, on the ground of all frames.
    ///
    /// # Errors
    ///
    /// [`SheetError::Frame`] for a scene that cannot be drawn, [`SheetError::NoFrames`] for an
    /// index beyond the frames.
    pub fn picture(&self, index: usize, scene: &Scene) -> Result<Rendering, SheetError> {
        let (Some(view), Some(caption)) = (self.stage.views.get(index), self.captions.get(index))
        else {
            return Err(SheetError::NoFrames);
        };
        let scene = Scene {
            ground: Some(self.stage.ground),
            ..scene.clone()
        };
        render(&scene, view, &self.options.style).map_err(|source| SheetError::Frame {
            number: caption.number,
            source,
        })
    }

    /// The contact sheet of all frames, before they are drawn.
    ///
    /// # Errors
    ///
    /// [`SheetError::NotKeyToKey`] and [`SheetError::Size`] for frames that cannot be laid out.
    pub fn plan(&self) -> Result<Plan<'_>, SheetError> {
        Plan::new(&self.captions, &self.options)
    }
}
