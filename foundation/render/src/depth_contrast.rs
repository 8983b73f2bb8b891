//! Darkening behind edges, so that crossing limbs can be distinguished.
//!
//! After Luft, Colditz and Deussen 2006, *Image enhancement by unsharp masking the depth buffer*:
//! where a surface lies further away than the mean of its surroundings, something near stands
//! beside it, and it is darkened.

use crate::depth::DepthMap;
use ga_image::colour::LinearColour;

/// The surroundings, as a fraction of the picture's height.
const RADIUS: f64 = 0.035;

/// No surface is darkened by more than this.
const MOST: f64 = 0.55;

/// Takes from each pixel that shows a surface `strength` times the part of `extent` by which it
/// lies further away than the mean of the surfaces around it.
pub(crate) fn darken_behind_edges(
    light: &mut [LinearColour],
    depth: &DepthMap,
    extent: f64,
    strength: f64,
) {
    let Some((near, far)) = depth.range() else {
        return;
    };
    if strength == 0.0 || extent.is_nan() || extent <= 0.0 {
        return;
    }
    // Depths from 0 to 1, which single precision carries well.
    let relative = |d: f32| ((f64::from(d) - near) / (far - near).max(f64::MIN_POSITIVE)) as f32;
    let (depths, coverage) = (depth.depths(), depth.coverages());
    let mut weighted = depths.clone();
    for (value, &c) in weighted.values_mut().iter_mut().zip(coverage.values()) {
        *value = if c > 0.0 { relative(*value) * c } else { 0.0 };
    }
    let radius = (RADIUS * f64::from(depth.height())).ceil() as usize;
    let weighted = weighted.blurred(radius);
    let weight = coverage.clone().blurred(radius);

    let pixels = light
        .iter_mut()
        .zip(depths.values().iter().zip(coverage.values()));
    let means = weighted.values().iter().zip(weight.values());
    for ((pixel, (&d, &c)), (&sum, &total)) in pixels.zip(means) {
        if c == 0.0 || total <= 0.0 {
            continue;
        }
        let behind = f64::from(relative(d) - sum / total).max(0.0) * (far - near) / extent;
        let taken = (strength * behind).min(MOST);
        *pixel = *pixel * (1.0 - taken * f64::from(c));
    }
}
