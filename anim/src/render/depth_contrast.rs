//! Darkening behind edges, so that limbs that cross are told apart.
//!
//! After Luft, Colditz and Deussen 2006, *Image enhancement by unsharp masking the depth buffer*:
//! where a surface lies further away than the mean of its surroundings, something near stands
//! beside it, and it is darkened.

use super::blur::Field;
use super::color::LinearColor;
use super::depth::DepthMap;
use super::vector::scale;

/// The surroundings, as a fraction of the picture's height.
const RADIUS: f64 = 0.035;

/// No surface is darkened by more than this.
const MOST: f64 = 0.55;

/// Takes from each pixel that shows a surface `strength` times the part of `extent` by which it
/// lies further away than the mean of the surfaces around it.
pub(super) fn darken_behind_edges(
    light: &mut [LinearColor],
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
    let weighted = depths
        .iter()
        .zip(coverage)
        .map(|(&d, &c)| if c > 0.0 { relative(d) * c } else { 0.0 })
        .collect();
    let width = depth.width() as usize;
    let radius = (RADIUS * f64::from(depth.height())).ceil() as usize;
    let weighted = Field::new(width, weighted).blurred(radius);
    let weight = Field::new(width, coverage.to_vec()).blurred(radius);

    let pixels = light.iter_mut().zip(depths.iter().zip(coverage));
    let means = weighted.values().iter().zip(weight.values());
    for ((pixel, (&d, &c)), (&sum, &total)) in pixels.zip(means) {
        if c == 0.0 || total <= 0.0 {
            continue;
        }
        let behind = f64::from(relative(d) - sum / total).max(0.0) * (far - near) / extent;
        let taken = (strength * behind).min(MOST);
        *pixel = scale(*pixel, 1.0 - taken * f64::from(c));
    }
}
