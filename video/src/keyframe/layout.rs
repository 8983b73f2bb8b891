//! Non-uniform blocks of a frame: where objects are, and where the background is.

use ga_image::plane::Plane;

/// Red at or below which boxes of a signature count as black.
const BLACK: f32 = 6.0;

/// The least number of columns and of rows that remain when bars are cropped.
const LEAST: usize = 8;

/// A rectangle in fractions of the frame, or in boxes of a signature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rectangle<T> {
    /// The first column.
    pub left: T,
    /// The first row.
    pub top: T,
    /// The column after the last.
    pub right: T,
    /// The row after the last.
    pub bottom: T,
}

impl Rectangle<usize> {
    /// All of a signature.
    pub(super) fn of(signature: &Plane<f32>) -> Self {
        Self {
            left: 0,
            top: 0,
            right: signature.width(),
            bottom: signature.height(),
        }
    }

    /// The least rectangle around two.
    pub(super) fn around(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }
}

/// A block of a layout.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Its place, in fractions of the frame without bars.
    pub place: Rectangle<f32>,
    /// Whether it belongs to the background; otherwise objects are there.
    pub background: bool,
}

/// How a frame is divided into blocks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layout {
    /// Five blocks: objects in the middle, and background in the four corners.
    #[default]
    Five,
    /// The layout of Cui, §3.1.1: the region of objects (1) below the middle, and the background
    /// regions at its left (2), above it (3) and at its right (4). Region 3 represents the
    /// background, since labels of stations and captions lie in the others. The paper does not
    /// print the borders; here they are a quarter of the width and a third of the height.
    Paper,
}

const fn block(edges: [f32; 4], background: bool) -> Block {
    let [left, top, right, bottom] = edges;
    let place = Rectangle {
        left,
        top,
        right,
        bottom,
    };
    Block { place, background }
}

const THIRD: f32 = 1.0 / 3.0;

/// All edges of blocks of both layouts.
pub(super) const COLUMN_EDGES: [f32; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
pub(super) const ROW_EDGES: [f32; 6] = [0.0, 0.25, THIRD, 0.5, 0.75, 1.0];

const FIVE: [Block; 5] = [
    block([0.25, 0.25, 0.75, 0.75], false),
    block([0.0, 0.0, 0.5, 0.5], true),
    block([0.5, 0.0, 1.0, 0.5], true),
    block([0.0, 0.5, 0.5, 1.0], true),
    block([0.5, 0.5, 1.0, 1.0], true),
];

const PAPER: [Block; 4] = [
    block([0.25, THIRD, 0.75, 1.0], false),
    block([0.0, 0.0, 0.25, 1.0], true),
    block([0.25, 0.0, 0.75, THIRD], true),
    block([0.75, 0.0, 1.0, 1.0], true),
];

/// Cells of a part of a signature, columns and rows, for what has to hold in most of the picture.
const CELLS: [usize; 2] = [8, 6];
pub(super) const CELL_COUNT: usize = CELLS[0] * CELLS[1];

impl Layout {
    /// The blocks: the region of objects first, then the background.
    #[must_use]
    pub fn blocks(self) -> &'static [Block] {
        match self {
            Self::Five => &FIVE,
            Self::Paper => &PAPER,
        }
    }

    /// The index of the block at a place, in fractions of the frame without bars. Where the corners
    /// of five blocks overlap the middle, a place belongs to the middle.
    #[must_use]
    pub fn block_at(self, x: f32, y: f32) -> usize {
        let inside = |block: &Block| {
            let place = block.place;
            (place.left..place.right).contains(&x) && (place.top..place.bottom).contains(&y)
        };
        self.blocks().iter().position(inside).unwrap_or(0)
    }
}

/// A cell of a part of a signature: the boxes from its left to its right and from its top to its
/// bottom.
pub(super) fn cell(part: Rectangle<usize>, index: usize) -> Rectangle<usize> {
    let (column, row) = (index % CELLS[0], index / CELLS[0]);
    let along = |start: usize, end: usize, index: usize, count: usize| {
        start + index * (end - start) / count
    };
    Rectangle {
        left: along(part.left, part.right, column, CELLS[0]),
        top: along(part.top, part.bottom, row, CELLS[1]),
        right: along(part.left, part.right, column + 1, CELLS[0]),
        bottom: along(part.top, part.bottom, row + 1, CELLS[1]),
    }
}

/// The part of two signatures that is left without black bars: rows and columns at the border that
/// are black in both are cropped. At least 8 rows and columns remain; `None` where everything is
/// black in both.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::keyframe::layout::without_bars;
///
/// let bars = Plane::from_fn(64, 36, |_, row| if (4..32).contains(&row) { 90.0 } else { 0.0 });
/// let place = without_bars(&bars, &bars).unwrap();
/// assert_eq!([place.left, place.top, place.right, place.bottom], [0, 4, 64, 32]);
/// ```
#[must_use]
pub fn without_bars(a: &Plane<f32>, b: &Plane<f32>) -> Option<Rectangle<usize>> {
    let (width, height) = (a.width().min(b.width()), a.height().min(b.height()));
    let bright =
        |column: usize, row: usize| a.row(row)[column] > BLACK || b.row(row)[column] > BLACK;
    let row_is_bright = |row: &usize| (0..width).any(|column| bright(column, *row));
    let top = (0..height).find(row_is_bright)?;
    let bottom = (0..height).rev().find(row_is_bright)? + 1;
    let column_is_bright = |column: &usize| (top..bottom).any(|row| bright(*column, row));
    let left = (0..width).find(column_is_bright)?;
    let right = (0..width).rev().find(column_is_bright)? + 1;
    let [left, right] = widened([left, right], width);
    let [top, bottom] = widened([top, bottom], height);
    Some(Rectangle {
        left,
        top,
        right,
        bottom,
    })
}

/// The range with at least [`LEAST`] numbers, where there are enough.
fn widened([mut start, mut end]: [usize; 2], length: usize) -> [usize; 2] {
    while end - start < LEAST.min(length) {
        start = start.saturating_sub(1);
        end = (end + 1).min(length);
    }
    [start, end]
}
