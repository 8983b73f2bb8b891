//! Texture atlases: a surface cut into charts, each flattened and placed in one square picture.
//!
//! [`unwrap`] gives every corner of every triangle a texture coordinate. No two triangles share a
//! texel, no triangle is folded, and lengths are kept as well as they can be, so that a picture
//! painted in the square covers the surface evenly. Textures, normal maps and other maps of a
//! surface are stored in this way.
//!
//! # How it works
//!
//! 1. Charts grow from seeds over faces whose normals lie within a cone, from their middles anew a
//!    few times; charts whose union still lies in a cone are joined.
//! 2. A chart is projected along its mean normal. Where that would fold a triangle or stretch too
//!    much, Tutte's embedding is relaxed to the minimum of the symmetric Dirichlet energy, which no
//!    folded triangle has. Where that fails too, or the image covers a place twice, the chart is
//!    cut.
//! 3. Charts are placed by their shapes, in four rotations, the largest first, at the largest scale
//!    that was found. If too little of the square is used, large charts are cut and all are placed
//!    again.
//!
//! Equal input gives equal coordinates, bit for bit.

mod chart;
mod embed;
mod flatten;
mod grow;
mod mask;
mod measure;
mod merge;
mod overlap;
mod pack;
pub(crate) mod raster;
mod reduce;
mod relax;
mod surface;

pub use crate::texture_space_error::MAX_SIZE;
pub use measure::Report;

use crate::{TextureCoordinates, TextureSpaceError};
use chart::Flat;
use flatten::Flattened;
use pack::Effort;
use surface::{NONE, Surface, Vector};

/// What an atlas is made for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The side of the square texture in texels, from 1 to [`MAX_SIZE`]; 1024 by default.
    pub size: u32,
    /// The texels that a triangle touches, and all within this number of rows and columns of them,
    /// belong to its chart alone; 1 by default, which is enough for bilinear interpolation. Each
    /// halving of the texture (a mip level) needs twice as many.
    pub margin_texels: u32,
    /// Charts are joined, at the price of more stretch, until there are at most this many; 200 by
    /// default. Parts of the surface that are not connected are never in one chart.
    pub charts: usize,
    /// Large charts are cut until at least this part of the texture is used, as far as there are
    /// faces between which to cut; 0.58 by default.
    pub utilisation: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            size: 1024,
            margin_texels: 1,
            charts: 200,
            utilisation: 0.58,
        }
    }
}

/// Texture coordinates of a triangle mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Atlas {
    /// For each triangle the coordinates (u, v) of its corners, u to the right and v up, in the
    /// unit square.
    pub coordinates: Vec<[[f64; 2]; 3]>,
    /// For each triangle its chart, counted from 0.
    pub charts: Vec<u32>,
    /// The figures of the atlas.
    pub report: Report,
}

impl Atlas {
    /// The coordinates as those of a mesh that consists of these triangles. Corners at the same
    /// place of the texture share one coordinate.
    #[must_use]
    pub fn texture_coordinates(&self) -> TextureCoordinates {
        let mut number = rustc_hash::FxHashMap::default();
        let mut coordinates = Vec::new();
        let corners = self.coordinates.iter().flatten().map(|place| {
            let key = place.map(f64::to_bits);
            Some(*number.entry(key).or_insert_with(|| {
                coordinates.push(*place);
                coordinates.len() as u32 - 1
            }))
        });
        let corners = corners.collect();
        TextureCoordinates {
            values: coordinates,
            corners,
        }
    }
}

/// Cuts a triangle mesh into charts, flattens them and places them in a square texture.
///
/// Corners run counter-clockwise seen from outside, and so they do in the texture. Vertices at
/// exactly the same position are one vertex for this purpose. Charts end at boundaries, at edges of
/// more than two faces, and where neighbouring faces have opposite orientations.
///
/// A degenerate triangle, whose height is below 10⁻⁹ of its longest side, has no image: it belongs
/// to the chart of a neighbour, and its three coordinates are one point of it. The figures do not
/// count it.
///
/// # Errors
///
/// [`TextureSpaceError`] for an empty mesh, one without area, coordinates that are not finite,
/// indices out of range, a size that is not allowed, and charts that do not fit.
///
/// # Examples
///
/// ```
/// use ga_mesh::atlas::{Options, unwrap};
///
/// let tetrahedron = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// let atlas = unwrap(&tetrahedron, &triangles, &Options::default())?;
/// assert_eq!((atlas.report.flipped, atlas.report.overlapping_texels), (0, 0));
/// # Ok::<(), ga_mesh::TextureSpaceError>(())
/// ```
pub fn unwrap(
    positions: &[[f64; 3]],
    triangles: &[[u32; 3]],
    options: &Options,
) -> Result<Atlas, TextureSpaceError> {
    let Options { size, .. } = *options;
    if !(1..=MAX_SIZE).contains(&size) {
        return Err(TextureSpaceError::Size { size });
    }
    let surface = Surface::new(positions, triangles)?;
    let mut charts = Vec::new();
    let partition = partition(&surface, options.charts);
    for faces in partition.faces() {
        charts.extend(flatten::flatten(&surface, faces, STRETCH));
    }
    charts = reduce::reduce(&surface, charts, options.charts);

    let mut best: Option<Placement> = None;
    let mut repairs = 0;
    let mut cuts = 0;
    let mut charts_of_best = Vec::new();
    while let Some(placement) = Placement::new(&surface, &charts, options, Effort::QUICK) {
        if !placement.pairs.is_empty() && repairs < REPAIRS {
            repairs += 1;
            charts = cut_overlaps(&surface, charts, &placement.pairs);
            continue;
        }
        let used = |placement: &Placement| placement.report.utilisation;
        let utilisation = used(&placement);
        if best.as_ref().is_none_or(|best| utilisation > used(best)) {
            best = Some(placement);
            charts_of_best.clone_from(&charts);
        }
        cuts += 1;
        if utilisation >= options.utilisation || cuts == CUTS {
            break;
        }
        match cut_large(&surface, &charts, options.charts) {
            Some(more) => charts = more,
            None => break,
        }
    }
    if let Some(quick) = &best
        && quick.report.utilisation < FAR_BELOW * options.utilisation
        && let Some(closer) = Placement::new(&surface, &charts_of_best, options, Effort::THOROUGH)
        && closer.pairs.is_empty()
        && closer.report.utilisation > quick.report.utilisation
    {
        best = Some(closer);
    }
    let best = best.ok_or(TextureSpaceError::DoesNotFit {
        charts: charts.len(),
        margin_texels: options.margin_texels,
        size,
    })?;
    Ok(best.into_atlas(&surface, triangles, size))
}

/// The figures of texture coordinates from anywhere, given as those of [`Atlas::coordinates`].
/// Triangles with a common edge are in one chart if their coordinates agree there.
///
/// # Errors
///
/// As [`unwrap`], and [`TextureSpaceError::Coordinates`], [`TextureSpaceError::OutsideSquare`].
pub fn measure(
    positions: &[[f64; 3]],
    triangles: &[[u32; 3]],
    coordinates: &[[[f64; 2]; 3]],
    options: &Options,
) -> Result<Report, TextureSpaceError> {
    let Options { size, .. } = *options;
    if !(1..=MAX_SIZE).contains(&size) {
        return Err(TextureSpaceError::Size { size });
    }
    if coordinates.len() != triangles.len() {
        return Err(TextureSpaceError::Coordinates {
            expected: triangles.len(),
            found: coordinates.len(),
        });
    }
    let is_inside = |corners: &[[f64; 2]; 3]| {
        let mut numbers = corners.as_flattened().iter();
        numbers.all(|x| (0.0..=1.0).contains(x))
    };
    if let Some(face) = coordinates.iter().position(|corners| !is_inside(corners)) {
        return Err(TextureSpaceError::OutsideSquare { face });
    }
    let surface = Surface::new(positions, triangles)?;
    let of_face = |face: u32| coordinates[surface.originals[face as usize] as usize];
    let at = |side: u32| {
        let corners = of_face(side / 3);
        let corner = side as usize % 3;
        [corners[corner], corners[(corner + 1) % 3]]
    };
    let mut seen = vec![false; surface.len()];
    let mut charts = Vec::new();
    for first in 0..surface.len() as u32 {
        if std::mem::replace(&mut seen[first as usize], true) {
            continue;
        }
        let mut chart = vec![first];
        let mut next = 0;
        while let Some(&face) = chart.get(next) {
            next += 1;
            for side in 3 * face..3 * face + 3 {
                let other = surface.across[side as usize];
                if other == NONE || seen[other as usize / 3] {
                    continue;
                }
                let [a, b] = at(other);
                if at(side) == [b, a] {
                    seen[other as usize / 3] = true;
                    chart.push(other / 3);
                }
            }
        }
        charts.push(chart);
    }
    let texel = |corners: [Flat; 3]| corners.map(|place| place.map(|x| x * f64::from(size)));
    let texels: Vec<[Flat; 3]> = (0..surface.len() as u32)
        .map(|face| texel(of_face(face)))
        .collect();
    Ok(measure::measure(&surface, &charts, &texels, size, options.margin_texels).0)
}

/// Charts whose normals lie in cones; where that gives many, those of smoothed normals, if they
/// are fewer.
fn partition(surface: &Surface, most: usize) -> grow::Partition {
    let mut normals = surface.normals.clone();
    let mut best = grow::grow(surface, &normals);
    for _ in 0..SMOOTHINGS {
        if best.charts <= most / 2 {
            break;
        }
        for _ in 0..4 {
            normals = surface.smoothed(&normals);
        }
        let smoother = grow::grow(surface, &normals);
        if smoother.charts < best.charts {
            best = smoother;
        }
    }
    best
}

/// How often normals are smoothed further, at most.
const SMOOTHINGS: usize = 3;

/// The greatest L2 stretch of a chart that is relaxed.
const STRETCH: f64 = 1.2;

/// How often large charts are cut and all are placed anew, at most.
const CUTS: usize = 8;

/// Charts are placed once more, with more effort, where less than this part of the utilisation that
/// was asked for is reached.
const FAR_BELOW: f64 = 0.95;

/// How often charts that overlap themselves by texels are cut, at most. Charts whose boundaries
/// cross are cut before, so one is usually enough.
const REPAIRS: usize = 20;

/// Charts with their places in the texture.
struct Placement {
    chart_of: Vec<u32>,
    /// For each face of the surface, its corners in texels.
    texels: Vec<[Flat; 3]>,
    report: Report,
    /// For each chart of which two faces claim the same texel, such a pair.
    pairs: Vec<[u32; 2]>,
}

impl Placement {
    fn new(
        surface: &Surface,
        charts: &[Flattened],
        options: &Options,
        effort: Effort,
    ) -> Option<Self> {
        let items: Vec<pack::Item> = charts.iter().map(item).collect();
        let (size, margin) = (options.size, options.margin_texels);
        let places = pack::pack(&items, size, margin, effort)?;
        let mut chart_of = vec![NONE; surface.len()];
        let mut texels = vec![[[0.0; 2]; 3]; surface.len()];
        for (index, (flattened, places)) in charts.iter().zip(&places).enumerate() {
            let chart = &flattened.chart;
            for (&face, triangle) in chart.faces.iter().zip(&chart.triangles) {
                chart_of[face as usize] = index as u32;
                texels[face as usize] = triangle.map(|vertex| places[vertex as usize]);
            }
        }
        let faces: Vec<Vec<u32>> = charts.iter().map(|f| f.chart.faces.clone()).collect();
        let (report, pairs) = measure::measure(surface, &faces, &texels, size, margin);
        Some(Self {
            chart_of,
            texels,
            report,
            pairs,
        })
    }

    fn into_atlas(self, surface: &Surface, triangles: &[[u32; 3]], size: u32) -> Atlas {
        let mut charts = vec![NONE; triangles.len()];
        let mut coordinates = vec![[[0.0; 2]; 3]; triangles.len()];
        let mut of_vertex = rustc_hash::FxHashMap::default();
        for (face, &original) in surface.originals.iter().enumerate() {
            let corners = self.texels[face].map(|place| place.map(|x| x / f64::from(size)));
            charts[original as usize] = self.chart_of[face];
            coordinates[original as usize] = corners;
            if surface.originals.len() < triangles.len() {
                for (vertex, place) in triangles[original as usize].into_iter().zip(corners) {
                    of_vertex
                        .entry(vertex)
                        .or_insert((self.chart_of[face], place));
                }
            }
        }
        let first = surface.originals[0] as usize;
        let fallback = (charts[first], coordinates[first][0]);
        for face in 0..triangles.len() {
            if charts[face] == NONE {
                let neighbour = triangles[face].iter().find_map(|v| of_vertex.get(v));
                let &(chart, place) = neighbour.unwrap_or(&fallback);
                charts[face] = chart;
                coordinates[face] = [place; 3];
            }
        }
        Atlas {
            coordinates,
            charts,
            report: self.report,
        }
    }
}

/// The image of a chart at the scale at which the whole atlas stretches least.
fn item(flattened: &Flattened) -> pack::Item {
    let scale = flattened.distortion.scale();
    let mut places: Vec<Flat> = flattened.image.clone();
    for place in &mut places {
        *place = place.map(|x| x * scale);
    }
    pack::straighten(&mut places);
    let sides = flattened
        .chart
        .boundary()
        .map(|side| flattened.chart.side(side));
    let boundary = sides
        .map(|side| side.map(|vertex| places[vertex as usize]))
        .collect();
    pack::Item { boundary, places }
}

/// Cuts the charts in which pairs of faces overlap, between these faces.
fn cut_overlaps(surface: &Surface, charts: Vec<Flattened>, pairs: &[[u32; 2]]) -> Vec<Flattened> {
    let mut cut = Vec::with_capacity(charts.len() + pairs.len());
    for flattened in charts {
        let chart = &flattened.chart;
        let place = |face: u32| chart.faces.iter().position(|&f| f == face);
        let ends = pairs
            .iter()
            .find_map(|&[a, b]| Some([place(a)?, place(b)?]));
        let Some(ends) = ends else {
            cut.push(flattened);
            continue;
        };
        for half in flatten::split(surface, chart, ends.map(|end| end as u32)) {
            cut.extend(flatten::flatten(surface, half, STRETCH));
        }
    }
    cut
}

/// Cuts the charts that make placing hard, the largest and the longest, into two each; `None` when
/// there are no faces between which to cut, or too many charts.
fn cut_large(surface: &Surface, charts: &[Flattened], most: usize) -> Option<Vec<Flattened>> {
    let mut order: Vec<(f64, usize)> = (0..charts.len())
        .filter(|&index| charts[index].chart.faces.len() > 1)
        .map(|index| {
            let item = item(&charts[index]);
            let [width, height] = [0, 1].map(|axis| {
                let values = item.places.iter().map(|place| place[axis]);
                let low = values.clone().fold(f64::INFINITY, f64::min);
                values.fold(f64::NEG_INFINITY, f64::max) - low
            });
            (width.max(height), index)
        })
        .collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let longest = order.first()?.0;
    let room = most.saturating_sub(charts.len());
    let cut: Vec<usize> = order
        .iter()
        .take_while(|(length, _)| *length > 0.6 * longest)
        .map(|&(_, index)| index)
        .take(room.min(charts.len() / 3 + 2))
        .collect();
    if cut.is_empty() {
        return None;
    }
    let mut all = Vec::with_capacity(charts.len() + cut.len());
    for (index, flattened) in charts.iter().enumerate() {
        if cut.contains(&index) {
            let ends = flatten::far_apart(surface, &flattened.chart);
            for half in flatten::split(surface, &flattened.chart, ends) {
                all.extend(flatten::flatten(surface, half, STRETCH));
            }
        } else {
            all.push(Flattened::clone(flattened));
        }
    }
    (all.len() <= most).then_some(all)
}
