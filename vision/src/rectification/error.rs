//! Why rigs cannot be rectified.

use ga_camera::CameraError;

/// Why a rig cannot be rectified.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RectificationError {
    /// The cameras are at the same place, or a number is not finite.
    #[error("the distance between the cameras is {0} m, so there is no disparity")]
    Baseline(f64),
    /// The second camera is above or below the first, rather than beside it.
    #[error("the second camera is at {0:?} m from the first: more above or below than beside it")]
    Vertical([f64; 3]),
    /// The second camera is before or behind the first, rather than beside it.
    #[error("the second camera is at {0:?} m from the first: more before or behind than beside it")]
    Forward([f64; 3]),
    /// The second camera is to the left of the first.
    #[error("the second camera is at {0:?} m, left of the first: the views are exchanged")]
    Exchanged([f64; 3]),
    /// There is no picture, or the rectified ones would have more than 2²⁸ pixels.
    #[error("pictures of {} × {} pixels cannot be rectified", .0[0], .0[1])]
    Size([usize; 2]),
    /// `alpha` is not in [0, 1].
    #[error("alpha is {0}, not from 0 to 1")]
    Alpha(f64),
    /// A camera does not see what is in front of it after the rotation.
    #[error("the new axis is outside the field of a camera: the cameras look too far apart")]
    Axis,
    /// There is no rectangle that both cameras see.
    #[error("the rectified pictures would show nothing: the views do not overlap")]
    Empty,
    /// A pixel has no place in the other picture.
    #[error(transparent)]
    Camera(#[from] CameraError),
}
