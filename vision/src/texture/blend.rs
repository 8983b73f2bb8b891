//! One colour for each texel from those of the views.

use rayon::prelude::*;

use super::covered::Covered;
use super::exposure::Overlaps;
use super::geometry::Geometry;
use super::sampler::{Decoder, Sampler};
use super::view::View;
use super::weight::{Grade, Weights};

/// A view, where its texels are, and how much they count.
pub(super) struct Layer<'a> {
    pub(super) view: &'a View,
    pub(super) geometry: Geometry<'a>,
    pub(super) weights: Weights,
    /// Factors of its linear light.
    pub(super) gain: [f64; 3],
}

/// The colours of texels.
pub(super) struct Blend {
    /// Linear light.
    pub(super) colours: Vec<[f32; 3]>,
    /// For each texel the view that counts most, or [`NONE`].
    pub(super) best: Vec<u16>,
    /// How well each texel is seen by the view that sees it best.
    pub(super) grades: Vec<Grade>,
}

/// No view sees a texel.
pub(super) const NONE: u16 = u16::MAX;

/// Light outside of this range may have been clipped, or says little.
const TRUSTED: [f32; 2] = [0.002, 0.97];

impl Layer<'_> {
    /// The colour of each texel that is seen, as the picture shows it.
    fn colours(&self, covered: &Covered, decoder: &Decoder, step: usize) -> Vec<Option<[f32; 3]>> {
        let sampler = Sampler::new(&self.view.picture, decoder);
        let gain = self.gain.map(|gain| gain as f32);
        let count = covered.len().div_ceil(step);
        let colour = |index: usize| {
            let index = index * step;
            if self.weights.values[index] == 0.0 {
                return None;
            }
            let placed = self.geometry.place(&covered.texels[index])?;
            let colour = sampler.mean(placed.pixel, placed.sides, self.weights.reaches[index]);
            Some([0, 1, 2].map(|channel| gain[channel] * colour[channel]))
        };
        (0..count).into_par_iter().map(colour).collect()
    }
}

/// What the layers show of the same texels, from about the given number of texels at most.
pub(super) fn overlaps(
    layers: &[Layer],
    covered: &Covered,
    decoder: &Decoder,
    samples: usize,
) -> Overlaps {
    let step = (covered.len() / samples).max(1);
    let colours: Vec<_> = layers
        .iter()
        .map(|layer| layer.colours(covered, decoder, step))
        .collect();
    let mut overlaps = Overlaps::new(layers.len());
    let mut seen = Vec::new();
    for sample in 0..colours.first().map_or(0, Vec::len) {
        seen.clear();
        for (view, (layer, colours)) in layers.iter().zip(&colours).enumerate() {
            let [dark, light] = TRUSTED;
            if let Some(colour) = colours[sample]
                && layer.weights.grades[sample * step] == Grade::Well
                && colour.iter().all(|x| *x < light)
                && colour.iter().any(|x| *x > dark)
            {
                seen.push((view, colour));
            }
        }
        overlaps.add(&seen);
    }
    overlaps
}

/// Blends the layers in two bands: low frequencies are the weighted mean of all views, high ones
/// those of the view that counts most (P. Burt and E. Adelson, A Multiresolution Spline with
/// Application to Image Mosaics, 1983, with two bands and on the surface).
///
/// With the weighted mean m of all views and the light cᵢ of view i, the result at a texel whose
/// best view is i is `cᵢ − G(cᵢ − m)`, where G smooths over `radius` texels of the chart that
/// view i sees. Where the views agree, it is cᵢ.
pub(super) fn blend(
    layers: &[Layer],
    covered: &Covered,
    decoder: &Decoder,
    radius: usize,
) -> Blend {
    let mut sums = vec![[0.0_f32; 4]; covered.len()];
    let mut best = vec![NONE; covered.len()];
    let mut most = vec![0.0_f32; covered.len()];
    let mut grades = vec![Grade::Unseen; covered.len()];
    for (number, layer) in (0..).zip(layers) {
        let colours = layer.colours(covered, decoder, 1);
        for (grade, own) in grades.iter_mut().zip(&layer.weights.grades) {
            *grade = (*own).max(*grade);
        }
        let texels = sums.par_iter_mut().zip(&mut best).zip(&mut most);
        let seen = texels.zip(&colours).zip(&layer.weights.values);
        seen.for_each(|((((sum, best), most), colour), weight)| {
            let Some([red, green, blue]) = *colour else {
                return;
            };
            for (sum, value) in sum.iter_mut().zip([red, green, blue, 1.0]) {
                *sum += weight * value;
            }
            if *weight > *most {
                (*most, *best) = (*weight, number);
            }
        });
    }
    let mean = |[red, green, blue, weight]: [f32; 4]| match weight > 0.0 {
        true => [red, green, blue].map(|x| x / weight),
        false => [0.0; 3],
    };
    let means: Vec<[f32; 3]> = sums.into_par_iter().map(mean).collect();
    if layers.len() == 1 {
        return Blend {
            colours: means,
            best,
            grades,
        };
    }
    let mut colours = means.clone();
    for (number, layer) in (0..).zip(layers) {
        let own = layer.colours(covered, decoder, 1);
        let mut low: Vec<[f32; 4]> = own
            .par_iter()
            .zip(&means)
            .zip(&layer.weights.grades)
            .map(|((own, mean), grade)| match own {
                Some(own) if *grade == Grade::Well => {
                    let [red, green, blue] = [0, 1, 2].map(|k| own[k] - mean[k]);
                    [red, green, blue, 1.0]
                }
                _ => [0.0; 4],
            })
            .collect();
        covered.smooth(&mut low, radius);
        let texels = colours.par_iter_mut().zip(&best).zip(&own).zip(&low);
        texels.for_each(|(((colour, best), own), low)| {
            if let Some(own) = own
                && *best == number
            {
                // Few neighbours that are seen well say little.
                let share = 1.0 / (low[3] + 0.02 * (1.0 - low[3]));
                *colour = [0, 1, 2].map(|k| (own[k] - low[k] * share).max(0.0));
            }
        });
    }
    Blend {
        colours,
        best,
        grades,
    }
}
