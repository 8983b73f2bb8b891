//! Whether the flat image of a chart covers any place twice.

use super::chart::{Chart, Flat, cross, minus};

/// Two faces whose boundary sides cross in the image, if there are any.
///
/// Where no triangle is folded and no boundary side crosses another one, the image of a connected
/// chart covers every place once.
pub(super) fn crossing(chart: &Chart, image: &[Flat]) -> Option<[u32; 2]> {
    let sides: Vec<u32> = chart.boundary().collect();
    let segments: Vec<[Flat; 2]> = sides
        .iter()
        .map(|&side| chart.side(side).map(|vertex| image[vertex as usize]))
        .collect();
    let grid = Grid::new(&segments);
    for places in &grid.cells {
        for (at, &i) in places.iter().enumerate() {
            for &j in &places[at + 1..] {
                let (a, b) = (segments[i as usize], segments[j as usize]);
                let ends = [sides[i as usize], sides[j as usize]].map(|side| chart.side(side));
                let apart = ends[0].iter().all(|vertex| !ends[1].contains(vertex));
                if apart && cross_each_other(a, b) {
                    return Some([i, j].map(|k| sides[k as usize] / 3));
                }
            }
        }
    }
    None
}

/// Whether two segments cross at a point inside both.
fn cross_each_other([a, b]: [Flat; 2], [c, d]: [Flat; 2]) -> bool {
    let side = |p: Flat, q: Flat, r: Flat| cross(minus(q, p), minus(r, p));
    let (s, t) = (side(a, b, c), side(a, b, d));
    let (u, v) = (side(c, d, a), side(c, d, b));
    s * t < 0.0 && u * v < 0.0
}

/// Segments in the cells of a grid that their bounding boxes touch.
struct Grid {
    cells: Vec<Vec<u32>>,
}

impl Grid {
    fn new(segments: &[[Flat; 2]]) -> Self {
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for point in segments.iter().flatten() {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let extent = (high[0] - low[0])
            .max(high[1] - low[1])
            .max(f64::MIN_POSITIVE);
        let across = ((segments.len() as f64).sqrt() as usize).clamp(1, 256) * 2;
        let cell = extent / across as f64;
        let mut cells = vec![Vec::new(); across * across];
        let place = |x: f64, axis: usize| (((x - low[axis]) / cell) as usize).min(across - 1);
        for (index, [a, b]) in segments.iter().enumerate() {
            let range =
                |axis: usize| place(a[axis].min(b[axis]), axis)..=place(a[axis].max(b[axis]), axis);
            for row in range(1) {
                for column in range(0) {
                    cells[row * across + column].push(index as u32);
                }
            }
        }
        Self { cells }
    }
}
