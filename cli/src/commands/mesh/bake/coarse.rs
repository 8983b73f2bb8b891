//! The coarse mesh: triangles with texture coordinates, and its files.

use anyhow::Result;
use ga_mesh::atlas::{self, Options, Report};
use ga_mesh::gltf::{self, Document};
use ga_mesh::normals::vertex_normals;
use ga_mesh::{
    CornerAttribute, Faces, Image, Material, Mesh, Texture, TextureCoordinates, tangents,
};

/// The maps of a mesh, each as an image.
#[derive(Clone, Debug, Default)]
pub(super) struct Images {
    pub(super) colour: Option<Image>,
    pub(super) normal: Option<Image>,
    pub(super) occlusion: Option<Image>,
}

/// A mesh of triangles with texture coordinates, normals and tangents.
pub(super) struct Coarse {
    pub(super) mesh: Mesh,
    /// What the texture coordinates are like.
    pub(super) report: Report,
    /// Whether they were made here.
    pub(super) unwrapped: bool,
}

impl Coarse {
    /// The mesh of a file as triangles, with its own texture coordinates where every corner has
    /// one, otherwise, or if `force` says so, with those of a new atlas.
    pub(super) fn new(mesh: &Mesh, options: &Options, force: bool) -> Result<Self> {
        let corners = mesh.faces().corner_triangles();
        let vertex = |corner: u32| mesh.faces().corners()[corner as usize];
        let triangles: Vec<[u32; 3]> = corners.iter().map(|c| c.map(vertex)).collect();
        let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
        let own = mesh
            .texture_coordinates()
            .filter(|own| !force && own.corners.iter().all(Option::is_some))
            .map(|own| at_corners(own, &corners));
        let unwrapped = own.is_none();
        let (coordinates, report) = match own {
            Some(own) => {
                let places = of_triangles(&own);
                let report = atlas::measure(&positions, &triangles, &places, options)?;
                (own, report)
            }
            None => {
                let atlas = atlas::unwrap(&positions, &triangles, options)?;
                (atlas.texture_coordinates(), atlas.report)
            }
        };
        let faces = Faces::from_polygons(&triangles)?;
        let normals = match mesh.normals() {
            Some(normals) => at_corners(normals, &corners),
            None => {
                let normals = vertex_normals(&positions, &triangles);
                let normals = normals.into_iter().map(Into::into).collect();
                CornerAttribute::of_vertices(normals, &faces)
            }
        };
        let mesh = Mesh::new(positions, faces)?
            .with_texture_coordinates(vec![coordinates])?
            .with_normals(normals)?;
        let tangents = tangents::mikktspace(&mesh, 0)?;
        Ok(Self {
            mesh: mesh.with_tangents(tangents)?,
            report,
            unwrapped,
        })
    }

    /// The OBJ file and its MTL file, which names the maps.
    pub(super) fn obj(&self, images: Images, stem: &str) -> Result<Vec<(String, Vec<u8>)>> {
        Ok(ga_mesh::obj::encode_files(&self.with_maps(images)?, stem))
    }

    /// The GLB file.
    pub(super) fn glb(&self, images: Images) -> Result<Vec<u8>> {
        let document = Document::from_mesh(&self.with_maps(images)?)?;
        Ok(gltf::encode(&document)?)
    }

    fn with_maps(&self, images: Images) -> Result<Mesh> {
        let material = Material {
            base_colour_texture: images.colour.map(Texture::new),
            normal_texture: images.normal.map(Texture::new),
            occlusion_texture: images.occlusion.map(Texture::new),
            ..Material::named("baked")
        };
        let of_faces = vec![Some(0); self.mesh.faces().len()];
        Ok(self.mesh.clone().with_materials(vec![material], of_faces)?)
    }
}

/// An attribute at the corners of triangles.
fn at_corners<T: Clone>(
    attribute: &CornerAttribute<T>,
    corners: &[[u32; 3]],
) -> CornerAttribute<T> {
    let corners = corners.as_flattened().iter();
    CornerAttribute {
        values: attribute.values.clone(),
        corners: corners.map(|&c| attribute.corners[c as usize]).collect(),
    }
}

/// The coordinates of each triangle, of which every corner has one.
fn of_triangles(coordinates: &TextureCoordinates) -> Vec<[[f64; 2]; 3]> {
    let place = |corner: Option<u32>| corner.map_or([0.0; 2], |c| coordinates.values[c as usize]);
    let triangles = coordinates.corners.as_chunks::<3>().0;
    triangles.iter().map(|corners| corners.map(place)).collect()
}
