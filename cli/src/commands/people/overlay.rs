//! The fitted body over the pictures of a film.

use ga_body::agreement::OUTLIER;
use ga_body::character::FittedCharacter;
use ga_camera::Camera;
use ga_draw::Colour;
use ga_draw::document::Side;
use ga_image::plane::Plane;
use ga_render::Segment;
use ga_render::text::{self, LINE_HEIGHT, Weight};
use ga_runtime::cga3::Point;

use super::figure::Figure;

const WHITE: Colour = Colour([255; 3]);
const DARK: Colour = Colour([24, 28, 34]);
/// Joints that are far from where the body has them.
const WRONG: Colour = Colour([255, 64, 16]);
/// The half width of bones, as a part of the shorter side of a picture, and in pixels at least.
const BONE: f64 = 1.0 / 320.0;
const LEAST_BONE: f64 = 0.9;
/// Around the words and between them, in pixels.
const MARGIN: u32 = 6;
/// Pictures that have room for fewer lines of words have none.
const LEAST_LINES: usize = 8;

/// What is drawn over the pictures of a view.
pub(super) struct Overlay<'a> {
    pub(super) figure: &'a Figure,
    pub(super) fitted: &'a FittedCharacter,
    /// The number of the view.
    pub(super) view: usize,
    /// The columns and rows of pictures to which the pixels of camera and joints belong.
    pub(super) size: [usize; 2],
    /// The frame of the film that shows frame 0 of the body.
    pub(super) offset: f64,
}

impl Overlay<'_> {
    /// The frame of the body that a frame of the film shows.
    pub(super) fn body_frame(&self, frame: usize) -> Option<usize> {
        let frame = (frame as f64 - self.offset).round();
        (frame >= 0.0 && frame < self.figure.frames.len() as f64).then_some(frame as usize)
    }

    /// Draws the body and the joints that were found over a picture of the film, of any size.
    pub(super) fn draw(&self, picture: &mut Plane<[u8; 3]>, frame: usize) {
        let Some(frame) = self.body_frame(frame) else {
            return;
        };
        let sides = [picture.width(), picture.height()];
        let shorter = sides[0].min(sides[1]) as f64;
        let radius = (BONE * shorter).max(LEAST_BONE);
        let [across, down] = [0, 1].map(|k| sides[k] as f64 / self.size[k] as f64);
        // The centre of the first pixel is at 0 in files, and at a half on pictures.
        let scaled = |[u, v]: [f64; 2]| [(u + 0.5) * across, (v + 0.5) * down];
        let camera: &Camera = &self.fitted.cameras[self.view];
        let place = |point: Point<f64>| camera.project(point).ok().map(scaled);
        let mut line = |ends: [[f64; 2]; 2], radius: f64, colour: Colour| {
            Segment { ends, radius }.draw(picture, colour.0);
        };

        let places: Vec<_> = self.figure.frames[frame]
            .iter()
            .map(|&at| place(at.into()))
            .collect();
        let bones = self.figure.bones.iter().filter_map(|bone| {
            let [from, to] = bone.ends.map(|end| places[end]);
            Some(([from?, to?], bone.side))
        });
        let bones: Vec<([[f64; 2]; 2], Side)> = bones.collect();
        for (ends, _) in &bones {
            line(*ends, 1.7 * radius, WHITE);
        }
        for (ends, side) in &bones {
            line(*ends, radius, side.colour());
        }

        let fit = &self.fitted.poses[frame];
        let seen = &self.fitted.observations[frame].views[self.view];
        for ((pixel, residual), point) in seen
            .iter()
            .zip(&fit.residuals_px[self.view])
            .zip(&fit.points)
        {
            let Some(pixel) = pixel else { continue };
            let [x, y] = scaled(pixel.position);
            let is_wrong = residual.is_some_and(|residual| residual > OUTLIER * pixel.deviation);
            if !is_wrong {
                line([[x, y]; 2], 1.5 * radius, DARK);
                line([[x, y]; 2], 0.9 * radius, WHITE);
                continue;
            }
            if let Some(body) = place(*point) {
                line([[x, y], body], 0.4 * radius, WRONG);
            }
            let arm = 2.5 * radius;
            for (width, colour) in [(1.2 * radius, WHITE), (0.7 * radius, WRONG)] {
                line([[x - arm, y - arm], [x + arm, y + arm]], width, colour);
                line([[x - arm, y + arm], [x + arm, y - arm]], width, colour);
            }
        }
    }

    /// Writes the number of a frame of the film and what the colours are into a corner, as far as
    /// there is room.
    pub(super) fn label(&self, picture: &mut Plane<[u8; 3]>, frame: usize) {
        let mut x = MARGIN;
        let mut words = |picture: &mut Plane<[u8; 3]>, text: &str, colour: Option<Colour>| {
            let sample = if colour.is_some() { LINE_HEIGHT } else { 0 };
            let width = text::width(text, Weight::Regular);
            let end = x + sample + width + MARGIN;
            let least = LEAST_LINES * LINE_HEIGHT as usize;
            if end as usize > picture.width() || picture.height() < least {
                return;
            }
            let begin = if x == MARGIN { 0 } else { x };
            for row in 0..(LINE_HEIGHT + MARGIN) as usize {
                picture.row_mut(row)[begin as usize..end as usize].fill(DARK.0);
            }
            if let Some(colour) = colour {
                let middle = f64::from(MARGIN / 2 + LINE_HEIGHT / 2);
                let (from, to) = (f64::from(x) + 2.0, f64::from(x + sample) - 5.0);
                let ends = [[from, middle], [to, middle]];
                let radius = 2.5;
                Segment { ends, radius }.draw(picture, colour.0);
            }
            let start = [x + sample, MARGIN / 2];
            text::write(picture, start, width, text, Weight::Regular, WHITE.0);
            x = end;
        };
        let of_body = match self.body_frame(frame) {
            Some(_) => format!("frame {frame}"),
            None => format!("frame {frame}, without a body"),
        };
        words(picture, &of_body, None);
        for (text, colour) in [
            ("left", Side::Left.colour()),
            ("right", Side::Right.colour()),
            ("middle", Side::Middle.colour()),
            ("found joint", WHITE),
            ("far from the body", WRONG),
        ] {
            words(picture, text, Some(colour));
        }
    }
}
