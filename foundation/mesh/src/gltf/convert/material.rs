//! Between the materials of a document and those of a mesh.
//!
//! The coordinates of a mesh have v up, those of glTF v down. With D = diag(1, −1), e = (0, 1) and
//! the transform q = o + R S p in one of the two, the other has D R D in place of R, which rotates
//! the other way, and D (o + R S e) + e in place of o.

use std::sync::Arc;

use super::super::uri::{self, Uri};
use super::super::{self as gltf, Document, ImageSource, TextureInfo, TextureTransform};
use crate::{Image, Material, Texture};

/// The materials of a document, with their textures.
pub(super) fn to_materials(document: &Document) -> Vec<Material> {
    let images: Vec<Image> = document.images.iter().map(to_image).collect();
    let texture = |info: &Option<TextureInfo>| {
        let info = info.as_ref()?;
        let texture = &document.textures[info.texture];
        let image = images[texture.image?].clone();
        let sampler = texture.sampler.map(|sampler| &document.samplers[sampler]);
        Some(to_texture(info, image, sampler))
    };
    let material = |material: &gltf::MaterialElement| Material {
        name: material.name.clone().unwrap_or_default(),
        base_colour: material.base_colour.map(f64::from),
        base_colour_texture: texture(&material.base_colour_texture),
        metallic: material.metallic.into(),
        roughness: material.roughness.into(),
        metallic_roughness_texture: texture(&material.metallic_roughness_texture),
        normal_texture: texture(&material.normal_texture),
        normal_scale: material.normal_scale.into(),
        occlusion_texture: texture(&material.occlusion_texture),
        occlusion_strength: material.occlusion_strength.into(),
        emissive: material
            .emissive
            .map(|light| f64::from(light) * f64::from(material.emissive_strength)),
        emissive_texture: texture(&material.emissive_texture),
        alpha_mode: material.alpha_mode,
        double_sided: material.double_sided,
        unlit: material.unlit,
        phong: None,
    };
    document.materials.iter().map(material).collect()
}

fn to_image(image: &gltf::Image) -> Image {
    match &image.source {
        ImageSource::Bytes { media_type, bytes } => Image::Embedded {
            media_type: media_type.clone(),
            bytes: Arc::from(&bytes[..]),
        },
        ImageSource::Uri(text) => match uri::parse(text) {
            Some(Uri::File(path)) => Image::File(path.to_string_lossy().replace('\\', "/")),
            _ => Image::File(text.clone()),
        },
    }
}

fn to_texture(info: &TextureInfo, image: Image, sampler: Option<&gltf::Sampler>) -> Texture {
    let TextureTransform {
        offset: [u, v],
        rotation,
        scale,
        texcoord,
    } = info.transform.unwrap_or_default();
    let angle = f64::from(rotation);
    let [scale_u, scale_v] = scale.map(f64::from);
    let default = gltf::Sampler::default();
    let sampler = sampler.unwrap_or(&default);
    Texture {
        set: texcoord.unwrap_or(info.texcoord),
        offset: other_offset([u.into(), v.into()], angle, scale_v),
        rotation: angle,
        scale: [scale_u, scale_v],
        wrap: [sampler.wrap_u, sampler.wrap_v],
        magnification: sampler.magnification,
        minification: sampler.minification,
        ..Texture::new(image)
    }
}

/// The offset with v the other way: D (o + R S e) + e, where R (0, s) is (s sin α, s cos α) in
/// coordinates with v down. In those with v up the sine has the other sign, which D restores.
fn other_offset([u, v]: [f64; 2], angle: f64, scale_v: f64) -> [f64; 2] {
    // Exact where there is no rotation.
    let (sine, cosine) = if angle == 0.0 {
        (0.0, 1.0)
    } else {
        angle.sin_cos()
    };
    [u + scale_v * sine, 1.0 - v - scale_v * cosine]
}

/// Adds the materials of a mesh to a document, each image, sampler and texture once.
pub(super) fn from_materials(materials: &[Material], document: &mut Document) {
    for material in materials {
        let mut texture = |texture: &Option<Texture>| {
            texture
                .as_ref()
                .map(|texture| from_texture(texture, document))
        };
        let strength = material
            .emissive
            .iter()
            .fold(1.0f64, |most, &light| most.max(light));
        let material = gltf::MaterialElement {
            name: Some(material.name.clone()).filter(|name| !name.is_empty()),
            base_colour: material.base_colour.map(|c| c as f32),
            base_colour_texture: texture(&material.base_colour_texture),
            metallic: material.metallic as f32,
            roughness: material.roughness as f32,
            metallic_roughness_texture: texture(&material.metallic_roughness_texture),
            normal_texture: texture(&material.normal_texture),
            normal_scale: material.normal_scale as f32,
            occlusion_texture: texture(&material.occlusion_texture),
            occlusion_strength: material.occlusion_strength as f32,
            emissive: material.emissive.map(|light| (light / strength) as f32),
            emissive_strength: strength as f32,
            emissive_texture: texture(&material.emissive_texture),
            alpha_mode: material.alpha_mode,
            double_sided: material.double_sided,
            unlit: material.unlit,
            extras: None,
        };
        document.materials.push(material);
    }
}

/// The index of the material without the textures that use texture coordinates which a primitive
/// with only `sets` sets of them lacks; glTF forbids such textures. A copy of the material is added
/// to the document where it has any.
pub(super) fn with_sets(material: usize, sets: usize, document: &mut Document) -> usize {
    let mut copy = document.materials[material].clone();
    for texture in [
        &mut copy.base_colour_texture,
        &mut copy.metallic_roughness_texture,
        &mut copy.normal_texture,
        &mut copy.occlusion_texture,
        &mut copy.emissive_texture,
    ] {
        *texture = texture.filter(|texture| (texture.texcoord as usize) < sets);
    }
    if copy == document.materials[material] {
        return material;
    }
    index_of(copy, &mut document.materials)
}

fn from_texture(texture: &Texture, document: &mut Document) -> TextureInfo {
    let source = match &texture.image {
        Image::File(path) => ImageSource::Uri(uri::of_path(path)),
        Image::Embedded { media_type, bytes } => ImageSource::Bytes {
            media_type: media_type.clone(),
            bytes: bytes.to_vec(),
        },
    };
    let image = gltf::Image {
        name: None,
        source,
        extras: None,
    };
    let sampler = gltf::Sampler {
        name: None,
        magnification: texture.magnification,
        minification: texture.minification,
        wrap_u: texture.wrap[0],
        wrap_v: texture.wrap[1],
        extras: None,
    };
    let image = Some(index_of(image, &mut document.images));
    let sampler =
        (sampler != gltf::Sampler::default()).then(|| index_of(sampler, &mut document.samplers));
    let with_index = gltf::TextureElement {
        sampler,
        image,
        ..gltf::TextureElement::default()
    };
    let [scale_u, scale_v] = texture.scale;
    let [u, v] = texture.offset;
    // The inverse of `other_offset`.
    let [shift_u, shift_v] = other_offset([0.0; 2], texture.rotation, scale_v);
    let transform = TextureTransform {
        offset: [(u - shift_u) as f32, (shift_v - v) as f32],
        rotation: texture.rotation as f32,
        scale: [scale_u as f32, scale_v as f32],
        texcoord: None,
    };
    TextureInfo {
        texture: index_of(with_index, &mut document.textures),
        texcoord: texture.set,
        transform: Some(transform).filter(|transform| *transform != TextureTransform::default()),
    }
}

/// The index of an item in a list, to which it is added if it is not there.
fn index_of<T: PartialEq>(item: T, list: &mut Vec<T>) -> usize {
    match list.iter().position(|known| *known == item) {
        Some(index) => index,
        None => {
            list.push(item);
            list.len() - 1
        }
    }
}
