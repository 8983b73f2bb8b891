//! Colours between the pixels of a picture.

use ga_image::colour::linear_from_srgb;
use ga_image::plane::Plane;
use ga_image::pyramid::Pyramid;

/// A picture as linear light, and smaller copies of it.
pub(super) struct Sampler {
    pyramid: Pyramid<[f32; 3]>,
}

/// The linear light of each 16-bit code of sRGB.
pub(super) struct Decoder {
    light: Vec<f32>,
}

impl Decoder {
    pub(super) fn new() -> Self {
        let light = |code: u16| linear_from_srgb(f64::from(code) / f64::from(u16::MAX)) as f32;
        Self {
            light: (0..=u16::MAX).map(light).collect(),
        }
    }
}

/// The most halvings of a picture.
const LEVELS: usize = 8;

impl Sampler {
    /// The picture with copies for texels of up to so many pixels.
    pub(super) fn new(picture: &Plane<[u16; 3]>, decoder: &Decoder, pixels: f64) -> Self {
        let linear = picture.map(|codes| codes.map(|code| decoder.light[usize::from(code)]));
        let levels = 2 + pixels.max(1.0).log2().ceil().min(LEVELS as f64) as usize;
        let levels = if pixels > 1.0 { levels } else { 1 };
        Self {
            pyramid: Pyramid::new(&linear, levels),
        }
    }

    /// The colour at a place, for a texel whose side is so many pixels: bicubic interpolation, and
    /// between two copies linearly where texels are larger than pixels.
    pub(super) fn at(&self, place: [f64; 2], pixels: f64) -> [f32; 3] {
        let levels = self.pyramid.levels();
        let last = levels.len() - 1;
        let level = pixels.max(1.0).log2().min(last as f64);
        let lower = level as usize;
        let share = (level - lower as f64) as f32;
        let colour = |level: usize| {
            let scale = 1.0 / (1_u64 << level) as f64;
            bicubic(&levels[level], place.map(|x| x * scale))
        };
        let near = colour(lower);
        if share == 0.0 || lower == last {
            return near;
        }
        let far = colour(lower + 1);
        [0, 1, 2].map(|k| near[k] + share * (far[k] - near[k]))
    }
}

/// Catmull and Rom's cubic between the four nearest columns and rows, not below zero. The border is
/// continued by its outermost pixels.
fn bicubic(picture: &Plane<[f32; 3]>, [u, v]: [f64; 2]) -> [f32; 3] {
    let (columns, across) = taps(u, picture.width());
    let (rows, down) = taps(v, picture.height());
    let mut sum = [0.0; 3];
    for (row, weight) in rows.into_iter().zip(down) {
        let row = picture.row(row);
        let mut inner = [0.0; 3];
        for (column, weight) in columns.into_iter().zip(across) {
            for (inner, value) in inner.iter_mut().zip(row[column]) {
                *inner += weight * value;
            }
        }
        for (sum, inner) in sum.iter_mut().zip(inner) {
            *sum += weight * inner;
        }
    }
    sum.map(|x: f32| x.max(0.0))
}

/// The four neighbours of a place along an axis, and their weights.
fn taps(place: f64, length: usize) -> ([usize; 4], [f32; 4]) {
    let last = length - 1;
    let place = place.clamp(0.0, last as f64);
    let first = place.floor();
    let t = (place - first) as f32;
    let first = first as usize;
    let indices = [
        first.saturating_sub(1),
        first,
        (first + 1).min(last),
        (first + 2).min(last),
    ];
    let (t2, t3) = (t * t, t * t * t);
    let weights = [
        0.5 * (2.0 * t2 - t3 - t),
        0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
        0.5 * (4.0 * t2 - 3.0 * t3 + t),
        0.5 * (t3 - t2),
    ];
    (indices, weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Catmull and Rom's cubic reproduces polynomials of second degree.
    #[test]
    fn parabolas_are_reproduced() {
        let height = |u: f64, v: f64| (3.0 + u + 0.5 * v + 0.25 * u * u - 0.125 * u * v) as f32;
        let picture = Plane::from_fn(9, 8, |u, v| [height(u as f64, v as f64); 3]);
        for [u, v] in [[2.0, 3.0], [2.25, 3.5], [4.9, 1.1], [5.5, 5.5]] {
            let found = bicubic(&picture, [u, v])[1];
            assert!((found - height(u, v)).abs() < 1e-4, "{u}, {v}: {found}");
        }
    }
}
