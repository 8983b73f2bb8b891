//! The statements of an MTL file.

use super::MtlProblem;
use super::texture::{Picture, picture};
use crate::obj::lines::Lines;
use crate::words::{Words, numbers, text};
use crate::{AlphaMode, Material, Phong, Texture};

/// What is wrong with a line of a library, or ignored in it, and the line, from 1.
pub(in crate::obj) type Remark = (usize, MtlProblem);

/// The materials of a library, and what is ignored in it. The error is the first faulty line.
pub(in crate::obj) fn library(bytes: &[u8]) -> Result<(Vec<Material>, Vec<Remark>), Remark> {
    let mut parser = Parser::default();
    let mut warnings = Vec::new();
    for (line, text) in Lines::new(bytes) {
        parser.statement(&text).map_err(|problem| (line, problem))?;
        let ignored = parser.ignored.drain(..);
        warnings.extend(ignored.map(|problem| (line, problem)));
    }
    parser.close();
    Ok((parser.materials, warnings))
}

#[derive(Default)]
struct Parser {
    materials: Vec<Material>,
    open: Option<Open>,
    /// What is ignored in the line being read.
    ignored: Vec<MtlProblem>,
}

/// The material being read.
struct Open {
    material: Material,
    phong: Phong,
    /// Whether the file states anything of `phong`.
    has_phong: bool,
    has_roughness: bool,
    roughness_picture: Option<Picture>,
    metallic_picture: Option<Picture>,
}

impl Open {
    fn new(name: String) -> Self {
        Self {
            material: Material::named(name),
            phong: Phong::default(),
            has_phong: false,
            has_roughness: false,
            roughness_picture: None,
            metallic_picture: None,
        }
    }

    fn finish(self) -> Material {
        let mut material = self.material;
        if !self.has_roughness {
            material.roughness = match self.phong.illumination {
                // Diffuse reflection alone.
                Some(0 | 1) => 1.0,
                _ => Material::roughness_of_exponent(self.phong.exponent),
            };
        }
        if material.base_colour[3] < 1.0 || self.phong.opacity_texture.is_some() {
            material.alpha_mode = AlphaMode::Blend;
        }
        material.unlit = self.phong.illumination == Some(0);
        if let (Some(roughness), Some(metallic)) = (self.roughness_picture, self.metallic_picture)
            && roughness.texture.image == metallic.texture.image
            && roughness.channel.as_deref() == Some("g")
            && metallic.channel.as_deref() == Some("b")
        {
            material.metallic_roughness_texture = Some(roughness.texture);
        }
        if self.has_phong {
            material.phong = Some(self.phong);
        }
        material
    }

    /// The picture of Phong's model that a statement stands for.
    fn phong_picture(&mut self, statement: &str) -> Option<&mut Option<Texture>> {
        let phong = &mut self.phong;
        let picture = match statement {
            "map_Ka" => &mut phong.ambient_texture,
            "map_Ks" => &mut phong.specular_texture,
            "map_Ns" => &mut phong.exponent_texture,
            "map_d" => &mut phong.opacity_texture,
            "bump" | "map_bump" | "map_Bump" => &mut phong.bump_texture,
            _ => return None,
        };
        self.has_phong = true;
        Some(picture)
    }
}

impl Parser {
    fn close(&mut self) {
        self.materials.extend(self.open.take().map(Open::finish));
    }

    fn statement(&mut self, line: &[u8]) -> Result<(), MtlProblem> {
        let mut words = Words::new(line);
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        let keyword = text(keyword)?;
        if keyword == "newmtl" {
            let name = words.joined()?;
            if name.is_empty() {
                return Err(MtlProblem::NoName);
            }
            self.close();
            self.open = Some(Open::new(name));
            return Ok(());
        }
        let known = matches!(
            keyword,
            "Ka" | "Kd" | "Ks" | "Ke" | "illum" | "d" | "Tr" | "Ns"
        ) || matches!(keyword, "Ni" | "Pr" | "Pm" | "norm" | "bump")
            || keyword.starts_with("map_");
        let Some(open) = &mut self.open else {
            if !known {
                return Ok(());
            }
            let statement = keyword.to_owned();
            return Err(MtlProblem::NoMaterial { statement });
        };
        property(open, keyword, &mut words, &mut self.ignored)
    }
}

fn property(
    open: &mut Open,
    keyword: &str,
    words: &mut Words<'_>,
    ignored: &mut Vec<MtlProblem>,
) -> Result<(), MtlProblem> {
    let texture = |picture: Option<Picture>| picture.map(|picture| picture.texture);
    let fraction = |value: f64| value.clamp(0.0, 1.0);
    let not_negative = |value: f64| value.max(0.0);
    match keyword {
        "Kd" => {
            let [red, green, blue] = colour(keyword, words)?.map(fraction);
            open.material.base_colour = [red, green, blue, open.material.base_colour[3]];
        }
        "Ke" => open.material.emissive = colour(keyword, words)?.map(not_negative),
        "Ka" => {
            open.phong.ambient = colour(keyword, words)?.map(not_negative);
            open.has_phong = true;
        }
        "Ks" => {
            open.phong.specular = colour(keyword, words)?.map(not_negative);
            open.has_phong = true;
        }
        "Ns" => {
            open.phong.exponent = not_negative(one_number(keyword, words)?);
            open.has_phong = true;
        }
        "Ni" => {
            open.phong.refraction = Some(not_negative(one_number(keyword, words)?));
            open.has_phong = true;
        }
        "illum" => {
            open.phong.illumination = Some(one_number(keyword, words)?.clamp(0.0, 10.0) as u8);
            open.has_phong = true;
        }
        "d" => {
            if words.rest().is_some_and(|rest| rest.starts_with(b"-halo")) {
                words.next();
            }
            open.material.base_colour[3] = fraction(one_number(keyword, words)?);
        }
        "Tr" => open.material.base_colour[3] = fraction(1.0 - one_number(keyword, words)?),
        "Pr" => {
            open.material.roughness = fraction(one_number(keyword, words)?);
            open.has_roughness = true;
        }
        "Pm" => open.material.metallic = fraction(one_number(keyword, words)?),
        "map_Kd" => {
            open.material.base_colour_texture = texture(picture(keyword, words, ignored)?);
        }
        "map_Ke" => {
            open.material.emissive_texture = texture(picture(keyword, words, ignored)?);
        }
        "norm" | "map_Kn" => {
            if let Some(picture) = picture(keyword, words, ignored)? {
                open.material.normal_scale = picture.bump;
                open.material.normal_texture = Some(picture.texture);
            }
        }
        "map_Pr" => open.roughness_picture = picture(keyword, words, ignored)?,
        "map_Pm" => open.metallic_picture = picture(keyword, words, ignored)?,
        _ => {
            if let Some(slot) = open.phong_picture(keyword) {
                *slot = texture(picture(keyword, words, ignored)?);
            }
        }
    }
    Ok(())
}

fn one_number(statement: &str, words: &mut Words<'_>) -> Result<f64, MtlProblem> {
    let ([value], found) = numbers::<1>(words)?;
    if found == 1 {
        return Ok(value);
    }
    Err(MtlProblem::WrongCount {
        statement: statement.to_owned(),
        expected: "one number",
        found,
    })
}

/// Red, green and blue, or one number for all three.
fn colour(statement: &str, words: &mut Words<'_>) -> Result<[f64; 3], MtlProblem> {
    if let Some(kind @ (b"spectral" | b"xyz")) = words.clone().next() {
        return Err(MtlProblem::ColourKind {
            statement: statement.to_owned(),
            kind: text(kind)?.to_owned(),
        });
    }
    let (colour, found) = numbers::<3>(words)?;
    match found {
        1 => Ok([colour[0]; 3]),
        3 => Ok(colour),
        _ => Err(MtlProblem::WrongCount {
            statement: statement.to_owned(),
            expected: "1 or 3 numbers",
            found,
        }),
    }
}
