//! The disparities that a matcher without errors would find in the rectified still.

use anyhow::Result;
use ga_camera::Camera;
use ga_camera::rig::StereoRig;
use ga_image::plane::Plane;
use ga_render::DepthMap;
use ga_runtime::cga3::Point;
use ga_vision::disparity::DisparityMap;
use ga_vision::rectification::{Rectification, RectificationOptions};
use rayon::prelude::*;

use super::inputs::Truth;
use super::studio::SIZE;

/// A surface is the one that the other camera shows where their depths differ by less than this
/// part.
const SAME: f64 = 0.01;

/// The true disparity of each pixel of the left view as a rig rectifies it, and whether the right
/// view shows the same point.
pub(super) fn true_disparities(
    found: &StereoRig,
    truth: &Truth,
) -> Result<(DisparityMap, Plane<u8>)> {
    let rectification = Rectification::new(found, SIZE, RectificationOptions::default())?;
    let [width, height] = rectification.size;
    let rows = (0..height).into_par_iter().map(|row| {
        let pixels = (0..width)
            .map(|column| of_pixel([column as f64, row as f64], &rectification, found, truth));
        pixels.collect::<Vec<_>>()
    });
    let pixels: Vec<Option<(f64, bool)>> = rows.flatten_iter().collect();
    let disparities = pixels
        .iter()
        .map(|pixel| pixel.map_or(f32::NAN, |(d, _)| d as f32));
    let visible = pixels.iter().map(|pixel| match pixel {
        Some((_, true)) => u8::MAX,
        _ => 0,
    });
    let map = Plane::from_values(width, height, disparities.collect())?;
    let mask = Plane::from_values(width, height, visible.collect())?;
    Ok((DisparityMap::new(map), mask))
}

/// The disparity of a pixel of the rectified left view, and whether both cameras see its point.
fn of_pixel(
    pixel: [f64; 2],
    rectification: &Rectification,
    found: &StereoRig,
    truth: &Truth,
) -> Option<(f64, bool)> {
    let rectified = rectification.rig.left();
    let direction = rectified.direction(pixel).ok()?;
    let back = rectification.left.motor.reverse();
    let seen = back.transform(Point::from(direction.coordinates()));
    let in_view = found.left.intrinsics.project(seen).ok()?;
    let depth = depth_at(&truth.depths[0], in_view)?;
    let point = unprojected(&truth.rig.left, in_view, depth)?;
    let in_right = truth.rig.right.project(point).ok()?;
    let [_, _, right_depth] = truth
        .rig
        .right
        .world_to_camera
        .transform(point)
        .coordinates();
    let of_right = depth_at(&truth.depths[1], in_right);
    let is_visible = of_right.is_some_and(|depth| (depth - right_depth).abs() < SAME * depth);
    let [column, _] = rectification.right_pixel(in_right).ok()?;
    Some((pixel[0] - column, is_visible))
}

/// The depth at the pixel around a place.
fn depth_at(map: &DepthMap, place: [f64; 2]) -> Option<f64> {
    let [column, row] = place.map(f64::round);
    let is_inside = column >= 0.0 && row >= 0.0;
    is_inside.then(|| map.get(column as u32, row as u32))?
}

/// The point at a depth that a camera shows at a pixel.
fn unprojected(camera: &Camera, pixel: [f64; 2], depth: f64) -> Option<Point<f64>> {
    let direction = camera.intrinsics.direction(pixel).ok()?.coordinates();
    let in_frame = Point::from(direction.map(|part| part * depth / direction[2]));
    Some(camera.world_to_camera.reverse().transform(in_frame))
}
