//! Meshes, their files and their parts.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod atlas;
mod attributes;
mod gltf;
mod normals;
mod obj;
mod polygons;
mod query;
mod topology;
