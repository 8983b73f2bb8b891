//! The camera that makes a scene fill the picture.

use super::legend::Legend;
use crate::camera::{Camera, Pixel};
use crate::picture::Picture;
use crate::scene::Scene;
use crate::stroke::all_curves;

/// The space around the scene for labels and heads of arrows, in pixels.
const MARGIN: f64 = 34.0;

/// The camera with which the scene fits into the picture beside the legend.
pub(super) fn fitted(
    scene: &Scene,
    picture: &Picture,
    legend: &Legend,
    [width, height]: Pixel,
) -> Camera {
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
    // A single point is not enlarged without bound.
    camera.scale = scales[0].min(scales[1]).min(width.max(height)) * zoom;
    camera.middle =
        [0, 1].map(|k| 0.5 * (room[0][k] + room[1][k]) - camera.scale * 0.5 * (low[k] + high[k]));
    camera
}
