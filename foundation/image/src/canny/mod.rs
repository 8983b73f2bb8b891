//! Edges: lines of pixels at which a picture is steepest.

mod hysteresis;

use ga_runtime::batch::{Batch, Work};

use crate::filter::{Border, Gradient, SlopeRows};
use crate::plane::{Plane, PlaneError, PlaneView, same_size};
use hysteresis::{COLUMNS, Hysteresis};

/// Edges after J. Canny, "A computational approach to edge detection", 1986:
///
/// ```text
/// m = √(dx² + dy²)
/// candidates: m > low, and m is greater than that of both neighbours across the edge
/// edges: candidates with m > high, and those connected to them by way of candidates
/// ```
///
/// `[dx, dy]` is Sobel's [`Gradient`] of a picture whose outermost pixels are repeated; m and the
/// thresholds are 4 times the step of a sharp vertical or horizontal edge. Beyond the border
/// m = 0. The direction across the edge is rounded to a multiple of 45°. Of two neighbours in a row
/// or a column with equal m, the first is the edge. Pixels are connected to their eight neighbours.
///
/// These are the edges of OpenCV's `Canny` with `L2gradient`. Noise is to be removed before, by a
/// [`Gaussian`](crate::filter::Gaussian).
///
/// The value holds the memory of the work, which is used again for other pictures.
///
/// ```
/// use ga_image::canny::Canny;
/// use ga_image::plane::Plane;
///
/// let square = Plane::from_fn(20, 20, |column, row| {
///     if (5..15).contains(&column) && (5..15).contains(&row) { 200 } else { 50 }
/// });
/// let edges = Canny::new(100.0, 300.0)?.edges(&square);
/// assert_eq!(edges.row(10).iter().filter(|value| **value == 255).count(), 2);
/// # Ok::<(), ga_image::plane::PlaneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Canny {
    /// Squares of the thresholds.
    low: i32,
    high: i32,
    hysteresis: Hysteresis,
    rows: [Row; 3],
}

/// Squares of slopes, continued by one pixel on both sides, and the slopes.
#[derive(Clone, Debug, Default)]
struct Row {
    squares: Vec<i32>,
    dx: Vec<i16>,
    dy: Vec<i16>,
}

/// Bits of the kind of a pixel.
const CANDIDATE: u8 = 1;
const STRONG: u8 = 2;

impl Canny {
    /// Edges between two thresholds of the slope.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Thresholds`] unless 0 ≤ `low` ≤ `high`, which NaN is not. They may be
    /// infinite.
    pub fn new(low: f64, high: f64) -> Result<Self, PlaneError> {
        if !(0.0 <= low && low <= high) {
            return Err(PlaneError::Thresholds { low, high });
        }
        let [low, high] = [low, high].map(|threshold| (threshold * threshold).floor() as i32);
        Ok(Self {
            low,
            high,
            hysteresis: Hysteresis::default(),
            rows: Default::default(),
        })
    }

    /// A picture that is white (255) at edges and black (0) elsewhere.
    #[must_use]
    pub fn edges<'a>(&mut self, picture: impl Into<PlaneView<'a, u8>>) -> Plane<u8> {
        let picture = picture.into();
        let mut edges = Plane::filled(picture.width(), picture.height(), 0);
        self.run(picture, &mut edges);
        edges
    }

    /// Writes the edges to a plane of the picture's size.
    ///
    /// # Errors
    ///
    /// [`PlaneError::Differs`] when the plane has another size.
    pub fn edges_into<'a>(
        &mut self,
        picture: impl Into<PlaneView<'a, u8>>,
        edges: &mut Plane<u8>,
    ) -> Result<(), PlaneError> {
        let picture = picture.into();
        same_size(picture, edges.view())?;
        self.run(picture, edges);
        Ok(())
    }

    fn run(&mut self, picture: PlaneView<'_, u8>, edges: &mut Plane<u8>) {
        if picture.is_empty() {
            return;
        }
        let (width, height) = (picture.width(), picture.height());
        let padded = width.next_multiple_of(COLUMNS);
        for row in &mut self.rows {
            row.squares.clear();
            row.squares.resize(padded + 2, 0);
            for slopes in [&mut row.dx, &mut row.dy] {
                slopes.clear();
                slopes.resize(padded, 0);
            }
        }
        self.hysteresis.clear(width, height);
        Batch::new().run(Edges {
            slopes: SlopeRows::new(picture, Gradient::Sobel, Border::Replicate),
            canny: self,
            size: [width, height],
            edges,
        });
    }
}

struct Edges<'a, 'b> {
    slopes: SlopeRows<'a>,
    canny: &'b mut Canny,
    size: [usize; 2],
    edges: &'b mut Plane<u8>,
}

impl Work for Edges<'_, '_> {
    #[inline(always)]
    fn run(mut self) {
        let [_, height] = self.size;
        self.fill(0, 0);
        for row in 0..height {
            if row + 1 < height {
                self.fill((row + 1) % 3, row + 1);
            } else {
                self.canny.rows[(row + 1) % 3].squares.fill(0);
            }
            self.suppress(row);
            self.canny.hysteresis.grow_down(row);
        }
        self.canny.hysteresis.finish();
        for row in 0..height {
            write(self.canny.hysteresis.edges(row), self.edges.row_mut(row));
        }
    }
}

impl Edges<'_, '_> {
    /// Computes the slopes of a row of the picture.
    #[inline(always)]
    fn fill(&mut self, slot: usize, row: usize) {
        let [width, _] = self.size;
        let Row { squares, dx, dy } = &mut self.canny.rows[slot];
        self.slopes.horizontal(row, &mut dx[..width]);
        self.slopes.vertical(row, &mut dy[..width]);
        let (squares, _) = squares[1..].as_chunks_mut::<COLUMNS>();
        let ((dx, _), (dy, _)) = (dx.as_chunks(), dy.as_chunks());
        for ((squares, dx), dy) in squares.iter_mut().zip(dx).zip(dy) {
            add_squares(squares, dx, dy);
        }
    }

    /// Finds the candidates of a row.
    #[inline(always)]
    fn suppress(&mut self, row: usize) {
        let [width, _] = self.size;
        let thresholds = [self.canny.low, self.canny.high];
        let [above, here, below] = [row + 2, row, row + 1].map(|k| &self.canny.rows[k % 3]);
        for word in 0..width.div_ceil(COLUMNS) {
            let column = word * COLUMNS;
            let block = Block {
                above: around(&above.squares[column..]),
                here: around(&here.squares[column..]),
                below: around(&below.squares[column..]),
                dx: first(&here.dx[column..]),
                dy: first(&here.dy[column..]),
            };
            let mut kinds = [0; COLUMNS];
            greatest(&mut kinds, &block, thresholds);
            let (candidates, strong) = (gathered(&kinds, CANDIDATE), gathered(&kinds, STRONG));
            self.canny.hysteresis.set(row, word, candidates, strong);
        }
    }
}

/// Squares of slopes in three rows, each at the columns before those of a block, at those of the
/// block, and after them; and the slopes of the block.
struct Block<'a> {
    above: [&'a [i32; COLUMNS]; 3],
    here: [&'a [i32; COLUMNS]; 3],
    below: [&'a [i32; COLUMNS]; 3],
    dx: &'a [i16; COLUMNS],
    dy: &'a [i16; COLUMNS],
}

#[inline(always)]
fn add_squares(squares: &mut [i32; COLUMNS], dx: &[i16; COLUMNS], dy: &[i16; COLUMNS]) {
    for k in 0..COLUMNS {
        let (x, y) = (i32::from(dx[k]), i32::from(dy[k]));
        squares[k] = x * x + y * y;
    }
}

/// The first numbers.
#[inline(always)]
fn first<T>(numbers: &[T]) -> &[T; COLUMNS] {
    numbers.first_chunk().expect("rows are padded")
}

#[inline(always)]
fn around(squares: &[i32]) -> [&[i32; COLUMNS]; 3] {
    [first(squares), first(&squares[1..]), first(&squares[2..])]
}

/// Tells which pixels of a block are steeper than their neighbours across the edge. Every pixel
/// takes the same steps, so that the loops run in lanes.
#[inline(always)]
fn greatest(kinds: &mut [u8; COLUMNS], block: &Block<'_>, [low, high]: [i32; 2]) {
    /// The tangent of 22.5°, times 2¹⁵.
    const TANGENT: i32 = 13573;
    let [above_left, above, above_right] = block.above;
    let [left, here, right] = block.here;
    let [below_left, below, below_right] = block.below;
    let mut others = [0; COLUMNS];
    for k in 0..COLUMNS {
        let (slope_x, slope_y) = (i32::from(block.dx[k]), i32::from(block.dy[k]));
        let (x, y) = (slope_x.abs(), slope_y.abs() << 15);
        let flat = x * TANGENT;
        // The first of two equal neighbours along a row or a column is the edge.
        let along_row = left[k].max(right[k] - 1);
        let along_column = above[k].max(below[k] - 1);
        let falling = above_right[k].max(below_left[k]);
        let rising = above_left[k].max(below_right[k]);
        let falls = (slope_x ^ slope_y) < 0;
        let other = if falls { falling } else { rising };
        let is_vertical = y > flat + (x << 16);
        let other = if is_vertical { along_column } else { other };
        let is_horizontal = y < flat;
        others[k] = if is_horizontal { along_row } else { other };
    }
    for k in 0..COLUMNS {
        let is_candidate = here[k] > others[k].max(low);
        let is_strong = is_candidate & (here[k] > high);
        kinds[k] = u8::from(is_candidate) * CANDIDATE + u8::from(is_strong) * STRONG;
    }
}

/// One bit of each kind.
#[inline(always)]
fn gathered(kinds: &[u8; COLUMNS], bit: u8) -> u64 {
    let mut gathered = [0; 8];
    let (groups, _) = kinds.as_chunks();
    for (byte, group) in gathered.iter_mut().zip(groups) {
        let ones = u64::from_le_bytes(*group) >> bit.trailing_zeros() & 0x0101_0101_0101_0101;
        // The product has the lowest bits of the bytes in its uppermost byte, in their order.
        *byte = (ones.wrapping_mul(0x0102_0408_1020_4080) >> 56) as u8;
    }
    u64::from_le_bytes(gathered)
}

/// Writes 255 for each bit that is set, 0 for the others.
#[inline(always)]
fn write(words: &[u64], pixels: &mut [u8]) {
    for (word, pixels) in words.iter().zip(pixels.chunks_mut(COLUMNS)) {
        let mut written = [0; COLUMNS];
        let (groups, _) = written.as_chunks_mut();
        for (group, byte) in groups.iter_mut().zip(word.to_le_bytes()) {
            *group = WHITE[usize::from(byte)];
        }
        pixels.copy_from_slice(&written[..pixels.len()]);
    }
}

/// The eight pixels of each byte of bits.
static WHITE: [[u8; 8]; 256] = {
    let mut table = [[0; 8]; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut bit = 0;
        while bit < 8 {
            if byte >> bit & 1 == 1 {
                table[byte][bit] = u8::MAX;
            }
            bit += 1;
        }
        byte += 1;
    }
    table
};
