//! The part of a page that shows a motion.

use std::fmt::Write;

use super::check::{MotionError, check};
use super::data::Data;
use super::model::{Motion, Side};
use super::still;
use crate::document::page::Page;
use crate::escape::{escaped, in_script};
use crate::page::{GEOMETRY, STAGE};

const SHEET: &str = include_str!("motion.css");
/// The mathematics of the part. It uses [`GEOMETRY`] and needs no document.
pub(super) const FIGURE: &str = include_str!("figure.js");
/// It uses [`GEOMETRY`], [`STAGE`] and [`FIGURE`].
pub(super) const SCRIPT: &str = include_str!("motion.js");

/// The number of films that stand beside the figure; more stand below it.
const BESIDE: usize = 3;

impl Page {
    /// A motion that plays beside its films and that the mouse rotates, with what it shows in words
    /// below it. At first it stands at the first frame with a pose; without scripts, only this pose
    /// is shown.
    ///
    /// # Errors
    ///
    /// [`MotionError`]; then nothing is added to the page.
    pub fn motion(&mut self, motion: &Motion, caption: &str) -> Result<(), MotionError> {
        check(motion)?;
        let data = Data::of(motion);
        let first = data.first();
        let last = data.frames.len() - 1;
        let said = format!("Frame {first}, the first with a pose among the frames 0 to {last}.");
        let mut html = String::from("<figure class=\"motion\">\n<div class=\"still\">\n");
        html += &still::draw(&data, &format!("{caption} {said}"));
        // Writing to a string does not fail.
        let _ = write!(
            html,
            "<noscript>{said} The motion and its films are shown by a script, \
             which this browser does not run.</noscript>\n</div>\n\
             <div class=\"{}\" hidden>\n\
             <canvas class=\"stage\" tabindex=\"0\" role=\"img\" aria-label=\"{}\"></canvas>\n",
            if data.films.len() > BESIDE {
                "views"
            } else {
                "views beside"
            },
            escaped(caption)
        );
        if !data.films.is_empty() {
            html += "<div class=\"films\">\n";
            for film in &data.films {
                let [width, height] = film.size;
                let name = escaped(film.name);
                let _ = writeln!(
                    html,
                    "<div><canvas width=\"{width}\" height=\"{height}\" role=\"img\" \
                     aria-label=\"{name}\"></canvas><p>{name} <span></span></p></div>"
                );
            }
            html += "</div>\n";
        }
        let _ = write!(
            html,
            "</div>\n<div class=\"controls\" hidden><button type=\"button\">Play</button>\
             <input type=\"range\" min=\"0\" max=\"{last}\" value=\"{first}\" aria-label=\"Frame\">\
             <output></output>\
             <label><input type=\"checkbox\">follow the figure</label></div>\n<p class=\"legend\">{}</p>\n\
             <p class=\"help\" hidden>Drag or use the arrow keys to rotate · wheel, two fingers or \
             + − to zoom · double click or 0 to reset · space to play · , and . for one frame</p>\n\
             <figcaption>{}</figcaption>\n<script type=\"application/json\">{}</script>\n</figure>\n",
            legend(motion, &data),
            escaped(caption),
            in_script(&json(&data))
        );
        self.add_style(SHEET);
        self.add(format_args!("{html}"));
        self.add_scripts(&[GEOMETRY, STAGE, FIGURE, SCRIPT]);
        Ok(())
    }
}

/// The data as JSON.
pub(super) fn json(data: &Data<'_>) -> String {
    // This cannot fail: all keys are texts, and all numbers are finite.
    serde_json::to_string(data).unwrap_or_default()
}

/// What the colours and the lines on the floor are.
fn legend(motion: &Motion, data: &Data<'_>) -> String {
    let mut html = String::new();
    for side in Side::ALL {
        if motion.bones.iter().any(|bone| bone.side == side) {
            let words = match side {
                Side::Left => "the person’s left",
                Side::Right => "the person’s right",
                Side::Middle => "middle",
            };
            let colour = side.colour();
            let _ = write!(
                html,
                "<span><i style=\"background:{colour}\"></i>{words}</span> "
            );
        }
    }
    if !data.floor.is_empty() {
        let _ = write!(
            html,
            "<span><i class=\"floor\"></i>floor, squares of {} m</span>",
            data.step
        );
    }
    html
}
