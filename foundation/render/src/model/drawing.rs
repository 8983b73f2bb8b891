//! Models as scenes with what is drawn beside them.

use ga_image::colour::LinearColour;
use ga_runtime::vga3::Vector;

use super::Model;
use crate::{Ground, Polyline, Scene, Visibility};

/// What is drawn beside the surfaces, lines and points of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// The edges of all triangles.
    pub edges: bool,
    /// Level ground.
    pub ground: Option<Ground>,
}

/// The width of the model's polylines and the diameter of its points, in pixels.
const LINE_WIDTH: f64 = 2.0;
const POINT_DIAMETER: f64 = 5.0;

/// The width and the colour of edges, in pixels and in sRGB.
const EDGE_WIDTH: f64 = 1.0;
const EDGE_COLOUR: [u8; 3] = [30, 40, 60];

impl Model {
    /// Calls `draw` with the model as a scene.
    pub fn with_scene<T>(&self, options: Options, draw: impl FnOnce(&Scene) -> T) -> T {
        let materials = self.materials();
        let edges = match options.edges {
            true => self.edges(),
            false => Vec::new(),
        };
        let mut lines = self.lines(LINE_WIDTH);
        lines.extend(edges.iter().map(|ends| Polyline {
            points: ends,
            colour: LinearColour::from_srgb(EDGE_COLOUR),
            width: EDGE_WIDTH,
            visibility: Visibility::Hidden,
        }));
        draw(&Scene {
            lines: &lines,
            dots: &self.dots(POINT_DIAMETER),
            ground: options.ground,
            ..self.scene(&materials)
        })
    }

    /// The least and the greatest coordinates of the model's points; zeros without points.
    #[must_use]
    pub fn bounds(&self) -> [Vector<f64>; 2] {
        ga_mesh::bounds(self.points().map(Vector::from)).unwrap_or_default()
    }
}
