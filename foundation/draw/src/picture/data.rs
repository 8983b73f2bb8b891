//! The data of a picture, and its JSON for the page.

use ga_runtime::vga3::Vector;
use serde::Serialize;

use crate::colour::Colour;

/// Everything that is drawn.
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
    /// The index of the element that it belongs to.
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded")]
    pub(crate) centre: Vector<f64>,
    #[serde(serialize_with = "rounded_number")]
    pub(crate) radius: f64,
    pub(crate) opacity: f64,
    pub(crate) width: f64,
    /// Whether it is drawn with dashed lines and hides nothing.
    pub(crate) imaginary: bool,
}

/// A convex part of a plane.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Patch {
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded_list")]
    pub(crate) corners: Vec<Vector<f64>>,
    #[serde(serialize_with = "rounded")]
    pub(crate) normal: Vector<f64>,
    pub(crate) opacity: f64,
}

/// A line through points, which are close enough for the line to look smooth.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Curve {
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded_list")]
    pub(crate) points: Vec<Vector<f64>>,
    pub(crate) width: f64,
    pub(crate) opacity: f64,
    pub(crate) dashed: bool,
    /// Whether it ends in an arrow's head.
    pub(crate) arrow: bool,
}

/// A point, with a radius in pixels.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Dot {
    pub(crate) element: Option<usize>,
    pub(crate) colour: Colour,
    #[serde(serialize_with = "rounded")]
    pub(crate) at: Vector<f64>,
    pub(crate) radius: f64,
    pub(crate) form: Form,
}

/// The form of a dot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Form {
    Full,
    Hollow,
    Square,
}

/// A text beside its anchor.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Label {
    pub(crate) element: Option<usize>,
    #[serde(serialize_with = "rounded")]
    pub(crate) at: Vector<f64>,
    pub(crate) text: String,
    /// Whether it is the label of an element and not the name of an axis.
    pub(crate) strong: bool,
}

/// The picture with its numbers rounded as in its JSON.
#[cfg(test)]
pub(crate) fn as_written(picture: &Picture) -> Picture {
    let short = |point: Vector<f64>| Vector::from(shortened(point));
    let mut picture = picture.clone();
    for ball in &mut picture.balls {
        (ball.centre, ball.radius) = (short(ball.centre), short_number(ball.radius));
    }
    for patch in &mut picture.patches {
        patch.corners = patch.corners.iter().copied().map(short).collect();
        patch.normal = short(patch.normal);
    }
    for curve in &mut picture.curves {
        curve.points = curve.points.iter().copied().map(short).collect();
    }
    for dot in &mut picture.dots {
        dot.at = short(dot.at);
    }
    for label in &mut picture.labels {
        label.at = short(label.at);
    }
    picture
}

/// A number to five decimals, which is less than a pixel of any screen.
fn short_number(x: f64) -> f64 {
    // Adding zero turns a negative zero into zero.
    (x * 1e5).round() / 1e5 + 0.0
}

fn shortened(point: Vector<f64>) -> [f64; 3] {
    point.coordinates().map(short_number)
}

fn rounded<S: serde::Serializer>(point: &Vector<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    shortened(*point).serialize(serializer)
}

fn rounded_number<S: serde::Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    short_number(*number).serialize(serializer)
}

fn rounded_list<S: serde::Serializer>(
    points: &[Vector<f64>],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(points.iter().map(|point| shortened(*point)))
}
