//! Shadows that objects cast on each other.

use ga_image::plane::Plane;
use rayon::prelude::*;

use crate::Vector;
use crate::cut::Cut;
use crate::raster;
use crate::world::World;

/// The surfaces that a distant light sees first.
pub(crate) struct ShadowMap {
    /// Across the light, and towards it.
    axes: [Vector; 3],
    /// The coordinates along the axes at which the map begins.
    origin: Vector,
    /// Texels per unit of length.
    density: f64,
    /// For each texel the greatest coordinate towards the light; −∞ where there is no surface.
    nearest: Plane,
}

/// Texels along a side of the map.
const SIZE: usize = 2048;

/// Texels beyond the objects on each side.
const BORDER: usize = 4;

/// Rows of the map that are drawn together.
const BAND: usize = 256;

impl ShadowMap {
    /// The map for a light in the unit direction `towards_light`; `None` where there is nothing to
    /// cast a shadow.
    pub(crate) fn new(world: &World, towards_light: Vector) -> Option<Self> {
        let [across, up] = towards_light.orthonormal_pair();
        let axes = [across, up, towards_light];
        let along = |p: &Vector| Vector::new(axes[0].dot(*p), axes[1].dot(*p), axes[2].dot(*p));
        let mut projected: Vec<Vec<Vector>> = world
            .objects
            .iter()
            .map(|placed| placed.positions.iter().map(along).collect())
            .collect();
        let [low, high] = ga_mesh::bounds(projected.iter().flatten().copied())?;
        let extent = high - low;
        let density = (SIZE - 2 * BORDER) as f64 / extent.e1.max(extent.e2);
        if !(density.is_finite() && density > 0.0) {
            return None;
        }
        let border = BORDER as f64 / density;
        let origin = low - Vector::new(border, border, 0.0);
        for point in projected.iter_mut().flatten() {
            *point = (*point - origin) * density;
        }

        let mut nearest = Plane::filled(SIZE, SIZE, f32::NEG_INFINITY);
        let bands = nearest.values_mut().par_chunks_mut(SIZE * BAND);
        bands.enumerate().for_each(|(band, texels)| {
            let rows = band * BAND..(band + 1) * BAND;
            let first = rows.start * SIZE;
            for (placed, projected) in world.objects.iter().zip(&projected) {
                let is_solid = world.is_solid(placed);
                for (index, triangle) in placed.object.triangles.iter().enumerate() {
                    let corners = triangle.map(|v| projected[v as usize].coordinates());
                    let cut = if is_solid {
                        None
                    } else {
                        Cut::caster(world, &world.face((placed.first + index) as u32))
                    };
                    raster::fill_rows(SIZE, rows.clone(), corners, |texel, height| {
                        let shows = |cut: &Cut| cut.shows_at(texel, SIZE, corners);
                        if !cut.as_ref().is_none_or(shows) {
                            return;
                        }
                        let texel = &mut texels[texel - first];
                        *texel = texel.max(height);
                    });
                }
            }
        });
        Some(Self {
            axes,
            origin,
            density,
            nearest,
        })
    }

    /// The share of the light, 0 to 1, that reaches a point of a surface with this unit normal on
    /// the side of the viewer.
    pub(crate) fn visibility(&self, point: Vector, normal: Vector) -> f64 {
        let cosine = self.axes[2].dot(normal);
        let outward = if cosine < 0.0 { -normal } else { normal };
        // Over two texels to each side, the surface itself rises by their width times the tangent
        // of its slope; raised along its normal by their width times the sine, it stays clear.
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let raised = point + outward * ((0.75 + 3.0 * sine) / self.density);
        let [x, y, height] = self.axes.map(|axis| axis.dot(raised));
        let [x, y, height] = [
            (x - self.origin.e1) * self.density - 0.5,
            (y - self.origin.e2) * self.density - 0.5,
            (height - self.origin.e3) * self.density,
        ];
        let last = (SIZE - 3) as f64;
        if !(x >= 1.0 && y >= 1.0 && x < last && y < last) {
            return 1.0;
        }
        let (column, row) = (x as usize, y as usize);
        let shares = |part: f64| [1.0 - part, 1.0, 1.0, part];
        let across = shares(x - column as f64);
        let down = shares(y - row as f64);
        let mut blocked = 0.0;
        for (j, down) in down.into_iter().enumerate() {
            let begin = (row + j - 1) * SIZE + column - 1;
            let texels = &self.nearest.values()[begin..begin + 4];
            for (&nearest, across) in texels.iter().zip(across) {
                if f64::from(nearest) > height {
                    blocked += across * down;
                }
            }
        }
        1.0 - blocked / 9.0
    }
}
