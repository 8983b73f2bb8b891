//! The colours of the fine mesh.

use std::path::Path;

use ga_mesh::bake::{FinePoint, corner_colours, corner_coordinates};
use ga_mesh::obj::Warning;
use ga_mesh::{Image, Material, Mesh, Texture};

use crate::model::{Meaning, load_texture};
use crate::texture::{Mipmap, TextureError};

/// A picture, and where it is taken at the corners of each triangle.
type Picture = (Mipmap, Vec<[[f64; 2]; 3]>);

/// The colour of each point of a mesh, as linear light.
#[derive(Debug)]
pub struct MeshColours(Colours);

#[derive(Debug)]
enum Colours {
    /// Those of the vertices, at the corners of each triangle.
    Vertices(Vec<[[f64; 4]; 3]>),
    /// Those of the materials.
    Materials {
        /// For each triangle its colour, and its picture if it has one.
        triangles: Vec<([f64; 3], Option<usize>)>,
        pictures: Vec<Picture>,
    },
}

impl MeshColours {
    /// The colours of the vertices of a mesh, or else of its materials with their pictures; white
    /// for faces without a material. A material whose picture does not exist has its base colour
    /// alone, with a warning. Relative paths of pictures begin in `folder`.
    ///
    /// # Errors
    /// [`TextureError`] where a picture exists and cannot be read.
    pub fn new(mesh: &Mesh, folder: Option<&Path>) -> Result<(Self, Vec<Warning>), TextureError> {
        let mut warnings = Vec::new();
        if let Some(colours) = corner_colours(mesh) {
            return Ok((Self(Colours::Vertices(colours)), warnings));
        }
        let mut pictures = Vec::new();
        let mut of_material = Vec::new();
        for material in mesh.materials() {
            let picture = match &material.base_colour_texture {
                Some(placed) => picture(mesh, material, placed, folder, &mut warnings)?,
                None => None,
            };
            let picture = picture.map(|picture| {
                pictures.push(picture);
                pictures.len() - 1
            });
            let [r, g, b, _] = material.base_colour;
            of_material.push(([r, g, b], picture));
        }
        let mut triangles = Vec::new();
        for (face, corners) in mesh.faces().iter().enumerate() {
            let material = mesh.face_materials().get(face).copied().flatten();
            let colour = material.map_or(([1.0; 3], None), |m| of_material[m as usize]);
            triangles.extend(std::iter::repeat_n(colour, corners.len() - 2));
        }
        let colours = Colours::Materials {
            triangles,
            pictures,
        };
        Ok((Self(colours), warnings))
    }

    /// The colour of a point: red, green and blue.
    #[must_use]
    pub fn at(&self, point: &FinePoint) -> [f32; 3] {
        let triangle = point.triangle as usize;
        let colour = match &self.0 {
            Colours::Vertices(corners) => {
                let [r, g, b, _] = point.mean(&corners[triangle]);
                [r, g, b]
            }
            Colours::Materials {
                triangles,
                pictures,
            } => {
                let (colour, picture) = triangles[triangle];
                let Some(picture) = picture else {
                    return colour.map(|x| x as f32);
                };
                let (texture, coordinates) = &pictures[picture];
                let texel = texture.at(point.mean(&coordinates[triangle]), 0.0);
                [0, 1, 2].map(|channel| colour[channel] * texel[channel])
            }
        };
        colour.map(|x| x as f32)
    }
}

/// The picture of a material, with the coordinates at which it is taken; `None` where the mesh has
/// no such coordinates, or, with a warning, where the picture does not exist.
fn picture(
    mesh: &Mesh,
    material: &Material,
    placed: &Texture,
    folder: Option<&Path>,
    warnings: &mut Vec<Warning>,
) -> Result<Option<Picture>, TextureError> {
    let Some(coordinates) = corner_coordinates(mesh, placed.set as usize) else {
        return Ok(None);
    };
    let texture = load_texture(&material.name, placed, Meaning::Colour, folder)?;
    if let (None, Image::File(path)) = (&texture, &placed.image) {
        let warning = Warning::MissingTexture {
            material: material.name.clone(),
            path: path.clone(),
        };
        warnings.push(warning);
    }
    let place = |corners: [[f64; 2]; 3]| corners.map(|coordinate| placed.place(coordinate));
    Ok(texture.map(|texture| (texture, coordinates.into_iter().map(place).collect())))
}
