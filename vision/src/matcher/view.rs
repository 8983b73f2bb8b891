//! The two views as the matcher reads them: brought to the same exposure, the right one moved by
//! the least disparity and mirrored, and with a margin on either side of each row.

use std::ops::Range;

use ga_image::plane::PlaneView;
use ga_image::sample::Sample;
use rayon::join;

use super::exposure::{Exposed, IN_A_LEVEL};

/// The columns of margin on either side of a row, in which its outermost pixel is repeated.
pub(super) const MARGIN: usize = 4;

/// A view with margins. The right view is stored mirrored: its pixel in column *x* is in column
/// *w* − 1 − *x*, so that the candidates of a pixel lie in the order of rising disparity. Then the
/// mirrored right view has the same relation to the left view as the left view to it.
#[derive(Clone, Debug)]
pub(super) struct View {
    frame: Frame,
    levels: Vec<u8>,
    /// The numbers that the levels are rounded from; nothing where they tell no more than these.
    fine: Vec<u16>,
    /// The standard deviation of their noise, in levels.
    fine_noise: f32,
}

/// Where the pixels of a view are.
#[derive(Clone, Debug)]
struct Frame {
    width: usize,
    height: usize,
    mirrored: bool,
    /// The columns that show something; others repeat the nearest of these.
    seen: Range<usize>,
}

impl View {
    pub(super) fn new(width: usize, height: usize, mirrored: bool) -> Self {
        Self {
            frame: Frame {
                width,
                height,
                mirrored,
                seen: 0..width,
            },
            levels: vec![0; (width + 2 * MARGIN) * height],
            fine: Vec::new(),
            fine_noise: 0.0,
        }
    }

    /// Takes the levels of the pixels of a plane of this size, moved to the right by a number of
    /// columns, less than the width.
    pub(super) fn fill<T: Copy>(
        &mut self,
        plane: PlaneView<'_, T>,
        level: impl Fn(T) -> u8,
        shift: isize,
    ) {
        self.frame.place(&mut self.levels, plane, level, shift);
        self.fine.clear();
        let width = self.frame.width;
        let seen = shown(width, shift);
        self.frame.seen = match self.frame.mirrored {
            true => width - seen.end..width - seen.start,
            false => seen,
        };
    }

    /// Keeps the numbers that the levels were rounded from, of a plane moved as before.
    fn keep_fine<T: Sample>(&mut self, plane: PlaneView<'_, T>, shift: isize) {
        self.fine.resize(self.levels.len(), 0);
        self.frame.place(&mut self.fine, plane, T::to_u16, shift);
        let number = |value: u16| i32::from(value);
        self.fine_noise =
            deviation_of_noise(&self.frame, |row| self.fine_row(row), number, FINENESS)
                * FINENESS as f32
                / IN_A_LEVEL as f32;
    }

    pub(super) fn width(&self) -> usize {
        self.frame.width
    }

    pub(super) fn height(&self) -> usize {
        self.frame.height
    }

    /// The columns that show something.
    pub(super) fn seen(&self) -> Range<usize> {
        self.frame.seen.clone()
    }

    /// Whether columns count from the right.
    pub(super) fn is_mirrored(&self) -> bool {
        self.frame.mirrored
    }

    /// Whether there are numbers that tell more than the levels.
    pub(super) fn is_fine(&self) -> bool {
        !self.fine.is_empty()
    }

    /// The row at a signed place, with margins; beyond the border, the outermost row.
    #[inline(always)]
    pub(super) fn padded(&self, row: isize) -> &[u8] {
        self.frame.padded(&self.levels, row)
    }

    /// As [`padded`](Self::padded), the numbers that the levels are rounded from.
    #[inline(always)]
    pub(super) fn padded_fine(&self, row: isize) -> &[u16] {
        self.frame.padded(&self.fine, row)
    }

    /// A row of the numbers that the levels are rounded from, without margins.
    pub(super) fn fine_row(&self, row: usize) -> &[u16] {
        &self.padded_fine(row.cast_signed())[MARGIN..][..self.frame.width]
    }

    /// The standard deviation of their noise, in levels; `None` where they tell no more than these.
    pub(super) fn fine_noise(&self) -> Option<f32> {
        self.is_fine().then_some(self.fine_noise)
    }

    /// A row without margins.
    #[inline(always)]
    pub(super) fn row(&self, row: usize) -> &[u8] {
        &self.padded(row.cast_signed())[MARGIN..][..self.frame.width]
    }
}

impl Frame {
    /// Copies the changed pixels of a plane to where they are in this view.
    fn place<T: Copy, U: Copy>(
        &self,
        values: &mut [U],
        plane: PlaneView<'_, T>,
        change: impl Fn(T) -> U,
        shift: isize,
    ) {
        let width = self.width;
        let seen = shown(width, shift);
        let hidden = (-shift).max(0).cast_unsigned();
        let rows = values.chunks_exact_mut(width + 2 * MARGIN);
        for (row, source) in rows.zip(plane.rows()) {
            let inside = &mut row[MARGIN..][..width];
            for (to, from) in inside[seen.clone()].iter_mut().zip(&source[hidden..]) {
                *to = change(*from);
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
    }

    #[inline(always)]
    fn padded<'a, U>(&self, values: &'a [U], row: isize) -> &'a [U] {
        let row = row.clamp(0, self.height.cast_signed() - 1).cast_unsigned();
        let stride = self.width + 2 * MARGIN;
        &values[row * stride..][..stride]
    }
}

/// The columns that still show something of a view that is moved to the right.
fn shown(width: usize, shift: isize) -> Range<usize> {
    shift.max(0).cast_unsigned()..width.saturating_add_signed(shift.min(0))
}

/// Takes the left and the right view, the right one at the exposure of the left and moved to the
/// right by the least disparity. Then disparities count from that one.
pub(super) fn fill<T: Sample>(
    planes: [PlaneView<'_, T>; 2],
    [left, right]: [&mut View; 2],
    least_disparity: isize,
) {
    let Exposed {
        tables: [left_table, right_table],
        is_fine,
    } = Exposed::new(planes);
    let take = |view: &mut View, plane: PlaneView<'_, T>, table: &[u8], shift| {
        view.fill(plane, |value: T| table[usize::from(value.to_u16())], shift);
        if is_fine {
            view.keep_fine(plane, shift);
        }
    };
    join(
        || take(left, planes[0], &left_table, 0),
        || take(right, planes[1], &right_table, least_disparity),
    );
}

/// The standard deviation of noise in a view, in levels.
pub(super) fn noise(view: &View) -> f32 {
    deviation_of_noise(&view.frame, |row| view.row(row), i32::from, 1)
}

/// Numbers of 16 bits that are taken together where noise is measured.
const FINENESS: u32 = 16;

/// The standard deviation of noise, in steps of so many numbers: the first quartile of the
/// magnitude of the Laplacian 1 −2 1; −2 4 −2; 1 −2 1, whose weights have a root of the sum of
/// squares of 6, divided by 6 · 0.3186, that quartile of a normal distribution.
fn deviation_of_noise<'a, T: Copy + 'a>(
    frame: &Frame,
    rows: impl Fn(usize) -> &'a [T],
    number: impl Fn(T) -> i32,
    step: u32,
) -> f32 {
    const QUARTILE: f32 = 1.91;
    let mut counts = [0u32; 2048];
    let mut total = 0;
    // Every second row is more than enough for a quartile.
    for row in (1..frame.height.saturating_sub(1)).step_by(2) {
        let [above, middle, below] = [row - 1, row, row + 1].map(&rows);
        for column in frame.seen.start + 1..frame.seen.end.saturating_sub(1) {
            let second = |line: &[T]| {
                number(line[column - 1]) - 2 * number(line[column]) + number(line[column + 1])
            };
            let value = second(above) - 2 * second(middle) + second(below);
            counts[((value.unsigned_abs() / step) as usize).min(2047)] += 1;
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
