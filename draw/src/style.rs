//! How an element looks.

use crate::colour::Colour;

/// How an element looks. What is `None` is chosen to suit the element.
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
    /// The colour; without it the next of the [`PALETTE`].
    pub colour: Option<Colour>,
    /// The width of lines in pixels; 2 without it. Points are drawn to suit.
    pub width: Option<f64>,
    /// How much of what is behind a surface it hides, from 0 to 1; 0.3 for spheres and 0.16 for
    /// planes without it. Lines and points are always opaque.
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

    /// The same in a colour.
    #[must_use]
    pub fn coloured(self, colour: Colour) -> Self {
        let colour = Some(colour);
        Self { colour, ..self }
    }

    /// The same with lines of a width in pixels.
    #[must_use]
    pub fn with_width(self, width: f64) -> Self {
        let width = Some(width);
        Self { width, ..self }
    }

    /// The same with surfaces of an opacity from 0 to 1.
    #[must_use]
    pub fn with_opacity(self, opacity: f64) -> Self {
        let opacity = Some(opacity);
        Self { opacity, ..self }
    }
}
