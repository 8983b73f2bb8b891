//! Pixels and points in columns: one slice for each coordinate.

use ga_runtime::cga3::Point;

use super::TriangulationError;

/// The pixels of one view, coordinate by coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelColumns<'a> {
    /// The columns in the picture.
    pub u: &'a [f64],
    /// The rows in the picture.
    pub v: &'a [f64],
}

/// Points that were triangulated from two views, coordinate by coordinate: element i of each list
/// belongs to the pair of pixels i.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointColumns {
    /// The first coordinate in the world, in metres.
    pub x: Vec<f64>,
    /// The second coordinate.
    pub y: Vec<f64>,
    /// The third coordinate.
    pub z: Vec<f64>,
    /// The distance of the two rays in metres.
    pub gap: Vec<f64>,
    /// The parallax: the angle between the rays in radians, in (0, π).
    pub angle: Vec<f64>,
    /// How far in front of the left camera the foot on its ray is, along the optical axis, in
    /// metres; negative behind the camera.
    pub depth_left: Vec<f64>,
    /// The same for the right camera.
    pub depth_right: Vec<f64>,
}

/// One point of [`PointColumns`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangulatedPoint {
    /// Where it is in the world.
    pub position: Point<f64>,
    /// The distance of the two rays in metres.
    pub gap: f64,
    /// The angle between the rays in radians, in (0, π).
    pub angle: f64,
    /// The depths of the feet in front of the left and of the right camera, along the optical axes,
    /// in metres.
    pub depths: [f64; 2],
}

impl TriangulatedPoint {
    /// Whether the point is in front of both cameras (its cheirality).
    #[must_use]
    pub fn is_in_front(&self) -> bool {
        self.depths.iter().all(|depth| *depth > 0.0)
    }
}

impl PixelColumns<'_> {
    /// The pixel of an index.
    pub(super) fn get(&self, index: usize) -> [f64; 2] {
        [self.u[index], self.v[index]]
    }
}

impl PointColumns {
    /// How many points there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether there are no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    /// One point, or `None` where the columns do not reach that far.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<TriangulatedPoint> {
        let at = |column: &[f64]| column.get(index).copied();
        Some(TriangulatedPoint {
            position: Point::new(at(&self.x)?, at(&self.y)?, at(&self.z)?),
            gap: at(&self.gap)?,
            angle: at(&self.angle)?,
            depths: [at(&self.depth_left)?, at(&self.depth_right)?],
        })
    }

    /// Checks that all points are in front of both cameras.
    ///
    /// # Errors
    /// [`TriangulationError::Point`] with [`TriangulationError::Behind`] for the first point that
    /// is not.
    pub fn check_in_front(&self) -> Result<(), TriangulationError> {
        let depths = self.depth_left.iter().zip(&self.depth_right);
        for (point, (left, right)) in depths.enumerate() {
            for (view, depth) in [*left, *right].into_iter().enumerate() {
                if depth.is_nan() || depth <= 0.0 {
                    let error = TriangulationError::Behind { view, depth };
                    return Err(error.of_point(point));
                }
            }
        }
        Ok(())
    }

    /// Makes room for a number of points. Nothing is allocated where there was room before.
    pub(super) fn resize(&mut self, count: usize) {
        for column in self.lists() {
            column.resize(count, 0.0);
        }
    }

    /// The columns in the order of the fields.
    fn lists(&mut self) -> [&mut Vec<f64>; 7] {
        [
            &mut self.x,
            &mut self.y,
            &mut self.z,
            &mut self.gap,
            &mut self.angle,
            &mut self.depth_left,
            &mut self.depth_right,
        ]
    }

    /// The columns in the order of the fields, as slices.
    pub(super) fn slices(&mut self) -> [&mut [f64]; 7] {
        self.lists().map(Vec::as_mut_slice)
    }
}

/// Covariances of points, coefficient by coefficient, in square metres: element i of each list
/// belongs to the point i. The matrix is symmetric; with the axes of the world,
/// `[[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CovarianceColumns {
    /// The variance of x.
    pub xx: Vec<f64>,
    /// The covariance of x and y.
    pub xy: Vec<f64>,
    /// The covariance of x and z.
    pub xz: Vec<f64>,
    /// The variance of y.
    pub yy: Vec<f64>,
    /// The covariance of y and z.
    pub yz: Vec<f64>,
    /// The variance of z.
    pub zz: Vec<f64>,
}

impl CovarianceColumns {
    /// How many covariances there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.xx.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.xx.is_empty()
    }

    /// The covariance of one point by rows, or `None` where the columns do not reach that far.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<[[f64; 3]; 3]> {
        let at = |column: &[f64]| column.get(index).copied();
        let [xx, xy, xz] = [at(&self.xx)?, at(&self.xy)?, at(&self.xz)?];
        let [yy, yz, zz] = [at(&self.yy)?, at(&self.yz)?, at(&self.zz)?];
        Some([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    }

    /// Makes room for a number of covariances.
    pub(super) fn resize(&mut self, count: usize) {
        for column in self.lists() {
            column.resize(count, 0.0);
        }
    }

    fn lists(&mut self) -> [&mut Vec<f64>; 6] {
        [
            &mut self.xx,
            &mut self.xy,
            &mut self.xz,
            &mut self.yy,
            &mut self.yz,
            &mut self.zz,
        ]
    }

    /// The columns in the order of the fields, as slices.
    pub(super) fn slices(&mut self) -> [&mut [f64]; 6] {
        self.lists().map(Vec::as_mut_slice)
    }
}
