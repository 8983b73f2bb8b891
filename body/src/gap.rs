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
    let mut gaps = gaps(cameras, observations);
    gaps.retain(|gap| gap.is_finite());
    Some(stated.max(median(&mut gaps)?))
}

/// The median of the gaps of all points; infinite where most rays meet behind a view, and `None`
/// where no point is seen by two views.
pub(crate) fn median_gap(cameras: &[Camera], observations: &[Observation]) -> Option<f64> {
    median(&mut gaps(cameras, observations))
}

/// The gaps of all points between all pairs of views.
fn gaps(cameras: &[Camera], observations: &[Observation]) -> Vec<f64> {
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
    gaps
}

/// A view disagrees with others where its rays miss theirs by so many times what these miss each
/// other.
const DISAGREES: f64 = 4.0;

/// The views whose rays miss those of all others by far, where these meet each other. Two views
/// are always kept: which of them is wrong cannot be told.
pub(crate) fn disagreeing(cameras: &[Camera], observations: &[Observation]) -> Vec<usize> {
    let Some(stated) = median(&mut deviations(observations)) else {
        return Vec::new();
    };
    let gaps: Vec<((usize, usize), f64)> = pairs_of_views(cameras.len())
        .filter_map(|(a, b)| {
            let of_two = |observation: &Observation| Observation {
                views: [a, b].map(|view| observation.views[view].clone()).to_vec(),
            };
            let of_two: Vec<Observation> = observations.iter().map(of_two).collect();
            Some(((a, b), median_gap(&[cameras[a], cameras[b]], &of_two)?))
        })
        .collect();
    let mut left_out: Vec<usize> = Vec::new();
    while cameras.len() - left_out.len() > 2 {
        let kept = (0..cameras.len()).filter(|view| !left_out.contains(view));
        let is_kept = |(a, b): (usize, usize)| !left_out.contains(&a) && !left_out.contains(&b);
        let of_view = |view: usize, own: bool| {
            let pairs = gaps.iter().filter(|(pair, _)| is_kept(*pair));
            let pairs = pairs.filter(|((a, b), _)| (*a == view || *b == view) == own);
            pairs.map(|(_, gap)| *gap).collect::<Vec<f64>>()
        };
        let worst = kept
            .filter_map(|view| {
                // A view that shows no joint together with another one says nothing.
                let nearest = of_view(view, true).into_iter().reduce(f64::min)?;
                let others = median(&mut of_view(view, false))?.max(stated);
                let times = nearest / others;
                (times > DISAGREES).then_some((view, times))
            })
            .max_by(|a, b| a.1.total_cmp(&b.1));
        match worst {
            Some((view, _)) => left_out.push(view),
            None => break,
        }
    }
    left_out
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
