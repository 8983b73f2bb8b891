//! Films with the body drawn over them, and some of their pictures for the page.

use anyhow::{Context as _, Result};
use ga_draw::document::{Encoding, MotionFilm, MotionPicture};
use ga_image::film::Rate;
use ga_image::jpeg;
use ga_image::plane::Plane;
use ga_image::resample::{Method, resize};
use ga_video::{Frame, Source as _};

use super::films::ViewFilm;
use super::overlay::Overlay;
use crate::film_file::{Film, Show};
use crate::format::Format;
use crate::frame::{Progress, Warning};
use crate::output::Staging;

/// The largest width and height of pictures on the page, in pixels.
const PAGE_SIZE: [usize; 2] = [640, 360];
/// The quality of their encoding.
const QUALITY: u8 = 75;
/// How many pictures a film has on the page at most, and how many pixels all have together: such
/// pictures take about a fifth of a byte a pixel, and a page should stay below 15 MB.
const MOST_PICTURES: usize = 150;
const MOST_PIXELS: usize = 48_000_000;

/// The format of overlays.
pub(super) const FORMAT: Format = match cfg!(feature = "mp4") {
    true => Format::Mp4,
    false => Format::Y4m,
};

/// A film that was drawn.
pub(super) struct Drawn {
    /// The pictures for the page.
    pub(super) film: MotionFilm,
    /// Each how many frames they show.
    pub(super) step: usize,
    /// What of the overlay is not as it was drawn.
    pub(super) warning: Option<Warning>,
}

/// Where a film is drawn for.
pub(super) struct Task<'a> {
    pub(super) film: ViewFilm,
    pub(super) overlay: Overlay<'a>,
    /// The name of the view.
    pub(super) name: String,
    /// Frames in a second, where the film does not state them.
    pub(super) rate: f64,
    /// How many films are on the page.
    pub(super) films: usize,
}

impl Task<'_> {
    /// Draws the film, with one of its pictures in memory at a time.
    pub(super) fn draw(mut self, outputs: &Staging, progress: &Progress) -> Result<Drawn> {
        let size = page_size(self.film.size);
        let most = MOST_PIXELS / (size[0] * size[1]).max(1) / self.films.max(1);
        let step = self.film.frames.div_ceil(most.clamp(1, MOST_PICTURES));
        let mut pictures = Vec::new();
        let mut warning = None;
        if let Some(path) = self.film.overlay.take() {
            let rate = self.film.rate().unwrap_or(self.rate);
            let film = Film {
                path: &path,
                format: FORMAT,
                size: self.film.size.map(|side| side as u32),
                frames: self.film.frames,
                rate: Rate::new(rate).unwrap_or(Rate::HIGHEST),
            };
            warning = film.warning();
            film.write(outputs, |show| {
                self.read(step, &mut pictures, Some(show), progress)
            })?;
        } else {
            self.read(step, &mut pictures, None, progress)?;
        }
        let film = MotionFilm {
            name: self.name,
            size: size.map(|side| side as u32),
            pictures,
        };
        Ok(Drawn {
            film,
            step,
            warning,
        })
    }

    fn read(
        &mut self,
        step: usize,
        pictures: &mut Vec<MotionPicture>,
        mut show: Option<&mut Show<'_>>,
        progress: &Progress,
    ) -> Result<()> {
        let colours = self.film.source.properties().colours;
        let mut frame = Frame::default();
        let mut index = 0;
        while self.film.source.read(&mut frame)? {
            let frames = match index % step {
                0 => self.shown(index, step),
                _ => 0..0,
            };
            if show.is_some() || !frames.is_empty() {
                let mut picture = frame.to_rgb(colours);
                if !frames.is_empty() {
                    let bytes = self.of_page(&picture, index)?;
                    let encoding = Encoding::Jpeg;
                    pictures.push(MotionPicture {
                        frames,
                        encoding,
                        bytes,
                    });
                }
                if let Some(show) = &mut show {
                    self.overlay.draw(&mut picture, index);
                    self.overlay.label(&mut picture, index);
                    show(&picture).with_context(|| format!("the view {}", self.name))?;
                }
            }
            index += 1;
            progress.at(index as u64, self.film.frames as u64);
        }
        Ok(())
    }

    /// The frames of the body at which a picture of the film is shown, until the next one.
    fn shown(&self, index: usize, step: usize) -> std::ops::Range<usize> {
        let frames = self.overlay.figure.frames.len() as f64;
        let of_body = |index: usize| {
            let frame = (index.min(self.film.frames) as f64 - self.overlay.offset).round();
            frame.clamp(0.0, frames) as usize
        };
        of_body(index)..of_body(index + step)
    }

    /// A small picture with the body over it, as JPEG.
    fn of_page(&self, picture: &Plane<[u8; 3]>, index: usize) -> Result<Vec<u8>> {
        let [width, height] = page_size(self.film.size);
        let mut small = resize(picture, width, height, Method::Area)?;
        self.overlay.draw(&mut small, index);
        jpeg::encode(&small, QUALITY).context("a picture of the page cannot be written")
    }
}

/// The size of a film on the page.
fn page_size(size: [usize; 2]) -> [usize; 2] {
    let factors = [0, 1].map(|k| PAGE_SIZE[k] as f64 / size[k] as f64);
    let factor = factors[0].min(factors[1]).min(1.0);
    size.map(|side| ((side as f64 * factor).round() as usize).max(1))
}
