//! Two cameras side by side that look the same way: disparity is depth.

use ga_runtime::cga3::{Motor, Point, Translator};

use super::StereoRig;
use super::error::RigError;
use crate::{Camera, Intrinsics, Lens};

/// A rectified rig: two pinholes of one focal length with parallel axes, the right one displaced
/// along x by the baseline B. A point is seen in both views in the same row v, at the columns
/// `u_left` and `u_right = u_left − d`. Its depth is
///
/// ```text
/// Z = f B/(d + c_right − c_left)
/// ```
///
/// with the columns c of the principal points. Their difference is zero where the axes are made to
/// meet the pictures in the same column.
///
/// ```
/// use ga_camera::Intrinsics;
/// use ga_camera::rig::RectifiedRig;
/// // The motorcycle pair of Middlebury 2014.
/// let left = Intrinsics::new([994.978, 994.978], [311.193, 254.877])?;
/// let right = Intrinsics::new([994.978, 994.978], [342.279, 254.877])?;
/// let rig = RectifiedRig::new(left, right, 0.193001)?;
/// let depth = rig.depth(50.5140380859375).unwrap();
/// assert!((depth - 2.3533291586918226).abs() < 1e-12);
/// assert!((rig.disparity(depth).unwrap() - 50.5140380859375).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectifiedRig {
    left: Intrinsics,
    right: Intrinsics,
    baseline: f64,
}

impl RectifiedRig {
    /// A rig from its cameras and the distance between them in metres.
    ///
    /// # Errors
    /// [`RigError`] for a lens with distortion, focal lengths or rows of principal points
    /// that differ, and a baseline that is not positive and finite.
    pub fn new(left: Intrinsics, right: Intrinsics, baseline: f64) -> Result<Self, RigError> {
        for (view, camera) in [("left", left), ("right", right)] {
            if camera.lens() != Lens::Pinhole {
                return Err(RigError::Lens { view });
            }
        }
        if left.focal() != right.focal() {
            return Err(RigError::Focal {
                left: left.focal(),
                right: right.focal(),
            });
        }
        let [left_row, right_row] = [left, right].map(|camera| camera.principal()[1]);
        if left_row != right_row {
            return Err(RigError::Rows {
                left: left_row,
                right: right_row,
            });
        }
        if !(baseline > 0.0 && baseline.is_finite()) {
            return Err(RigError::Baseline(baseline));
        }
        Ok(Self {
            left,
            right,
            baseline,
        })
    }

    /// The left camera's focal lengths and principal point.
    #[must_use]
    pub fn left(&self) -> Intrinsics {
        self.left
    }

    /// The right camera's focal lengths and principal point.
    #[must_use]
    pub fn right(&self) -> Intrinsics {
        self.right
    }

    /// The distance between the cameras in metres.
    #[must_use]
    pub fn baseline(&self) -> f64 {
        self.baseline
    }

    /// The difference of the columns of the principal points, right minus left, in pixels: the
    /// negative disparity of what is infinitely far away.
    #[must_use]
    pub fn disparity_offset(&self) -> f64 {
        self.right.principal()[0] - self.left.principal()[0]
    }

    /// The depth in metres at a disparity in pixels; `None` where it is not positive and finite.
    #[must_use]
    pub fn depth(&self, disparity: f64) -> Option<f64> {
        self.quotient(disparity + self.disparity_offset())
    }

    /// The disparity in pixels at a depth in metres; `None` where the depth is not positive and
    /// finite.
    #[must_use]
    pub fn disparity(&self, depth: f64) -> Option<f64> {
        Some(self.quotient(depth)? - self.disparity_offset())
    }

    /// `f B/x`.
    fn quotient(&self, x: f64) -> Option<f64> {
        let result = self.left.focal()[0] * self.baseline / x;
        (x > 0.0 && x.is_finite() && result.is_finite()).then_some(result)
    }

    /// The point, in the left camera's frame, that is seen at a pixel of the left view with a
    /// disparity in pixels; `None` where its depth is not positive and finite.
    #[must_use]
    pub fn point(&self, [u, v]: [f64; 2], disparity: f64) -> Option<Point<f64>> {
        let depth = self.depth(disparity)?;
        let ([fx, fy], [cx, cy]) = (self.left.focal(), self.left.principal());
        let (x, y) = ((u - cx) / fx * depth, (v - cy) / fy * depth);
        (x.is_finite() && y.is_finite()).then(|| Point::new(x, y, depth))
    }

    /// The same rig as two cameras in the left one's frame.
    #[must_use]
    pub fn stereo_rig(&self) -> StereoRig {
        let camera = |intrinsics, world_to_camera| Camera {
            intrinsics,
            world_to_camera,
        };
        let displacement = [-self.baseline, 0.0, 0.0];
        StereoRig {
            left: camera(self.left, Motor::default()),
            right: camera(
                self.right,
                Translator::from_displacement(displacement).into(),
            ),
        }
    }
}
