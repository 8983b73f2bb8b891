//! Primitives fitted to points: spheres, circles, planes, lines and cylinders with the least sum of
//! squared orthogonal distances, with weights, among gross errors, and with covariances.
//!
//! | primitive | unknowns | points needed | that do not lie |
//! | --- | --- | --- | --- |
//! | [`Line`](crate::cga3::Line::fit) | 4 | 2 | at one place |
//! | [`Plane`](crate::cga3::Plane::fit) | 3 | 3 | on a line |
//! | [`Circle`](crate::cga3::Circle::fit) | 6 | 3 | on a line |
//! | [`Sphere`](crate::cga3::Sphere::fit) | 4 | 4 | in a plane |
//! | [`Cylinder`](Cylinder::fit) | 5 | 6 | in a plane |
//!
//! Each has `fit`, `fit_weighted` and `fit_robustly`; round ones also `fit_algebraically`, the fast
//! start of the search. `cga2::Line` and `cga2::Circle` of the plane (feature `cga2`) have 2 and 3
//! unknowns, for as many points.
//!
//! A fit is a [`PrimitiveFit`]: the primitive as an element of cga3, residuals, and the covariance
//! of its parameters. All computation is relative to the centroid of the points and in units of
//! their extent, so that it loses no digits far from the origin. Sums run in the order of the
//! input, so the same input gives the same result to the last bit.
//!
//! ```
//! use ga_runtime::cga3::{Point, Sphere};
//! use ga_runtime::geometry::fit::RobustSettings;
//! // Points of a sphere about (0, 0, 5) of radius 2, of which every third is wrong.
//! let point = |k: u32| {
//!     let t = f64::from(k);
//!     let radius = if k % 3 == 0 { 2.5 + t.cos() } else { 2.0 };
//!     let z: f64 = (1.7 * t).sin();
//!     let width = radius * (1.0 - z * z).sqrt();
//!     Point::new(width * t.cos(), width * t.sin(), 5.0 + radius * z)
//! };
//! let points: Vec<_> = (0..60).map(point).collect();
//! let found = Sphere::fit_robustly(&points, &RobustSettings::new(0.01)).unwrap();
//! assert!((found.fit.radius() - 2.0).abs() < 1e-12 && found.inliers.len() >= 40);
//! ```

mod circle;
mod cloud;
mod consensus;
mod cylinder;
mod cylinder_axis;
mod interface;
mod line;
mod loss;
mod place;
#[cfg(feature = "cga2")]
mod planar_circle;
#[cfg(feature = "cga2")]
mod planar_line;
mod plane;
mod quadric;
mod radial;
mod random;
mod refinement;
mod result;
mod robust;
mod search;
mod settings;
mod shape;
mod sphere;

pub use circle::CircleFit;
pub use cylinder::{Cylinder, CylinderFit};
pub use line::LineFit;
pub use loss::Loss;
#[cfg(feature = "cga2")]
pub use planar_circle::PlanarCircleFit;
#[cfg(feature = "cga2")]
pub use planar_line::PlanarLineFit;
pub use plane::PlaneFit;
pub use result::PrimitiveFit;
pub use robust::RobustFit;
pub use settings::RobustSettings;
pub use sphere::SphereFit;
