//! Materials, textures and samplers.

use super::super::problem::{Element, Problem};
use super::super::{MaterialElement, Sampler, TextureElement, TextureInfo, TextureTransform, json};
use crate::{AlphaMode, Filter, FormatError, Minification, Wrap};

pub(super) fn material(
    index: usize,
    json: &json::Material,
) -> Result<MaterialElement, FormatError> {
    let default = MaterialElement::default();
    let pbr = json.pbr_metallic_roughness.as_ref();
    let info = |info: &Option<json::TextureInfo>| info.as_ref().map(texture_info);
    let strength = json.extensions.emissive_strength.as_ref();
    Ok(MaterialElement {
        name: json.name.clone(),
        base_colour: pbr
            .and_then(|pbr| pbr.base_color_factor)
            .unwrap_or(default.base_colour),
        base_colour_texture: pbr.and_then(|pbr| info(&pbr.base_color_texture)),
        metallic: pbr
            .and_then(|pbr| pbr.metallic_factor)
            .unwrap_or(default.metallic),
        roughness: pbr
            .and_then(|pbr| pbr.roughness_factor)
            .unwrap_or(default.roughness),
        metallic_roughness_texture: pbr.and_then(|pbr| info(&pbr.metallic_roughness_texture)),
        normal_texture: info(&json.normal_texture),
        normal_scale: json
            .normal_texture
            .as_ref()
            .and_then(|texture| texture.scale)
            .unwrap_or(default.normal_scale),
        occlusion_texture: info(&json.occlusion_texture),
        occlusion_strength: json
            .occlusion_texture
            .as_ref()
            .and_then(|texture| texture.strength)
            .unwrap_or(default.occlusion_strength),
        emissive: json.emissive_factor.unwrap_or(default.emissive),
        emissive_strength: strength
            .and_then(|extension| extension.emissive_strength)
            .unwrap_or(default.emissive_strength),
        emissive_texture: info(&json.emissive_texture),
        alpha_mode: match json.alpha_mode.as_deref() {
            None | Some("OPAQUE") => AlphaMode::Opaque,
            Some("MASK") => AlphaMode::Mask {
                cutoff: json.alpha_cutoff.unwrap_or(0.5).into(),
            },
            Some("BLEND") => AlphaMode::Blend,
            Some(other) => {
                let (property, value) = ("alphaMode", other.to_owned());
                let problem = Problem::Value { property, value };
                return Err(FormatError::gltf(Element::Material(index), problem));
            }
        },
        double_sided: json.double_sided,
        unlit: json.extensions.unlit.is_some(),
        extras: json.extras.clone(),
    })
}

fn texture_info(json: &json::TextureInfo) -> TextureInfo {
    let transform = |json: &json::TextureTransform| {
        let default = TextureTransform::default();
        TextureTransform {
            offset: json.offset.unwrap_or(default.offset),
            rotation: json.rotation.unwrap_or(default.rotation),
            scale: json.scale.unwrap_or(default.scale),
            texcoord: json.tex_coord,
        }
    };
    TextureInfo {
        texture: json.index,
        texcoord: json.tex_coord,
        transform: json.extensions.transform.as_ref().map(transform),
    }
}

pub(super) fn texture(json: &json::Texture) -> TextureElement {
    TextureElement {
        name: json.name.clone(),
        sampler: json.sampler,
        image: json.source,
        extras: json.extras.clone(),
    }
}

pub(super) fn sampler(index: usize, json: &json::Sampler) -> Result<Sampler, FormatError> {
    let code = |property, code: u64| {
        let value = code.to_string();
        FormatError::gltf(Element::Sampler(index), Problem::Value { property, value })
    };
    let wrap = |property, wrap: Option<u64>| match wrap {
        None => Ok(Wrap::Repeat),
        Some(wrap) => Wrap::from_code(wrap).ok_or_else(|| code(property, wrap)),
    };
    let magnification = json
        .mag_filter
        .map(|filter| Filter::from_code(filter).ok_or_else(|| code("magFilter", filter)));
    let minification = json
        .min_filter
        .map(|filter| Minification::from_code(filter).ok_or_else(|| code("minFilter", filter)));
    Ok(Sampler {
        name: json.name.clone(),
        magnification: magnification.transpose()?,
        minification: minification.transpose()?,
        wrap_u: wrap("wrapS", json.wrap_s)?,
        wrap_v: wrap("wrapT", json.wrap_t)?,
        extras: json.extras.clone(),
    })
}
