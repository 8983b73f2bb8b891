//! Edges: lines of pixels at which a picture is steepest.

use ga_runtime::batch::{Batch, Work};

use crate::filter::{Border, Gradient, SlopeRows};
use crate::plane::{Plane, PlaneView, SizeError, same_size};

/// Edges after J. Canny, "A computational approach to edge detection", 1986: pixels whose slope is
/// greater than those of the two neighbours across the edge and above the upper threshold, and
/// those above the lower threshold that are connected to them through their eight neighbours.
///
/// The slope is the length `√(dx² + dy²)` of Sobel's gradient, of a picture whose outermost pixels
/// are repeated; it is 4 times the step of a sharp vertical or horizontal edge. Directions are
/// rounded to multiples of 45°. These are the edges of OpenCV's `Canny` with `L2gradient`. Noise is
/// to be removed before, by a [`Gaussian`](crate::filter::Gaussian).
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
/// # Ok::<(), ga_image::canny::ThresholdError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Canny {
    /// Squares of the thresholds.
    low: i32,
    high: i32,
    /// Kinds of pixels, continued by one pixel on all sides.
    kinds: Vec<u8>,
    /// Indices of edge pixels whose neighbours have not been visited.
    pending: Vec<usize>,
    rows: [Row; 3],
}

/// Thresholds of slopes that are not in order.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the thresholds {low} and {high} of slopes are not two numbers from 0 on in rising order")]
pub struct ThresholdError {
    /// The lower threshold.
    pub low: f64,
    /// The upper threshold.
    pub high: f64,
}

/// Squares of slopes, continued by one pixel on both sides, and the slopes.
#[derive(Clone, Debug, Default)]
struct Row {
    squares: Vec<i32>,
    dx: Vec<i16>,
    dy: Vec<i16>,
}

const NONE: u8 = 0;
const WEAK: u8 = 1;
const EDGE: u8 = 2;

impl Canny {
    /// Edges between two thresholds of the slope.
    ///
    /// # Errors
    ///
    /// [`ThresholdError`] unless 0 ≤ `low` ≤ `high`.
    pub fn new(low: f64, high: f64) -> Result<Self, ThresholdError> {
        if !(0.0 <= low && low <= high) {
            return Err(ThresholdError { low, high });
        }
        let [low, high] = [low, high].map(|threshold| (threshold * threshold).floor() as i32);
        Ok(Self {
            low,
            high,
            kinds: Vec::new(),
            pending: Vec::new(),
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
    /// [`SizeError::Differs`] when the plane has another size.
    pub fn edges_into<'a>(
        &mut self,
        picture: impl Into<PlaneView<'a, u8>>,
        edges: &mut Plane<u8>,
    ) -> Result<(), SizeError> {
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
        self.kinds.clear();
        self.kinds.resize((width + 2) * (height + 2), NONE);
        self.pending.clear();
        for row in &mut self.rows {
            row.squares.clear();
            row.squares.resize(width + 2, 0);
            row.dx.resize(width, 0);
            row.dy.resize(width, 0);
        }
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
        let [width, height] = self.size;
        let stride = width + 2;
        self.fill(0, 0);
        for row in 0..height {
            if row + 1 < height {
                self.fill((row + 1) % 3, row + 1);
            } else {
                self.canny.rows[(row + 1) % 3].squares.fill(0);
            }
            let [above, here, below] = [row + 2, row, row + 1].map(|k| &self.canny.rows[k % 3]);
            let kinds = &mut self.canny.kinds[(row + 1) * stride + 1..][..width];
            let thresholds = [self.canny.low, self.canny.high];
            greatest(kinds, [&above.squares, &below.squares], here, thresholds);
            collect(kinds, (row + 1) * stride + 1, &mut self.canny.pending);
        }
        connect(&mut self.canny.kinds, &mut self.canny.pending, stride);
        for row in 0..height {
            let kinds = &self.canny.kinds[(row + 1) * stride + 1..][..width];
            for (edge, kind) in self.edges.row_mut(row).iter_mut().zip(kinds) {
                *edge = if *kind == EDGE { u8::MAX } else { 0 };
            }
        }
    }
}

impl Edges<'_, '_> {
    /// Computes the slopes of a row of the picture.
    #[inline(always)]
    fn fill(&mut self, slot: usize, row: usize) {
        let Row { squares, dx, dy } = &mut self.canny.rows[slot];
        self.slopes.horizontal(row, dx);
        self.slopes.vertical(row, dy);
        for ((square, dx), dy) in squares[1..].iter_mut().zip(&*dx).zip(&*dy) {
            let [dx, dy] = [dx, dy].map(|slope| i32::from(*slope));
            *square = dx * dx + dy * dy;
        }
    }
}

/// Tells which pixels of a row are steeper than their neighbours across the edge. Every pixel takes
/// the same steps, so that the loop runs in lanes.
#[inline(always)]
fn greatest(kinds: &mut [u8], beside: [&[i32]; 2], here: &Row, [low, high]: [i32; 2]) {
    /// The tangent of 22.5°, times 2¹⁵.
    const TANGENT: i32 = 13573;
    let width = kinds.len();
    let [above, below] = beside.map(|row| [0, 1, 2].map(|k| &row[k..][..width]));
    let middle = [0, 1, 2].map(|k| &here.squares[k..][..width]);
    let (dx, dy) = (&here.dx[..width], &here.dy[..width]);
    for column in 0..width {
        let (slope_x, slope_y) = (i32::from(dx[column]), i32::from(dy[column]));
        let (x, y) = (slope_x.abs(), slope_y.abs() << 15);
        let flat = x * TANGENT;
        let is_horizontal = y < flat;
        let is_vertical = y > flat + (x << 16);
        let falls = (slope_x ^ slope_y) < 0;
        let square = middle[1][column];
        // The first of two equal neighbours along a row or a column is the edge.
        let diagonal = if falls {
            above[2][column].max(below[0][column])
        } else {
            above[0][column].max(below[2][column])
        };
        let along_column = above[1][column].max(below[1][column] - 1);
        let along_row = middle[0][column].max(middle[2][column] - 1);
        let other = if is_vertical { along_column } else { diagonal };
        let other = if is_horizontal { along_row } else { other };
        let kind = i32::from(square > low) + i32::from(square > high);
        kinds[column] = if square > other { kind as u8 } else { NONE };
    }
}

/// Notes the indices of edge pixels in a row that begins at an index.
#[inline(always)]
fn collect(kinds: &[u8], start: usize, pending: &mut Vec<usize>) {
    for (block, part) in kinds.chunks(16).enumerate() {
        if part.iter().fold(0, |any, kind| any | kind) < EDGE {
            continue;
        }
        for (offset, kind) in part.iter().enumerate() {
            if *kind == EDGE {
                pending.push(start + 16 * block + offset);
            }
        }
    }
}

/// Makes edges of the weak pixels that are connected to edges.
fn connect(kinds: &mut [u8], pending: &mut Vec<usize>, stride: usize) {
    let offsets = [
        0,
        1,
        2,
        stride,
        stride + 2,
        2 * stride,
        2 * stride + 1,
        2 * stride + 2,
    ];
    while let Some(index) = pending.pop() {
        for offset in offsets {
            let neighbour = index + offset - stride - 1;
            if kinds[neighbour] == WEAK {
                kinds[neighbour] = EDGE;
                pending.push(neighbour);
            }
        }
    }
}
