//! What a line is drawn with.

use crate::colour::Colour;

/// The element that a line belongs to, and the colour and the width of the line.
#[derive(Clone, Copy)]
pub(super) struct Pen {
    pub(super) element: Option<usize>,
    pub(super) colour: Colour,
    pub(super) width: f64,
}

impl Pen {
    /// The pen of the coordinate axes and of the grid.
    pub(super) const GREY: Self = Self {
        element: None,
        colour: Colour([0x7a, 0x7a, 0x7a]),
        width: 1.2,
    };

    pub(super) fn thin(self) -> Self {
        let width = 0.7 * self.width;
        Self { width, ..self }
    }

    pub(super) fn fine(self) -> Self {
        let width = 0.45 * self.width;
        Self { width, ..self }
    }
}
