//! The transparent surfaces in front of the opaque ones, sample by sample.

use crate::barycentric::barycentric;
use std::ops::Range;

use rayon::prelude::*;

use crate::cut::Cut;
use crate::style::Style;
use crate::surface::{Drawing, Pass, Samples};
use crate::view::View;
use crate::world::World;

/// Every transparent surface that is seen at any sample of a picture.
///
/// The layers of a pixel are sorted by their depth, so that the picture does not depend on the
/// order of triangles, and surfaces that cross are right on both sides of the crossing (an
/// A-buffer, after Carpenter 1984, *The A-buffer, an antialiased hidden surface method*).
pub(crate) struct Layers {
    /// Sorted by pixel, then from back to front.
    layers: Vec<Layer>,
    /// For each pixel its first layer, and the number of all at the end; empty without layers.
    first: Vec<u32>,
}

/// A transparent triangle at a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Layer {
    /// The pixel of the picture.
    pixel: u32,
    /// The sample of the pixel, row by row.
    pub(crate) sample: u32,
    pub(crate) triangle: u32,
    pub(crate) inverse_depth: f32,
}

/// Rows of samples that are drawn together. What is drawn does not depend on it.
const BAND: usize = 48;

impl Layers {
    /// Draws the transparent triangles where no surface of `samples` lies in front of them.
    pub(crate) fn draw(world: &World, view: &View, style: &Style, samples: &Samples) -> Self {
        let transparent = transparent(world);
        if transparent.is_empty() {
            return Self {
                layers: Vec::new(),
                first: Vec::new(),
            };
        }
        let size = [samples.width, samples.height];
        let drawing = Drawing::new(world, view, samples.lens, size, Pass::All);
        let rows: Vec<Range<usize>> = transparent
            .par_iter()
            .map(|&number| drawing.rows(&world.face(number), samples.height))
            .collect();
        let factor = style.supersampling as usize;
        let mut layers: Vec<Layer> = (0..samples.height.div_ceil(BAND))
            .into_par_iter()
            .flat_map_iter(|band| {
                let band = band * BAND..((band + 1) * BAND).min(samples.height);
                let mut layers = Vec::new();
                for (&number, rows) in transparent.iter().zip(&rows) {
                    if rows.start < band.end && rows.end > band.start {
                        let band = band.clone();
                        add(world, &drawing, samples, factor, number, band, &mut layers);
                    }
                }
                layers
            })
            .collect();
        layers.par_sort_unstable_by(|a, b| {
            let depth = a.inverse_depth.total_cmp(&b.inverse_depth);
            let pixel = a.pixel.cmp(&b.pixel);
            let rest = (a.triangle, a.sample).cmp(&(b.triangle, b.sample));
            pixel.then(depth).then(rest)
        });
        let pixels = (style.width * style.height) as usize;
        let mut first = vec![0; pixels + 1];
        for layer in &layers {
            first[layer.pixel as usize + 1] += 1;
        }
        for pixel in 0..pixels {
            first[pixel + 1] += first[pixel];
        }
        Self { layers, first }
    }

    /// The layers of a pixel from back to front.
    pub(crate) fn of(&self, pixel: usize) -> &[Layer] {
        match self.first.get(pixel..pixel + 2) {
            Some(&[begin, end]) => &self.layers[begin as usize..end as usize],
            _ => &[],
        }
    }
}

/// The numbers of the transparent triangles.
fn transparent(world: &World) -> Vec<u32> {
    let mut numbers = Vec::new();
    for placed in world
        .objects
        .iter()
        .filter(|placed| !world.is_solid(placed))
    {
        let triangles = 0..placed.object.triangles.len();
        numbers.extend(
            triangles
                .map(|index| (placed.first + index) as u32)
                .filter(|&number| {
                    let material = world.material(&world.face(number));
                    material.is_some_and(|material| material.transparent)
                }),
        );
    }
    numbers
}

/// Adds a triangle's layers in some rows of samples.
fn add(
    world: &World,
    drawing: &Drawing,
    samples: &Samples,
    factor: usize,
    number: u32,
    rows: Range<usize>,
    layers: &mut Vec<Layer>,
) {
    let face = world.face(number);
    if !drawing.draws(&face) {
        return;
    }
    let cut = Cut::new(world, &face);
    let corners = face.in_frame();
    let pixels = samples.width / factor;
    drawing.cover(&face, rows, |index, inverse_depth| {
        if inverse_depth < samples.inverse_depth[index] {
            return;
        }
        let (row, column) = (index / samples.width, index % samples.width);
        let ray = samples.lens.ray(column as f64 + 0.5, row as f64 + 0.5);
        if cut
            .as_ref()
            .is_some_and(|cut| !cut.shows(barycentric(ray, corners)))
        {
            return;
        }
        layers.push(Layer {
            pixel: (row / factor * pixels + column / factor) as u32,
            sample: (row % factor * factor + column % factor) as u32,
            triangle: number,
            inverse_depth,
        });
    });
}
