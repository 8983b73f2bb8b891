//! The texture coordinates of the skin.

use ga_mesh::Mesh;
use ga_mesh::atlas::{Options, unwrap};

/// The side of the texture in texels for which the charts are placed.
const SIZE: u32 = 1024;

/// Texels around a chart that belong to it alone, so that smaller copies of the texture keep charts
/// apart.
const GAP: u32 = 3;

/// The mesh with texture coordinates.
pub(crate) fn with_texture_coordinates(mesh: Mesh) -> Mesh {
    let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let options = Options {
        size: SIZE,
        margin_texels: GAP,
        ..Options::default()
    };
    let atlas = unwrap(&positions, &mesh.triangles(), &options)
        .expect("a closed surface of even triangles has an atlas");
    mesh.with_texture_coordinates(vec![atlas.texture_coordinates()])
        .expect("there are three finite coordinates for each triangle")
}
