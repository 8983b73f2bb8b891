//! The texels that show the surface, and means over neighbours within a chart.

use std::ops::Range;

use ga_mesh::bake::Texels;
use rayon::prelude::*;

use super::target::Target;
use crate::texture::TextureError;

/// A texel and the point of the surface that it shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Texel {
    /// Where it is in the rows of the texture.
    pub(super) index: u32,
    pub(super) triangle: u32,
    /// The barycentric coordinates of the second and the third corner.
    pub(super) weights: [f32; 2],
}

/// The texels that show the surface, in the order of their indices. Numbers of texels here are
/// places in this list.
pub(super) struct Covered {
    pub(super) size: u32,
    pub(super) texels: Vec<Texel>,
    /// Runs of neighbours in a row that belong to one chart.
    rows: Vec<Range<usize>>,
    /// The texels column by column, and the runs in this order.
    by_column: Vec<u32>,
    columns: Vec<Range<usize>>,
}

impl Covered {
    pub(super) fn new(texels: &Texels, target: &Target, size: u32) -> Result<Self, TextureError> {
        let mut list = Vec::with_capacity(texels.len());
        list.extend(texels.iter().map(|texel| Texel {
            index: texel.index,
            triangle: texel.triangle,
            weights: [texel.weights[1] as f32, texel.weights[2] as f32],
        }));
        if list.is_empty() {
            return Err(TextureError::NoTriangles);
        }
        let chart = |texel: &Texel| target.charts[texel.triangle as usize];
        check_charts(&list, target, size)?;
        let column = |texel: &Texel| texel.index % size;
        let rows = runs(list.len(), |a, b| {
            let (a, b) = (&list[a], &list[b]);
            b.index == a.index + 1 && column(b) != 0 && chart(a) == chart(b)
        });
        let by_column = columns_first(&list, size);
        let columns = runs(list.len(), |a, b| {
            let [a, b] = [a, b].map(|place| &list[by_column[place] as usize]);
            b.index == a.index + size && chart(a) == chart(b)
        });
        Ok(Self {
            size,
            texels: list,
            rows,
            by_column,
            columns,
        })
    }

    pub(super) fn len(&self) -> usize {
        self.texels.len()
    }

    /// The texel at a place of the texture, if one is there.
    pub(super) fn find(&self, index: u32) -> Option<u32> {
        let found = self
            .texels
            .binary_search_by_key(&index, |texel| texel.index);
        found.ok().map(|place| place as u32)
    }

    /// The pairs of neighbours within charts.
    pub(super) fn neighbours(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let of_rows = self.rows.iter().flat_map(|run| {
            let inner = run.start as u32..run.end as u32 - 1;
            inner.map(|first| [first, first + 1])
        });
        let of_columns = self.columns.iter().flat_map(|run| {
            let pairs = self.by_column[run.clone()].windows(2);
            pairs.map(|pair| [pair[0], pair[1]])
        });
        of_rows.chain(of_columns)
    }

    /// Replaces the values of all texels by their means over neighbours of the same chart: a window
    /// of `radius` texels on either side along rows and along columns, each applied twice, which is
    /// close to a Gaussian of this radius divided by 1.2.
    pub(super) fn smooth<const C: usize>(&self, values: &mut [[f32; C]], radius: usize) {
        let mut turned: Vec<[f32; C]> = vec![[0.0; C]; values.len()];
        for _ in 0..2 {
            smooth_runs(values, &self.rows, radius);
            let places = turned.par_iter_mut().zip(&self.by_column);
            places.for_each(|(to, from)| *to = values[*from as usize]);
            smooth_runs(&mut turned, &self.columns, radius);
            for (from, to) in turned.iter().zip(&self.by_column) {
                values[*to as usize] = *from;
            }
        }
    }
}

/// Fails where a chart with an area in the texture owns no texel.
fn check_charts(list: &[Texel], target: &Target, size: u32) -> Result<(), TextureError> {
    /// A chart of this number of texels contains the middle of one, unless it is thinner than a
    /// texel.
    const LARGE: f64 = 4.0;
    let mut areas = vec![0.0; target.chart_count];
    for (chart, [a, b, c]) in target.charts.iter().zip(&target.coordinates) {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        areas[*chart as usize] += 0.5 * area.abs() * f64::from(size) * f64::from(size);
    }
    let mut owns = vec![false; target.chart_count];
    for texel in list {
        owns[target.charts[texel.triangle as usize] as usize] = true;
    }
    let lost = areas.iter().zip(&owns).filter(|(_, owns)| !**owns);
    let lost: Vec<f64> = lost.map(|(area, _)| *area).filter(|a| *a > 0.0).collect();
    let hidden = lost.iter().filter(|area| **area > LARGE).count();
    let charts = target.chart_count;
    match (hidden, lost.len()) {
        (_, 0) => Ok(()),
        (0, lost) => Err(TextureError::TooSmall { size, lost, charts }),
        (hidden, _) => Err(TextureError::Overlapping { hidden, charts }),
    }
}

/// The runs of 0..count in which each element and the next are joined.
fn runs(count: usize, is_joined: impl Fn(usize, usize) -> bool) -> Vec<Range<usize>> {
    let mut runs = Vec::new();
    let mut start = 0;
    for end in 1..=count {
        if end == count || !is_joined(end - 1, end) {
            runs.push(start..end);
            start = end;
        }
    }
    runs
}

/// The numbers of the texels in the order of columns, by a counting sort.
fn columns_first(list: &[Texel], size: u32) -> Vec<u32> {
    let mut starts = vec![0_u32; size as usize + 1];
    for texel in list {
        starts[(texel.index % size) as usize + 1] += 1;
    }
    for column in 0..size as usize {
        starts[column + 1] += starts[column];
    }
    let mut sorted = vec![0; list.len()];
    for (number, texel) in (0..).zip(list) {
        let place = &mut starts[(texel.index % size) as usize];
        sorted[*place as usize] = number;
        *place += 1;
    }
    sorted
}

/// The mean over a window around each value, as far as it lies in the same run.
fn smooth_runs<const C: usize>(values: &mut [[f32; C]], runs: &[Range<usize>], radius: usize) {
    let mut pieces = Vec::with_capacity(runs.len());
    let mut rest = values;
    for run in runs {
        let (piece, after) = rest.split_at_mut(run.len());
        pieces.push(piece);
        rest = after;
    }
    pieces.par_iter_mut().with_min_len(64).for_each_init(
        Vec::new,
        |sums: &mut Vec<[f64; C]>, run| {
            sums.clear();
            let mut sum = [0.0; C];
            sums.push(sum);
            for value in run.iter() {
                for (sum, value) in sum.iter_mut().zip(value) {
                    *sum += f64::from(*value);
                }
                sums.push(sum);
            }
            let length = run.len();
            for (place, value) in run.iter_mut().enumerate() {
                let from = place.saturating_sub(radius);
                let to = (place + radius + 1).min(length);
                let share = 1.0 / (to - from) as f64;
                *value = std::array::from_fn(|c| (share * (sums[to][c] - sums[from][c])) as f32);
            }
        },
    );
}
