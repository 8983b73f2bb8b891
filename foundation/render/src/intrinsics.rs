//! The projection of a camera in pixels.

use crate::{LARGEST_COORDINATE, RenderError};

/// The projection of a camera from its frame to the pixels of one picture, as computer vision
/// states it.
///
/// The frame is right-handed with *x* to the right, *y* down and *z* forwards. A point falls on
///
/// ```text
/// u = f_x x/z + s y/z + c_x
/// v = f_y y/z + c_y
/// ```
///
/// with focal lengths f, principal point c and skew s in pixels. [`PixelOrigin`] says where in the
/// first pixel u = v = 0 is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    /// Focal lengths along u and v in pixels.
    pub focal: [f64; 2],
    /// Principal point in pixels.
    pub principal: [f64; 2],
    /// Skew in pixels, 0 for most cameras.
    pub skew: f64,
    /// Where u = v = 0 is.
    pub origin: PixelOrigin,
}

/// Where in the first pixel the coordinates are zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PixelOrigin {
    /// In its middle, so that whole numbers are the middles of pixels: the convention of OpenCV and
    /// of most calibrations.
    #[default]
    Centre,
    /// In its upper left corner, so that the middles of pixels lie on halves.
    Corner,
}

impl Intrinsics {
    /// Intrinsics without skew, in the convention of computer vision: (0, 0) is the middle of the
    /// first pixel.
    pub fn new(focal: [f64; 2], principal: [f64; 2]) -> Self {
        Self {
            focal,
            principal,
            skew: 0.0,
            origin: PixelOrigin::Centre,
        }
    }

    /// The principal point as column and row, where pixels cover whole numbers to the next.
    pub(crate) fn centre(&self) -> [f64; 2] {
        match self.origin {
            PixelOrigin::Centre => self.principal.map(|c| c + 0.5),
            PixelOrigin::Corner => self.principal,
        }
    }

    pub(crate) fn check(&self) -> Result<(), RenderError> {
        // Quotients of two numbers within this range stay finite.
        let reasonable = |number: f64| number.abs() <= LARGEST_COORDINATE;
        if !self.focal.iter().all(|&f| reasonable(f) && f > 1e-30) {
            return Err(RenderError::Camera("a focal length is not positive"));
        }
        if !(self.principal.iter().all(|&c| reasonable(c)) && reasonable(self.skew)) {
            return Err(RenderError::Camera(
                "its principal point or skew is not finite",
            ));
        }
        Ok(())
    }
}
