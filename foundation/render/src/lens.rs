//! The projection onto the pixels of one picture.

use crate::Vector;
use crate::clip::Clipper;
use crate::view::{Projection, View};

/// A camera's projection onto the pixels of one picture, where pixel (0, 0) covers 0 to 1.
#[derive(Clone, Copy)]
pub(crate) struct Lens {
    /// Pixels per unit of `x / depth` and of `y / depth`.
    focal: [f64; 2],
    /// Columns per unit of `y / depth`.
    skew: f64,
    centre: [f64; 2],
}

/// How far beyond the picture a corner may fall, in widths or heights of the picture. Wide enough
/// that few triangles are cut, small enough that the rasteriser's integers do not overflow.
const GUARD: f64 = 3.5;

impl Lens {
    pub(crate) fn new(view: &View, width: u32, height: u32) -> Self {
        let size = [f64::from(width), f64::from(height)];
        // Offsets here count upwards, those of a camera downwards.
        let skew = -view.skew();
        match view.projection() {
            Projection::FieldOfView { tangent } => Self {
                focal: [size[1] / (2.0 * tangent); 2],
                skew,
                centre: size.map(|side| side / 2.0),
            },
            Projection::Pixels { focal, principal } => Self {
                focal,
                skew,
                // A camera counts from the middle of the first pixel.
                centre: principal.map(|c| c + 0.5),
            },
        }
    }

    /// The projection onto a picture with `factor` times as many columns and rows.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            focal: self.focal.map(|f| f * factor),
            skew: self.skew * factor,
            centre: self.centre.map(|c| c * factor),
        }
    }

    /// Pixels per unit of `x / depth`, the geometric mean of both directions.
    pub(crate) fn magnification(&self) -> f64 {
        (self.focal[0] * self.focal[1]).sqrt()
    }

    /// Column and row of the point at these right and up offsets and the given inverse depth.
    pub(crate) fn project(&self, [x, y]: [f64; 2], inverse_depth: f64) -> [f64; 2] {
        let (x, y) = (x * inverse_depth, y * inverse_depth);
        [
            self.centre[0] + x * self.focal[0] + y * self.skew,
            self.centre[1] - y * self.focal[1],
        ]
    }

    /// The view vector of depth 1 through a place in the picture.
    pub(crate) fn ray(&self, column: f64, row: f64) -> Vector {
        let y = (self.centre[1] - row) / self.focal[1];
        let x = (column - self.centre[0] - self.skew * y) / self.focal[0];
        Vector::new(x, y, 1.0)
    }

    /// The change of [`Lens::ray`] to the next column, and to the next row.
    pub(crate) fn ray_steps(&self) -> [Vector; 2] {
        let down = -1.0 / self.focal[1];
        [
            Vector::new(1.0 / self.focal[0], 0.0, 0.0),
            Vector::new(-self.skew * down / self.focal[0], down, 0.0),
        ]
    }

    /// What a picture of this size shows of the depths between `near` and `far`, with some room
    /// around it.
    pub(crate) fn clipper(&self, [near, far]: [f64; 2], width: usize, height: usize) -> Clipper {
        let (width, height) = (width as f64, height as f64);
        let column = |c: f64| (c - self.centre[0]) / self.focal[0];
        let row = |r: f64| (self.centre[1] - r) / self.focal[1];
        Clipper::new(
            [near, far],
            [column(-GUARD * width), row((1.0 + GUARD) * height)],
            [column((1.0 + GUARD) * width), row(-GUARD * height)],
            self.skew / self.focal[0],
        )
    }
}

impl View {
    /// Column, row and depth at which a picture of the given size shows `point`, with the centre of
    /// pixel (0, 0) at (½, ½); `None` when it is nearer than the near depth, behind the camera, or
    /// beyond the far depth. A picture of [`View::pinhole`] has one size, and the one given here is
    /// not used.
    pub fn project(&self, point: [f64; 3], width: u32, height: u32) -> Option<[f64; 3]> {
        let Vector {
            e1: x,
            e2: y,
            e3: depth,
        } = self.in_frame(point.into());
        (depth >= self.near() && depth <= self.far()).then(|| {
            let [column, row] = Lens::new(self, width, height).project([x, y], 1.0 / depth);
            [column, row, depth]
        })
    }
}
