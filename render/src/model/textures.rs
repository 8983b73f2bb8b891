//! The pictures of a model's materials.

use std::collections::HashMap;
use std::path::Path;

use ga_files::ReadError;
use ga_image::colour::LinearColour;
use ga_image::file::DecodeError;
use ga_image::picture::Picture;
use ga_mesh::{AlphaMode, Filter as MeshFilter, Image, Minification, Texture as Reference, Wrap};

use super::{Model, Surface};
use crate::Material;
use crate::texture::{Filter, Sampler, Texture, TextureError};

/// A picture of a material that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TextureFileError {
    /// The file cannot be read, or is not a picture.
    #[error("the picture of material {material:?}: {problem}")]
    File {
        /// The name of the material.
        material: String,
        /// What is wrong; it names the file.
        problem: ReadError<DecodeError>,
    },
    /// A picture within the file of the model is not a picture.
    #[error("the picture of material {material:?}: {problem}")]
    Embedded {
        /// The name of the material.
        material: String,
        /// What is wrong.
        problem: DecodeError,
    },
    /// The picture has no pixels.
    #[error("the picture of material {material:?}: {problem}")]
    Texture {
        /// The name of the material.
        material: String,
        /// What is wrong.
        problem: TextureError,
    },
}

/// What the numbers of a picture mean.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Meaning {
    /// Colours, encoded as sRGB.
    Colour,
    /// Plain numbers.
    Data,
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
    ) -> Result<Surface, TextureFileError> {
        let name = &material.name;
        if material.alpha_mode == AlphaMode::Blend {
            let warning = format!("material {name:?} is transparent; it is drawn opaque");
            self.model.warnings.push(warning);
        }
        let [red, green, blue, opacity] = material.base_colour;
        let mut load = |reference: &Option<Reference>, meaning| match reference {
            Some(reference) => self.texture(name, reference, meaning),
            None => Ok(None),
        };
        Ok(Surface {
            base_colour: load(&material.base_colour_texture, Meaning::Colour)?,
            metallic_roughness: load(&material.metallic_roughness_texture, Meaning::Data)?,
            normal: load(&material.normal_texture, Meaning::Data)?,
            occlusion: load(&material.occlusion_texture, Meaning::Data)?,
            emission: load(&material.emissive_texture, Meaning::Colour)?,
            material: Material {
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
                unlit: material.unlit,
                ..Material::default()
            },
        })
    }

    fn texture(
        &mut self,
        material: &str,
        reference: &Reference,
        meaning: Meaning,
    ) -> Result<Option<usize>, TextureFileError> {
        let key = match &reference.image {
            Image::File(path) => path.clone(),
            // Textures of one image share its bytes.
            Image::Embedded { bytes, .. } => format!("{:p}", bytes.as_ptr()),
        };
        let sampler = sampler(
            reference.wrap,
            reference.magnification,
            reference.minification,
        );
        let key = (key, meaning, sampler);
        if let Some(&texture) = self.loaded.get(&key) {
            return Ok(texture);
        }
        let index = match self.picture(material, &reference.image)? {
            None => None,
            Some(picture) => {
                let pixels = picture.to_rgba::<u16>();
                let texture = match meaning {
                    Meaning::Colour => Texture::colour(&pixels, sampler),
                    Meaning::Data => Texture::data(&pixels, sampler),
                };
                let texture = texture.map_err(|problem| TextureFileError::Texture {
                    material: material.to_owned(),
                    problem,
                })?;
                self.model.textures.push(texture);
                Some(self.model.textures.len() - 1)
            }
        };
        self.loaded.insert(key, index);
        Ok(index)
    }

    fn picture(
        &mut self,
        material: &str,
        image: &Image,
    ) -> Result<Option<Picture>, TextureFileError> {
        match image {
            Image::File(path) => self.file(material, path),
            Image::Embedded { bytes, .. } => decode(material, bytes).map(Some),
        }
    }

    /// The picture in a file; `None`, with a warning, where it does not exist.
    fn file(&mut self, material: &str, path: &str) -> Result<Option<Picture>, TextureFileError> {
        let file = self.folder.map(|folder| folder.join(path));
        match file.filter(|file| file.exists()) {
            Some(file) => {
                let picture = ga_image::file::read(file);
                picture.map(Some).map_err(|problem| TextureFileError::File {
                    material: material.to_owned(),
                    problem,
                })
            }
            None => {
                self.model.warnings.push(format!(
                    "material {material:?}: there is no picture {path}; the surface is shown \
                     without it"
                ));
                Ok(None)
            }
        }
    }
}

/// The picture in the bytes of a file.
fn decode(material: &str, bytes: &[u8]) -> Result<Picture, TextureFileError> {
    ga_image::file::decode(bytes).map_err(|problem| TextureFileError::Embedded {
        material: material.to_owned(),
        problem,
    })
}

fn sampler(
    wrap: [Wrap; 2],
    magnification: Option<MeshFilter>,
    minification: Option<Minification>,
) -> Sampler {
    let filter = match (magnification, minification) {
        (Some(MeshFilter::Nearest), _) => Filter::Nearest,
        (_, Some(minification)) if minification.levels.is_none() => Filter::Bilinear,
        _ => Filter::Trilinear,
    };
    Sampler { wrap, filter }
}
