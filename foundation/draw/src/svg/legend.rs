//! The title and the list of elements.

use std::fmt::Write as _;

use super::path::number;
use super::theme::{FAINT, INK};
use crate::camera::Pixel;
use crate::colour::Colour;
use crate::escape::escaped;
use crate::label::{Frame, text_width};
use crate::scene::Scene;

/// The title and the list of elements that have a label, in the upper left corner.
pub(super) struct Legend {
    title: String,
    title_size: f64,
    entries: Vec<(String, &'static str, Colour)>,
    /// The width of the list, and the height of the title above it.
    pub(super) width: f64,
    pub(super) top: f64,
}

/// The height of a line of the legend.
const LINE: f64 = 22.0;
/// The size of the letters of the legend.
const LEGEND_LETTER: f64 = 13.0;

impl Legend {
    pub(super) fn of(scene: &Scene, [width, height]: Pixel) -> Self {
        let fits = ((height - 60.0) / LINE).max(0.0) as usize;
        let labelled = scene.elements().iter().filter(|_| scene.legend);
        let entries: Vec<_> = labelled
            .filter_map(|element| {
                let label = shortened(element.label.as_ref()?, 32);
                Some((label, element.shape.kind(), element.colour))
            })
            .take(fits)
            .collect();
        let widest = entries.iter().fold(0.0_f64, |widest, (label, kind, _)| {
            let text = text_width(label, LEGEND_LETTER) + text_width(kind, LEGEND_LETTER);
            widest.max(text + 46.0)
        });
        let title = shortened(scene.title.trim(), 120);
        let title_size =
            (17.0 * (width - 32.0) / text_width(&title, 17.0).max(1.0)).clamp(8.0, 17.0);
        Self {
            title_size,
            top: if title.is_empty() { 0.0 } else { 24.0 },
            title,
            entries,
            width: widest.min(0.45 * width),
        }
    }

    /// The boxes of the list and of the title.
    pub(super) fn boxes(&self) -> [Frame; 2] {
        let lines = self.entries.len() as f64;
        let title = 16.0 + text_width(&self.title, self.title_size);
        [
            [[0.0, 0.0], [self.width, self.top + 24.0 + LINE * lines]],
            [[0.0, 0.0], [title, self.top]],
        ]
    }

    pub(super) fn write(&self, body: &mut String) {
        if !self.title.is_empty() {
            let _ = writeln!(
                body,
                "<text class=\"ink\" x=\"16\" y=\"29\" font-size=\"{}\" font-weight=\"600\" fill=\"{INK}\">{}</text>",
                number(self.title_size),
                escaped(&self.title)
            );
        }
        for (line, (label, kind, colour)) in self.entries.iter().enumerate() {
            let y = self.top + 30.0 + LINE * line as f64;
            let _ = writeln!(
                body,
                "<rect x=\"16\" y=\"{}\" width=\"12\" height=\"12\" rx=\"3\" fill=\"{colour}\"/>\
                 <text class=\"ink\" x=\"36\" y=\"{}\" font-size=\"{LEGEND_LETTER}\" fill=\"{INK}\">{} <tspan class=\"faint\" dx=\"4\" fill=\"{FAINT}\">{kind}</tspan></text>",
                number(y - 6.0),
                number(y + 4.5),
                escaped(label),
            );
        }
    }
}

/// A text of at most `most` letters.
fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    text.chars().take(most - 1).chain(['…']).collect()
}
