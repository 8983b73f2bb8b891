//! The modules of a tag, read through the homography of its corners.

use ga_image::interpolation::bilinear;
use ga_image::plane::Plane;

use super::marker::{Tag, TagOptions};
use crate::homography::Homography;

/// The least difference between bright and dark modules, in levels.
const LEAST_CONTRAST: f64 = 6.0;
/// The part of the modules of the border that may be bright.
const BRIGHT_BORDER: f64 = 0.1;
/// The places in a module where it is looked at, along each axis, from its middle.
const PLACES: [f64; 3] = [-0.25, 0.0, 0.25];

/// The tag in a quadrangle; `None` where the quadrangle is no tag of the dictionary.
pub(super) fn read(levels: &Plane<f32>, quad: [[f64; 2]; 4], options: TagOptions) -> Option<Tag> {
    let (data, border) = (options.dictionary.side(), usize::from(options.border));
    let side = data + 2 * border;
    let end = side as f64;
    let corners = [[0.0, 0.0], [end, 0.0], [end, end], [0.0, end]];
    let homography = Homography::from_pairs(&corners, &quad)?;
    let module = |index: usize| {
        let centre = [index % side, index / side].map(|k| k as f64 + 0.5);
        let mut sum = 0.0;
        for dy in PLACES {
            for dx in PLACES {
                let place = homography.apply([centre[0] + dx, centre[1] + dy])?;
                sum += bilinear(levels, place)?;
            }
        }
        Some(sum / (PLACES.len() * PLACES.len()) as f64)
    };
    let modules = (0..side * side).map(module).collect::<Option<Vec<f64>>>()?;
    let threshold = threshold(&modules)?;
    let is_inside = |k: usize| (border..border + data).contains(&k);
    let (mut bright, mut pattern) = (0, Vec::new());
    for (index, level) in modules.iter().enumerate() {
        let is_bright = *level > threshold;
        if is_inside(index % side) && is_inside(index / side) {
            pattern.push(is_bright);
        } else {
            bright += usize::from(is_bright);
        }
    }
    if bright as f64 > BRIGHT_BORDER * (side * side - data * data) as f64 {
        return None;
    }
    let identity = options.dictionary.identify(&pattern)?;
    // Rotated clockwise by a quarter, the first corner of the upright tag is the second one seen.
    Some(Tag {
        id: identity.id,
        corners: [0, 1, 2, 3].map(|k| quad[(k + identity.quarters) % 4]),
        hamming: identity.hamming,
    })
}

/// The level that divides modules into dark and bright ones with the greatest variance between the
/// two (N. Otsu, "A threshold selection method from gray-level histograms", 1979); `None` where
/// they hardly differ.
fn threshold(modules: &[f64]) -> Option<f64> {
    let mut sorted = modules.to_vec();
    sorted.sort_by(f64::total_cmp);
    let total: f64 = sorted.iter().sum();
    let count = sorted.len() as f64;
    let mut below = 0.0;
    let mut best = (0.0, None);
    for split in 1..sorted.len() {
        below += sorted[split - 1];
        let dark = below / split as f64;
        let bright = (total - below) / (count - split as f64);
        let variance = split as f64 * (count - split as f64) * (bright - dark).powi(2);
        if variance > best.0 && bright - dark >= LEAST_CONTRAST {
            best = (variance, Some(0.5 * (dark + bright)));
        }
    }
    best.1
}
