//! A board in a picture.

use crate::calibration::BoardView;

/// Where the points of a board are in a picture: all of them, or those that are seen.
///
/// The points of boards with tags have their own numbers. Those of a part of a chessboard count
/// from the first corner that is seen: they say nothing about the same board in another picture.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundBoard {
    columns: usize,
    view: BoardView,
    /// The other orders in which the board looks the same, as indices into its points.
    orders: Vec<Vec<usize>>,
}

impl FoundBoard {
    pub(crate) fn new(columns: usize, view: BoardView, orders: Vec<Vec<usize>>) -> Self {
        Self {
            columns,
            view,
            orders,
        }
    }

    /// The number of points in a row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The points that are seen.
    ///
    /// Of chessboards and circles, rows follow columns clockwise in the picture. The square between
    /// the first corner of a chessboard and its diagonal neighbour is dark, as OpenCV orders them.
    /// Where several points of the board may be the first, it is the one nearest to the top left.
    #[must_use]
    pub fn view(&self) -> &BoardView {
        &self.view
    }

    /// The same board in the one of its possible orders that is most like that of another view from
    /// about the same direction.
    ///
    /// A chessboard with an odd number of columns + rows begins at one corner only. Others, and
    /// grids of circles, look the same after a rotation by 180°, or by 90°, and two views of them
    /// may begin at different points. The points of a board with tags have one order.
    #[must_use]
    pub fn ordered_like(&self, other: &Self) -> Self {
        let difference = |view: &BoardView| -> f64 {
            let [own, other] = view.shared(&other.view);
            let pairs = || own.points().iter().zip(other.points());
            let count = own.points().len() as f64;
            let between = |k: usize| pairs().map(move |(a, b)| a.pixel[k] - b.pixel[k]);
            let mean = [0, 1].map(|k| between(k).sum::<f64>() / count);
            let squares = |k: usize| between(k).map(|d| (d - mean[k]).powi(2)).sum::<f64>();
            squares(0) + squares(1)
        };
        let others = self.orders.iter().map(|order| {
            let pixels = order.iter().map(|&index| self.view.points()[index].pixel);
            BoardView::complete(&pixels.collect::<Vec<_>>())
        });
        let all = std::iter::once(self.view.clone()).chain(others);
        let best = all.min_by(|a, b| difference(a).total_cmp(&difference(b)));
        Self {
            view: best.unwrap_or_default(),
            ..self.clone()
        }
    }
}
