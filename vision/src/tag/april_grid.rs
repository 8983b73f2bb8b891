//! Grids of AprilTags, as kalibr has them.

use ga_image::plane::PlaneView;
use ga_image::sample::Sample;
use ga_runtime::cga3::Point;

use super::consistency::{Places, consistent};
use super::detect::in_levels;
use super::dictionary::Dictionary;
use super::error::{TagError, check_length, check_size};
use super::marker::TagOptions;
use crate::calibration::{BoardView, SeenPoint};

/// A grid of AprilTags, as kalibr's target `aprilgrid` (P. Furgale, J. Rehder and R. Siegwart,
/// "Unified temporal and spatial calibration for multi-sensor systems", 2013): tags of the family
/// 36h11, numbered row by row from 0 at the bottom left. Its points are the corners of the tags.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AprilGrid {
    tags: [usize; 2],
    side: f64,
    spacing: f64,
    border: u8,
}

impl AprilGrid {
    /// The modules in the black border of the tags that kalibr prints.
    pub const BORDER_OF_KALIBR: u8 = 2;

    const DICTIONARY: Dictionary = Dictionary::April36h11;

    /// A grid of so many columns and rows of tags (`tagCols` and `tagRows`), with the side of the
    /// black border of a tag in metres (`tagSize`), the gap between tags as a part of that
    /// (`tagSpacing`), and how many modules wide the border is: [`Self::BORDER_OF_KALIBR`], or 1
    /// as in the pictures of AprilTag.
    ///
    /// # Errors
    ///
    /// [`TagError`] for sizes and lengths that no grid has, and more tags than the family has.
    pub fn new(tags: [usize; 2], [side, spacing]: [f64; 2], border: u8) -> Result<Self, TagError> {
        check_size(tags, "tags", 1)?;
        check_length("a tag", side)?;
        check_length("the gap between tags", side * spacing)?;
        if !(1..=2).contains(&border) {
            return Err(TagError::Border { border });
        }
        let (dictionary, needed) = (Self::DICTIONARY, tags[0] * tags[1]);
        match needed <= dictionary.count() {
            true => Ok(Self {
                tags,
                side,
                spacing,
                border,
            }),
            false => Err(TagError::TooFewTags { dictionary, needed }),
        }
    }

    /// The corners of all tags in metres, row by row from the bottom left, two in a row of each tag
    /// and two rows of each row of tags: x to the right and y up, in the plane z = 0, from the
    /// bottom left corner of the first tag.
    ///
    /// ```
    /// use ga_runtime::cga3::Point;
    /// use ga_vision::tag::AprilGrid;
    ///
    /// // Tags of 8 cm with gaps of 2 cm: 12 corners in a row.
    /// let grid = AprilGrid::new([6, 5], [0.08, 0.25], AprilGrid::BORDER_OF_KALIBR)?;
    /// let points = grid.points();
    /// assert_eq!((points.len(), points[3]), (120, Point::new(0.18, 0.0, 0.0)));
    /// assert_eq!(points[12 + 2], Point::new(0.1, 0.08, 0.0));
    /// # Ok::<(), ga_vision::tag::TagError>(())
    /// ```
    #[must_use]
    pub fn points(&self) -> Vec<Point<f64>> {
        let [columns, rows] = self.tags.map(|count| 2 * count);
        let indices = (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row]));
        let places = indices.map(|index| self.place(index));
        places.map(|[x, y]| Point::new(x, y, 0.0)).collect()
    }

    /// The corners of the tags that are seen in a grey picture, as indices in
    /// [`points`](Self::points). None, where no tags are found that agree on where the grid is.
    #[must_use]
    pub fn find<'a, T: Sample>(&self, picture: impl Into<PlaneView<'a, T>>) -> BoardView {
        let levels = picture.into().map(Sample::to_level);
        let options = TagOptions {
            dictionary: Self::DICTIONARY,
            border: self.border,
        };
        let places = |id: usize| -> Option<Places> {
            let corners = self.corners(id)?;
            Some(corners.map(|corner| self.place(corner)))
        };
        let tags = consistent(in_levels(&levels, options), places);
        let columns = self.columns();
        let mut found = Vec::new();
        for placed in tags {
            if let Some(corners) = self.corners(placed.tag.id) {
                let points = corners.map(|[column, row]| row * columns + column);
                let seen = points.into_iter().zip(placed.tag.corners);
                found.extend(seen.map(|(point, pixel)| SeenPoint { point, pixel }));
            }
        }
        BoardView::of_different(found)
    }

    /// The side of a tag in metres.
    pub(crate) fn side(&self) -> f64 {
        self.side
    }

    /// The number of corners of tags in a row.
    pub(crate) fn columns(&self) -> usize {
        2 * self.tags[0]
    }

    /// Column and row of the corners of a tag, in the order of [`Tag::corners`](super::Tag): kalibr
    /// has the tags as their authors draw them, which is rotated by 180° from
    /// [`Dictionary::April36h11`].
    fn corners(&self, id: usize) -> Option<[[usize; 2]; 4]> {
        let [columns, rows] = self.tags;
        let [left, bottom] = [id % columns, id / columns].map(|k| 2 * k);
        let corners = [[1, 0], [0, 0], [0, 1], [1, 1]];
        let corners = corners.map(|[column, row]| [left + column, bottom + row]);
        (id < columns * rows).then_some(corners)
    }

    fn place(&self, index: [usize; 2]) -> [f64; 2] {
        index.map(|k| ((k / 2) as f64 * (1.0 + self.spacing) + (k % 2) as f64) * self.side)
    }
}
