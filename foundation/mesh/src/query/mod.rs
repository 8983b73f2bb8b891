//! Queries on the surface of a mesh: the nearest point, what a ray hits, what lies within reach.
//!
//! A [`Bvh`] is a bounding volume hierarchy over the triangles of a mesh: a tree whose nodes hold
//! boxes around the triangles below them, so that a query visits only the triangles near its
//! answer. It is built once, keeps a copy of the corners, and is independent of the mesh after
//! that.
//!
//! | query | method |
//! | --- | --- |
//! | the nearest point of the surface | [`Bvh::nearest`], [`Bvh::nearest_within`] |
//! | the triangles within a radius of a point | [`Bvh::within`] |
//! | the triangles that meet a sphere, or a box | [`Bvh::on_sphere`], [`Bvh::in_box`] |
//! | what a ray hits first, and everything that it hits | [`Bvh::first_hit`], [`Bvh::all_hits`] |
//! | whether a ray hits anything | [`Bvh::is_hit`] |
//! | where a line crosses the surface | [`Bvh::crossings`] |
//! | the section by a plane | [`Bvh::section`], [`Bvh::contours`] |
//! | the pairs of triangles of two surfaces that meet | [`Bvh::overlaps`] |
//! | signed distance from a closed surface | [`ClosedSurface::signed_distance`] |
//!
//! Elements of the algebra go in and come out: points, spheres, lines and planes are those of
//! [`ga_runtime::cga3`], rays and their hits those of [`ga_runtime::geometry::ray`].
//!
//! # Exactness
//!
//! The answer is that of a comparison with every triangle, one after the other: the boxes are
//! rounded outwards, and among several triangles at the same distance, the one with the lowest
//! index is taken. So the same mesh and the same query always give the same answer. Rays do not
//! slip through edges that triangles share (S. Woop, C. Benthin and I. Wald, Watertight
//! Ray/Triangle Intersection, JCGT 2, 2013). Degenerate triangles are segments or points for
//! distances, and are never hit by rays.
//!
//! Distances are in the unit of the coordinates. Computations take up to the fourth power of
//! lengths: differences of coordinates should be below 10⁷⁵ and, between corners of a triangle,
//! above 10⁻⁷⁵.
//!
//! # Example
//!
//! ```
//! use ga_mesh::query::Bvh;
//! use ga_runtime::cga3::Point;
//! use ga_runtime::geometry::ray::Ray;
//!
//! let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
//! let square = Bvh::new(&corners, &[[0, 1, 2], [0, 2, 3]])?;
//!
//! let nearest = square.nearest(Point::new(3.0, 1.0, 2.0))?;
//! assert_eq!(nearest.point, Point::new(3.0, 1.0, 0.0));
//! assert_eq!((nearest.distance, nearest.triangle), (2.0, 0));
//!
//! let ray = Ray::new(Point::new(1.0, 3.0, 5.0), [0.0, 0.0, -1.0]).unwrap();
//! let found = square.first_hit(ray).unwrap();
//! assert_eq!((found.hit.distance, found.triangle), (5.0, 1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod build;
mod error;
mod frame;
mod hierarchy;
mod line;
mod nearest;
mod node;
mod overlap;
mod packet;
mod pairs;
mod ray;
mod section;
mod signed_distance;

pub use error::QueryError;
pub use hierarchy::Bvh;
pub use nearest::Nearest;
pub(crate) use nearest::closest_weights;
pub use overlap::LineCrossing;
pub use ray::MeshHit;
pub use section::{Contour, Segment};
pub use signed_distance::{ClosedSurface, NotClosed};
