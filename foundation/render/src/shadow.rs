//! Soft shadows that a model casts on a level ground.

use crate::Vector;
use crate::cut::Cut;
use crate::raster;
use crate::world::{Placed, World};
use ga_image::plane::Plane;

/// How much of a light reaches each place of the ground.
///
/// The model is projected along the light onto the ground, where each texel remembers the height of
/// the lowest surface above it. A light of half angle α seen past an edge at height *h* is covered
/// little by little over a width of about *2 h tan α*, so each texel's darkness is spread that
/// wide: sharp at the feet, soft at the head.
pub(crate) struct GroundShadow {
    /// Least *x* and *z* of the map, and texels per unit of length.
    origin: [f64; 2],
    density: f64,
    darkness: Plane,
}

/// A mesh in the world that casts a shadow.
pub(crate) struct Caster<'a> {
    positions: &'a [Vector],
    triangles: &'a [[u32; 3]],
    /// The world, and the number of the first triangle in it, where there are parts cut out.
    cut: Option<(&'a World<'a>, usize)>,
}

impl<'a> Caster<'a> {
    pub(crate) fn new(world: &'a World<'a>, placed: &'a Placed<'a>) -> Self {
        Self {
            positions: &placed.positions,
            triangles: placed.object.triangles,
            cut: (!world.is_solid(placed)).then_some((world, placed.first)),
        }
    }
}

/// Texels along a side of the map.
const SIZE: usize = 288;

/// The radii, in texels, over which darkness is spread; heights between are shared by the
/// neighbouring two.
const RADII: [usize; 6] = [1, 3, 6, 12, 24, 40];

impl GroundShadow {
    /// The shadow on the plane `y = ground`, for a light in the direction `towards_light` (above
    /// the horizon) whose half angle has the given tangent; `None` for a model that casts none.
    pub(crate) fn new(
        casters: &[Caster],
        ground: f64,
        towards_light: Vector,
        light_tangent: f64,
    ) -> Option<Self> {
        let slant = [towards_light.e1, towards_light.e3].map(|c| c / towards_light.e2);
        // x and z on the ground, and the height above it.
        let project = |position: &Vector| {
            let [x, y, z] = position.coordinates();
            let height = y - ground;
            [x - slant[0] * height, z - slant[1] * height, height]
        };
        let projected: Vec<Vec<[f64; 3]>> = casters
            .iter()
            .map(|caster| caster.positions.iter().map(project).collect())
            .collect();
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in projected.iter().flatten() {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let border = RADII[RADII.len() - 1] + 2;
        let density = (SIZE - 2 * border) as f64 / (high[0] - low[0]).max(high[1] - low[1]);
        if !(density.is_finite() && density > 0.0) {
            return None;
        }

        let origin = low.map(|c| c - border as f64 / density);
        let mut lowest = Plane::filled(SIZE, SIZE, f32::INFINITY);
        let texels = lowest.values_mut();
        for (caster, projected) in casters.iter().zip(&projected) {
            for (index, triangle) in caster.triangles.iter().enumerate() {
                let corners = triangle.map(|v| {
                    let [x, z, height] = projected[v as usize];
                    [(x - origin[0]) * density, (z - origin[1]) * density, height]
                });
                let cut = caster.cut.and_then(|(world, first)| {
                    Cut::caster(world, &world.face((first + index) as u32))
                });
                raster::fill(SIZE, SIZE, corners, |texel, height| {
                    let shows = |cut: &Cut| cut.shows_at(texel, SIZE, corners);
                    if !cut.as_ref().is_none_or(shows) {
                        return;
                    }
                    texels[texel] = texels[texel].min(height);
                });
            }
        }
        Some(Self {
            origin,
            density,
            darkness: spread(&lowest, light_tangent * density),
        })
    }

    /// The share of the light that reaches the ground at `(x, z)`, from 0 to 1.
    pub(crate) fn visibility(&self, x: f64, z: f64) -> f64 {
        let column = (x - self.origin[0]) * self.density - 0.5;
        let row = (z - self.origin[1]) * self.density - 0.5;
        let last = (SIZE - 1) as f64;
        let inside = column >= 0.0 && row >= 0.0 && column < last && row < last;
        if !inside {
            return 1.0;
        }
        let (i, j) = (column as usize, row as usize);
        let (u, v) = (column - i as f64, row - j as f64);
        let texel = |i: usize, j: usize| f64::from(self.darkness.values()[j * SIZE + i]);
        let near = texel(i, j) * (1.0 - u) + texel(i + 1, j) * u;
        let far = texel(i, j + 1) * (1.0 - u) + texel(i + 1, j + 1) * u;
        1.0 - (near * (1.0 - v) + far * v)
    }
}

/// Darkness from 0 to 1: each covered texel spread over the radius that its height asks for.
fn spread(lowest: &Plane, texels_per_height: f64) -> Plane {
    let mut darkness = Plane::filled(SIZE, SIZE, 0.0);
    for (band, &radius) in RADII.iter().enumerate() {
        let covered = lowest.map(|height| {
            if height.is_finite() {
                band_share(band, f64::from(height.max(0.0)) * texels_per_height)
            } else {
                0.0
            }
        });
        if covered.values().iter().all(|&c| c == 0.0) {
            continue;
        }
        let blurred = covered.blurred(radius);
        for (sum, &part) in darkness.values_mut().iter_mut().zip(blurred.values()) {
            *sum += part;
        }
    }
    darkness.map(|value| value.clamp(0.0, 1.0))
}

/// The share of a texel of the wanted radius that a band spreads: the shares of all bands add to 1.
fn band_share(band: usize, radius: f64) -> f32 {
    let radii = RADII.map(|r| r as f64);
    let radius = radius.clamp(radii[0], radii[radii.len() - 1]);
    let rising = if band == 0 {
        1.0
    } else {
        (radius - radii[band - 1]) / (radii[band] - radii[band - 1])
    };
    let falling = if band + 1 == radii.len() {
        1.0
    } else {
        (radii[band + 1] - radius) / (radii[band + 1] - radii[band])
    };
    rising.min(falling).max(0.0) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square plate of side 2 at height `h` over the ground, two triangles.
    fn plate(height: f64) -> [Vector; 4] {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        corners.map(|[x, z]| Vector::new(x, height, z))
    }

    fn shadow_of(positions: &[Vector; 4], towards_light: Vector, tangent: f64) -> GroundShadow {
        let plate = Caster {
            positions,
            triangles: &[[0, 1, 2], [0, 2, 3]],
            cut: None,
        };
        GroundShadow::new(&[plate], 0.0, towards_light, tangent).unwrap()
    }

    #[test]
    fn a_plate_under_a_slanting_light_shadows_the_place_beside_it() {
        // Down from the left: the shadow moves right by the height.
        let shadow = shadow_of(&plate(3.0), Vector::new(-0.5, 0.5, 0.0), 0.01);
        assert!(shadow.visibility(3.0, 0.0) < 1e-3);
        assert!(shadow.visibility(2.2, 0.8) < 1e-3);
        for lit in [[1.7, 0.0], [4.3, 0.0], [3.0, 1.3], [3.0, -1.3], [90.0, 0.0]] {
            assert!(shadow.visibility(lit[0], lit[1]) > 1.0 - 1e-5, "{lit:?}");
        }
    }

    #[test]
    fn the_edge_of_a_shadow_is_as_soft_as_the_blocker_is_high() {
        let softness = |height: f64| {
            let shadow = shadow_of(&plate(height), Vector::Y, 0.1);
            let half_shadow = shadow.visibility(1.0, 0.0);
            assert!(
                (half_shadow - 0.5).abs() < 0.1,
                "{half_shadow} at height {height}"
            );
            (0..4000)
                .map(|i| shadow.visibility(-2.0 + f64::from(i) / 1000.0, 0.0))
                .filter(|v| (0.05..0.95).contains(v))
                .count()
        };
        let (low, middle, high) = (softness(0.1), softness(1.0), softness(2.0));
        assert!(low < middle / 2 && middle < high, "{low} {middle} {high}");
    }

    #[test]
    fn bands_share_each_texel_completely() {
        for tenth in 0..600 {
            let radius = f64::from(tenth) / 10.0;
            let total: f32 = (0..RADII.len()).map(|band| band_share(band, radius)).sum();
            assert!((total - 1.0).abs() < 1e-6);
        }
    }
}
