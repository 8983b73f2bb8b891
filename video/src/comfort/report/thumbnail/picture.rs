//! Pictures with titles, side by side.

use crate::comfort::{Match, Viewing};
use ga_image::file::FormatError;
use ga_image::jpeg;
use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;

use crate::comfort::report::axis::INK;
use ga_draw::document::{Anchor, Svg};

/// The widths of the whole, of one of two pictures and of one of three.
pub(super) const WIDTH: f64 = 980.0;

pub(super) const HALF: f64 = 484.0;

pub(super) const THIRD: f64 = 320.0;

pub(super) const GAP: f64 = 10.0;

/// The line of words above pictures.
pub(super) const TITLE: f64 = 24.0;

pub(super) const QUALITY: u8 = 82;

/// A picture, and what one sees in it.
pub(in crate::comfort::report) struct Thumbnail {
    pub(in crate::comfort::report) svg: String,
    pub(in crate::comfort::report) words: String,
}

/// What pictures need to know of the video.
#[derive(Clone, Copy)]
pub(in crate::comfort::report) struct Video<'a> {
    pub(in crate::comfort::report) viewing: &'a Viewing,
    pub(in crate::comfort::report) colours: YCbCr,
}

/// A picture of pixels, with a title above it.
pub(super) fn put(
    svg: &mut Svg,
    [x, y]: [f64; 2],
    size: [f64; 2],
    title: &str,
    picture: &Plane<[u8; 3]>,
) -> Result<(), FormatError> {
    let bytes = jpeg::encode(picture, QUALITY)?;
    svg.picture([x, y], size, ("jpeg", &bytes), "");
    put_title(svg, [x, y], title);
    Ok(())
}

pub(super) fn put_title(svg: &mut Svg, [x, y]: [f64; 2], title: &str) {
    let attributes = format!("fill=\"{INK}\" font-weight=\"bold\"");
    svg.text([x, y - 7.0], 13.0, Anchor::Start, &attributes, title);
}

/// A part of the matches, from all parts of the picture.
pub(super) fn some(matches: &[Match], most: usize) -> impl Iterator<Item = &Match> {
    matches.iter().step_by(matches.len().div_ceil(most).max(1))
}
