//! Meshes, their files and their parts.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod atlas;
mod attributes;
mod bake;
mod damage;
mod geodesic;
mod gltf;
mod materials;
mod normals;
mod obj;
mod ply;
mod ply_strips;
mod polygons;
mod query;
mod report;
mod tangents;
mod topology;
mod triangulation;
