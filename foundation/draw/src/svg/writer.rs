//! SVG elements for the parts of a picture.

use std::fmt::Write as _;

use super::path::{line, number, number3, outlines};
use super::theme::{FAINT, GROUND, INK};
use crate::camera::{Camera, Pixel};
use crate::colour::Colour;
use crate::escape::escaped;
use crate::label::{Frame, LETTER, placed};
use crate::picture::{Ball, Curve, Form, Picture};
use crate::stroke::{Hiding, Stroke, all_curves};
use crate::surface::{Piece, Surface};

pub(super) struct Writer<'a> {
    pub(super) defs: String,
    pub(super) body: String,
    clips: usize,
    picture: &'a Picture,
}

impl<'a> Writer<'a> {
    pub(super) fn new(picture: &'a Picture) -> Self {
        Self {
            defs: String::new(),
            body: String::new(),
            clips: 0,
            picture,
        }
    }

    pub(super) fn surfaces_and_strokes(&mut self, camera: &Camera) {
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
        // A dot is painted over the lines through it.
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
        if let Some(head) = stroke.head {
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

    /// Writes the labels beside the boxes that are taken.
    pub(super) fn labels(&mut self, camera: &Camera, size: Pixel, taken: &[Frame]) {
        for text in placed(self.picture, camera, size, taken) {
            let label = &self.picture.labels[text.label];
            let [x, y] = text.middle;
            if let Some(leader) = text.leader() {
                let _ = writeln!(
                    self.body,
                    "<path d=\"{}\" fill=\"none\" class=\"leader\" stroke=\"{FAINT}\" stroke-width=\"0.8\"/>",
                    line(&leader, false)
                );
            }
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

/// A colour mixed with a part of grey.
fn mixed(colour: Colour, grey: f64, part: f64) -> Colour {
    Colour(
        colour
            .0
            .map(|value| (f64::from(value) * (1.0 - part) + grey * part).round() as u8),
    )
}
