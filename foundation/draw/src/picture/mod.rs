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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use ga_runtime::cga3::{Plane, Point};
    use ga_runtime::vga3::Vector;

    use super::*;
    use crate::style::Style;

    /// Four borders and seven lines each way, a quarter of half a side apart, all in the plane.
    #[test]
    fn a_plane_is_a_square_with_a_grid() {
        let mut scene = Scene::new("A plane");
        let plane = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
        scene.add(plane, Style::default()).unwrap();
        (scene.grid, scene.axes) = (false, false);
        let picture = Picture::of(&scene);
        let [patch] = &picture.patches[..] else {
            panic!("one square")
        };
        let sides =
            (0..4).map(|side| (patch.corners[side] - patch.corners[(side + 1) % 4]).length());
        let side = patch.corners[0].e1.abs() * 2.0;
        assert!(sides.into_iter().all(|other| (other - side).abs() < 1e-12));
        let ends = |curve: &Curve| [curve.points[0], curve.points[curve.points.len() - 1]];
        let grid = picture.curves.iter().filter(|curve| curve.opacity == 0.35);
        let mut places: [Vec<i32>; 2] = Default::default();
        for [from, to] in grid.map(ends) {
            assert!(((from - to).length() - side).abs() < 1e-12);
            let across = usize::from((from - to).e1.abs() < 1e-12);
            let place = |end: Vector<f64>| if across == 1 { end.e1 } else { end.e2 };
            assert!((place(from) - place(to)).abs() < 1e-12);
            let eighths = place(from) / (side / 8.0);
            assert!((eighths - eighths.round()).abs() < 1e-9, "{eighths}");
            places[across].push(eighths.round() as i32);
        }
        for mut places in places {
            places.sort_unstable();
            assert_eq!(places, [-3, -2, -1, 0, 1, 2, 3]);
        }
    }
}
