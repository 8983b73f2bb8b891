//! Contours: the borders of regions, curves that settle at edges, figures fitted to them, and
//! curves in space from two views.
//!
//! - [`borders`]: the borders of the regions of a picture in black and white, with their hierarchy.
//! - [`Regions`]: those of the bright regions of a picture, without small ones.
//! - [`MeasuredContour`]: a closed curve in numbers.
//! - [`outline`]: the border of the largest region or hole of a picture.
//! - [`snake`]: closed curves that minimise an energy of their shape and of the picture.
//! - [`fit`]: ellipses through points; for lines and circles see [`ga_runtime::geometry::fit`].
//! - [`space_curve`](mod@space_curve): the closed curve in space that two views see as contours.
//!
//! Places are pixel coordinates `[u, v]`: u to the right and v down from the centre of the top left
//! pixel.

mod border;
mod error;
pub mod fit;
mod measured;
mod outline;
mod picture_border;
mod polygon;
mod regions;
pub mod snake;
pub mod space_curve;

pub use border::{Contour, borders};
pub use error::ContourError;
pub use measured::{MeasuredContour, NearestCircle};
pub use outline::outline;
pub use polygon::{centroid, perimeter, resampled, signed_area};
pub use regions::Regions;
