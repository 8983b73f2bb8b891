//! Corners, by the smaller eigenvalue of the structure tensor.

use ga_image::filter::{Border, Gaussian};
use ga_image::plane::Plane;

/// Corners need this many pixels around them, for their descriptors.
pub(super) const MARGIN: usize = 18;

/// A corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) place: [f64; 2],
    pub(super) strength: f64,
}

/// The corners of a smoothed picture by rows, at most a given number.
///
/// The strength is the smaller eigenvalue of the structure tensor, the mean of `∇I ∇Iᵀ` weighted by
/// a Gaussian (J. Shi and C. Tomasi, "Good features to track", 1994). A corner is a maximum of it
/// among its eight neighbours, at the top of the paraboloid through them. The strongest ones are
/// taken, no more than a share from each cell of a grid, so that they cover the picture.
pub(super) fn corners(smooth: &Plane<f32>, least_strength: f64, count: usize) -> Vec<Corner> {
    let (width, height) = (smooth.width(), smooth.height());
    if width.min(height) <= 2 * MARGIN {
        return Vec::new();
    }
    let Some(strengths) = strengths(smooth) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for row in MARGIN..height - MARGIN {
        let rows = [row - 1, row, row + 1].map(|row| strengths.row(row));
        for column in MARGIN..width - MARGIN {
            let centre = rows[1][column];
            if f64::from(centre) < least_strength {
                continue;
            }
            let around = |k: usize| rows[k / 3][column + k % 3 - 1];
            // Of equal neighbours the last one counts.
            let is_top = (0..4).all(|k| around(k) <= centre) && (5..9).all(|k| around(k) < centre);
            if is_top {
                let [u, v] = top(&std::array::from_fn(|k| f64::from(around(k))));
                found.push(Corner {
                    place: [column as f64 + u, row as f64 + v],
                    strength: centre.into(),
                });
            }
        }
    }
    spread(found, [width, height], count)
}

/// The smaller eigenvalue of the structure tensor at each pixel.
fn strengths(smooth: &Plane<f32>) -> Option<Plane<f32>> {
    let (width, height) = (smooth.width(), smooth.height());
    let tensors = Plane::from_fn(width, height, |column, row| {
        if column == 0 || row == 0 || column + 1 == width || row + 1 == height {
            return [0.0; 3];
        }
        let line = smooth.row(row);
        let x = 0.5 * (line[column + 1] - line[column - 1]);
        let y = 0.5 * (smooth.row(row + 1)[column] - smooth.row(row - 1)[column]);
        [x * x, x * y, y * y]
    });
    let window = Gaussian::new(1.5).ok()?;
    let means = window.blur(&tensors, Border::Mirror);
    Some(means.map(|[xx, xy, yy]| {
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        mean - (half * half + xy * xy).sqrt()
    }))
}

/// The top of the paraboloid that fits a pixel and its neighbours best, as an offset of at most
/// half a pixel along each axis.
fn top(values: &[f64; 9]) -> [f64; 2] {
    let [a, b, c, d, e, f, g, h, i] = *values;
    let x = (c + f + i - a - d - g) / 6.0;
    let y = (g + h + i - a - b - c) / 6.0;
    let xx = (a + c + d + f + g + i - 2.0 * (b + e + h)) / 3.0;
    let yy = (a + b + c + g + h + i - 2.0 * (d + e + f)) / 3.0;
    let xy = (a + i - c - g) / 4.0;
    let determinant = xx * yy - xy * xy;
    let offset = [
        (xy * y - yy * x) / determinant,
        (xy * x - xx * y) / determinant,
    ];
    match offset.iter().all(|value| value.is_finite()) && determinant > 0.0 {
        true => offset.map(|value| value.clamp(-0.5, 0.5)),
        false => [0.0; 2],
    }
}

/// The strongest corners, of which no cell of a grid has more than a share, by rows.
fn spread(mut corners: Vec<Corner>, size: [usize; 2], count: usize) -> Vec<Corner> {
    const CELL: usize = 48;
    let [columns, rows] = size.map(|side| side.div_ceil(CELL));
    let share = count.saturating_mul(3).div_ceil(columns * rows).max(2);
    // The sort is stable, so that equal strengths stay in the order of rows.
    corners.sort_by(|a, b| b.strength.total_cmp(&a.strength));
    let mut taken = vec![0; columns * rows];
    corners.retain(|corner| {
        let [column, row] = corner.place.map(|x| x as usize / CELL);
        let cell = &mut taken[row * columns + column];
        *cell += 1;
        *cell <= share
    });
    corners.truncate(count);
    corners.sort_by(|a, b| {
        a.place[1]
            .total_cmp(&b.place[1])
            .then(a.place[0].total_cmp(&b.place[0]))
    });
    corners
}
