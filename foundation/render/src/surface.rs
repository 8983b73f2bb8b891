//! Which triangle is seen at which sample, and how far away.

use crate::barycentric::barycentric;
use std::ops::Range;

use rayon::prelude::*;

use crate::clip::Clipper;
use crate::cut::Cut;
use crate::lens::Lens;
use crate::raster::{self, Corner};
use crate::view::View;
use crate::world::{Face, World};

/// The visible surface at every sample of a picture.
pub(crate) struct Samples {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// 1 / depth of the nearest surface; 0 where there is none.
    pub(crate) inverse_depth: Vec<f32>,
    /// The number of the triangle seen, or [`NO_TRIANGLE`].
    pub(crate) triangle: Vec<u32>,
    pub(crate) lens: Lens,
}

/// No surface is seen at a sample.
pub(crate) const NO_TRIANGLE: u32 = u32::MAX;

/// Which surfaces are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pass {
    /// All surfaces.
    All,
    /// Those that nothing shines through.
    Opaque,
}

/// Rows that are drawn together. What is drawn does not depend on it.
const BAND: usize = 48;

impl Samples {
    /// Draws all triangles into a picture of `factor` samples along each side of a pixel.
    pub(crate) fn draw(
        world: &World,
        view: &View,
        [width, height]: [u32; 2],
        factor: u32,
        pass: Pass,
    ) -> Self {
        let lens = Lens::new(view, width, height).scaled(f64::from(factor));
        let (width, height) = ((width * factor) as usize, (height * factor) as usize);
        let drawing = Drawing::new(world, view, lens, [width, height], pass);
        let rows: Vec<Vec<Range<u16>>> = world
            .objects
            .iter()
            .map(|placed| {
                let triangles = 0..placed.object.triangles.len();
                let rows = triangles.into_par_iter().map(|triangle| {
                    let number = (placed.first + triangle) as u32;
                    let rows = drawing.rows(&world.face(number), height);
                    rows.start as u16..rows.end as u16
                });
                rows.collect()
            })
            .collect();

        let mut inverse_depth = vec![0f32; width * height];
        let mut triangle = vec![NO_TRIANGLE; width * height];
        let bands = inverse_depth
            .par_chunks_mut(width * BAND)
            .zip(triangle.par_chunks_mut(width * BAND));
        bands.enumerate().for_each(|(band, (depths, triangles))| {
            let begin = band * BAND;
            let end = begin + depths.len() / width;
            for (placed, rows) in world.objects.iter().zip(&rows) {
                let solid = world.is_solid(placed);
                for (index, rows) in rows.iter().enumerate() {
                    if usize::from(rows.start) < end && usize::from(rows.end) > begin {
                        let number = (placed.first + index) as u32;
                        drawing.triangle(number, solid, begin..end, depths, triangles);
                    }
                }
            }
        });
        Self {
            width,
            height,
            inverse_depth,
            triangle,
            lens,
        }
    }
}

/// What is the same for all triangles.
pub(crate) struct Drawing<'a> {
    world: &'a World<'a>,
    lens: Lens,
    clipper: Clipper,
    width: usize,
    pass: Pass,
}

impl<'a> Drawing<'a> {
    /// `lens` and size are those of the samples.
    pub(crate) fn new(
        world: &'a World<'a>,
        view: &View,
        lens: Lens,
        [width, height]: [usize; 2],
        pass: Pass,
    ) -> Self {
        Self {
            world,
            lens,
            clipper: lens.clipper([view.near(), view.far()], width, height),
            width,
            pass,
        }
    }

    /// Whether the side of a triangle that is seen is to be drawn.
    pub(crate) fn draws(&self, face: &Face) -> bool {
        let Some(material) = self.world.material(face) else {
            return true;
        };
        let in_pass = self.pass == Pass::All || !material.transparent;
        in_pass && (material.double_sided || face.faces_eye())
    }

    /// The rows of samples that a triangle may cover, in a picture of this height.
    pub(crate) fn rows(&self, face: &Face, height: usize) -> Range<usize> {
        raster::rows_of(self.polygon(face).into_iter(), height)
    }

    /// Calls `visit` with each sample in some rows that a triangle covers and the inverse depth of
    /// the triangle there. The index of the sample is that in the picture.
    pub(crate) fn cover(&self, face: &Face, rows: Range<usize>, mut visit: impl FnMut(usize, f32)) {
        for fan in self.polygon(face).fans() {
            raster::fill_rows(self.width, rows.clone(), fan, &mut visit);
        }
    }

    /// The visible part of a triangle on the picture, with the inverse depth of each corner.
    fn polygon(&self, face: &Face) -> Corners {
        let polygon = self.clipper.clip(face.in_frame());
        let mut corners = Corners::default();
        for &corner in polygon.corners() {
            let inverse = 1.0 / corner.e3;
            let [column, row] = self.lens.project([corner.e1, corner.e2], inverse);
            corners.push([column, row, inverse]);
        }
        corners
    }

    /// Draws a triangle into some rows.
    fn triangle(
        &self,
        number: u32,
        solid: bool,
        rows: Range<usize>,
        depths: &mut [f32],
        triangles: &mut [u32],
    ) {
        let face = self.world.face(number);
        if !solid && !self.draws(&face) {
            return;
        }
        let cut = if solid {
            None
        } else {
            Cut::new(self.world, &face)
        };
        let corners = face.in_frame();
        let first = rows.start * self.width;
        self.cover(&face, rows, |sample, inverse| {
            let index = sample - first;
            if inverse <= depths[index] {
                return;
            }
            if let Some(cut) = &cut {
                let (row, column) = (sample / self.width, sample % self.width);
                let ray = self.lens.ray(column as f64 + 0.5, row as f64 + 0.5);
                if !cut.shows(barycentric(ray, corners)) {
                    return;
                }
            }
            depths[index] = inverse;
            triangles[index] = number;
        });
    }
}

/// The corners of a clipped triangle on the picture.
#[derive(Clone, Copy, Default)]
struct Corners {
    corners: [Corner; 9],
    len: usize,
}

impl Corners {
    fn push(&mut self, corner: Corner) {
        self.corners[self.len] = corner;
        self.len += 1;
    }

    fn into_iter(self) -> impl Iterator<Item = Corner> {
        self.corners.into_iter().take(self.len)
    }

    /// Triangles that share the first corner.
    fn fans(&self) -> impl Iterator<Item = [Corner; 3]> + '_ {
        (2..self.len).map(|i| [self.corners[0], self.corners[i - 1], self.corners[i]])
    }
}
