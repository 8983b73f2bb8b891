//! Colours between the pixels of a picture.

use ga_image::colour::linear_from_srgb;
use ga_image::interpolation::cubic_weights;
use ga_image::plane::Plane;
use rayon::prelude::*;

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

/// The light in front of a camera. A pixel is the mean of the light over its area, so that this is
/// the spline of second degree with these means (I. J. Schoenberg, "Splines and histograms", in:
/// Spline Functions and Approximation Theory, 1973), along rows and columns. Interpolation of the
/// pixels themselves would show details that are a few pixels wide with too little contrast.
pub(super) struct Sampler {
    pixels: Plane<[f32; 3]>,
    /// The factors of the B-splines at the pixels.
    factors: Plane<[f32; 3]>,
}

/// How the light between pixels is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// By the spline, in which distant pixels have a small part too.
    Spline,
    /// By Catmull and Rom's cubic between the four nearest columns and rows, so that an edge leaves
    /// no trace beyond them.
    Near,
}

/// The greatest number of samples along the side of a texel.
const MOST_SAMPLES: f64 = 64.0;

impl Sampler {
    pub(super) fn new(picture: &Plane<[u16; 3]>, decoder: &Decoder) -> Self {
        let pixels = picture.map(|codes| codes.map(|code| decoder.light[usize::from(code)]));
        let mut factors = pixels.clone();
        let (width, height) = (factors.width(), factors.height());
        let across = Elimination::new(width);
        let rows = factors.values_mut().par_chunks_exact_mut(width);
        rows.for_each(|row| across.solve(row.as_flattened_mut(), 3));
        Elimination::new(height).solve(factors.values_mut().as_flattened_mut(), 3 * width);
        Self { pixels, factors }
    }

    /// The mean colour of a texel whose middle is at `place`. Its sides are these long in pixels.
    pub(super) fn mean(&self, place: [f64; 2], sides: [[f64; 2]; 2], reach: Reach) -> [f32; 3] {
        let [columns, rows] = sides.map(|[x, y]| x.hypot(y).ceil().clamp(1.0, MOST_SAMPLES));
        let mut sum = [0.0; 3];
        for row in 0..rows as u32 {
            for column in 0..columns as u32 {
                let part = |k: u32, count: f64| (f64::from(k) + 0.5) / count - 0.5;
                let (s, t) = (part(column, columns), part(row, rows));
                let at = [0, 1].map(|k| place[k] + s * sides[0][k] + t * sides[1][k]);
                for (sum, value) in sum.iter_mut().zip(self.at(at, reach)) {
                    *sum += value;
                }
            }
        }
        let share = 1.0 / (columns * rows) as f32;
        sum.map(|x: f32| (share * x).max(0.0))
    }

    /// The light at a place. The border of the picture is continued.
    fn at(&self, [u, v]: [f64; 2], reach: Reach) -> [f32; 3] {
        let size = [self.pixels.width(), self.pixels.height()];
        match reach {
            Reach::Spline => sum(&self.factors, spline(u, size[0]), spline(v, size[1])),
            Reach::Near => sum(&self.pixels, cubic(u, size[0]), cubic(v, size[1])),
        }
    }
}

/// Neighbours along an axis and their weights.
type Taps<const N: usize> = ([usize; N], [f32; N]);

fn sum<const N: usize>(
    plane: &Plane<[f32; 3]>,
    (columns, across): Taps<N>,
    (rows, down): Taps<N>,
) -> [f32; 3] {
    let mut sum = [0.0; 3];
    for (row, weight) in rows.into_iter().zip(down) {
        let row = plane.row(row);
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
    sum
}

/// The three neighbours of a place, and the values of their B-splines.
fn spline(place: f64, length: usize) -> Taps<3> {
    let last = length - 1;
    let place = place.clamp(-0.5, last as f64 + 0.5);
    let nearest = place.round().clamp(0.0, last as f64);
    let t = (place - nearest) as f32;
    let nearest = nearest as usize;
    let indices = [nearest.saturating_sub(1), nearest, (nearest + 1).min(last)];
    let weights = [
        0.5 * (0.5 - t) * (0.5 - t),
        0.75 - t * t,
        0.5 * (0.5 + t) * (0.5 + t),
    ];
    (indices, weights)
}

/// The four neighbours of a place, and their weights by Catmull and Rom's cubic.
fn cubic(place: f64, length: usize) -> Taps<4> {
    let last = length - 1;
    let place = place.clamp(0.0, last as f64);
    let first = place.floor();
    let weights = cubic_weights(place - first).map(|weight| weight as f32);
    let first = first as usize;
    let indices = [
        first.saturating_sub(1),
        first,
        (first + 1).min(last),
        (first + 2).min(last),
    ];
    (indices, weights)
}

/// Gauss's elimination for the factors f of B-splines whose means over pixels are given,
/// f₋₁/6 + 4 f₀/6 + f₁/6, where the outermost pixels are their own neighbours.
struct Elimination {
    /// What remains of the diagonal, reciprocal.
    pivots: Vec<f32>,
}

impl Elimination {
    fn new(length: usize) -> Self {
        let mut pivots: Vec<f32> = Vec::with_capacity(length);
        for place in 0..length {
            let borders = [0, length - 1].iter().filter(|end| **end == place).count();
            let diagonal = (4.0 + borders as f32) / 6.0;
            let eliminated = pivots.last().map_or(0.0, |pivot| pivot / 36.0);
            pivots.push((diagonal - eliminated).recip());
        }
        Self { pivots }
    }

    /// Replaces means by factors. Each is `stride` numbers, one after the other.
    fn solve(&self, values: &mut [f32], stride: usize) {
        let later = 1..self.pivots.len();
        for (place, pivot) in later.zip(&self.pivots) {
            let (before, here) = values.split_at_mut(place * stride);
            let before = &before[(place - 1) * stride..];
            for (value, before) in here.iter_mut().zip(before) {
                *value -= pivot / 6.0 * before;
            }
        }
        for (place, pivot) in self.pivots.iter().enumerate().rev() {
            let (here, after) = values.split_at_mut((place + 1) * stride);
            let here = &mut here[place * stride..];
            for (value, after) in here.iter_mut().zip(after) {
                *value -= *after / 6.0;
            }
            for value in here {
                *value *= pivot;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampler(values: &Plane<[f32; 3]>) -> Sampler {
        let light = (0..=u16::MAX).map(f32::from).collect();
        let codes = values.map(|value| value.map(|x| x as u16));
        Sampler::new(&codes, &Decoder { light })
    }

    /// Simpson's rule is exact for the polynomials between the borders of pixels.
    #[test]
    fn pixels_are_the_means_of_the_light() {
        let value = |u: usize, v: usize| ((37 * u * u + 101 * v + 53 * u * v) % 997) as f32;
        let picture = Plane::from_fn(7, 5, |u, v| [value(u, v), 20.0, value(v, u)]);
        let sampler = sampler(&picture);
        for (u, v) in (0..7).flat_map(|u| (0..5).map(move |v| (u, v))) {
            let mut mean = [0.0; 3];
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                let weight = [1.0, 4.0, 1.0].map(|x| x / 6.0);
                let place = |k: usize, i: usize| k as f64 + 0.4999999 * (i as f64 - 1.0);
                let found = sampler.at([place(u, i), place(v, j)], Reach::Spline);
                for (mean, found) in mean.iter_mut().zip(found) {
                    *mean += weight[i] * weight[j] * found;
                }
            }
            let expected = picture.row(v)[u];
            assert!(
                (0..3).all(|k| (mean[k] - expected[k]).abs() < 0.02),
                "{u} {v}"
            );
        }
    }

    /// Far from the border the spline is the polynomial of which the pixels are the means.
    #[test]
    fn parabolas_are_reproduced() {
        // The mean of u² over a pixel is 1/12 more than the square of its middle.
        let height = |u: f64, v: f64| 3000.0 + 240.0 * u + 120.0 * v + 12.0 * u * u - 6.0 * u * v;
        let picture = Plane::from_fn(41, 40, |u, v| {
            [(height(u as f64, v as f64) + 1.0) as f32; 3]
        });
        let sampler = sampler(&picture);
        for [u, v] in [[20.0, 18.0], [20.25, 19.5], [21.9, 18.1], [22.5, 21.5]] {
            let found = f64::from(sampler.at([u, v], Reach::Spline)[1]);
            assert!((found - height(u, v)).abs() < 0.05, "{u}, {v}: {found}");
            // The cubic reproduces the pixels, which are the means.
            let found = f64::from(sampler.at([u, v], Reach::Near)[1]);
            assert!(
                (found - height(u, v) - 1.0).abs() < 0.05,
                "{u}, {v}: {found}"
            );
        }
    }

    /// A texel of 8 × 4 pixels is their mean.
    #[test]
    fn large_texels_are_means() {
        let picture = Plane::from_fn(32, 32, |u, v| [((u + v) % 2 * 1000) as f32; 3]);
        let sampler = sampler(&picture);
        for reach in [Reach::Spline, Reach::Near] {
            let found = sampler.mean([15.5, 15.5], [[8.0, 0.0], [0.0, 4.0]], reach);
            assert!((found[0] - 500.0).abs() < 1.0, "{found:?}");
        }
    }
}
