//! The pictures of materials.

use std::collections::HashMap;
use std::path::Path;

use ga_image::colour::LinearColour;
use ga_mesh::obj::Warning;
use ga_mesh::{AlphaMode, Filter as MeshFilter, Image, Texture};

use super::{Model, Surface};
use crate::texture::{Filter, Mipmap, Sampler, TextureError};
use crate::{Appearance, CoordinateSet, Placement, Placements};

/// What the numbers of a picture mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Meaning {
    /// Colours, encoded as sRGB.
    Colour,
    /// Plain numbers.
    Data,
}

/// The picture of a texture of a mesh, with the texture's wrap modes and filter, at the depth of
/// its file. Its place on the surface is that of [`ga_mesh::Texture::place`], which is left to the
/// caller.
///
/// The file is looked for in `folder`. `None` where it does not exist, or without a folder; errors
/// name the `material`.
///
/// ```
/// use ga_render::model::{Meaning, load_texture};
///
/// let wood = ga_mesh::Texture::file("wood.png");
/// let folder = std::env::temp_dir().join("a folder without pictures");
/// assert_eq!(load_texture("floor", &wood, Meaning::Colour, Some(&folder))?, None);
/// # Ok::<(), ga_render::texture::TextureError>(())
/// ```
///
/// # Errors
///
/// [`TextureError`] for a picture that exists and cannot be read.
pub fn load_texture(
    material: &str,
    reference: &Texture,
    meaning: Meaning,
    folder: Option<&Path>,
) -> Result<Option<Mipmap>, TextureError> {
    let material = || material.to_owned();
    let picture = match &reference.image {
        Image::File(path) => {
            let file = folder.map(|folder| folder.join(path));
            let Some(file) = file.filter(|file| file.exists()) else {
                return Ok(None);
            };
            ga_image::file::read(file).map_err(|problem| TextureError::File {
                material: material(),
                problem,
            })?
        }
        Image::Embedded { bytes, .. } => {
            ga_image::file::decode(bytes).map_err(|problem| TextureError::Embedded {
                material: material(),
                problem,
            })?
        }
    };
    let pixels = picture.to_rgba::<u16>();
    let texture = match meaning {
        Meaning::Colour => Mipmap::colour(&pixels, sampler(reference)),
        Meaning::Data => Mipmap::data(&pixels, sampler(reference)),
    };
    texture.map(Some).map_err(|problem| TextureError::Pixels {
        material: material(),
        problem: Box::new(problem),
    })
}

/// Loads each picture once for each way in which it is read.
pub(super) struct Loader<'a> {
    model: &'a mut Model,
    folder: Option<&'a Path>,
    loaded: HashMap<(String, Meaning, Sampler), Option<usize>>,
}

impl<'a> Loader<'a> {
    /// Files of pictures are looked for in `folder`; without one, their materials have no textures.
    pub(super) fn new(model: &'a mut Model, folder: Option<&'a Path>) -> Self {
        Self {
            model,
            folder,
            loaded: HashMap::new(),
        }
    }

    /// A material with its pictures.
    pub(super) fn surface(
        &mut self,
        material: &ga_mesh::Material,
    ) -> Result<Surface, TextureError> {
        let name = &material.name;
        let used = [
            ("base colour", &material.base_colour_texture),
            ("roughness", &material.metallic_roughness_texture),
            ("normals", &material.normal_texture),
            ("occlusion", &material.occlusion_texture),
            ("emission", &material.emissive_texture),
        ];
        for (what, texture) in used {
            if texture.as_ref().is_some_and(|texture| texture.set > 1) {
                self.model.warnings.push(format!(
                    "material {name:?}: the texture of its {what} is placed by a third or later \
                     set of texture coordinates; the first set is used"
                ));
            }
        }
        let placement =
            |texture: &Option<Texture>| texture.as_ref().map(placement).unwrap_or_default();
        let placements = Placements {
            base_colour: placement(&material.base_colour_texture),
            metallic_roughness: placement(&material.metallic_roughness_texture),
            normal: placement(&material.normal_texture),
            occlusion: placement(&material.occlusion_texture),
            emission: placement(&material.emissive_texture),
        };
        let [red, green, blue, opacity] = material.base_colour;
        let mut load = |reference: &Option<Texture>, meaning| match reference {
            Some(reference) => self.texture(name, reference, meaning),
            None => Ok(None),
        };
        Ok(Surface {
            base_colour: load(&material.base_colour_texture, Meaning::Colour)?,
            metallic_roughness: load(&material.metallic_roughness_texture, Meaning::Data)?,
            normal: load(&material.normal_texture, Meaning::Data)?,
            occlusion: load(&material.occlusion_texture, Meaning::Data)?,
            emission: load(&material.emissive_texture, Meaning::Colour)?,
            material: Appearance {
                base_colour: LinearColour::new(red, green, blue),
                opacity,
                metallic: material.metallic,
                roughness: material.roughness,
                normal_scale: material.normal_scale,
                occlusion_strength: material.occlusion_strength,
                emission: LinearColour::from(material.emissive),
                cutoff: match material.alpha_mode {
                    AlphaMode::Mask { cutoff } => Some(cutoff),
                    AlphaMode::Opaque | AlphaMode::Blend => None,
                },
                transparent: material.alpha_mode == AlphaMode::Blend,
                double_sided: material.double_sided,
                unlit: material.unlit,
                placements,
                ..Appearance::default()
            },
        })
    }

    fn texture(
        &mut self,
        material: &str,
        reference: &Texture,
        meaning: Meaning,
    ) -> Result<Option<usize>, TextureError> {
        let key = match &reference.image {
            Image::File(path) => path.clone(),
            // Textures of one image share its bytes.
            Image::Embedded { bytes, .. } => format!("{:p}", bytes.as_ptr()),
        };
        let key = (key, meaning, sampler(reference));
        if let Some(&texture) = self.loaded.get(&key) {
            return Ok(texture);
        }
        let index = match load_texture(material, reference, meaning, self.folder)? {
            Some(texture) => {
                self.model.textures.push(texture);
                Some(self.model.textures.len() - 1)
            }
            None => {
                if let Image::File(path) = &reference.image {
                    let warning = Warning::MissingTexture {
                        material: material.to_owned(),
                        path: path.clone(),
                    };
                    self.model.warnings.push(warning.to_string());
                }
                None
            }
        };
        self.loaded.insert(key, index);
        Ok(index)
    }
}

/// [`Texture::place`] as a matrix and an offset.
fn placement(texture: &Texture) -> Placement {
    let offset = texture.place([0.0; 2]);
    let [u, v] = [[1.0, 0.0], [0.0, 1.0]].map(|unit| {
        let moved = texture.place(unit);
        [0, 1].map(|axis| moved[axis] - offset[axis])
    });
    Placement {
        set: match texture.set {
            1 => CoordinateSet::Second,
            _ => CoordinateSet::First,
        },
        matrix: [[u[0], v[0]], [u[1], v[1]]],
        offset,
    }
}

fn sampler(reference: &Texture) -> Sampler {
    let filter = match (reference.magnification, reference.minification) {
        (Some(MeshFilter::Nearest), _) => Filter::Nearest,
        (_, Some(minification)) if minification.levels.is_none() => Filter::Bilinear,
        _ => Filter::Trilinear,
    };
    Sampler {
        wrap: reference.wrap,
        filter,
    }
}
