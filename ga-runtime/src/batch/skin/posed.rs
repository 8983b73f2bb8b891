//! Where the images of points are written to.

use crate::cga3::Point;
use crate::vga3::Vector;

/// Where the images of the points of a chunk are written to. A list of directions may be empty;
/// then they are not computed.
#[derive(Debug)]
pub struct Posed<'a, S> {
    /// The images of the points.
    pub points: &'a mut [Point<S>],
    /// The normals there.
    pub normals: &'a mut [Vector<S>],
    /// The tangents there.
    pub tangents: &'a mut [Vector<S>],
}

impl<'a, S> Posed<'a, S> {
    /// The points alone.
    #[must_use]
    pub fn of_points(points: &'a mut [Point<S>]) -> Self {
        Self {
            points,
            normals: &mut [],
            tangents: &mut [],
        }
    }
}
