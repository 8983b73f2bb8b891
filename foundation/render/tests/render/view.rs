//! Where cameras stand and where they see points.

use ga_render::{View, ViewDirection};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use crate::FIELD_OF_VIEW;

pub(crate) fn point() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-50f64..50.0)
}

proptest! {
    /// All points inside, with the margin free, and as near as that allows.
    #[test]
    fn a_fitted_camera_sees_everything_and_no_more(
        points in prop::collection::vec(point(), 2..40),
        azimuth in -7f64..7.0,
        elevation in -1.5f64..1.5,
        aspect in 0.2f64..4.0,
        margin in 0f64..0.5,
    ) {
        let view = ViewDirection { azimuth, elevation };
        let camera = View::fit(points.clone(), view, FIELD_OF_VIEW, aspect, margin).unwrap();
        let (width, height) = ((1e4 * aspect) as u32, 10_000);
        let mut most = 0f64;
        for &point in &points {
            let [column, row, depth] = camera.project(point, width, height).unwrap();
            prop_assert!(depth > camera.near());
            let x = (2.0 * column / f64::from(width) - 1.0) / (1.0 - margin);
            let y = (2.0 * row / f64::from(height) - 1.0) / (1.0 - margin);
            most = most.max(x.abs()).max(y.abs());
        }
        prop_assert!(most < 1.001, "{most}");
        let (eye, forward) = (Vector::from(camera.eye()), Vector::from(camera.forward()));
        let depths = points.iter().map(|&p| (Vector::from(p) - eye).dot(forward));
        let nearest = depths.clone().fold(f64::INFINITY, f64::min);
        let extent = depths.fold(0.0, f64::max);
        prop_assert!(most > 0.999 || nearest < 0.06 * extent, "{most} leaves room");
        prop_assert!(camera.up()[1] > 0.0 && camera.right()[1].abs() < 1e-12);
        let side = [azimuth.sin() * elevation.cos(), elevation.sin(), azimuth.cos() * elevation.cos()];
        prop_assert!(Vector::from(side).dot(forward) < -1.0 + 1e-9);
    }

    /// `project` against the textbook: the line from the eye through the point pierces the picture
    /// plane.
    #[test]
    fn projected_points_lie_on_their_lines_of_sight(eye in point(), target in point(), at in point()) {
        prop_assume!(Vector::from(eye).distance(target.into()) > 1.0);
        let up = [0.1, 1.0, 0.2];
        let Ok(camera) = View::look_at(eye, target, up, FIELD_OF_VIEW, 1e-3) else {
            return Ok(());
        };
        let middle = camera.project(target, 200, 100).unwrap();
        prop_assert!((middle[0] - 100.0).abs() < 1e-9 && (middle[1] - 50.0).abs() < 1e-9);
        if let Some([column, row, depth]) = camera.project(at, 200, 100) {
            let slope = (FIELD_OF_VIEW / 2.0).tan() / 50.0 * depth;
            for axis in 0..3 {
                let rebuilt = eye[axis]
                    + camera.forward()[axis] * depth
                    + camera.right()[axis] * (column - 100.0) * slope
                    + camera.up()[axis] * (50.0 - row) * slope;
                prop_assert!((rebuilt - at[axis]).abs() < 1e-6 * (1.0 + depth));
            }
        }
    }

}
