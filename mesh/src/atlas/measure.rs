//! What an atlas is like: stretch, folds, texels that are used, and texels claimed twice.

use super::chart::{Flat, stretch};
use super::raster;
use super::surface::{NONE, Surface};

/// The figures of an atlas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// How many charts there are.
    pub charts: usize,
    /// The part of the texels whose centres lie in a triangle.
    pub utilisation: f64,
    /// The area-weighted L2 stretch of Sander, Snyder, Gortler and Hoppe 2001, *Texture mapping
    /// progressive meshes*: √(Σ s² A′/Σ A′), where s² is half the sum of the squared singular
    /// values of the map from the texture to a triangle and A′ the area of the triangle, times
    /// √(texture area / surface area). 1 for an isometric map, never less.
    pub stretch_l2: f64,
    /// The greatest L2 stretch of a triangle, in the same unit.
    pub stretch_max: f64,
    /// Triangles of the surface whose image is folded over or has no area. Degenerate triangles are
    /// not counted; see [`unwrap`](super::unwrap).
    pub flipped: usize,
    /// Texels that two triangles claim: their centre lies in both, or the texel lies within the
    /// margin of two charts.
    pub overlapping_texels: usize,
}

/// The report, and pairs of faces of one chart that claim the same texel.
pub(super) fn measure(
    surface: &Surface,
    chart_of: &[u32],
    charts: usize,
    texels: &[[Flat; 3]],
    size: u32,
    margin: u32,
) -> (Report, Vec<[u32; 2]>) {
    let side = size as usize;
    let mut covered = vec![NONE; side * side];
    let mut claimed = vec![NONE; side * side];
    let mut is_double = vec![false; side * side];
    let mut pairs = Vec::new();
    let (mut area, mut flat_area, mut stretched) = (0.0, 0.0, 0.0);
    let (mut greatest, mut flipped, mut used) = (0.0_f64, 0, 0);
    let reach = i64::from(margin);
    for (face, &corners) in texels.iter().enumerate() {
        let (on_surface, flat, squared) = stretch(surface.corners(face as u32), corners);
        area += on_surface;
        flat_area += flat;
        stretched += squared * on_surface;
        greatest = greatest.max(squared);
        if !(flat > 0.0) {
            flipped += 1;
        }
        raster::centres(corners, |column, row| {
            let Some(texel) = texel(column, row, side) else {
                return;
            };
            let before = covered[texel];
            if before == NONE {
                covered[texel] = face as u32;
                used += 1;
            } else {
                is_double[texel] = true;
                if chart_of[before as usize] == chart_of[face] {
                    pairs.push([before, face as u32]);
                }
            }
        });
        let chart = chart_of[face];
        raster::touched(corners, 0.0, |row, [first, last]| {
            for row in row - reach..=row + reach {
                for column in first - reach..=last + reach {
                    if let Some(texel) = texel(column, row, side) {
                        let before = std::mem::replace(&mut claimed[texel], chart);
                        is_double[texel] |= before != NONE && before != chart;
                    }
                }
            }
        });
    }
    let report = Report {
        charts,
        utilisation: f64::from(used) / (side * side) as f64,
        stretch_l2: (stretched * flat_area).sqrt() / area,
        stretch_max: (greatest * flat_area / area).sqrt(),
        flipped,
        overlapping_texels: is_double.iter().filter(|&&double| double).count(),
    };
    (report, pairs)
}

fn texel(column: i64, row: i64, side: usize) -> Option<usize> {
    let (column, row) = (usize::try_from(column).ok()?, usize::try_from(row).ok()?);
    (column < side && row < side).then(|| row * side + column)
}
