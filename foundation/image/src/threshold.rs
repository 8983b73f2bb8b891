//! Thresholds: which pixels are brighter than a level.

use ga_runtime::batch::{Batch, Work};

use crate::filter::Border;
use crate::plane::{Plane, PlaneView};

/// How many pixels have each of the 256 levels.
#[must_use]
pub fn histogram<'a>(picture: impl Into<PlaneView<'a, u8>>) -> [u64; 256] {
    let mut counts = [0; 256];
    Batch::new().run(Counting {
        picture: picture.into(),
        counts: &mut counts,
    });
    counts
}

/// The level that divides the pixels into two classes, those not above and those above it, with the
/// greatest variance between the classes, `n₀ n₁ (m₀ − m₁)²` for `n` pixels of mean level `m` in
/// each (N. Otsu, "A threshold selection method from gray-level histograms", 1979). The least such
/// level, if several have it.
///
/// `None` where all pixels have one level.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::threshold::{above, otsu};
///
/// let picture = Plane::from_fn(8, 8, |column, row| {
///     if column < 3 { 20 } else { 200 + row as u8 }
/// });
/// let level = otsu(&picture).ok_or("one level")?;
/// assert_eq!(level, 20);
/// assert_eq!(above(&picture, level).row(0), [0, 0, 0, 255, 255, 255, 255, 255]);
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn otsu<'a>(picture: impl Into<PlaneView<'a, u8>>) -> Option<u8> {
    let counts = histogram(picture);
    let total: u64 = counts.iter().sum();
    let levels = counts.iter().zip(0u64..);
    let sum: u64 = levels.map(|(count, level)| count * level).sum();
    let (mut lower_count, mut lower_sum) = (0, 0);
    let mut best = None;
    let mut greatest = 0.0;
    for (count, level) in counts.iter().zip(0u8..=u8::MAX) {
        lower_count += count;
        lower_sum += count * u64::from(level);
        let upper_count = total - lower_count;
        if lower_count == 0 || upper_count == 0 {
            continue;
        }
        let [n0, n1] = [lower_count, upper_count].map(|n| n as f64);
        let difference = lower_sum as f64 / n0 - (sum - lower_sum) as f64 / n1;
        let variance = n0 * n1 * difference * difference;
        if variance > greatest {
            greatest = variance;
            best = Some(level);
        }
    }
    best
}

/// White (255) where a pixel is above a level, black (0) elsewhere.
#[must_use]
pub fn above<'a>(picture: impl Into<PlaneView<'a, u8>>, level: u8) -> Plane<u8> {
    picture
        .into()
        .map(|value| if value > level { u8::MAX } else { 0 })
}

/// White (255) where a pixel is above the mean of the square of 2 `radius` + 1 pixels round it,
/// minus `offset`; black (0) elsewhere. Beyond its border the picture is continued by `border`.
/// The mean is not rounded.
///
/// ```
/// use ga_image::filter::Border;
/// use ga_image::plane::Plane;
/// use ga_image::threshold::adaptive;
///
/// // A bright dot on a ramp that has no single level which divides them.
/// let ramp = Plane::from_fn(40, 9, |column, row| {
///     5 * column as u8 + if [column, row] == [4, 4] { 25 } else { 0 }
/// });
/// let dots = adaptive(&ramp, 2, -8, Border::Mirror);
/// assert_eq!(dots.values().iter().filter(|value| **value == 255).count(), 1);
/// assert_eq!(dots.get(4, 4), Some(255));
/// ```
#[must_use]
pub fn adaptive<'a>(
    picture: impl Into<PlaneView<'a, u8>>,
    radius: u16,
    offset: i16,
    border: Border,
) -> Plane<u8> {
    let picture = picture.into();
    let (width, height) = (picture.width(), picture.height());
    let mut white = Plane::filled(width, height, 0);
    if picture.is_empty() {
        return white;
    }
    let reach = radius as isize;
    let side = 2 * i64::from(radius) + 1;
    let row_at = |row: isize| picture.row(border.index(row, height));
    let mut columns = vec![0i64; width];
    for row in -reach - 1..reach {
        for (sum, value) in columns.iter_mut().zip(row_at(row)) {
            *sum += i64::from(*value);
        }
    }
    let column_at = |column: isize| border.index(column, width);
    for row in 0..height {
        let (leaving, entering) = (row.cast_signed() - reach - 1, row.cast_signed() + reach);
        let changes = row_at(leaving).iter().zip(row_at(entering));
        for (sum, (old, new)) in columns.iter_mut().zip(changes) {
            *sum += i64::from(*new) - i64::from(*old);
        }
        let mut sum: i64 = (-reach - 1..reach).map(|c| columns[column_at(c)]).sum();
        let target = white.row_mut(row).iter_mut();
        for ((column, target), value) in (0isize..).zip(target).zip(picture.row(row)) {
            sum += columns[column_at(column + reach)] - columns[column_at(column - reach - 1)];
            let level = i64::from(*value) + i64::from(offset);
            *target = if level * side * side > sum {
                u8::MAX
            } else {
                0
            };
        }
    }
    white
}

struct Counting<'a> {
    picture: PlaneView<'a, u8>,
    counts: &'a mut [u64; 256],
}

impl Work for Counting<'_> {
    #[inline(always)]
    fn run(self) {
        if self.picture.width() * self.picture.height() < LEAST_FOR_PAIRS {
            let mut tables = [[0; 256]; 4];
            for row in self.picture.rows() {
                count(&mut tables, row);
            }
            collect(&tables, self.counts);
            return;
        }
        let mut pairs = [(); 2].map(|()| vec![0; 1 << 16]);
        // A counter of 32 bits cannot overflow before it is added up.
        let mut pending = 0;
        for row in self.picture.rows() {
            for part in row.chunks(1 << 24) {
                pending += part.len();
                count_pairs(&mut pairs, self.counts, part);
                if pending > 1 << 30 {
                    pending = 0;
                    collect_pairs(&mut pairs, self.counts);
                }
            }
        }
        collect_pairs(&mut pairs, self.counts);
    }
}

/// From this number of pixels on, tables of pairs save more time than it takes to clear and add
/// them.
const LEAST_FOR_PAIRS: usize = 1 << 18;

/// Counts pixels in several tables, so that equal levels beside each other do not wait for one
/// counter.
#[inline(always)]
fn count(tables: &mut [[u32; 256]; 4], pixels: &[u8]) {
    let (groups, rest) = pixels.as_chunks::<4>();
    for group in groups {
        for (table, pixel) in tables.iter_mut().zip(group) {
            table[usize::from(*pixel)] += 1;
        }
    }
    for pixel in rest {
        tables[0][usize::from(*pixel)] += 1;
    }
}

fn collect(tables: &[[u32; 256]; 4], counts: &mut [u64; 256]) {
    for table in tables {
        for (count, part) in counts.iter_mut().zip(table) {
            *count += u64::from(*part);
        }
    }
}

/// Counts pairs of pixels beside each other: half as many counters change as there are pixels.
#[inline(always)]
fn count_pairs([even, odd]: &mut [Vec<u32>; 2], counts: &mut [u64; 256], pixels: &[u8]) {
    let (words, rest) = pixels.as_chunks::<8>();
    for word in words {
        let bytes = u64::from_le_bytes(*word);
        even[usize::from(bytes as u16)] += 1;
        odd[usize::from((bytes >> 16) as u16)] += 1;
        even[usize::from((bytes >> 32) as u16)] += 1;
        odd[usize::from((bytes >> 48) as u16)] += 1;
    }
    for pixel in rest {
        counts[usize::from(*pixel)] += 1;
    }
}

/// Adds each counter of pairs to those of both its levels, and clears it.
fn collect_pairs(pairs: &mut [Vec<u32>; 2], counts: &mut [u64; 256]) {
    for table in pairs {
        for (high, row) in table.as_chunks_mut::<256>().0.iter_mut().enumerate() {
            for (count, pair) in counts.iter_mut().zip(&mut *row) {
                *count += u64::from(*pair);
            }
            counts[high] += row.iter().map(|pair| u64::from(*pair)).sum::<u64>();
            row.fill(0);
        }
    }
}
