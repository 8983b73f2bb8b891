//! Polygons in space: their plane, their shape and their triangles.

mod fill;
mod plane;
mod triangulation;

pub(crate) use plane::Plane;
pub(crate) use triangulation::Triangulation;
