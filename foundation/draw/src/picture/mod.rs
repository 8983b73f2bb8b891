//! A scene as balls, flat patches, curves and dots: what both SVG and the page draw.
//!
//! In the coordinates of the picture the [extent](crate::extent) of the scene is the ball of radius
//! 1 about the origin.

mod background;
mod data;
mod drawing;
mod element;
mod pen;
mod polyline;

#[cfg(test)]
pub(crate) use data::as_written;
pub(crate) use data::{Ball, Curve, Form, Label, Patch, Picture};
pub(crate) use polyline::heading;

use crate::extent::Extent;
use crate::scene::Scene;
use drawing::Drawing;

impl Picture {
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut drawing = Drawing::new(Extent::of(scene), scene.view.up.axes());
        if scene.grid {
            drawing.grid();
        }
        if scene.axes {
            drawing.coordinate_axes();
        }
        for (index, element) in scene.elements().iter().enumerate() {
            drawing.element(index, element);
        }
        drawing.picture
    }
}
