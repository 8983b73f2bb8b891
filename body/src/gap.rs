//! How far the rays of one point from two views miss each other, in pixels.

use ga_camera::Camera;
use ga_camera::triangulation::triangulate;
use ga_numerics::order_statistics::median;
use ga_runtime::geometry::ray::Ray;

use crate::Observation;

/// The least distance of two rays as their views see it: the length of their common perpendicular
/// over the sum of what a pixel is there in each view. Infinite where they meet behind a view.
pub(crate) fn gap_in_pixels(cameras: [&Camera; 2], rays: [Ray<f64>; 2]) -> f64 {
    let Ok(found) = triangulate(rays[0], rays[1]) else {
        return f64::INFINITY;
    };
    if !found.is_in_front() {
        return f64::INFINITY;
    }
    let metres_per_pixel = cameras.iter().zip(found.depths).map(|(camera, depth)| {
        let [x, y] = camera.intrinsics.focal();
        depth / (0.5 * (x + y))
    });
    found.gap / metres_per_pixel.sum::<f64>()
}

/// The standard deviation of pixels that the gaps of all points show, or that the pixels state
/// where this is larger. `None` where no point is seen by two views.
pub(crate) fn noise(cameras: &[Camera], observations: &[Observation]) -> Option<f64> {
    let stated = median(&mut deviations(observations))?;
    let mut gaps: Vec<f64> = Vec::new();
    for observation in observations {
        for (a, b) in pairs_of_views(cameras.len()) {
            let pixels = observation.views[a].iter().zip(&observation.views[b]);
            for (one, other) in pixels {
                let (Some(one), Some(other)) = (one, other) else {
                    continue;
                };
                let rays = [cameras[a].ray(one.position), cameras[b].ray(other.position)];
                if let [Ok(one), Ok(other)] = rays {
                    gaps.push(gap_in_pixels([&cameras[a], &cameras[b]], [one, other]));
                }
            }
        }
    }
    gaps.retain(|gap| gap.is_finite());
    Some(stated.max(median(&mut gaps)?))
}

/// The deviations of all pixels.
pub(crate) fn deviations(observations: &[Observation]) -> Vec<f64> {
    let pixels = observations.iter().flat_map(|o| o.views.iter().flatten());
    pixels.flatten().map(|pixel| pixel.deviation).collect()
}

/// All pairs of views.
pub(crate) fn pairs_of_views(views: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..views).flat_map(move |a| (a + 1..views).map(move |b| (a, b)))
}
