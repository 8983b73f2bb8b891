//! The statements of an MTL file.

use ga_files::{Deviation, Reading};

use super::MtlProblem;
use super::remarks::Remarks;
use super::texture::{Picture, picture};
use crate::obj::lines::Lines;
use crate::obj::text::{self, Text};
use crate::words::{Words, numbers, text};
use crate::{AlphaMode, Material, Phong, Texture};

/// What is wrong with a line of a library, and the line, from 1.
pub(in crate::obj) type Fault = (usize, MtlProblem);

/// The materials of a library, and what in it deviates from the format.
pub(in crate::obj) type Library = (Vec<Material>, Vec<Deviation<MtlProblem>>);

/// The contents of a library. The error is the first faulty line.
pub(in crate::obj) fn library(bytes: &[u8], reading: Reading) -> Result<Library, Fault> {
    let Text { text, foreign } = text::decode(bytes).map_err(|line| (line, MtlProblem::NotText))?;
    let mut parser = Parser {
        materials: Vec::new(),
        open: None,
        is_nameless: false,
        remarks: Remarks::new(reading),
    };
    let deviations = &mut parser.remarks.deviations;
    if let Some(foreign) = foreign {
        let (line, encoding) = (foreign.first_line, foreign.encoding);
        let problem = MtlProblem::NotUtf8 { encoding };
        let tolerated = deviations.tolerate_times(line, foreign.count, problem);
        tolerated.map_err(|problem| (line, problem))?;
    }
    let mut lines = Lines::new(&text);
    for (line, text) in lines.by_ref() {
        parser.remarks.line = line;
        parser.statement(&text).map_err(|problem| (line, problem))?;
    }
    parser.close();
    let mut deviations = parser.remarks.deviations;
    if let Some((line, count)) = lines.returns() {
        let tolerated = deviations.tolerate_times(line, count, MtlProblem::CarriageReturns);
        tolerated.map_err(|problem| (line, problem))?;
    }
    Ok((parser.materials, deviations.into_list()))
}

struct Parser {
    materials: Vec<Material>,
    open: Option<Open>,
    /// Whether the lines belong to a material without a name, which is left out.
    is_nameless: bool,
    remarks: Remarks,
}

/// The material being read.
struct Open {
    material: Material,
    phong: Phong,
    /// Whether the file states anything of `phong`.
    has_phong: bool,
    has_roughness: bool,
    /// The opacities by `d` and by `Tr`.
    opacities: [Option<f64>; 2],
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
            opacities: [None; 2],
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

    fn set_number(&mut self, statement: &str, value: f64, remarks: &mut Remarks) {
        let (fraction, not_negative) = (value.clamp(0.0, 1.0), value.max(0.0));
        match statement {
            "Pm" => self.material.metallic = fraction,
            "Pr" => {
                self.material.roughness = fraction;
                self.has_roughness = true;
            }
            "d" => self.opacities[0] = Some(fraction),
            "Tr" => self.opacities[1] = Some((1.0 - value).clamp(0.0, 1.0)),
            _ => {
                self.has_phong = true;
                match statement {
                    "Ns" => self.phong.exponent = not_negative,
                    "Ni" => self.phong.refraction = Some(not_negative),
                    _ => self.phong.illumination = Some(value.clamp(0.0, 10.0) as u8),
                }
            }
        }
        if let [Some(opaque), Some(other)] = self.opacities
            && matches!(statement, "d" | "Tr")
            && (opaque - other).abs() > 1e-6
        {
            remarks.note(MtlProblem::TwoOpacities);
        }
        let [by_d, by_tr] = self.opacities;
        if let Some(opacity) = by_d.or(by_tr) {
            self.material.base_colour[3] = opacity;
        }
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
            self.close();
            self.is_nameless = name.is_empty();
            if self.is_nameless {
                return self.remarks.tolerate(MtlProblem::NoName);
            }
            self.open = Some(Open::new(name));
            return Ok(());
        }
        match &mut self.open {
            Some(open) => property(open, keyword, &mut words, &mut self.remarks),
            None if self.is_nameless => Ok(()),
            None => {
                let statement = keyword.to_owned();
                if is_known(keyword) {
                    return self.remarks.tolerate(MtlProblem::NoMaterial { statement });
                }
                self.remarks
                    .note(MtlProblem::UnknownStatement { statement });
                Ok(())
            }
        }
    }
}

/// Whether a line can begin with this word, although it may be ignored.
fn is_known(keyword: &str) -> bool {
    matches!(
        keyword.strip_prefix("map_").unwrap_or(keyword),
        "Ka" | "Kd"
            | "Ks"
            | "Ke"
            | "Kn"
            | "Tf"
            | "Tr"
            | "d"
            | "Ns"
            | "Ni"
            | "illum"
            | "sharpness"
            | "bump"
            | "Bump"
            | "disp"
            | "Disp"
            | "decal"
            | "refl"
            | "aat"
            | "norm"
            | "Pr"
            | "Pm"
            | "Ps"
            | "Pc"
            | "Pcr"
            | "aniso"
            | "anisor"
    )
}

fn property(
    open: &mut Open,
    keyword: &str,
    words: &mut Words<'_>,
    remarks: &mut Remarks,
) -> Result<(), MtlProblem> {
    let texture = |picture: Option<Picture>| picture.map(|picture| picture.texture);
    let fraction = |value: f64| value.clamp(0.0, 1.0);
    let not_negative = |value: f64| value.max(0.0);
    match keyword {
        "Kd" => {
            if let Some(colour) = colour(keyword, words, remarks)? {
                let [red, green, blue] = colour.map(fraction);
                open.material.base_colour = [red, green, blue, open.material.base_colour[3]];
            }
        }
        "Ke" => {
            if let Some(colour) = colour(keyword, words, remarks)? {
                open.material.emissive = colour.map(not_negative);
            }
        }
        "Ka" | "Ks" => {
            if let Some(colour) = colour(keyword, words, remarks)? {
                let slot = match keyword {
                    "Ka" => &mut open.phong.ambient,
                    _ => &mut open.phong.specular,
                };
                *slot = colour.map(not_negative);
                open.has_phong = true;
            }
        }
        "Ns" | "Ni" | "illum" | "Pr" | "Pm" | "Tr" | "d" => {
            let rest = words.rest();
            if keyword == "d" && rest.is_some_and(|rest| rest.starts_with(b"-halo")) {
                words.next();
            }
            if let Some(value) = one_number(keyword, words, remarks)? {
                open.set_number(keyword, value, remarks);
            }
        }
        "map_Kd" => {
            open.material.base_colour_texture = texture(picture(keyword, words, remarks)?);
        }
        "map_Ke" => {
            open.material.emissive_texture = texture(picture(keyword, words, remarks)?);
        }
        "norm" | "map_Kn" => {
            if let Some(picture) = picture(keyword, words, remarks)? {
                open.material.normal_scale = picture.bump;
                open.material.normal_texture = Some(picture.texture);
            }
        }
        "map_Pr" => open.roughness_picture = picture(keyword, words, remarks)?,
        "map_Pm" => open.metallic_picture = picture(keyword, words, remarks)?,
        _ => {
            if let Some(slot) = open.phong_picture(keyword) {
                *slot = texture(picture(keyword, words, remarks)?);
            } else if !is_known(keyword) {
                let statement = keyword.to_owned();
                remarks.note(MtlProblem::UnknownStatement { statement });
            }
        }
    }
    Ok(())
}

/// The number of a line; `None` where there is none, which is tolerated.
fn one_number(
    statement: &str,
    words: &mut Words<'_>,
    remarks: &mut Remarks,
) -> Result<Option<f64>, MtlProblem> {
    let ([value], found) = numbers::<1>(words)?;
    if found != 1 {
        remarks.tolerate(MtlProblem::WrongCount {
            statement: statement.to_owned(),
            expected: "one number",
            found,
        })?;
    }
    Ok((found > 0).then_some(value))
}

/// Red, green and blue, or one number for all three; `None` for other descriptions of colours,
/// which are tolerated.
fn colour(
    statement: &str,
    words: &mut Words<'_>,
    remarks: &mut Remarks,
) -> Result<Option<[f64; 3]>, MtlProblem> {
    if let Some(kind @ (b"spectral" | b"xyz")) = words.clone().next() {
        let kind = text(kind)?.to_owned();
        let statement = statement.to_owned();
        remarks.tolerate(MtlProblem::ColourKind { statement, kind })?;
        return Ok(None);
    }
    let (colour, found) = numbers::<3>(words)?;
    if !matches!(found, 1 | 3) {
        remarks.tolerate(MtlProblem::WrongCount {
            statement: statement.to_owned(),
            expected: "1 or 3 numbers",
            found,
        })?;
    }
    Ok(match found {
        0 | 2 => None,
        1 => Some([colour[0]; 3]),
        _ => Some(colour),
    })
}
