//! The two views as the matcher reads them: brought to the same exposure, the right one moved by
//! the least disparity and mirrored, and with a margin on either side of each row.

use std::ops::Range;

use ga_image::plane::PlaneView;
use rayon::join;

/// The columns of margin on either side of a row, in which its outermost pixel is repeated.
pub(super) const MARGIN: usize = 4;

/// A view with margins. The right view is stored mirrored: its pixel in column *x* is in column
/// *w* − 1 − *x*, so that the candidates of a pixel lie in the order of rising disparity. Then the
/// mirrored right view has the same relation to the left view as the left view to it.
#[derive(Clone, Debug)]
pub(super) struct View {
    width: usize,
    height: usize,
    mirrored: bool,
    /// The columns that show something; others repeat the nearest of these.
    seen: Range<usize>,
    levels: Vec<u8>,
}

impl View {
    pub(super) fn new(width: usize, height: usize, mirrored: bool) -> Self {
        Self {
            width,
            height,
            mirrored,
            seen: 0..width,
            levels: vec![0; (width + 2 * MARGIN) * height],
        }
    }

    /// Takes the pixels of a plane of this size, each changed by a table and moved to the right by
    /// a number of columns, less than the width.
    pub(super) fn fill(&mut self, plane: PlaneView<'_, u8>, table: &[u8; 256], shift: isize) {
        let width = self.width;
        let seen = shift.max(0).cast_unsigned()..width.saturating_add_signed(shift.min(0));
        let hidden = (-shift).max(0).cast_unsigned();
        let rows = self.levels.chunks_exact_mut(width + 2 * MARGIN);
        for (row, source) in rows.zip(plane.rows()) {
            let inside = &mut row[MARGIN..][..width];
            for (level, value) in inside[seen.clone()].iter_mut().zip(&source[hidden..]) {
                *level = table[usize::from(*value)];
            }
            let (first, last) = (inside[seen.start], inside[seen.end - 1]);
            inside[..seen.start].fill(first);
            inside[seen.end..].fill(last);
            if self.mirrored {
                inside.reverse();
            }
            let (first, last) = (inside[0], inside[width - 1]);
            row[..MARGIN].fill(first);
            row[MARGIN + width..].fill(last);
        }
        self.seen = match self.mirrored {
            true => width - seen.end..width - seen.start,
            false => seen,
        };
    }

    pub(super) fn width(&self) -> usize {
        self.width
    }

    pub(super) fn height(&self) -> usize {
        self.height
    }

    /// The columns that show something.
    pub(super) fn seen(&self) -> Range<usize> {
        self.seen.clone()
    }

    /// Whether columns count from the right.
    pub(super) fn is_mirrored(&self) -> bool {
        self.mirrored
    }

    /// The row at a signed place, with margins; beyond the border, the outermost row.
    #[inline(always)]
    pub(super) fn padded(&self, row: isize) -> &[u8] {
        let row = row.clamp(0, self.height.cast_signed() - 1).cast_unsigned();
        let stride = self.width + 2 * MARGIN;
        &self.levels[row * stride..][..stride]
    }

    /// A row without margins.
    #[inline(always)]
    pub(super) fn row(&self, row: usize) -> &[u8] {
        &self.padded(row.cast_signed())[MARGIN..][..self.width]
    }
}

/// Takes the left and the right view, the right one at the exposure of the left and moved to the
/// right by the least disparity. Then disparities count from that one.
pub(super) fn fill(
    planes: [PlaneView<'_, u8>; 2],
    [left, right]: [&mut View; 2],
    least_disparity: isize,
) {
    let identity = std::array::from_fn(|level| level as u8);
    let table = exposure(planes);
    join(
        || left.fill(planes[0], &identity, 0),
        || right.fill(planes[1], &table, least_disparity),
    );
}

/// The table that brings the right view to the exposure of the left: the gain and the offset for
/// which means and standard deviations agree. Where the gain is within 6 % of 1 and the means are
/// within 6 levels, nothing is changed: such differences come from what only one view shows.
fn exposure([left, right]: [PlaneView<'_, u8>; 2]) -> [u8; 256] {
    let ((mean_left, deviation_left), (mean_right, deviation_right)) =
        join(|| moments(left), || moments(right));
    let gain = if deviation_right > 0.5 && deviation_left > 0.5 {
        deviation_left / deviation_right
    } else {
        1.0
    };
    let same = (gain - 1.0).abs() <= 0.06 && (mean_left - mean_right).abs() <= 6.0;
    std::array::from_fn(|level| {
        if same {
            level as u8
        } else {
            // The conversion saturates.
            (mean_left + gain * (level as f64 - mean_right) + 0.5) as u8
        }
    })
}

/// The mean and the standard deviation of the levels.
fn moments(plane: PlaneView<'_, u8>) -> (f64, f64) {
    let mut counts = [0u64; 256];
    for row in plane.rows() {
        for level in row {
            counts[usize::from(*level)] += 1;
        }
    }
    let count = counts.iter().sum::<u64>().max(1) as f64;
    let moment = |power: i32, origin: f64| -> f64 {
        let levels = counts.iter().enumerate();
        levels
            .map(|(level, n)| *n as f64 * (level as f64 - origin).powi(power))
            .sum::<f64>()
            / count
    };
    let mean = moment(1, 0.0);
    (mean, moment(2, mean).sqrt())
}

/// The standard deviation of noise in a view, in levels: the first quartile of the magnitude of the
/// Laplacian 1 −2 1; −2 4 −2; 1 −2 1, whose weights have a root of the sum of squares of 6, divided
/// by 6 · 0.3186, that quartile of a normal distribution.
pub(super) fn noise(view: &View) -> f32 {
    const QUARTILE: f32 = 1.91;
    let mut counts = [0u32; 2048];
    let mut total = 0;
    let height = view.height();
    // Every second row is more than enough for a quartile.
    for row in (1..height.saturating_sub(1)).step_by(2) {
        let [above, middle, below] = [row - 1, row, row + 1].map(|r| view.row(r));
        for column in view.seen.start + 1..view.seen.end.saturating_sub(1) {
            let second = |line: &[u8]| {
                i32::from(line[column - 1]) - 2 * i32::from(line[column])
                    + i32::from(line[column + 1])
            };
            let value = second(above) - 2 * second(middle) + second(below);
            counts[(value.unsigned_abs() as usize).min(2047)] += 1;
            total += 1;
        }
    }
    // Within a count, values are taken as spread evenly over a width of 1.
    let mut below = 0;
    for (value, count) in counts.iter().enumerate() {
        if *count > 0 && 4 * (below + count) >= total {
            let within = (total as f32 / 4.0 - below as f32) / *count as f32;
            return (value as f32 - 0.5 + within).max(0.0) / QUARTILE;
        }
        below += count;
    }
    0.0
}
