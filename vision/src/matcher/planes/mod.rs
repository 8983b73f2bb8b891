//! Planes by region: the surface that a region of similar levels shows, where matches say little.
//!
//! A plane in space has disparities that are linear in the pixel, d = a x + b y + c. Regions of
//! similar levels often show one plane, so that what is matched in a part of a region tells the
//! rest of it. The plane is taken for pixels without a match, where the other view shows nothing
//! behind it, and for matches without texture that it contradicts.

mod disjoint_sets;
mod grid;
mod plane;
mod regions;

use super::exposure::IN_A_LEVEL;
use super::refine::over_rows;
use super::view::View;
use super::winner::{STEPS, UNKNOWN};
use grid::Grid;
use plane::DisparityPlane;
use rayon::prelude::*;
use regions::Regions;

/// The part of the matches of a region that must agree with a plane which fills its holes, and with
/// one that corrects matches without texture.
const AGREEMENT: f64 = 0.65;
const AGREEMENT_TO_CORRECT: f64 = 0.7;
/// How much nearer than what the other view shows a plane may be, in pixels.
const IN_FRONT: f64 = 1.5;
/// What the other view does not show in the left margin is the mean of plane and row, if these
/// differ by less than this number of pixels: curved surfaces lie between the two.
const SIMILAR: f64 = 8.0;
/// The matches of a region from which its plane is found.
const SAMPLES: usize = 150;
/// The pixels on either side of one that show whether there is texture, and the standard deviation
/// of their levels with texture.
const REACH: usize = 4;
const TEXTURE: f32 = 3.0;
/// Of views of more than 8 bits, that deviation in terms of their noise, and the least in levels.
const FINE_TEXTURE: f32 = 4.0;
const LEAST_TEXTURE: f32 = 0.1;

/// The planes of the regions of a view. The memory for finding the regions is kept.
#[derive(Debug, Default)]
pub(super) struct RegionPlanes {
    grid: Grid,
    regions: Regions,
}

impl RegionPlanes {
    /// Replaces disparities by those of planes. `map` has the disparities that the other view
    /// confirms, `filled` the same with the holes filled from the row, and `other` those of the
    /// other view in whole pixels, mirrored. No plane leads beyond the candidates, which begin
    /// at 0.
    pub(super) fn apply(
        &mut self,
        map: &[u16],
        candidates: usize,
        view: &View,
        other: &[u16],
        filled: &mut [u16],
    ) {
        let width = view.width();
        // The pictures for which the sizes of regions were found have 0.36 and 1.4 million pixels.
        let scale = (map.len() as f64 / 360_000.0).clamp(1.0, 4.0);
        let Self { grid, regions } = self;
        grid.fill(view);
        let is_matched = |[column, row]: [usize; 2]| map[row * width + column] != UNKNOWN;
        regions.find(grid, is_matched, scale);
        let threshold = 1.0 + (scale - 1.0) / 6.0;
        let samples = samples(grid, regions, map, width).into_par_iter();
        let planes = samples.with_min_len(16);
        let found = Found {
            grid,
            regions,
            planes: planes
                .map(|samples| DisparityPlane::fit(&samples, threshold))
                .collect(),
            threshold,
            greatest: candidates.saturating_sub(1) as f64,
            view,
        };
        over_rows(filled, width, |first, rows| {
            for (row, filled) in (first..).zip(rows.chunks_exact_mut(width)) {
                let place = row * width;
                found.apply(
                    row,
                    &map[place..][..width],
                    &other[place..][..width],
                    filled,
                );
            }
        });
    }
}

/// What was found of a view: its regions, and the plane of each.
struct Found<'a> {
    grid: &'a Grid,
    regions: &'a Regions,
    planes: Vec<Option<DisparityPlane>>,
    /// How far a match that agrees with a plane may be from it.
    threshold: f64,
    greatest: f64,
    view: &'a View,
}

impl Found<'_> {
    /// Replaces disparities of a row, from those of the row that the other view confirms and those
    /// of the other view.
    fn apply(&self, row: usize, map: &[u16], other: &[u16], filled: &mut [u16]) {
        let margin = map.iter().take_while(|d| **d == UNKNOWN).count();
        for (column, value) in filled.iter_mut().enumerate() {
            let region = self.regions.of_pixel(self.grid, column, row);
            let plane = self.planes[region].filter(|plane| plane.agreement >= AGREEMENT);
            let Some(plane) = plane else {
                continue;
            };
            let disparity = plane.at(column, row);
            let now = f64::from(*value) / f64::from(STEPS);
            let off = (disparity - now).abs();
            let wanted = if disparity < 0.0 || disparity > self.greatest {
                None
            } else if map[column] == UNKNOWN {
                let both = column < margin && off < SIMILAR;
                let chosen = if both {
                    (disparity + now) / 2.0
                } else {
                    disparity
                };
                (!is_seen_through(other, column, disparity)).then_some(chosen)
            } else {
                let corrects = plane.agreement >= AGREEMENT_TO_CORRECT && off > self.threshold;
                (corrects && !has_texture(self.view, column, row)).then_some(disparity)
            };
            if let Some(wanted) = wanted {
                // The conversion saturates; the greatest number stands for unknown.
                *value = ((wanted * f64::from(STEPS)).round() as u16).min(UNKNOWN - 1);
            }
        }
    }
}

/// Matches of each region, as places and disparities in pixels, evenly drawn from its cells.
fn samples(grid: &Grid, regions: &Regions, map: &[u16], width: usize) -> Vec<Vec<[f64; 3]>> {
    let wanted: Vec<usize> = (0..regions.count())
        .map(|region| regions.matches(region).min(SAMPLES))
        .collect();
    let mut samples: Vec<_> = wanted.iter().map(|n| Vec::with_capacity(*n)).collect();
    let mut met = vec![0; regions.count()];
    grid.each(|cell| {
        let [column, row] = cell.place;
        let disparity = map[row * width + column];
        if disparity == UNKNOWN {
            return;
        }
        let region = regions.of_cell(cell.number);
        let (all, wanted) = (regions.matches(region), wanted[region]);
        let before = met[region];
        met[region] += 1;
        if before * wanted / all != (before + 1) * wanted / all {
            let disparity = f64::from(disparity) / f64::from(STEPS);
            samples[region].push([column as f64, row as f64, disparity]);
        }
    });
    samples
}

/// Whether the other view shows something behind a point of this disparity at the place where it
/// would be seen.
fn is_seen_through(other: &[u16], column: usize, disparity: f64) -> bool {
    let target = (column as f64 - disparity).round();
    if target < 0.0 {
        return false;
    }
    let behind = other[other.len() - 1 - (target as usize).min(other.len() - 1)];
    behind != UNKNOWN && f64::from(behind) + IN_FRONT < disparity
}

/// Whether the levels around a pixel vary: by more than the noise of views of 8 bits, or, where the
/// numbers behind the levels are known, by several times their own.
fn has_texture(view: &View, column: usize, row: usize) -> bool {
    let columns = column.saturating_sub(REACH)..(column + REACH + 1).min(view.width());
    let rows = || row.saturating_sub(REACH)..(row + REACH + 1).min(view.height());
    let is_plain = deviation(rows().map(|row| &view.row(row)[columns.clone()])) < TEXTURE;
    if is_plain && let Some(noise) = view.fine_noise() {
        let deviation = deviation(rows().map(|row| &view.fine_row(row)[columns.clone()]));
        return deviation / IN_A_LEVEL as f32 >= (FINE_TEXTURE * noise).max(LEAST_TEXTURE);
    }
    !is_plain
}

/// The standard deviation of numbers of several rows, up to 16 bits each.
fn deviation<'a, T: Copy + Into<u32> + 'a>(rows: impl Iterator<Item = &'a [T]>) -> f32 {
    let (mut count, mut sum, mut squares) = (0, 0, 0);
    for row in rows {
        count += row.len();
        for number in row {
            let number: u32 = (*number).into();
            sum += u64::from(number);
            squares += u64::from(number * number);
        }
    }
    let [sum, squares] = [sum, squares].map(|sum| sum as f64 / count as f64);
    ((squares - sum * sum).max(0.0) as f32).sqrt()
}

#[cfg(test)]
mod tests {
    use ga_image::plane::Plane;

    use super::*;

    const WIDTH: usize = 120;
    const HEIGHT: usize = 80;

    /// The disparity of a slanted wall, and that of a board in front of it.
    fn truth(column: usize, row: usize) -> f64 {
        if is_board(column, row) {
            30.0
        } else {
            4.0 + 0.05 * column as f64 + 0.1 * row as f64
        }
    }

    fn is_board(column: usize, row: usize) -> bool {
        (60..90).contains(&column) && (20..60).contains(&row)
    }

    fn steps(disparity: f64) -> u16 {
        (disparity * f64::from(STEPS)).round() as u16
    }

    /// A wall of one level behind a board of another: what is left out of the wall, to its left
    /// margin and beside the board, lies on its plane again, and so do wrong matches on it.
    #[test]
    fn a_slanted_wall_is_continued() {
        let mut view = View::new(WIDTH, HEIGHT, false);
        let level = |column, row| if is_board(column, row) { 200u8 } else { 90 };
        let identity = |level: u8| level;
        view.fill(Plane::from_fn(WIDTH, HEIGHT, level).view(), identity, 0);
        let is_hole =
            |column: usize, row: usize| column < 20 || (42..60).contains(&column) && row > 10;
        let is_wrong = |column: usize, row: usize| column > 100 && row > 70;
        let mut map = Vec::new();
        let mut filled = Vec::new();
        for row in 0..HEIGHT {
            for column in 0..WIDTH {
                let found = if is_hole(column, row) {
                    UNKNOWN
                } else if is_wrong(column, row) {
                    steps(50.0)
                } else {
                    steps(truth(column, row))
                };
                map.push(found);
                filled.push(if found == UNKNOWN { steps(25.0) } else { found });
            }
        }
        let other = vec![UNKNOWN; map.len()];
        RegionPlanes::default().apply(&map, 64, &view, &other, &mut filled);
        for row in 0..HEIGHT {
            for column in 0..WIDTH {
                let found = f64::from(filled[row * WIDTH + column]) / f64::from(STEPS);
                let expected = truth(column, row);
                assert!(
                    (found - expected).abs() < 0.1,
                    "{column} {row}: {found} {expected}"
                );
            }
        }

        // What the other view sees through is not there.
        let mut filled = vec![steps(2.0); map.len()];
        let other = vec![0; map.len()];
        RegionPlanes::default().apply(&map, 64, &view, &other, &mut filled);
        assert_eq!(filled[40 * WIDTH + 50], steps(2.0));
    }

    /// A wall of one level, of which a few places differ from the rest.
    fn wall(found: impl Fn(usize, usize) -> u16, before: u16) -> Vec<u16> {
        let mut view = View::new(WIDTH, HEIGHT, false);
        view.fill(
            Plane::filled(WIDTH, HEIGHT, 90).view(),
            |level: u8| level,
            0,
        );
        let places = (0..WIDTH * HEIGHT).map(|place| [place % WIDTH, place / WIDTH]);
        let map: Vec<u16> = places.map(|[column, row]| found(column, row)).collect();
        let filled = |&found: &u16| if found == UNKNOWN { before } else { found };
        let mut filled: Vec<u16> = map.iter().map(filled).collect();
        let other = vec![UNKNOWN; map.len()];
        RegionPlanes::default().apply(&map, 64, &view, &other, &mut filled);
        filled
    }

    /// In the left margin, plane and row count alike where they are near each other.
    #[test]
    fn the_margin_is_between_plane_and_row() {
        let found = |column: usize, _: usize| {
            if column < 20 {
                UNKNOWN
            } else {
                steps(10.0 + 0.05 * column as f64)
            }
        };
        let filled = wall(found, steps(14.0));
        for column in 0..20 {
            let expected = steps((10.0 + 0.05 * column as f64 + 14.0) / 2.0);
            assert!(filled[WIDTH * 40 + column].abs_diff(expected) <= 2);
        }
    }

    /// Matches on the plane stay as they are.
    #[test]
    fn what_agrees_with_a_plane_is_not_replaced() {
        let bump = |column: usize| if column % 10 == 5 { 0.5 } else { 0.0 };
        let found = |column: usize, _: usize| steps(10.0 + bump(column));
        let filled = wall(found, 0);
        for (place, disparity) in filled.iter().enumerate() {
            assert_eq!(*disparity, found(place % WIDTH, 0));
        }
    }

    /// Where a plane leaves the range that was looked at, what was there stays.
    #[test]
    fn planes_end_with_the_range() {
        let mut view = View::new(WIDTH, HEIGHT, false);
        let identity = |level: u8| level;
        view.fill(Plane::filled(WIDTH, HEIGHT, 90).view(), identity, 0);
        let slant = |column: usize| 4.0 + 0.1 * column as f64;
        let is_hole = |column: usize| column >= WIDTH / 2;
        let cells = (0..WIDTH * HEIGHT).map(|place| place % WIDTH);
        let map: Vec<u16> = cells
            .map(|column| {
                if is_hole(column) {
                    UNKNOWN
                } else {
                    steps(slant(column))
                }
            })
            .collect();
        let before = map
            .iter()
            .map(|&d| if d == UNKNOWN { steps(3.0) } else { d });
        let before: Vec<u16> = before.collect();
        let other = vec![UNKNOWN; map.len()];
        let candidates = slant(3 * WIDTH / 4) as usize;
        let mut filled = before.clone();
        RegionPlanes::default().apply(&map, candidates, &view, &other, &mut filled);
        let row = HEIGHT / 2 * WIDTH;
        for column in WIDTH / 2..WIDTH {
            let expected = match slant(column) <= (candidates - 1) as f64 - 0.1 {
                true => slant(column),
                false if slant(column) >= candidates as f64 => 3.0,
                false => continue,
            };
            let found = f64::from(filled[row + column]) / f64::from(STEPS);
            assert!(
                (found - expected).abs() < 0.1,
                "{column}: {found} {expected}"
            );
        }
    }

    /// In a region with texture, matches are not corrected.
    #[test]
    fn matches_with_texture_stay() {
        let mut view = View::new(WIDTH, HEIGHT, false);
        let level = |column: usize, row: usize| 90 + 9 * ((column + row) % 2) as u8;
        let identity = |level: u8| level;
        view.fill(Plane::from_fn(WIDTH, HEIGHT, level).view(), identity, 0);
        let mut map = vec![steps(7.0); WIDTH * HEIGHT];
        map[WIDTH * 40 + 60] = steps(12.0);
        let mut filled = map.clone();
        let other = vec![UNKNOWN; map.len()];
        RegionPlanes::default().apply(&map, 64, &view, &other, &mut filled);
        assert_eq!(filled, map);
    }
}
