//! How an element looks.

use crate::colour::Colour;

/// How an element looks. A member that is `None` gets a default that suits the element.
///
/// ```
/// use ga_draw::{PALETTE, Style};
/// let style = Style::labelled("S").coloured(PALETTE[1]).with_opacity(0.5);
/// assert_eq!(style.label.as_deref(), Some("S"));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Style {
    /// The text beside the element and in the legend.
    pub label: Option<String>,
    /// The colour; by default the next one of the [`PALETTE`](crate::PALETTE).
    pub colour: Option<Colour>,
    /// The width of lines in pixels, 2 by default. The size of points follows from it.
    pub width: Option<f64>,
    /// The opacity of surfaces, from 0 to 1; by default 0.3 for spheres and 0.16 for planes. Lines
    /// and points are always opaque.
    pub opacity: Option<f64>,
}

impl Style {
    /// The style with a label and nothing else.
    #[must_use]
    pub fn labelled(label: impl Into<String>) -> Self {
        Self {
            label: Some(label.into()),
            ..Self::default()
        }
    }

    /// The same style in a colour.
    #[must_use]
    pub fn coloured(self, colour: Colour) -> Self {
        let colour = Some(colour);
        Self { colour, ..self }
    }

    /// The same style with lines of a width in pixels.
    #[must_use]
    pub fn with_width(self, width: f64) -> Self {
        let width = Some(width);
        Self { width, ..self }
    }

    /// The same style with surfaces of an opacity from 0 to 1.
    #[must_use]
    pub fn with_opacity(self, opacity: f64) -> Self {
        let opacity = Some(opacity);
        Self { opacity, ..self }
    }
}
