//! What an atlas is like: stretch, folds, texels that are used, and texels claimed twice.

use super::chart::{Flat, minus, stretch};
use super::mask::Mask;
use super::raster;
use super::surface::Surface;

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

/// The report, and for each chart of which two faces claim the same texel, such a pair.
///
/// `texels` are the corners of the faces of the surface in texels.
pub(super) fn measure(
    surface: &Surface,
    charts: &[Vec<u32>],
    texels: &[[Flat; 3]],
    size: u32,
    margin: u32,
) -> (Report, Vec<[u32; 2]>) {
    let side = size as usize;
    let mut double = Mask::empty(side, side);
    let mut claimed = Mask::empty(side, side);
    let mut covered = Mask::empty(side, side);
    let mut pairs = Vec::new();
    for faces in charts {
        let mut pair = None;
        for &face in faces {
            let mut is_new = true;
            raster::centres(texels[face as usize], |row, columns| {
                covered.fill(row, columns, |word, cells| {
                    is_new = false;
                    double.words[word] |= cells;
                });
            });
            if !is_new && pair.is_none() {
                pair = first_to_share(faces, face, texels);
            }
        }
        pairs.extend(pair);
        let (mask, offset) = claims(faces, texels, side, margin as usize);
        claimed.add(&mask, offset, |word, cells| double.words[word] |= cells);
    }

    let (mut area, mut flat_area, mut stretched) = (0.0, 0.0, 0.0);
    let (mut greatest, mut flipped) = (0.0_f64, 0);
    for (face, &corners) in texels.iter().enumerate() {
        let (on_surface, flat, squared) = stretch(surface.corners(face as u32), corners);
        area += on_surface;
        flat_area += flat;
        stretched += squared * on_surface;
        greatest = greatest.max(squared);
        flipped += usize::from(flat <= 0.0 || flat.is_nan());
    }
    let report = Report {
        charts: charts.len(),
        utilisation: covered.count() as f64 / (side * side) as f64,
        stretch_l2: (stretched * flat_area).sqrt() / area,
        stretch_max: (greatest * flat_area / area).sqrt(),
        flipped,
        overlapping_texels: double.count(),
    };
    (report, pairs)
}

/// The texels that a chart claims, and where in the texture the mask begins.
fn claims(faces: &[u32], texels: &[[Flat; 3]], side: usize, margin: usize) -> (Mask, [usize; 2]) {
    let (mut low, mut high) = ([side; 2], [0; 2]);
    for place in faces.iter().flat_map(|&face| texels[face as usize]) {
        for axis in 0..2 {
            let cell = place[axis].floor() as usize;
            low[axis] = low[axis].min(cell.saturating_sub(margin));
            high[axis] = high[axis].max(cell.saturating_add(margin + 1).min(side));
        }
    }
    let extent = [0, 1].map(|axis| high[axis].saturating_sub(low[axis]));
    let mut mask = Mask::empty(extent[0].max(1), extent[1].max(1));
    let origin = low.map(|cell| cell as f64);
    for &face in faces {
        let corners = texels[face as usize].map(|place| minus(place, origin));
        raster::touched(corners, 0.0, |row, columns| {
            mask.fill(row, columns, |_, _| ());
        });
    }
    mask.dilate(margin);
    (mask, low)
}

/// This face of a chart, with the first one that has a texel centre in common with it.
fn first_to_share(faces: &[u32], face: u32, texels: &[[Flat; 3]]) -> Option<[u32; 2]> {
    let spans = |face: u32| {
        let mut spans = Vec::new();
        raster::centres(texels[face as usize], |row, columns| {
            spans.push((row, columns))
        });
        spans
    };
    let own = spans(face);
    let shares = |&&other: &&u32| {
        other != face
            && spans(other).iter().any(|(row, [first, last])| {
                own.iter()
                    .any(|(r, [f, l])| r == row && f <= last && first <= l)
            })
    };
    let other = faces
        .iter()
        .take_while(|&&other| other != face)
        .find(shares)?;
    Some([*other, face])
}
