//! Materials, textures and images.

use super::Extras;
use crate::{AlphaMode, Filter, Minification, Wrap};

/// The appearance of a surface, by the model of metalness and roughness.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialElement {
    /// Its name.
    pub name: Option<String>,
    /// Red, green, blue as linear light, and alpha: a factor of the base colour's texture and of
    /// the colours of vertices.
    pub base_colour: [f32; 4],
    /// The texture of the base colour, in sRGB.
    pub base_colour_texture: Option<TextureInfo>,
    /// 0 for a dielectric, 1 for a metal: a factor of the texture's blue.
    pub metallic: f32,
    /// 0 for a mirror, 1 for chalk: a factor of the texture's green.
    pub roughness: f32,
    /// The texture of metalness (blue) and roughness (green).
    pub metallic_roughness_texture: Option<TextureInfo>,
    /// Normals in the frame of the tangents, each number as (n + 1) / 2.
    pub normal_texture: Option<TextureInfo>,
    /// A factor of the x and y of those normals.
    pub normal_scale: f32,
    /// The share of ambient light that arrives, in red.
    pub occlusion_texture: Option<TextureInfo>,
    /// How much of that texture counts, 0 to 1.
    pub occlusion_strength: f32,
    /// The light that the surface sends out: red, green, blue, 0 to 1, a factor of its texture.
    pub emissive: [f32; 3],
    /// A factor of that light, by `KHR_materials_emissive_strength`.
    pub emissive_strength: f32,
    /// The texture of that light, in sRGB.
    pub emissive_texture: Option<TextureInfo>,
    /// What alpha means.
    pub alpha_mode: AlphaMode,
    /// Whether the back of the surface is seen too.
    pub double_sided: bool,
    /// Whether the base colour is shown as it is, without light, by `KHR_materials_unlit`.
    pub unlit: bool,
    /// Data of an application.
    pub extras: Extras,
}

/// A texture, and where on the surface it lies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TextureInfo {
    /// The texture.
    pub texture: usize,
    /// The set of texture coordinates.
    pub texcoord: u32,
    /// A change of those coordinates, by `KHR_texture_transform`.
    pub transform: Option<TextureTransform>,
}

/// The change of texture coordinates x ↦ offset + R (scale · x), where R rotates by −angle in
/// coordinates with v down, so counter-clockwise on the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureTransform {
    /// The displacement.
    pub offset: [f32; 2],
    /// The angle in radians.
    pub rotation: f32,
    /// The factor of u and of v.
    pub scale: [f32; 2],
    /// The set of texture coordinates, in place of [`TextureInfo::texcoord`].
    pub texcoord: Option<u32>,
}

/// An image, and how it is sampled.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TextureElement {
    /// Its name.
    pub name: Option<String>,
    /// The sampler; that of [`Sampler::default`] where absent.
    pub sampler: Option<usize>,
    /// The image.
    pub image: Option<usize>,
    /// Data of an application.
    pub extras: Extras,
}

/// How a texture is sampled between and beyond its pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sampler {
    /// Its name.
    pub name: Option<String>,
    /// Where a pixel of the texture covers several of the picture.
    pub magnification: Option<Filter>,
    /// Where a pixel of the picture covers several of the texture.
    pub minification: Option<Minification>,
    /// Beyond the image along u.
    pub wrap_u: Wrap,
    /// Beyond the image along v.
    pub wrap_v: Wrap,
    /// Data of an application.
    pub extras: Extras,
}

/// An image.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Its name.
    pub name: Option<String>,
    /// Where its bytes are.
    pub source: ImageSource,
    /// Data of an application.
    pub extras: Extras,
}

/// Where the bytes of an image are.
#[derive(Clone, Debug, PartialEq)]
pub enum ImageSource {
    /// In a file, named by a URI relative to the glTF file. The reader does not open it; see
    /// [`Document::read_images`](super::Document::read_images).
    Uri(String),
    /// Here, as a file of the named media type, `image/png` or `image/jpeg`.
    Bytes {
        /// The media type.
        media_type: String,
        /// The bytes.
        bytes: Vec<u8>,
    },
}

impl Default for MaterialElement {
    /// The material of a primitive without one: a white metal, perfectly rough.
    fn default() -> Self {
        Self {
            name: None,
            base_colour: [1.0; 4],
            base_colour_texture: None,
            metallic: 1.0,
            roughness: 1.0,
            metallic_roughness_texture: None,
            normal_texture: None,
            normal_scale: 1.0,
            occlusion_texture: None,
            occlusion_strength: 1.0,
            emissive: [0.0; 3],
            emissive_strength: 1.0,
            emissive_texture: None,
            alpha_mode: AlphaMode::Opaque,
            double_sided: false,
            unlit: false,
            extras: None,
        }
    }
}

impl MaterialElement {
    /// The textures that the material uses.
    pub(super) fn textures(&self) -> impl Iterator<Item = &TextureInfo> {
        [
            &self.base_colour_texture,
            &self.metallic_roughness_texture,
            &self.normal_texture,
            &self.occlusion_texture,
            &self.emissive_texture,
        ]
        .into_iter()
        .flatten()
    }
}

impl Default for TextureTransform {
    fn default() -> Self {
        Self {
            offset: [0.0; 2],
            rotation: 0.0,
            scale: [1.0; 2],
            texcoord: None,
        }
    }
}
