//! Balls and patches cut into pieces that can be painted one after the other.
//!
//! Every surface is cut where another passes through it: a patch by the planes of other patches, a
//! ball by the planes of patches and by the planes of the circles in which it meets other balls. Of
//! two pieces, a plane then tells which is nearer to the eye, and sorting by these relations gives
//! an order in which each piece is painted after the pieces that it hides.

mod cut;
mod order;
mod outline;
mod piece;

pub(crate) use outline::outline;
pub(crate) use piece::{Piece, Surface};

use crate::camera::Camera;
use crate::picture::Picture;

/// Scenes with more surfaces than this are not cut, since the number of pieces grows fast.
const MOST_CUT: usize = 16;

impl Picture {
    /// The balls and patches in the order in which they are to be painted.
    pub(crate) fn pieces(&self, camera: &Camera) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let cuts = self.balls.len() + self.patches.len() <= MOST_CUT;
        for index in 0..self.patches.len() {
            self.cut_patch(index, cuts, camera, &mut pieces);
        }
        for index in 0..self.balls.len() {
            self.cut_ball(index, cuts, camera, &mut pieces);
        }
        self.sorted(pieces, camera)
    }
}
