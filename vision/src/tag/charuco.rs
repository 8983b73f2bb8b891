//! ChArUco boards: chessboards with tags in their white squares.

use ga_image::interpolation::bilinear;
use ga_image::plane::{Plane, PlaneError, PlaneView};
use ga_image::sample::Sample;
use ga_runtime::cga3::Point;
use ga_runtime::vga2::Vector;

use super::consistency::{Placed, Places, consistent};
use super::detect::in_levels;
use super::dictionary::Dictionary;
use super::error::{TagError, check_length, check_size};
use super::marker::TagOptions;
use crate::calibration::{BoardView, SeenPoint};
use crate::chessboard::refinement::Gradient;

/// The least side of the window around a corner, in pixels.
const LEAST_WINDOW: f64 = 2.0;
/// The greatest, which is that of chessboards.
const GREATEST_WINDOW: f64 = 20.0;
/// The least difference of bright and dark squares at a corner, in levels.
const LEAST_CONTRAST: f64 = 6.0;

/// Which squares of a ChArUco board are dark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CharucoPattern {
    /// The top left one, as OpenCV 4.6 and later draw boards.
    #[default]
    Current,
    /// The top left one where there is an odd number of rows, and its neighbours where the number
    /// is even, as OpenCV before 4.6 and `CharucoBoard::setLegacyPattern(true)` have it.
    Legacy,
}

/// A chessboard with tags in its white squares, numbered row by row from 0, as OpenCV's
/// `CharucoBoard`. Its points are the inner corners of the squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CharucoBoard {
    squares: [usize; 2],
    square: f64,
    marker: f64,
    dictionary: Dictionary,
    pattern: CharucoPattern,
}

impl CharucoBoard {
    /// A board of so many columns and rows of squares, with the sides of a square and of a tag in
    /// metres.
    ///
    /// # Errors
    ///
    /// [`TagError`] for sizes and lengths that no board has, and a dictionary with too few tags.
    pub fn new(
        squares: [usize; 2],
        [square, marker]: [f64; 2],
        dictionary: Dictionary,
        pattern: CharucoPattern,
    ) -> Result<Self, TagError> {
        check_size(squares, "squares", 3)?;
        check_length("a square", square)?;
        check_length("a tag", marker)?;
        if marker >= square {
            return Err(TagError::Marker { marker, square });
        }
        let board = Self {
            squares,
            square,
            marker,
            dictionary,
            pattern,
        };
        let needed = board.white_squares().count();
        match needed <= dictionary.count() {
            true => Ok(board),
            false => Err(TagError::TooFewTags { dictionary, needed }),
        }
    }

    /// The inner corners in metres, row by row from the top left: x to the right, y down, in the
    /// plane z = 0, from the outer corner of the top left square.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_vision::tag::{CharucoBoard, CharucoPattern, Dictionary};
    ///
    /// let (sides, dictionary) = ([0.04, 0.03], Dictionary::Aruco5x5_100);
    /// let board = CharucoBoard::new([8, 6], sides, dictionary, CharucoPattern::Current)?;
    /// let points = board.points();
    /// assert_eq!((points.len(), points[8]), (35, Point::new(0.08, 0.08, 0.0)));
    /// # Ok::<(), ga_vision::tag::TagError>(())
    /// ```
    #[must_use]
    pub fn points(&self) -> Vec<Point<f64>> {
        let places = (0..self.corner_count()).map(|index| self.place(index));
        places.map(|[x, y]| Point::new(x, y, 0.0)).collect()
    }

    /// The inner corners in a grey picture whose squares are next to a tag that is seen, as indices
    /// in [`points`](Self::points). None, where no tags are found that agree on where the board is.
    ///
    /// # Errors
    ///
    /// [`PlaneError`] where the picture cannot be filtered.
    pub fn find<'a, T: Sample>(
        &self,
        picture: impl Into<PlaneView<'a, T>>,
    ) -> Result<BoardView, PlaneError> {
        let levels = picture.into().map(Sample::to_level);
        let options = TagOptions {
            dictionary: self.dictionary,
            border: 1,
        };
        let squares: Vec<[usize; 2]> = self.white_squares().collect();
        let places = |id: usize| squares.get(id).map(|square| self.tag_places(*square));
        let tags = consistent(in_levels(&levels, options), places);
        if tags.is_empty() {
            return Ok(BoardView::default());
        }
        let gradient = Gradient::new(&levels)?;
        let corners = (0..self.corner_count()).filter_map(|point| {
            let pixel = self.corner(point, &tags, &levels, &gradient)?;
            Some(SeenPoint { point, pixel })
        });
        Ok(BoardView::of_different(corners.collect()))
    }

    /// The pixel of a corner, from the tags in the squares around it.
    fn corner(
        &self,
        index: usize,
        tags: &[Placed],
        levels: &Plane<f32>,
        gradient: &Gradient,
    ) -> Option<[f64; 2]> {
        let [x, y] = self.place(index);
        let is_beside = |placed: &&Placed| {
            let near = |place: &[f64; 2]| {
                (place[0] - x).abs() < self.square && (place[1] - y).abs() < self.square
            };
            placed.places.iter().all(near)
        };
        let around: Vec<&Placed> = tags.iter().filter(is_beside).collect();
        let at = |dx: f64, dy: f64| {
            let place = [x + dx * self.square, y + dy * self.square];
            let seen = around.iter().map(|tag| tag.homography.apply(place));
            let seen = seen.collect::<Option<Vec<_>>>()?;
            let sum = seen
                .iter()
                .fold(Vector::default(), |sum, pixel| sum + Vector::from(*pixel));
            (!seen.is_empty()).then(|| sum * (1.0 / seen.len() as f64))
        };
        let start = at(0.0, 0.0)?;
        // The tags begin beyond the gap between them and the edges of their squares.
        let gap = 0.5 * (1.0 - self.marker / self.square);
        let along = (at(0.5, 0.0)? - at(-0.5, 0.0)?) * gap;
        let down = (at(0.0, 0.5)? - at(0.0, -0.5)?) * gap;
        let window = |side: Vector<f64>| {
            let length = side.length();
            side * (length.clamp(LEAST_WINDOW, GREATEST_WINDOW) / length)
        };
        let found = gradient.corner(start, [along, down].map(window))?;
        // Between the corner and the tag, in bright squares, and as far from it in dark ones.
        let level = |along_sign: f64, down_sign: f64| {
            let offset = along * (0.6 * along_sign) + down * (0.6 * down_sign);
            bilinear(levels, (found + offset).coordinates())
        };
        let rising = level(1.0, -1.0)? + level(-1.0, 1.0)?;
        let falling = level(1.0, 1.0)? + level(-1.0, -1.0)?;
        let columns = self.columns();
        // The square to the lower right.
        let is_dark = self.is_dark([index % columns + 1, index / columns + 1]);
        let contrast = if is_dark {
            rising - falling
        } else {
            falling - rising
        };
        (0.5 * contrast >= LEAST_CONTRAST).then(|| found.coordinates())
    }

    /// The side of a square in metres.
    pub(crate) fn square(&self) -> f64 {
        self.square
    }

    /// The number of inner corners in a row.
    pub(crate) fn columns(&self) -> usize {
        self.squares[0] - 1
    }

    fn corner_count(&self) -> usize {
        let [columns, rows] = self.squares;
        (columns - 1) * (rows - 1)
    }

    fn place(&self, index: usize) -> [f64; 2] {
        let columns = self.columns();
        [index % columns + 1, index / columns + 1].map(|k| k as f64 * self.square)
    }

    /// Columns and rows of the squares with tags, by the numbers of these.
    fn white_squares(&self) -> impl Iterator<Item = [usize; 2]> {
        let [columns, rows] = self.squares;
        let squares = (0..rows).flat_map(move |row| (0..columns).map(move |column| [column, row]));
        let board = *self;
        squares.filter(move |square| !board.is_dark(*square))
    }

    fn is_dark(&self, [column, row]: [usize; 2]) -> bool {
        let is_even = (column + row).is_multiple_of(2);
        match self.pattern {
            CharucoPattern::Legacy if self.squares[1].is_multiple_of(2) => !is_even,
            _ => is_even,
        }
    }

    fn tag_places(&self, square: [usize; 2]) -> Places {
        let margin = 0.5 * (self.square - self.marker);
        let [left, top] = square.map(|k| k as f64 * self.square + margin);
        let [right, bottom] = [left, top].map(|edge| edge + self.marker);
        [[left, top], [right, top], [right, bottom], [left, bottom]]
    }
}
