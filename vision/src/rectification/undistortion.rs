//! Pictures without the distortion of their lens.

use ga_image::warp::Warp;
use ga_runtime::cga3::{Motor, Rotor};

use super::map;
use super::view::View;
use crate::geometry_error::ViewGeometryError;
use ga_camera::{Intrinsics, Lens};

/// A camera and the pinhole at the same place whose pictures replace its own.
///
/// ```
/// use ga_camera::{Intrinsics, RadialTangential};
/// use ga_vision::rectification::Undistortion;
/// let lens = RadialTangential::new(&[-0.2, 0.05, 0.0, 0.0])?;
/// let camera = Intrinsics::new([50.0, 50.0], [31.5, 23.5])?.with_lens(lens);
/// let straight = Undistortion::new(camera, [64, 48], None)?;
/// assert_eq!(straight.target.focal(), [50.0, 50.0]);
/// assert_eq!(straight.map().size(), [64, 48]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undistortion {
    /// The camera with its lens.
    pub source: Intrinsics,
    /// The pinhole.
    pub target: Intrinsics,
    /// Columns and rows of the pictures.
    pub size: [usize; 2],
}

impl Undistortion {
    /// The undistortion of pictures of a size in columns and rows.
    ///
    /// Without `alpha`, focal lengths and principal point are kept. Otherwise they are chosen as by
    /// OpenCV's `getOptimalNewCameraMatrix`: from `alpha` = 0, where all pixels of the new picture
    /// were seen, to 1, where it holds every pixel of the old one.
    ///
    /// # Errors
    /// [`ViewGeometryError`] for pictures without pixels, `alpha` beyond [0, 1], and a camera that
    /// sees no rectangle.
    pub fn new(
        source: Intrinsics,
        size: [usize; 2],
        alpha: Option<f64>,
    ) -> Result<Self, ViewGeometryError> {
        if size.iter().any(|count| *count < 2) {
            return Err(ViewGeometryError::UndistortionSize(size));
        }
        let target = match alpha {
            None => source.with_lens(Lens::Pinhole),
            Some(alpha) if (0.0..=1.0).contains(&alpha) => fitted(&source, size, alpha)?,
            Some(alpha) => return Err(ViewGeometryError::Alpha(alpha)),
        };
        Ok(Self {
            source,
            target,
            size,
        })
    }

    /// The map from pictures of the camera to those of the pinhole.
    #[must_use]
    pub fn map(&self) -> Warp {
        map(
            &self.source,
            self.size,
            Motor::default(),
            &self.target,
            self.size,
        )
    }
}

/// The pinhole between the one that shows the inner and the one that shows the outer rectangle.
fn fitted(
    source: &Intrinsics,
    size: [usize; 2],
    alpha: f64,
) -> Result<Intrinsics, ViewGeometryError> {
    let view = View {
        intrinsics: source,
        size,
        rotation: Rotor::default(),
        quarter_turns: 0,
    };
    let bounds = view.bounds().map_err(|error| match error {
        ViewGeometryError::Size(size) => ViewGeometryError::UndistortionSize(size),
        _ => ViewGeometryError::NoRectangle,
    })?;
    let fit = |[left, right, top, bottom]: [f64; 4]| {
        let fx = (size[0] - 1) as f64 / (right - left);
        let fy = (size[1] - 1) as f64 / (bottom - top);
        [fx, fy, -fx * left, -fy * top]
    };
    let (inner, outer) = (fit(bounds.inner), fit(bounds.outer));
    let [fx, fy, cx, cy] = std::array::from_fn(|k| inner[k] * (1.0 - alpha) + outer[k] * alpha);
    Intrinsics::new([fx, fy], [cx, cy]).map_err(|_| ViewGeometryError::NoRectangle)
}
