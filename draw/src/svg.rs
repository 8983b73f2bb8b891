//! Scalable Vector Graphics.

use std::fmt::Write as _;

use crate::camera::{Camera, Pixel};
use crate::escape::escaped;
use crate::label::{LETTER, placed, text_width};
use crate::picture::{Ball, Curve, Form, Picture};
use crate::scene::Scene;
use crate::stroke::{Hiding, Stroke, all_curves};
use crate::style::Colour;
use crate::surface::{Piece, Surface};

/// The room round the scene for labels and heads of arrows, in pixels.
const MARGIN: f64 = 34.0;

/// The classes that follow the reader's preference for light or dark; without style sheets the
/// attributes hold.
const STYLE: &str = "text{font-family:system-ui,'Segoe UI','DejaVu Sans',sans-serif}\
.halo{paint-order:stroke;stroke-linejoin:round}\
@media(prefers-color-scheme:dark){.ground{fill:#14171c}.ink{fill:#e8eaed}.faint{fill:#a8afb8}.halo{stroke:#14171c}.rim{stroke:#14171c}}";

const GROUND: &str = "#ffffff";
const INK: &str = "#1b1f24";
const FAINT: &str = "#5a626c";

/// Writes a scene.
pub(crate) fn draw(scene: &Scene) -> String {
    let size = scene.size.map(|pixels| f64::from(pixels.clamp(64, 8192)));
    let picture = Picture::of(scene);
    let legend = Legend::of(scene, size);
    let camera = fitted(scene, &picture, &legend, size);
    let mut writer = Writer {
        defs: String::new(),
        body: String::new(),
        clips: 0,
        picture: &picture,
    };
    writer.surfaces_and_strokes(&camera);
    writer.labels(&camera, size, &legend);
    legend.write(&mut writer.body);
    let [width, height] = size.map(number);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\" aria-labelledby=\"picture-title picture-description\">\n\
         <title id=\"picture-title\">{}</title>\n<desc id=\"picture-description\">{}</desc>\n<style>{STYLE}</style>\n\
         <defs>\n{}</defs>\n<rect class=\"ground\" width=\"100%\" height=\"100%\" fill=\"{GROUND}\"/>\n{}</svg>\n",
        escaped(&scene.title),
        escaped(&scene.told()),
        writer.defs,
        writer.body,
    )
}

/// The camera with which all that is drawn fits beside the legend.
fn fitted(scene: &Scene, picture: &Picture, legend: &Legend, [width, height]: Pixel) -> Camera {
    let mut camera = Camera::new(&scene.view);
    let curves = all_curves(picture, &camera);
    let corners = picture.patches.iter().flat_map(|patch| &patch.corners);
    let dots = picture.dots.iter().map(|dot| &dot.at);
    let points = curves
        .iter()
        .flat_map(|curve| &curve.points)
        .chain(corners)
        .chain(dots);
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for [x, y] in points.map(|point| camera.project(*point)) {
        (low, high) = (
            [low[0].min(x), low[1].min(y)],
            [high[0].max(x), high[1].max(y)],
        );
    }
    if low[0] > high[0] {
        (low, high) = ([-1.0; 2], [1.0; 2]);
    }
    let room = [
        [legend.width + MARGIN, legend.top + MARGIN],
        [width - MARGIN, height - MARGIN],
    ];
    let scales = [0, 1].map(|k| (room[1][k] - room[0][k]).max(16.0) / (high[k] - low[k]).max(1e-3));
    let zoom = if scene.view.zoom.is_finite() {
        scene.view.zoom.clamp(0.1, 20.0)
    } else {
        1.0
    };
    // A single point is not blown up.
    camera.scale = scales[0].min(scales[1]).min(width.max(height)) * zoom;
    camera.middle =
        [0, 1].map(|k| 0.5 * (room[0][k] + room[1][k]) - camera.scale * 0.5 * (low[k] + high[k]));
    camera
}

/// The title and the list of elements with labels, in the upper left corner.
struct Legend {
    title: String,
    title_size: f64,
    entries: Vec<(String, &'static str, Colour)>,
    width: f64,
    top: f64,
}

/// The height of a line of the legend, and the size of its letters.
const LINE: f64 = 22.0;
const LEGEND_LETTER: f64 = 13.0;

impl Legend {
    fn of(scene: &Scene, [width, height]: Pixel) -> Self {
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

    fn write(&self, body: &mut String) {
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

/// A text with at most so many letters.
fn shortened(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    text.chars().take(most - 1).chain(['…']).collect()
}

struct Writer<'a> {
    defs: String,
    body: String,
    clips: usize,
    picture: &'a Picture,
}

impl Writer<'_> {
    fn surfaces_and_strokes(&mut self, camera: &Camera) {
        let picture = self.picture;
        for (index, ball) in picture.balls.iter().enumerate() {
            self.gradient(index, ball);
        }
        let pieces = picture.pieces(camera);
        let hiding = Hiding::new(picture, camera, &pieces);
        let curves = all_curves(picture, camera);
        let strokes: Vec<Stroke> = curves
            .iter()
            .enumerate()
            .flat_map(|(index, curve)| hiding.strokes(index, curve))
            .collect();
        let dots: Vec<Option<usize>> = picture
            .dots
            .iter()
            .map(|dot| hiding.before(dot.at))
            .collect();
        let mut defined = vec![false; picture.balls.len()];
        for place in 0..=pieces.len() {
            for stroke in strokes.iter().filter(|stroke| stroke.before == Some(place)) {
                self.stroke(&curves[stroke.curve], stroke);
            }
            for dot in (0..dots.len()).filter(|dot| dots[*dot] == Some(place)) {
                self.dot(dot, camera, true);
            }
            if let Some(piece) = pieces.get(place) {
                self.piece(piece, &mut defined);
            }
        }
        let mut visible: Vec<(f64, Visible<'_>)> = Vec::new();
        let free = strokes.iter().filter(|stroke| stroke.before.is_none());
        visible.extend(free.map(|stroke| (stroke.depth, Visible::Stroke(stroke))));
        let free = (0..dots.len()).filter(|dot| dots[*dot].is_none());
        // A dot is on the lines through it.
        visible
            .extend(free.map(|dot| (camera.depth(picture.dots[dot].at) + 0.1, Visible::Dot(dot))));
        visible.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, item) in visible {
            match item {
                Visible::Stroke(stroke) => self.stroke(&curves[stroke.curve], stroke),
                Visible::Dot(dot) => self.dot(dot, camera, false),
            }
        }
    }

    /// The shading of a ball: light from the upper left, denser towards the rim.
    fn gradient(&mut self, index: usize, ball: &Ball) {
        let opacity = |power: f64| number3(1.0 - (1.0 - ball.opacity).powf(power));
        let _ = writeln!(
            self.defs,
            "<radialGradient id=\"shade{index}\" fx=\"0.36\" fy=\"0.3\">\
             <stop offset=\"0\" stop-color=\"{}\" stop-opacity=\"{}\"/>\
             <stop offset=\"0.62\" stop-color=\"{}\" stop-opacity=\"{}\"/>\
             <stop offset=\"1\" stop-color=\"{}\" stop-opacity=\"{}\"/></radialGradient>",
            mixed(ball.colour, 255.0, 0.62),
            opacity(0.6),
            ball.colour,
            opacity(1.0),
            mixed(ball.colour, 0.0, 0.22),
            opacity(1.9),
        );
    }

    fn piece(&mut self, piece: &Piece, defined: &mut [bool]) {
        if piece.regions.iter().any(Vec::is_empty) {
            return;
        }
        match piece.surface {
            Surface::Patch(index) => {
                let patch = &self.picture.patches[index];
                let _ = writeln!(
                    self.body,
                    "<path d=\"{}\" fill=\"{}\" fill-opacity=\"{}\"/>",
                    outlines(&piece.regions[0]),
                    patch.colour,
                    number3(patch.opacity)
                );
            }
            Surface::Ball(index) => {
                if !defined[index] {
                    defined[index] = true;
                    let path = outlines(&piece.regions[0]);
                    let _ = writeln!(self.defs, "<path id=\"ball{index}\" d=\"{path}\"/>");
                }
                let cuts = piece.regions.len() - 1;
                for region in &piece.regions[1..] {
                    let _ = writeln!(
                        self.defs,
                        "<clipPath id=\"cut{}\"><path clip-rule=\"evenodd\" d=\"{}\"/></clipPath>",
                        self.clips,
                        outlines(region)
                    );
                    let _ = write!(self.body, "<g clip-path=\"url(#cut{})\">", self.clips);
                    self.clips += 1;
                }
                let _ = write!(
                    self.body,
                    "<use href=\"#ball{index}\" fill=\"url(#shade{index})\"/>"
                );
                self.body.extend(std::iter::repeat_n("</g>", cuts));
                self.body.push('\n');
            }
        }
    }

    fn stroke(&mut self, curve: &Curve, stroke: &Stroke) {
        let hidden = stroke.before.is_some();
        let (opacity, width) = if hidden {
            (0.7 * curve.opacity, 0.8 * curve.width)
        } else {
            (curve.opacity, curve.width)
        };
        let _ = write!(
            self.body,
            "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"",
            line(&stroke.points, false),
            curve.colour,
            number3(width)
        );
        if opacity < 1.0 {
            let _ = write!(self.body, " stroke-opacity=\"{}\"", number3(opacity));
        }
        match (hidden, curve.dashed) {
            (false, false) => self.body += " stroke-linecap=\"round\" stroke-linejoin=\"round\"",
            (true, false) => self.body += " stroke-dasharray=\"3 4\"",
            (false, true) => self.body += " stroke-dasharray=\"8 5\"",
            (true, true) => self.body += " stroke-dasharray=\"2 6\"",
        }
        self.body += "/>\n";
        if let Some(head) = stroke.head.and_then(|head| arrow_head(head, curve.width)) {
            let _ = write!(
                self.body,
                "<path d=\"{}\" fill=\"{}\"",
                line(&head, true),
                curve.colour
            );
            if opacity < 1.0 {
                let _ = write!(self.body, " fill-opacity=\"{}\"", number3(opacity));
            }
            self.body += "/>\n";
        }
    }

    fn dot(&mut self, index: usize, camera: &Camera, hidden: bool) {
        let dot = &self.picture.dots[index];
        let [x, y] = camera.project(dot.at);
        let r = dot.radius;
        let opacity = if hidden { " opacity=\"0.75\"" } else { "" };
        let colour = dot.colour;
        let _ = match dot.form {
            Form::Full => writeln!(
                self.body,
                "<circle class=\"rim\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{colour}\" stroke=\"{GROUND}\"{opacity}/>",
                number(x),
                number(y),
                number(r)
            ),
            Form::Hollow => writeln!(
                self.body,
                "<circle class=\"ground\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{GROUND}\" stroke=\"{colour}\" stroke-width=\"2\"{opacity}/>",
                number(x),
                number(y),
                number(r - 1.0)
            ),
            Form::Square => writeln!(
                self.body,
                "<rect class=\"rim\" x=\"{}\" y=\"{}\" width=\"{2}\" height=\"{2}\" fill=\"{colour}\" stroke=\"{GROUND}\"{opacity}/>",
                number(x - r),
                number(y - r),
                number(2.0 * r)
            ),
        };
    }

    fn labels(&mut self, camera: &Camera, size: Pixel, legend: &Legend) {
        let lines = legend.entries.len() as f64;
        let taken = [
            [[0.0, 0.0], [legend.width, legend.top + 24.0 + LINE * lines]],
            [
                [0.0, 0.0],
                [
                    16.0 + text_width(&legend.title, legend.title_size),
                    legend.top,
                ],
            ],
        ];
        for text in placed(self.picture, camera, size, &taken) {
            let label = &self.picture.labels[text.label];
            let [x, y] = text.middle;
            let (class, fill, weight) = if label.strong {
                ("ink halo", INK, " font-weight=\"600\"")
            } else {
                ("faint halo", FAINT, "")
            };
            let _ = writeln!(
                self.body,
                "<text class=\"{class}\" x=\"{}\" y=\"{}\" font-size=\"{LETTER}\" text-anchor=\"middle\" fill=\"{fill}\" stroke=\"{GROUND}\" stroke-width=\"3.5\"{weight}>{}</text>",
                number(x),
                number(y + 0.34 * LETTER),
                escaped(&label.text)
            );
        }
    }
}

enum Visible<'a> {
    Stroke(&'a Stroke),
    Dot(usize),
}

/// The corners of an arrow's head; `None` where it points to the eye.
pub(crate) fn arrow_head([behind, tip]: [Pixel; 2], width: f64) -> Option<[Pixel; 3]> {
    let [dx, dy] = [tip[0] - behind[0], tip[1] - behind[1]];
    let long = dx.hypot(dy);
    if long < 0.75 {
        return None;
    }
    let [dx, dy] = [dx / long, dy / long];
    let (size, half) = (6.0 + 2.4 * width, 2.4 + 1.1 * width);
    let tip = [tip[0] + 0.35 * size * dx, tip[1] + 0.35 * size * dy];
    let foot = [tip[0] - size * dx, tip[1] - size * dy];
    Some([
        tip,
        [foot[0] - half * dy, foot[1] + half * dx],
        [foot[0] + half * dy, foot[1] - half * dx],
    ])
}

/// A colour with a part of grey in it.
fn mixed(colour: Colour, grey: f64, part: f64) -> Colour {
    Colour(
        colour
            .0
            .map(|value| (f64::from(value) * (1.0 - part) + grey * part).round() as u8),
    )
}

fn outlines(regions: &[Vec<Pixel>]) -> String {
    regions.iter().map(|points| line(points, true)).collect()
}

/// The data of a path through points, to a tenth of a pixel.
fn line(points: &[Pixel], closed: bool) -> String {
    let mut text = String::new();
    for (k, [x, y]) in points.iter().enumerate() {
        let letter = match k {
            0 => "M",
            1 => "L",
            _ => " ",
        };
        let _ = write!(text, "{letter}{} {}", number(*x), number(*y));
    }
    if closed {
        text.push('Z');
    }
    text
}

/// A number to a tenth.
fn number(x: f64) -> String {
    decimals(x, 10.0)
}

/// A number to a thousandth.
fn number3(x: f64) -> String {
    decimals(x, 1e3)
}

fn decimals(x: f64, parts: f64) -> String {
    // Nothing is so far off the picture on purpose.
    let x = if x.is_finite() {
        x.clamp(-1e6, 1e6)
    } else {
        0.0
    };
    // Adding zero turns a negative zero into zero.
    ((x * parts).round() / parts + 0.0).to_string()
}
