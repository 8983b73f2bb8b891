//! Rectification: views in which the two images of a point are in the same row.
//!
//! A [`Rectification`] is computed once for a rig, after J.-Y. Bouguet's method, by rotors: both
//! cameras rotate by half of the rotation between them, so that they look the same way with the
//! least change, and then together, so that the baseline lies along the rows. Cameras that stand
//! one above the other, on their side or on their head are first rolled by right angles. Its maps
//! take the pictures to the rectified ones, lens distortion included. An [`Undistortion`] does the
//! latter for one camera. A [`RectifiedRig`] is what remains of the rig: disparity is depth.
//!
//! Focal length and principal points are chosen as by OpenCV's `stereoRectify`; see
//! [`RectificationOptions`].

mod rotations;
mod storage;
mod summary;
mod undistortion;
mod view;

pub use summary::RectificationSummary;
pub use undistortion::Undistortion;

use ga_image::warp::Warp;
use ga_runtime::cga3::{Direction, Motor, Point};
use serde::Serialize;

use crate::geometry_error::ViewGeometryError;
use ga_camera::frame::{LeftCamera, Pose, RectifiedLeft, RectifiedRight, RightCamera};
use ga_camera::rig::RectifiedRig;
use ga_camera::rig::StereoRig;
use ga_camera::{CameraError, Intrinsics};
use rotations::Rotations;
use view::View;

/// The greatest number of pixels of a rectified picture, whose map has 16 bytes for each.
const MOST_PIXELS: usize = 1 << 28;

/// What the rectified pictures show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectificationOptions {
    /// Whether what is infinitely far away has the disparity zero: the principal points are then at
    /// the same place in both views. Otherwise each view is centred for itself.
    pub zero_disparity: bool,
    /// From 0, where the pictures are magnified until all of their pixels were seen, to 1, where
    /// they hold every pixel of the views. Without it, the focal length is the mean of the two.
    pub alpha: Option<f64>,
    /// Columns and rows of the rectified pictures; without it, those of the left view, after its
    /// [roll](Rectification::quarter_turns).
    pub size: Option<[usize; 2]>,
}

impl Default for RectificationOptions {
    /// Zero disparity at infinity, without `alpha`, in the size of the left view.
    fn default() -> Self {
        Self {
            zero_disparity: true,
            alpha: None,
            size: None,
        }
    }
}

/// A part of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Rectangle {
    /// The first column.
    pub left: usize,
    /// The first row.
    pub top: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

/// The rotations and cameras that rectify the views of a rig.
///
/// ```
/// use ga_camera::Intrinsics;
/// use ga_vision::rectification::{Rectification, RectificationOptions};
/// use ga_camera::rig::StereoRig;
///
/// // The right camera looks a little to the left, and stands a little higher.
/// let camera = Intrinsics::new([500.0, 500.0], [320.0, 240.0])?;
/// let (sine, cosine) = 0.05_f64.sin_cos();
/// let rotation = [[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]];
/// let rig = StereoRig::from_matrices(camera, camera, rotation, [-0.1, 0.01, 0.0])?;
/// let found = Rectification::new(&rig, [640, 480], RectificationOptions::default())?;
///
/// let point = ga_runtime::cga3::Point::new(0.2, -0.1, 2.0);
/// let [u, v] = found.left_pixel(rig.left.project(point)?)?;
/// let [u_right, v_right] = found.right_pixel(rig.right.project(point)?)?;
/// assert!((v - v_right).abs() < 1e-10);
/// let again = found.rig.point([u, v], u - u_right).unwrap();
/// assert!(found.left.motor.reverse().transform(again).distance(point) < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectification {
    /// The rotation of the left camera.
    pub left: Pose<LeftCamera, RectifiedLeft>,
    /// The rotation of the right camera.
    pub right: Pose<RightCamera, RectifiedRight>,
    /// The cameras after rectification.
    pub rig: RectifiedRig,
    /// Columns and rows of the rectified pictures.
    pub size: [usize; 2],
    /// The largest rectangles, left and right, that are known to hold only pixels that were seen;
    /// empty where there is none.
    pub valid: [Rectangle; 2],
    /// By how many right angles the pictures of the left and of the right camera are rolled,
    /// clockwise as you look at them: 0 to 3. It is not zero for a camera that stands on its side
    /// or on its head, and for both cameras where one is above the other: the baseline always lies
    /// along the rows.
    pub quarter_turns: [u8; 2],
    cameras: [Intrinsics; 2],
    source: [usize; 2],
}

impl Rectification {
    /// Rectifies a rig whose pictures have a size in columns and rows.
    ///
    /// # Errors
    /// [`ViewGeometryError`] for cameras at one place, one camera behind the other, a right camera
    /// that is on the left, and views that do not overlap.
    pub fn new(
        rig: &StereoRig,
        source: [usize; 2],
        options: RectificationOptions,
    ) -> Result<Self, ViewGeometryError> {
        if source.iter().any(|count| *count < 2) {
            return Err(ViewGeometryError::Size(source));
        }
        if let Some(alpha) = options.alpha.filter(|alpha| !(0.0..=1.0).contains(alpha)) {
            return Err(ViewGeometryError::Alpha(alpha));
        }
        let Rotations {
            rotors,
            quarter_turns,
        } = Rotations::of_rig(rig.left_to_right().motor)?;
        let cameras = [rig.left.intrinsics, rig.right.intrinsics];
        let views = [0, 1].map(|k| View {
            intrinsics: &cameras[k],
            size: source,
            rotation: rotors[k],
            quarter_turns: quarter_turns[k],
        });
        let size = options.size.unwrap_or(views[0].rolled_size());
        let is_empty = size.iter().any(|count| *count < 2);
        if is_empty || size[0].saturating_mul(size[1]) > MOST_PIXELS {
            return Err(ViewGeometryError::Size(size));
        }
        let frame = Frame::new(&views, size, options)?;
        let pinhole = |k: usize| {
            Intrinsics::new([frame.focal; 2], frame.centres[k]).map_err(ViewGeometryError::Unseen)
        };
        let baseline = rig.baseline();
        let rectified = RectifiedRig::new(pinhole(0)?, pinhole(1)?, baseline)
            .map_err(|_| ViewGeometryError::Baseline(baseline))?;
        Ok(Self {
            left: Pose::new(rotors[0].into()),
            right: Pose::new(rotors[1].into()),
            rig: rectified,
            size,
            valid: frame.valid,
            quarter_turns,
            cameras,
            source,
        })
    }

    /// The pixel of the rectified left view that shows what a pixel of the left view shows.
    ///
    /// # Errors
    /// [`CameraError`] as [`Intrinsics::direction`] and [`Intrinsics::project`].
    pub fn left_pixel(&self, pixel: [f64; 2]) -> Result<[f64; 2], CameraError> {
        rectified_pixel(&self.cameras[0], self.left.motor, &self.rig.left(), pixel)
    }

    /// The pixel of the rectified right view that shows what a pixel of the right view shows.
    ///
    /// # Errors
    /// As [`left_pixel`](Self::left_pixel).
    pub fn right_pixel(&self, pixel: [f64; 2]) -> Result<[f64; 2], CameraError> {
        rectified_pixel(&self.cameras[1], self.right.motor, &self.rig.right(), pixel)
    }

    /// The map from the left view to its rectified picture.
    #[must_use]
    pub fn left_map(&self) -> Warp {
        let new = self.rig.left();
        map(
            &self.cameras[0],
            self.source,
            self.left.motor,
            &new,
            self.size,
        )
    }

    /// The map from the right view to its rectified picture.
    #[must_use]
    pub fn right_map(&self) -> Warp {
        let new = self.rig.right();
        map(
            &self.cameras[1],
            self.source,
            self.right.motor,
            &new,
            self.size,
        )
    }
}

fn rectified_pixel(
    old: &Intrinsics,
    rotation: Motor<f64>,
    new: &Intrinsics,
    pixel: [f64; 2],
) -> Result<[f64; 2], CameraError> {
    let direction = rotation.transform(old.direction(pixel)?);
    new.project(Point::from(direction.vector()))
}

/// The map of pictures to a rotated camera with other intrinsics.
fn map(
    old: &Intrinsics,
    source: [usize; 2],
    rotation: Motor<f64>,
    new: &Intrinsics,
    size: [usize; 2],
) -> Warp {
    let back = rotation.reverse();
    // The planes of ga-image count from the corner of the first pixel, cameras from its centre.
    Warp::new(size, source, |[x, y]| {
        let direction: Direction<f64> = new.direction([x - 0.5, y - 0.5]).ok()?;
        let point = Point::from(back.transform(direction).vector());
        let [u, v] = old.project(point).ok()?;
        Some([u + 0.5, v + 0.5])
    })
}

/// Focal length and principal points of the rectified pictures.
struct Frame {
    focal: f64,
    centres: [[f64; 2]; 2],
    valid: [Rectangle; 2],
}

impl Frame {
    fn new(
        views: &[View<'_>; 2],
        size: [usize; 2],
        options: RectificationOptions,
    ) -> Result<Self, ViewGeometryError> {
        // The mean focal length along the columns, for pictures of the new height.
        let focal = views
            .iter()
            .map(|view| {
                0.5 * view.rolled_focal()[1] * size[1] as f64 / view.rolled_size()[1] as f64
            })
            .sum::<f64>();
        // Principal points that put the middles of the views into those of the pictures.
        let mut centres = [[0.0; 2]; 2];
        for (centre, view) in centres.iter_mut().zip(views) {
            let (mean, old) = (view.middle()?, view.rolled_size());
            *centre = [0, 1].map(|k| {
                let middle = 0.5 * (old[k] - 1) as f64 - focal * mean[k];
                middle * size[k] as f64 / old[k] as f64
            });
        }
        let [[left_x, left_y], [right_x, right_y]] = centres;
        let row = 0.5 * (left_y + right_y);
        let [left, right] = if options.zero_disparity {
            [0.5 * (left_x + right_x); 2]
        } else {
            [left_x, right_x]
        };
        let centres = [[left, row], [right, row]];
        let mut bounds = [views[0].bounds()?, views[1].bounds()?];
        for bounds in &mut bounds {
            for side in bounds.inner.iter_mut().chain(&mut bounds.outer) {
                *side *= focal;
            }
        }
        let scale = options.alpha.map_or(1.0, |alpha| {
            let scales = [0, 1].map(|k| {
                let limits = limits(centres[k], size);
                [bounds[k].inner, bounds[k].outer].map(|sides| ratios(limits, sides))
            });
            let largest = scales.iter().flat_map(|scale| scale[0]).fold(0.0, f64::max);
            let least = scales.iter().flat_map(|scale| scale[1]);
            let least = least.fold(f64::INFINITY, f64::min);
            largest * (1.0 - alpha) + least * alpha
        });
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(ViewGeometryError::Empty);
        }
        let valid = [0, 1].map(|k| rectangle(centres[k], bounds[k].inner.map(|x| x * scale), size));
        Ok(Self {
            focal: focal * scale,
            centres,
            valid,
        })
    }
}

/// The sides `[left, right, top, bottom]` of a picture as seen from a principal point.
fn limits([x, y]: [f64; 2], [width, height]: [usize; 2]) -> [f64; 4] {
    [-x, (width - 1) as f64 - x, -y, (height - 1) as f64 - y]
}

/// By how much each side must be scaled to reach the limit.
fn ratios(limits: [f64; 4], sides: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|k| limits[k] / sides[k])
}

/// The part of a picture between sides that are given from a principal point.
fn rectangle([x, y]: [f64; 2], sides: [f64; 4], size: [usize; 2]) -> Rectangle {
    let interval = |low: f64, high: f64, centre: f64, count: usize| {
        let first = (centre + low).ceil();
        let length = (high - low).floor();
        let end = (first + length).clamp(0.0, count as f64);
        let first = first.clamp(0.0, count as f64);
        (first as usize, (end - first).max(0.0) as usize)
    };
    let (left, width) = interval(sides[0], sides[1], x, size[0]);
    let (top, height) = interval(sides[2], sides[3], y, size[1]);
    Rectangle {
        left,
        top,
        width,
        height,
    }
}
