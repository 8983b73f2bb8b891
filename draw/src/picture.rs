//! A scene as balls, flat patches, curves and dots: what both the picture and the page draw.
//!
//! All coordinates are those in which the [extent](crate::extent) is the ball of radius 1 about the
//! origin.

use serde::Serialize;

use crate::extent::Extent;
use crate::scene::{Element, Scene};
use crate::shape::{Shape, ends};
use crate::style::Colour;
use crate::vector3::{
    Vector3, along, basis_across, difference, dot, length, normalized, on_circle, scaled, sum,
};

/// How far lines and planes reach.
const REACH: f64 = 1.15;

/// How long the axes of a frame are.
const FRAME: f64 = 0.24;

/// The colours of the three axes of a frame.
const AXES: [Colour; 3] = [
    Colour([0xd5, 0x5e, 0x00]),
    Colour([0x00, 0x94, 0x6c]),
    Colour([0x00, 0x72, 0xb2]),
];

/// The colour of the coordinate axes and of the grid.
const GREY: Colour = Colour([0x7a, 0x7a, 0x7a]);

/// Everything to be drawn.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct Picture {
    pub(crate) balls: Vec<Ball>,
    pub(crate) patches: Vec<Patch>,
    pub(crate) curves: Vec<Curve>,
    pub(crate) dots: Vec<Dot>,
    pub(crate) labels: Vec<Label>,
}

/// A sphere.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Ball {
    /// The element that it belongs to.
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded")]
    pub(crate) centre: Vector3,
    #[serde(serialize_with = "rounded_number")]
    pub(crate) radius: f64,
    pub(crate) opacity: f64,
    pub(crate) width: f64,
    /// Whether its outline is dashed, and nothing inside it.
    pub(crate) imaginary: bool,
}

/// A part of a plane, convex.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Patch {
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded_list")]
    pub(crate) corners: Vec<Vector3>,
    #[serde(serialize_with = "rounded")]
    pub(crate) normal: Vector3,
    pub(crate) opacity: f64,
}

/// A line through points, which lie closely enough for a smooth one.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Curve {
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded_list")]
    pub(crate) points: Vec<Vector3>,
    pub(crate) width: f64,
    pub(crate) opacity: f64,
    pub(crate) dashed: bool,
    /// Whether it ends in the head of an arrow.
    pub(crate) arrow: bool,
}

/// A point, of a size in pixels.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Dot {
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded")]
    pub(crate) at: Vector3,
    pub(crate) radius: f64,
    pub(crate) form: Form,
}

/// What a dot looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Form {
    Full,
    Hollow,
    Square,
}

/// A text beside a place.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Label {
    pub(crate) element: Option<usize>,
    #[serde(serialize_with = "rounded")]
    pub(crate) at: Vector3,
    pub(crate) text: String,
    /// Whether it belongs to an element and not to an axis.
    pub(crate) strong: bool,
}

impl Picture {
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut maker = Maker {
            extent: Extent::of(scene),
            up: scene.view.up.axes()[2],
            picture: Self::default(),
        };
        if scene.grid {
            maker.grid(scene.view.up.axes());
        }
        if scene.axes {
            maker.axes();
        }
        for (index, element) in scene.elements().iter().enumerate() {
            maker.element(index, element);
        }
        maker.picture
    }
}

struct Maker {
    extent: Extent,
    up: Vector3,
    picture: Picture,
}

impl Maker {
    fn element(&mut self, index: usize, element: &Element) {
        let extent = self.extent;
        let pen = Pen {
            element: Some(index),
            colour: element.colour,
            width: element.width,
        };
        let place = |point: &Vector3| extent.place(*point);
        let anchor = match &element.shape {
            Shape::Point { at } => self.dot(&pen, place(at), Form::Full),
            Shape::FlatPoint { at } => self.dot(&pen, place(at), Form::Square),
            Shape::PointPair {
                centre,
                direction,
                radius,
                imaginary,
            } => {
                let [p, q] = ends(*centre, *direction, *radius).map(|end| place(&end));
                self.curve(pen.thin(), segment(p, q, 24)).dashed = *imaginary;
                let form = if *imaginary { Form::Hollow } else { Form::Full };
                self.dot(&pen, p, form);
                self.dot(&pen, q, form)
            }
            Shape::TangentVector { at, direction } => {
                let at = place(at);
                self.dot(&pen, at, Form::Full);
                self.arrow(pen, at, scaled(*direction, FRAME));
                at
            }
            Shape::Circle {
                centre,
                normal,
                radius,
                imaginary,
            } => {
                let (centre, radius) = (place(centre), radius / extent.radius);
                let basis = basis_across(*normal, self.up);
                self.curve(pen, ring(centre, basis, radius, 96)).dashed = *imaginary;
                on_circle(centre, basis, radius, 0.7)
            }
            Shape::TangentBivector { at, normal } => {
                let at = place(at);
                let basis = basis_across(*normal, self.up);
                self.curve(pen.thin(), ring(at, basis, 0.4 * FRAME, 48));
                self.arrow(pen.thin(), at, scaled(*normal, 0.6 * FRAME));
                self.dot(&pen, at, Form::Full)
            }
            Shape::Sphere {
                centre,
                radius,
                imaginary,
            } => {
                let (centre, radius) = (place(centre), radius / extent.radius);
                self.ball(pen, centre, radius, *imaginary, element.opacity);
                // On the outline as seen from most sides.
                along(centre, self.up, radius)
            }
            Shape::Line { support, direction } => {
                let support = place(support);
                let (middle, half) = cut(support, *direction);
                let [from, to] = [-half, half].map(|t| along(middle, *direction, t));
                self.curve(pen, segment(from, to, 64)).arrow = true;
                along(middle, *direction, 0.8 * half)
            }
            Shape::Plane { support, normal } => {
                let support = place(support);
                self.plane(
                    pen,
                    along([0.0; 3], *normal, dot(support, *normal)),
                    *normal,
                    element.opacity,
                )
            }
            Shape::Direction { vector } => {
                let from = place(&[0.0; 3]);
                let vector = scaled(*vector, extent.radius.recip());
                self.arrow(pen, from, vector);
                along(from, vector, 0.6)
            }
            Shape::Frame { origin, axes } => {
                let at = place(origin);
                self.frame(pen, at, axes, FRAME);
                for (axis, text) in axes.iter().zip(["x", "y", "z"]) {
                    self.picture.labels.push(Label {
                        element: Some(index),
                        at: along(at, *axis, 1.12 * FRAME),
                        text: text.to_owned(),
                        strong: false,
                    });
                }
                self.dot(&pen, at, Form::Full)
            }
            Shape::Trajectory { points, frames } => {
                let points: Vec<Vector3> = points.iter().map(place).collect();
                for (origin, axes) in frames {
                    self.frame(pen.thin(), place(origin), axes, 0.6 * FRAME);
                }
                let middle = points[points.len() / 2];
                let (first, last) = (points[0], points[points.len() - 1]);
                if points.len() > 1 && points.iter().any(|point| *point != first) {
                    self.curve(pen, refined(&points)).arrow = first != last;
                    middle
                } else {
                    self.dot(&pen, first, Form::Full)
                }
            }
        };
        if let Some(text) = &element.label {
            self.picture.labels.push(Label {
                element: Some(index),
                at: anchor,
                text: text.clone(),
                strong: true,
            });
        }
    }

    /// Adds a curve, to be changed further.
    fn curve(&mut self, pen: Pen, points: Vec<Vector3>) -> &mut Curve {
        let place = self.picture.curves.len();
        self.picture.curves.push(Curve {
            element: pen.element,
            colour: pen.colour,
            points,
            width: pen.width,
            opacity: 1.0,
            dashed: false,
            arrow: false,
        });
        &mut self.picture.curves[place]
    }

    fn dot(&mut self, pen: &Pen, at: Vector3, form: Form) -> Vector3 {
        self.picture.dots.push(Dot {
            element: pen.element,
            colour: pen.colour,
            at,
            radius: 2.6 + 0.8 * pen.width,
            form,
        });
        at
    }

    fn arrow(&mut self, pen: Pen, from: Vector3, vector: Vector3) {
        self.curve(pen, segment(from, sum(from, vector), 16)).arrow = true;
    }

    fn frame(&mut self, pen: Pen, at: Vector3, axes: &[Vector3; 3], size: f64) {
        for (axis, colour) in axes.iter().zip(AXES) {
            let pen = Pen { colour, ..pen };
            self.arrow(pen, at, scaled(*axis, size));
        }
    }

    /// A sphere with its equator and two meridians.
    fn ball(&mut self, pen: Pen, centre: Vector3, radius: f64, imaginary: bool, opacity: f64) {
        self.picture.balls.push(Ball {
            element: pen.element,
            colour: pen.colour,
            centre,
            radius,
            opacity: if imaginary { 0.25 * opacity } else { opacity },
            width: 0.75 * pen.width,
            imaginary,
        });
        let [u, v] = basis_across(self.up, self.up);
        for basis in [[u, v], [u, self.up], [v, self.up]] {
            let curve = self.curve(pen.fine(), ring(centre, basis, radius, 72));
            (curve.opacity, curve.dashed) = (0.55, imaginary);
        }
    }

    /// A square of a plane about the point nearest to the middle of the picture, ruled, with its
    /// normal; gives the corner for the label.
    fn plane(&mut self, pen: Pen, middle: Vector3, normal: Vector3, opacity: f64) -> Vector3 {
        let [u, v] = basis_across(normal, self.up);
        let half = 0.92 * REACH;
        let corner = |a: f64, b: f64| along(along(middle, u, a * half), v, b * half);
        let corners = vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        self.picture.patches.push(Patch {
            element: pen.element,
            colour: pen.colour,
            corners: corners.clone(),
            normal,
            opacity,
        });
        for side in 0..4 {
            let points = segment(corners[side], corners[(side + 1) % 4], 32);
            self.curve(pen.thin(), points).opacity = 0.8;
        }
        for k in -3..=3 {
            let t = f64::from(k) / 4.0;
            for [from, to] in [
                [corner(t, -1.0), corner(t, 1.0)],
                [corner(-1.0, t), corner(1.0, t)],
            ] {
                self.curve(pen.fine(), segment(from, to, 32)).opacity = 0.35;
            }
        }
        let foot = corner(0.75, 0.75);
        self.arrow(pen.thin(), foot, scaled(normal, 0.8 * FRAME));
        corner(-0.9, 0.9)
    }

    /// The coordinate axes through the origin.
    fn axes(&mut self) {
        let origin = self.extent.place([0.0; 3]);
        for (axis, name) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .into_iter()
            .zip(["x", "y", "z"])
        {
            let (middle, half) = cut(origin, axis);
            let (from, to) = (along(middle, axis, -half), along(middle, axis, half));
            let curve = self.curve(Pen::GREY, segment(from, to, 64));
            (curve.arrow, curve.opacity) = (true, 0.9);
            self.picture.labels.push(Label {
                element: None,
                at: along(to, axis, 0.05),
                text: name.to_owned(),
                strong: false,
            });
        }
    }

    /// Lines in the horizontal plane through the origin, one or a round number of units apart.
    fn grid(&mut self, [u, v, up]: [Vector3; 3]) {
        let extent = self.extent;
        let step = round_step(extent.radius / 4.0);
        // In units of the scene the grid is a square about the middle, with lines at multiples of
        // the step.
        let [a, b] = [u, v].map(|axis| (dot(extent.centre, axis) / step).round());
        let reach = (REACH * extent.radius / step).floor().clamp(1.0, 12.0);
        let height = -dot(extent.centre, up) / extent.radius;
        let corner = |s: f64, t: f64| {
            let point = along(scaled(u, (a + s) * step), v, (b + t) * step);
            let flat = difference(
                extent.place(point),
                scaled(up, dot(extent.place(point), up)),
            );
            along(flat, up, height)
        };
        let count = reach as i32;
        for k in -count..=count {
            let k = f64::from(k);
            for [from, to] in [
                [corner(k, -reach), corner(k, reach)],
                [corner(-reach, k), corner(reach, k)],
            ] {
                let curve = self.curve(Pen::GREY.fine(), segment(from, to, 48));
                curve.opacity = 0.4;
            }
        }
    }
}

/// What a line is drawn with.
#[derive(Clone, Copy)]
struct Pen {
    element: Option<usize>,
    colour: Colour,
    width: f64,
}

impl Pen {
    const GREY: Self = Self {
        element: None,
        colour: GREY,
        width: 1.2,
    };

    fn thin(self) -> Self {
        let width = 0.7 * self.width;
        Self { width, ..self }
    }

    fn fine(self) -> Self {
        let width = 0.45 * self.width;
        Self { width, ..self }
    }
}

/// The middle of a line's part within reach, and half its length.
fn cut(point: Vector3, direction: Vector3) -> (Vector3, f64) {
    let middle = along(point, direction, -dot(point, direction));
    let half = (REACH * REACH - dot(middle, middle)).max(0.1).sqrt();
    (middle, half)
}

fn segment(from: Vector3, to: Vector3, pieces: u32) -> Vec<Vector3> {
    let step = difference(to, from);
    let place = |k| match k {
        _ if k == pieces => to,
        _ => along(from, step, f64::from(k) / f64::from(pieces)),
    };
    (0..=pieces).map(place).collect()
}

/// A circle, its first point also the last.
fn ring(centre: Vector3, basis: [Vector3; 2], radius: f64, pieces: u32) -> Vec<Vector3> {
    let angle = |k: u32| std::f64::consts::TAU * f64::from(k % pieces) / f64::from(pieces);
    (0..=pieces)
        .map(|k| on_circle(centre, basis, radius, angle(k)))
        .collect()
}

/// A path with points put in where they lie far apart, so that a part of it can be hidden.
fn refined(points: &[Vector3]) -> Vec<Vector3> {
    let mut fine = vec![points[0]];
    for pair in points.windows(2) {
        let gap = length(difference(pair[1], pair[0]));
        let pieces = (gap / 0.05).ceil().clamp(1.0, 48.0) as u32;
        fine.extend(&segment(pair[0], pair[1], pieces)[1..]);
    }
    fine
}

/// 1, 2 or 5 times a power of ten, near a positive number.
fn round_step(about: f64) -> f64 {
    let power = 10.0_f64.powf(about.log10().floor());
    let factor = about / power;
    power
        * match factor {
            _ if factor < 1.5 => 1.0,
            _ if factor < 3.5 => 2.0,
            _ if factor < 7.5 => 5.0,
            _ => 10.0,
        }
}

/// The direction of the last piece of a curve.
pub(crate) fn heading(points: &[Vector3]) -> Option<Vector3> {
    let (last, before) = points.split_last()?;
    let steps = before.iter().rev().map(|point| difference(*last, *point));
    steps.into_iter().find_map(normalized)
}

fn short(x: f64) -> f64 {
    // Adding zero turns a negative zero into zero.
    (x * 1e5).round() / 1e5 + 0.0
}

/// The picture with the numbers that are written of it.
#[cfg(test)]
pub(crate) fn as_written(picture: &Picture) -> Picture {
    let mut picture = picture.clone();
    for ball in &mut picture.balls {
        ball.centre = ball.centre.map(short);
        ball.radius = short(ball.radius);
    }
    for patch in &mut picture.patches {
        patch.corners = patch.corners.iter().map(|point| point.map(short)).collect();
        patch.normal = patch.normal.map(short);
    }
    for curve in &mut picture.curves {
        curve.points = curve.points.iter().map(|point| point.map(short)).collect();
    }
    for dot in &mut picture.dots {
        dot.at = dot.at.map(short);
    }
    for label in &mut picture.labels {
        label.at = label.at.map(short);
    }
    picture
}

fn rounded<S: serde::Serializer>(point: &Vector3, serializer: S) -> Result<S::Ok, S::Error> {
    point.map(short).serialize(serializer)
}

fn rounded_number<S: serde::Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    short(*number).serialize(serializer)
}

fn rounded_list<S: serde::Serializer>(
    points: &[Vector3],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(points.iter().map(|point| point.map(short)))
}

impl Serialize for Colour {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
