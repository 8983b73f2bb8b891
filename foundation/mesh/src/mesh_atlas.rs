//! The place of a whole mesh in a texture.

use crate::atlas::{Options, Report, measure, unwrap};
use crate::{CornerAttribute, Faces, Mesh, TextureSpaceError};

/// A mesh in triangles with a place in a texture: by its own texture coordinates, or by those of a
/// new atlas.
#[derive(Clone, Debug)]
pub struct MeshAtlas {
    /// The triangles with their texture coordinates, and with the normals of the mesh if it has
    /// any.
    pub mesh: Mesh,
    /// The texture coordinates of the corners of each triangle.
    pub coordinates: Vec<[[f64; 2]; 3]>,
    /// The figures of these coordinates.
    pub report: Report,
    /// Whether the atlas was made here.
    pub is_new: bool,
}

impl MeshAtlas {
    /// The mesh with its own coordinates where every corner has one, otherwise, or if `force` says
    /// so, with those of a new atlas. Its own are measured with a margin of `own_margin` texels.
    ///
    /// # Errors
    ///
    /// Those of [`unwrap`] and [`measure`].
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_mesh::MeshAtlas;
    /// use ga_mesh::atlas::Options;
    ///
    /// let square = ga_mesh::obj::decode(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
    /// let made = MeshAtlas::new(&square, &Options::default(), false, 0)?;
    /// assert!(made.is_new && made.mesh.faces().len() == 2);
    /// let kept = MeshAtlas::new(&made.mesh, &Options::default(), false, 0)?;
    /// assert!(!kept.is_new && kept.coordinates == made.coordinates);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        mesh: &Mesh,
        options: &Options,
        force: bool,
        own_margin: u32,
    ) -> Result<Self, TextureSpaceError> {
        let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
        let triangles = mesh.triangles();
        let corners = mesh.corner_triangles();
        let corners = || corners.as_flattened().iter().map(|&corner| corner as usize);
        let own = mesh
            .texture_coordinates()
            .filter(|own| !force && own.corners.iter().all(Option::is_some))
            .map(|own| own.at_corners(corners()));
        let is_new = own.is_none();
        let (attribute, coordinates, report) = match own {
            Some(own) => {
                let places = of_triangles(&own);
                let options = Options {
                    margin_texels: own_margin,
                    ..*options
                };
                let report = measure(&positions, &triangles, &places, &options)?;
                (own, places, report)
            }
            None => {
                let atlas = unwrap(&positions, &triangles, options)?;
                (atlas.texture_coordinates(), atlas.coordinates, atlas.report)
            }
        };
        let mut placed = Mesh::new(positions, Faces::from_uniform(triangles)?)?
            .with_texture_coordinates(vec![attribute])?;
        if let Some(normals) = mesh.normals() {
            placed = placed.with_normals(normals.at_corners(corners()))?;
        }
        Ok(Self {
            mesh: placed,
            coordinates,
            report,
            is_new,
        })
    }
}

/// The coordinates of each triangle, of which every corner has one.
fn of_triangles(coordinates: &CornerAttribute<[f64; 2]>) -> Vec<[[f64; 2]; 3]> {
    let place = |corner: Option<u32>| corner.map_or([0.0; 2], |c| coordinates.values[c as usize]);
    let triangles = coordinates.corners.as_chunks::<3>().0;
    triangles.iter().map(|corners| corners.map(place)).collect()
}
