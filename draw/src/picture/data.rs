//! The data of a picture, and how they are written as JSON.

use serde::Serialize;

use crate::colour::Colour;
use crate::vector3::Vector3;

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
