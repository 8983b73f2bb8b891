//! Subdivision surfaces: smooth surfaces as the limit of meshes that are refined again and again.
//!
//! [`subdivide`] refines a [`Mesh`](crate::Mesh) with all that it carries. Below it, a [`Cage`]
//! holds faces, creases and [`Rules`]; [`Cage::refine`] gives the next level and the [`Stencils`]
//! that compute it, which can be applied again to a mesh that moves, or to colours and weights.
//! [`Limit`] gives points and normals of the limit surface itself.
//!
//! | type | what it is |
//! | --- | --- |
//! | [`Rules`]: [`Scheme`], [`Boundary`], [`CreaseMethod`], [`TextureRule`] | the rules |
//! | [`Tags`], [`Crease`], [`Corner`], [`TagText`] | sharp edges and vertices, and their text |
//! | [`Cage`], [`Refined`] | a control mesh without positions, and its next level |
//! | [`Subdivision`] | a mesh with its attributes, level by level |
//! | [`CornerValues`] | texture coordinates with their seams |
//! | [`Stencils`] | fine values as weighted sums of coarse ones |
//! | [`Limit`] | points and tangents of the limit surface |
//!
//! # Rules
//!
//! The rules are those of OpenSubdiv. The boundary is an infinitely sharp crease. With the rule of
//! an edge's new vertex and the rule of a vertex:
//!
//! - A smooth edge has the rule of its [`Scheme`]; on a crease the new vertex is the midpoint. A
//!   crease of sharpness s < 1 has s times the second and 1 − s times the first, and so has one of
//!   s > 1 whose halves become smooth at once, as Chaikin's method can make them.
//! - A vertex with no sharp edge or one (a *dart*) has the smooth rule of the scheme.
//! - A vertex with two sharp edges, to a and b, goes to 3/4 v + 1/8 (a + b). Along a crease the
//!   vertices so converge to a uniform cubic B-spline curve.
//! - A vertex with three sharp edges or more, or that is sharp itself, stays.
//! - Where the sharpness of edges or of the vertex ends within a level, so that another rule holds
//!   at the next one, the two are blended by the mean of the sharpnesses that end.
//!
//! In one point this module differs from OpenSubdiv: an edge of more than two faces, which
//! OpenSubdiv makes infinitely sharp, is an error, as the surface is not a manifold there.
//!
//! Source: the documentation and the library OpenSubdiv 3, `Sdc::Scheme` and `Sdc::Crease`; see
//! [`Scheme`], [`Tags`] and [`Limit`] for the original papers.

mod cage;
mod catmull_clark;
mod corner_values;
mod limit;
mod loops;
mod mesh;
mod refinement;
mod rules;
mod sharpness;
mod stencils;
mod tag_problem;
mod tags;

pub use cage::Cage;
pub use corner_values::CornerValues;
pub use limit::Limit;
pub use mesh::{Subdivision, subdivide};
pub use refinement::Refined;
pub use rules::{Boundary, CreaseMethod, Rules, Scheme, TextureRule};
pub use stencils::{StencilLength, Stencils, Value};
pub use tag_problem::TagProblem;
pub use tags::{Corner, Crease, INFINITELY_SHARP, TagText, Tags};
