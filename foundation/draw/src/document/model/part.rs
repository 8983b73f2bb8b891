//! The part of a page that shows a model.

use std::fmt::Write;

use super::check::{ModelError, check};
use super::data::Data;
use super::view::ModelView;
use crate::document::page::Page;
use crate::escape::{escaped, in_script};
use crate::page::{GEOMETRY, STAGE};

const SHEET: &str = include_str!("model.css");
/// The mathematics of the part. It uses [`GEOMETRY`] and needs no document.
pub(super) const MESH: &str = include_str!("mesh.js");
/// What WebGL does. It uses [`MESH`].
pub(super) const PAINTER: &str = include_str!("painter.js");
/// It uses [`GEOMETRY`], [`STAGE`], [`MESH`] and [`PAINTER`].
pub(super) const SCRIPT: &str = include_str!("model.js");

impl Page {
    /// A model that the mouse, fingers and keys rotate, with what it shows in words below it. It is
    /// drawn by WebGL; browsers that have none, or run no scripts, show a sentence that says so.
    /// One with several frames has a button that plays them again and again.
    ///
    /// Browsers draw about 16 models on one page at the same time.
    ///
    /// # Errors
    ///
    /// [`ModelError`]; then nothing is added to the page.
    pub fn model(&mut self, model: &ModelView, caption: &str) -> Result<(), ModelError> {
        check(model)?;
        let data = Data::of(model);
        let words = escaped(caption);
        let mut html = format!(
            "<figure class=\"model\">\n<p class=\"absent\">The model is shown by a script with \
             WebGL, which this browser does not run.</p>\n\
             <canvas class=\"stage\" tabindex=\"0\" role=\"img\" aria-label=\"{words}\" hidden>\
             </canvas>\n"
        );
        let moves = data.frames > 1;
        if moves {
            // Writing to a string does not fail.
            let _ = writeln!(
                html,
                "<div class=\"controls\" hidden><button type=\"button\">Play</button>\
                 <input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"Frame\">\
                 <output></output></div>",
                data.frames - 1
            );
        }
        html += "<p class=\"help\" hidden>Drag or use the arrow keys to rotate · wheel, two fingers \
                 or + − to zoom · double click or 0 to reset";
        if moves {
            html += " · space to play · , and . for one frame";
        }
        if model.floor.is_some() {
            let _ = write!(html, " · squares of {} m", data.square);
        }
        let _ = write!(
            html,
            "</p>\n<figcaption>{words}</figcaption>\n\
             <script type=\"application/json\">{}</script>\n</figure>\n",
            in_script(&json(&data))
        );
        self.add_style(SHEET);
        self.add(format_args!("{html}"));
        self.add_scripts(&[GEOMETRY, STAGE, MESH, PAINTER, SCRIPT]);
        Ok(())
    }
}

fn json(data: &Data) -> String {
    // This cannot fail: all keys are texts, and all numbers are finite.
    serde_json::to_string(data).unwrap_or_default()
}
