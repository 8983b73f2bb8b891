//! Elements to be drawn together.

use crate::colour::{Colour, PALETTE};
use crate::shape::{Drawable, NotDrawable, Shape};
use crate::style::Style;
use crate::view::View;

/// Elements to be drawn together, and the view of them.
///
/// The scene is framed by its finite elements; lines and planes are cut off around them.
///
/// ```
/// use ga_draw::{Scene, Style};
/// use ga_runtime::cga3::{Line, Point, Sphere};
/// let mut scene = Scene::new("A line meets a sphere");
/// let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.0), 1.0);
/// let line = Line::through(Point::new(-2.0, 0.0, 0.5), Point::new(2.0, 0.5, 0.5));
/// scene.add(sphere, Style::labelled("S"))?;
/// scene.add(line, Style::labelled("l"))?;
/// scene.add(sphere & line, Style::labelled("S ∨ l"))?;
/// assert!(scene.to_svg().starts_with("<svg "));
/// assert!(scene.to_html().starts_with("<!DOCTYPE html>"));
/// # Ok::<(), ga_draw::NotDrawable>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The title: what the scene shows, in a few words.
    pub title: String,
    /// A description for readers who cannot see the picture. Where it is empty, a list of the
    /// elements takes its place.
    pub description: String,
    /// The direction from which the scene is seen, and the zoom.
    pub view: View,
    /// Width and height of the picture in pixels. Each is clamped to the range from 64 to 8192.
    pub size: [u32; 2],
    /// Whether the coordinate axes are drawn.
    pub axes: bool,
    /// Whether a grid is drawn in the horizontal plane through the origin.
    pub grid: bool,
    /// Whether the elements with a label are listed.
    pub legend: bool,
    elements: Vec<Element>,
}

/// An element with its label and its complete style.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Element {
    pub(crate) shape: Shape,
    pub(crate) label: Option<String>,
    pub(crate) colour: Colour,
    pub(crate) width: f64,
    pub(crate) opacity: f64,
}

impl Scene {
    /// An empty scene.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            description: String::new(),
            view: View::default(),
            size: [800, 600],
            axes: false,
            grid: false,
            legend: true,
            elements: Vec::new(),
        }
    }

    /// Adds an element. Its width is clamped to the range from 0.25 to 20 pixels and its opacity to
    /// the range from 0 to 1; NaN counts as not given.
    ///
    /// # Errors
    ///
    /// [`NotDrawable`] where the element has no place, or numbers that cannot be drawn. The scene
    /// is then unchanged.
    pub fn add(&mut self, element: impl Drawable, style: Style) -> Result<&mut Self, NotDrawable> {
        let shape = element.shape()?;
        let next = PALETTE[self.elements.len() % PALETTE.len()];
        let within = |value: Option<f64>, low, high, default| match value {
            Some(value) if !value.is_nan() => value.clamp(low, high),
            _ => default,
        };
        let opacity = match shape {
            Shape::Plane { .. } => 0.16,
            _ => 0.3,
        };
        self.elements.push(Element {
            shape,
            label: style.label.filter(|label| !label.trim().is_empty()),
            colour: style.colour.unwrap_or(next),
            width: within(style.width, 0.25, 20.0, 2.0),
            opacity: within(style.opacity, 0.0, 1.0, opacity),
        });
        Ok(self)
    }

    /// The shapes of the elements, in the order in which they were added.
    pub fn shapes(&self) -> impl Iterator<Item = &Shape> {
        self.elements.iter().map(|element| &element.shape)
    }

    pub(crate) fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// The description, or a list of the elements.
    pub(crate) fn description_or_list(&self) -> String {
        if !self.description.trim().is_empty() {
            return self.description.clone();
        }
        let describe = |element: &Element| match &element.label {
            Some(label) => format!("{} {label}", element.shape.kind()),
            None => element.shape.kind().to_owned(),
        };
        let list: Vec<String> = self.elements.iter().map(describe).collect();
        match list.len() {
            0 => "An empty scene.".to_owned(),
            _ => format!("Elements: {}.", list.join(", ")),
        }
    }
}
