//! Reports: pages of HTML that need no other file, and charts in SVG for them. [`chart`] is for
//! those that are drawn with the crate `plotters`.
//!
//! ```
//! use ga_draw::document::{Anchor, Page, Svg};
//!
//! let mut chart = Svg::new([200.0, 40.0], "a bar");
//! chart.rectangle([0.0, 10.0], [120.0, 20.0], "fill=\"#0072b2\"");
//! chart.text([124.0, 25.0], 12.0, Anchor::Start, "", "60 %");
//! let mut page = Page::new("Progress");
//! page.svg(&chart.into_text());
//! page.table(["frame", "score"], [["0".to_owned(), "7".to_owned()]]);
//! assert!(page.into_html().starts_with("<!DOCTYPE html>"));
//! ```

pub mod chart;
mod line_chart;
mod model;
mod motion;
mod overlay;
mod page;
mod svg;
mod values;

pub use line_chart::{LineChart, Series};
pub use model::{ModelCoordinates, ModelError, ModelTexture, ModelView};
pub use motion::{
    Bone, Encoding, FilmProblem, Motion, MotionCamera, MotionError, MotionFilm, MotionPicture, Side,
};
pub use overlay::{Outline, overlay};
pub use page::{Cell, Page, Tint, percent};
pub use svg::{Anchor, Svg, ticks};
