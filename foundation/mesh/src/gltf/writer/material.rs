//! Materials, textures and samplers.

use super::super::{Document, MaterialElement, Sampler, TextureElement, TextureInfo, json};
use crate::{AlphaMode, Filter, Minification, Wrap};

/// The names of the extensions that the materials use.
pub(super) fn extensions(document: &Document) -> Vec<String> {
    let materials = &document.materials;
    let has_transform = |material: &MaterialElement| {
        let mut textures = material.textures();
        textures.any(|info| info.transform.is_some())
    };
    let used = [
        (
            "KHR_materials_emissive_strength",
            materials
                .iter()
                .any(|material| material.emissive_strength != 1.0),
        ),
        (
            "KHR_materials_unlit",
            materials.iter().any(|material| material.unlit),
        ),
        ("KHR_texture_transform", materials.iter().any(has_transform)),
    ];
    used.into_iter()
        .filter(|(_, is_used)| *is_used)
        .map(|(name, _)| name.to_owned())
        .collect()
}

pub(super) fn material(material: &MaterialElement) -> json::Material {
    let default = MaterialElement::default();
    let info = |texture: &Option<TextureInfo>| texture.as_ref().map(texture_info);
    let pbr = json::PbrMetallicRoughness {
        base_color_factor: changed(material.base_colour, default.base_colour),
        base_color_texture: info(&material.base_colour_texture),
        metallic_factor: changed(material.metallic, default.metallic),
        roughness_factor: changed(material.roughness, default.roughness),
        metallic_roughness_texture: info(&material.metallic_roughness_texture),
    };
    let normal_scale = changed(material.normal_scale, default.normal_scale);
    let strength = changed(material.occlusion_strength, default.occlusion_strength);
    let emissive_strength = changed(material.emissive_strength, default.emissive_strength);
    let (mode, cutoff) = match material.alpha_mode {
        AlphaMode::Opaque => (None, None),
        AlphaMode::Mask { cutoff } => (Some("MASK"), changed(cutoff as f32, 0.5)),
        AlphaMode::Blend => (Some("BLEND"), None),
    };
    json::Material {
        name: material.name.clone(),
        pbr_metallic_roughness: changed(pbr, json::PbrMetallicRoughness::default()),
        normal_texture: info(&material.normal_texture).map(|info| json::TextureInfo {
            scale: normal_scale,
            ..info
        }),
        occlusion_texture: info(&material.occlusion_texture)
            .map(|info| json::TextureInfo { strength, ..info }),
        emissive_texture: info(&material.emissive_texture),
        emissive_factor: changed(material.emissive, default.emissive),
        alpha_mode: mode.map(str::to_owned),
        alpha_cutoff: cutoff,
        double_sided: material.double_sided,
        extensions: json::MaterialExtensions {
            unlit: material.unlit.then(json::Empty::default),
            emissive_strength: emissive_strength.map(|strength| json::EmissiveStrength {
                emissive_strength: Some(strength),
            }),
        },
        extras: material.extras.clone(),
    }
}

/// A value, unless it is the default.
fn changed<T: PartialEq>(value: T, default: T) -> Option<T> {
    (value != default).then_some(value)
}

fn texture_info(info: &TextureInfo) -> json::TextureInfo {
    let transform = info.transform.map(|transform| json::TextureTransform {
        offset: changed(transform.offset, [0.0; 2]),
        rotation: changed(transform.rotation, 0.0),
        scale: changed(transform.scale, [1.0; 2]),
        tex_coord: transform.texcoord,
    });
    json::TextureInfo {
        index: info.texture,
        tex_coord: info.texcoord,
        scale: None,
        strength: None,
        extensions: json::TextureInfoExtensions { transform },
    }
}

pub(super) fn texture(texture: &TextureElement) -> json::Texture {
    json::Texture {
        name: texture.name.clone(),
        sampler: texture.sampler,
        source: texture.image,
        extras: texture.extras.clone(),
    }
}

pub(super) fn sampler(sampler: &Sampler) -> json::Sampler {
    json::Sampler {
        name: sampler.name.clone(),
        mag_filter: sampler.magnification.map(Filter::code),
        min_filter: sampler.minification.map(Minification::code),
        wrap_s: changed(sampler.wrap_u, Wrap::Repeat).map(Wrap::code),
        wrap_t: changed(sampler.wrap_v, Wrap::Repeat).map(Wrap::code),
        extras: sampler.extras.clone(),
    }
}
