//! Pictures as SVG, for pages of HTML: shapes, text and pictures of pixels.

use std::fmt::{Display, Write};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

use crate::escape::escaped;

/// A picture to which elements are added, the last ones on top. Places are x to the right and y
/// down. Attributes are those of SVG, such as `fill="#fff"`.
#[derive(Clone, Debug)]
pub struct Svg {
    text: String,
}

/// Where a text is, against its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

impl Svg {
    /// A picture of a size, and what it shows in words.
    #[must_use]
    pub fn new([width, height]: [f64; 2], words: &str) -> Self {
        let (width, height) = (Short(width), Short(height));
        Self {
            text: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
                 viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" role=\"img\" \
                 aria-label=\"{}\">\n",
                escaped(words)
            ),
        }
    }

    /// A rectangle with its upper left corner and its size.
    pub fn rectangle(&mut self, [x, y]: [f64; 2], size: [f64; 2], attributes: &str) {
        let [width, height] = size.map(Short);
        self.add(format_args!(
            "<rect x=\"{}\" y=\"{}\" width=\"{width}\" height=\"{height}\" {attributes}/>\n",
            Short(x),
            Short(y)
        ));
    }

    /// A straight line.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], attributes: &str) {
        let [[x1, y1], [x2, y2]] = [from, to].map(|place| place.map(Short));
        self.add(format_args!(
            "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" {attributes}/>\n"
        ));
    }

    /// A circle.
    pub fn circle(&mut self, centre: [f64; 2], radius: f64, attributes: &str) {
        let [x, y] = centre.map(Short);
        let radius = Short(radius);
        self.add(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {attributes}/>\n"
        ));
    }

    /// Straight lines through places.
    pub fn path(&mut self, places: impl IntoIterator<Item = [f64; 2]>, attributes: &str) {
        self.text += "<path d=\"";
        for (index, place) in places.into_iter().enumerate() {
            let [x, y] = place.map(Short);
            let letter = if index == 0 { "M" } else { "L" };
            self.add(format_args!("{letter}{x} {y}"));
        }
        self.add(format_args!("\" {attributes}/>\n"));
    }

    /// A line of text with the height of its letters.
    pub fn text(
        &mut self,
        [x, y]: [f64; 2],
        size: f64,
        anchor: Anchor,
        attributes: &str,
        text: &str,
    ) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        self.add(format_args!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{anchor}\" {attributes}>{}</text>\n",
            Short(x),
            Short(y),
            Short(size),
            escaped(text)
        ));
    }

    /// The bytes of a file of the kind `image/…`, stretched over a rectangle.
    pub fn picture(
        &mut self,
        [x, y]: [f64; 2],
        size: [f64; 2],
        (kind, bytes): (&str, &[u8]),
        attributes: &str,
    ) {
        let [width, height] = size.map(Short);
        self.add(format_args!(
            "<image x=\"{}\" y=\"{}\" width=\"{width}\" height=\"{height}\" \
             preserveAspectRatio=\"none\" {attributes} href=\"data:image/{kind};base64,{}\"/>\n",
            Short(x),
            Short(y),
            BASE64_STANDARD.encode(bytes)
        ));
    }

    /// Elements as they are.
    pub fn raw(&mut self, elements: &str) {
        self.text += elements;
    }

    /// The whole picture.
    #[must_use]
    pub fn into_text(mut self) -> String {
        self.text += "</svg>\n";
        self.text
    }

    fn add(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        let _ = self.text.write_fmt(element);
    }
}

/// A length with at most two decimals.
struct Short(f64);

impl Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        // Not −0.
        let rounded = (100.0 * self.0).round() / 100.0 + 0.0;
        rounded.fmt(f)
    }
}

/// About `most` numbers from `first` to `last`, multiples of 1, 2 or 5 times a power of ten.
#[must_use]
pub fn ticks([first, last]: [f64; 2], most: usize) -> Vec<f64> {
    let length = last - first;
    if !(length > 0.0 && length.is_finite()) {
        return vec![first];
    }
    let least = length / most.max(1) as f64;
    let power = 10_f64.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let step = step.into_iter().find(|step| *step >= 0.999 * least);
    let step = step.unwrap_or(10.0 * power);
    let from = (first / step - 1e-9).ceil() as i64;
    let to = (last / step + 1e-9).floor() as i64;
    (from..=to).map(|k| k as f64 * step).collect()
}

#[cfg(test)]
mod tests {
    use super::{Anchor, Svg, ticks};

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(
            ticks([0.0, 48.0], 10),
            [0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0]
        );
        assert_eq!(ticks([-3.0, 4.0], 5), [-2.0, 0.0, 2.0, 4.0]);
        assert_eq!(ticks([2.0, 2.0], 5), [2.0]);
    }

    #[test]
    fn text_stays_text_and_numbers_are_short() {
        let mut svg = Svg::new([10.0, 4.5], "a < b");
        svg.text([1.0 / 3.0, -0.0], 9.0, Anchor::End, "", "\"<&");
        let text = svg.into_text();
        assert!(text.contains("aria-label=\"a &lt; b\""));
        assert!(text.contains("<text x=\"0.33\" y=\"0\" font-size=\"9\""));
        assert!(text.contains(">&quot;&lt;&amp;</text>\n</svg>\n"));
    }
}
