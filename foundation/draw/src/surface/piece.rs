//! Pieces of balls and patches.

use ga_runtime::vga3::Vector;

use crate::camera::Pixel;
use crate::plane::Plane;

/// A ball or a patch by its index in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Surface {
    Ball(usize),
    Patch(usize),
}

/// A part of a ball or patch that no other surface passes through.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) surface: Surface,
    /// The corners in space of a piece of a patch; empty for a ball.
    pub(super) polygon: Vec<Vector<f64>>,
    /// For a piece of a ball, the planes of other surfaces, and whether it is on the positive side.
    pub(crate) sides: Vec<(Surface, Plane, bool)>,
    /// The part of the picture that it covers: what is inside all of these regions. Each is an
    /// outline, perhaps with a hole.
    pub(crate) regions: Vec<Vec<Vec<Pixel>>>,
    pub(super) depth: f64,
}

impl Piece {
    /// Whether a piece of a ball is on the positive side of a surface's plane; `None` where that
    /// plane does not cut the ball.
    pub(super) fn side_of(&self, surface: Surface) -> Option<bool> {
        let mut sides = self.sides.iter();
        sides.find(|side| side.0 == surface).map(|side| side.2)
    }

    /// The box around what the piece covers.
    pub(super) fn bounds(&self) -> [Pixel; 2] {
        let mut bounds = [[f64::NEG_INFINITY; 2], [f64::INFINITY; 2]];
        for region in &self.regions {
            let mut own = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
            for point in region.iter().flatten() {
                for k in 0..2 {
                    own[0][k] = own[0][k].min(point[k]);
                    own[1][k] = own[1][k].max(point[k]);
                }
            }
            for k in 0..2 {
                bounds[0][k] = bounds[0][k].max(own[0][k]);
                bounds[1][k] = bounds[1][k].min(own[1][k]);
            }
        }
        bounds
    }
}

/// The mean of points.
pub(super) fn mean(points: &[Vector<f64>]) -> Vector<f64> {
    let total = points
        .iter()
        .fold(Vector::default(), |total, point| total + *point);
    total * (points.len() as f64).recip()
}
