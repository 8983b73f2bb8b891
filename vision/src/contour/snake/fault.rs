//! Snakes that have settled where there is no edge.

use super::Settled;
use crate::contour::picture_border::{REACH_OF_SNAKES, is_at_border};
use crate::contour::polygon::signed_area;

/// A snake that encloses fewer pixels has found nothing.
const LEAST_AREA: f64 = 4.0;
/// The part of the points that may be at the border of the picture.
const AT_BORDER: f64 = 0.05;

/// Why a snake is not the outline of a thing.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SnakeFault {
    /// It has shrunk to a point or a line: nothing holds it.
    #[error(
        "the snake has collapsed: it encloses {area:.3} px². No edge held it; begin nearer to one, \
         or draw it there by its flow"
    )]
    Collapsed {
        /// The area that it encloses, in pixels.
        area: f64,
    },
    /// It lies along the border of the picture.
    #[error(
        "the snake rests on the border of the picture with {points} of its {count} points: there \
         it is not the outline of what the picture shows"
    )]
    AtBorder {
        /// How many points are within 1.5 px of the centres of the outermost pixels.
        points: usize,
        /// The number of all points.
        count: usize,
    },
}

impl SnakeFault {
    /// One word for programs.
    #[must_use]
    pub fn kind(self) -> &'static str {
        match self {
            Self::Collapsed { .. } => "collapsed",
            Self::AtBorder { .. } => "at_border",
        }
    }
}

impl Settled {
    /// Why the snake is not the outline of a thing in a picture with these columns and rows;
    /// nothing where it may be one.
    ///
    /// ```
    /// use ga_image::plane::Plane;
    /// use ga_vision::contour::snake::{PictureSnake, SnakeFault, Start};
    ///
    /// // Nothing holds a snake in a picture without edges.
    /// let start = Start::Circle { centre: [40.0, 30.0], radius: 15.0 };
    /// let snake = PictureSnake { start, ..PictureSnake::default() };
    /// let settled = snake.settle(&Plane::filled(80, 60, 90u8), |_| {})?;
    /// assert!(matches!(settled.faults([80, 60])[..], [SnakeFault::Collapsed { .. }]));
    /// # Ok::<(), ga_vision::contour::ContourError>(())
    /// ```
    #[must_use]
    pub fn faults(&self, size: [usize; 2]) -> Vec<SnakeFault> {
        let area = signed_area(&self.points).abs();
        let collapsed = (area < LEAST_AREA).then_some(SnakeFault::Collapsed { area });
        let at_border = |place: &&[f64; 2]| is_at_border(**place, size, REACH_OF_SNAKES);
        let (points, count) = (
            self.points.iter().filter(at_border).count(),
            self.points.len(),
        );
        let rests = points as f64 > AT_BORDER * count as f64;
        let at_border = rests.then_some(SnakeFault::AtBorder { points, count });
        collapsed.into_iter().chain(at_border).collect()
    }
}
