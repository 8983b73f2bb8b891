//! Contact sheets, before and after their pictures are drawn.

use ga_image::plane::Plane;

use super::layout::Size;
use super::{Caption, Options, SheetError, paint};
use crate::Rendering;

/// The places of pictures and captions on a contact sheet.
pub struct Plan<'a> {
    captions: &'a [Caption],
    options: &'a Options,
    /// The indices of the frames in each row.
    rows: Vec<Vec<usize>>,
    size: Size,
}

/// A contact sheet and what is on it.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The sheet.
    pub image: Plane<[u8; 3]>,
    /// The picture of each frame, in the order of the frames.
    pub pictures: Vec<Rendering>,
    /// The least and greatest depth in any picture: the range of all depth pictures on the sheet.
    /// `None` when no picture shows anything.
    pub depth_range: Option<(f64, f64)>,
}

impl<'a> Plan<'a> {
    pub(super) fn new(captions: &'a [Caption], options: &'a Options) -> Result<Self, SheetError> {
        let rows = options.layout.rows(captions)?;
        Ok(Self {
            captions,
            options,
            size: Size::new(&rows, options)?,
            rows,
        })
    }

    /// The sheet with these pictures, one for each frame. The place of a frame without one stays
    /// free.
    #[must_use]
    pub fn sheet(&self, pictures: Vec<Rendering>) -> Sheet {
        let ranges = pictures.iter().filter_map(|picture| picture.depth.range());
        let depth_range = ranges.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        let image = paint::sheet(
            self.captions,
            &pictures,
            &self.rows,
            &self.size,
            depth_range,
            self.options,
        );
        Sheet {
            image,
            pictures,
            depth_range,
        }
    }
}
