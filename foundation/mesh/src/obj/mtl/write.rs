//! Materials as the text of a library.

use std::fmt::Write;

use crate::{Image, Material, Texture, Wrap};

/// Materials as the text of an MTL file, each beside the name that `usemtl` lines give it.
///
/// Each is written in the terms of Phong's model, see [`Material::to_phong`], and with `Pr`, `Pm`,
/// `Ke` and `norm`, so that reading gives the same numbers back. MTL has no place for occlusion
/// textures, alpha cutoffs, double sides, filters, rotated textures and texture-coordinate sets
/// other than the first; these are left out. Embedded images get the path that `path_of` gives.
#[must_use]
pub fn encode<'a>(
    materials: impl IntoIterator<Item = (&'a str, &'a Material)>,
    path_of: impl Fn(&Image) -> String,
) -> String {
    let mut text = String::new();
    for (name, material) in materials {
        // Writing to a String cannot fail.
        let _ = write_material(&mut text, name, material, &path_of);
    }
    text
}

fn write_material(
    text: &mut String,
    name: &str,
    material: &Material,
    path_of: &impl Fn(&Image) -> String,
) -> std::fmt::Result {
    let phong = material.to_phong();
    if !text.is_empty() {
        text.push('\n');
    }
    writeln!(text, "newmtl {name}")?;
    let [red, green, blue, opacity] = material.base_colour;
    for (keyword, [red, green, blue]) in [
        ("Ka", phong.ambient),
        ("Kd", [red, green, blue]),
        ("Ks", phong.specular),
        ("Ke", material.emissive),
    ] {
        writeln!(text, "{keyword} {red:?} {green:?} {blue:?}")?;
    }
    writeln!(text, "Ns {:?}", phong.exponent)?;
    writeln!(text, "d {opacity:?}")?;
    if let Some(refraction) = phong.refraction {
        writeln!(text, "Ni {refraction:?}")?;
    }
    let illumination = match phong.illumination {
        _ if material.unlit => Some(0),
        Some(0) => None,
        other => other,
    };
    if let Some(illumination) = illumination {
        writeln!(text, "illum {illumination}")?;
    }
    writeln!(
        text,
        "Pr {:?}\nPm {:?}",
        material.roughness, material.metallic
    )?;

    let mut picture = |keyword: &str, texture: &Option<Texture>| -> std::fmt::Result {
        match texture {
            // MTL has no rotation and one set of texture coordinates.
            Some(texture) if texture.rotation == 0.0 && texture.set == 0 => {
                writeln!(
                    text,
                    "{keyword}{} {}",
                    options(texture),
                    path_of(&texture.image)
                )
            }
            _ => Ok(()),
        }
    };
    picture("map_Ka", &phong.ambient_texture)?;
    picture("map_Kd", &material.base_colour_texture)?;
    picture("map_Ks", &phong.specular_texture)?;
    picture("map_Ke", &material.emissive_texture)?;
    picture("map_Ns", &phong.exponent_texture)?;
    picture("map_d", &phong.opacity_texture)?;
    picture("bump", &phong.bump_texture)?;
    picture("map_Pr -imfchan g", &material.metallic_roughness_texture)?;
    picture("map_Pm -imfchan b", &material.metallic_roughness_texture)?;
    let normal = match material.normal_scale {
        1.0 => "norm".to_owned(),
        scale => format!("norm -bm {scale:?}"),
    };
    picture(&normal, &material.normal_texture)
}

fn options(texture: &Texture) -> String {
    let mut options = String::new();
    if texture.offset != [0.0; 2] {
        let [u, v] = texture.offset;
        options += &format!(" -o {u:?} {v:?} 0");
    }
    if texture.scale != [1.0; 2] {
        let [u, v] = texture.scale;
        options += &format!(" -s {u:?} {v:?} 1");
    }
    if texture.wrap == [Wrap::ClampToEdge; 2] {
        options += " -clamp on";
    }
    options
}
