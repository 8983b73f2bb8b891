//! Surfaces from disparity: points, triangles, normals and meshes.
//!
//! Each pixel of the left view with a known disparity is a point of the left camera's frame, at the
//! depth `Z = f B/(d + c_right − c_left)` of a [`RectifiedRig`]. Neighbouring pixels are joined by
//! triangles unless the surface is torn between them.
//!
//! # Which depths noise decides
//!
//! The disparities of a matcher have a standard deviation σ, [`DISPARITY_DEVIATION`], and so have
//! depths one of `σ_Z = Z²/(f B) σ`, which relative to the depth is `σ/(d + c_right − c_left)`. Far
//! away it grows beyond every bound: at a disparity of 0.05 px a depth is any number. Points whose
//! relative deviation is greater than [`SurfaceOptions::depth_deviation`] are left out.
//!
//! # Where a surface is cut
//!
//! An edge of the grid joins two pixels if their disparities differ by no more than
//! [`SurfaceOptions::cut_px`] for each pixel of distance along rows or columns (the larger of the
//! two counts for a diagonal). A triangle needs all three edges. The rule is one of disparity,
//! since that is what was measured and its errors are equally large everywhere: a limit on depth
//! would tear what is far away and join what is near. A limit of 1 px cuts where a surface is so
//! steep that the right view would show it reversed.
//!
//! Of the two diagonals of a square of pixels, the one between more similar disparities is taken.
//! Where one corner is missing, the other three may still be a triangle.
//!
//! ```
//! use ga_image::plane::Plane;
//! use ga_camera::Intrinsics;
//! use ga_vision::disparity::DisparityMap;
//! use ga_camera::rig::RectifiedRig;
//! use ga_vision::surface::{Surface, SurfaceOptions};
//!
//! // A wall at 0.1 · 500/25 = 2 m, with one pixel of something at 1 m before it.
//! let camera = Intrinsics::new([500.0, 500.0], [1.5, 1.0])?;
//! let rig = RectifiedRig::new(camera, camera, 0.1)?;
//! let values = vec![25.0, 25.0, 25.0, 25.0, 25.0, 25.0, 25.0, 25.0, 25.0, 25.0, 25.0, 50.0];
//! let map = DisparityMap::new(Plane::from_values(4, 3, values)?);
//! let surface = Surface::new(&map, &rig, &SurfaceOptions::default())?;
//! assert_eq!((surface.points().len(), surface.triangles().len()), (12, 11));
//! assert_eq!(surface.points()[0].coordinates(), [-0.006, -0.004, 2.0]);
//! // It faces the camera.
//! assert_eq!(surface.normals()[0].unwrap().coordinates(), [0.0, 0.0, -1.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`RectifiedRig`]: ga_camera::rig::RectifiedRig

mod grid;
mod model;
mod pair;
mod rectified_pair;

pub use grid::{DISPARITY_DEVIATION, DepthSummary, Surface, SurfaceOptions};
pub use pair::{disparity_range, seen_by_both};
pub use rectified_pair::{PairMatch, PairOptions, RectifiedPair};
