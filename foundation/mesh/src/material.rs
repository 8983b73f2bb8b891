//! Materials of surfaces.

use std::sync::Arc;

/// The appearance of a surface: the metallic–roughness model of glTF 2.0, and beside it what a
/// Wavefront MTL file says in the terms of Phong's model.
///
/// Colours are linear light. Where there is a texture, each number is a factor of what the texture
/// says; a texture of a colour is stored as sRGB, any other as plain numbers.
///
/// # Phong's model
///
/// A material that is given by Phong's model alone becomes one of this model so: the base colour is
/// the diffuse colour `Kd` with the opacity `d`; the exponent n of the highlight (`Ns`) becomes the
/// roughness r with
///
/// r⁴ = 2 / (n + 2),   n = 2 / r⁴ − 2,
///
/// by which the microfacets of both models spread alike near the normal (Walter et al.,
/// *Microfacet Models for Refraction through Rough Surfaces*, 2007, where α = r²). The surface is
/// taken for a dielectric, metallic = 0. Emission `Ke` is the same in both. In the other direction
/// the specular colour is 0.04 (1 − m) + m × base colour with m the metallic part, the diffuse
/// colour the base colour, the ambient colour the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// Red, green, blue, each the part of the light that is reflected, and opacity; 0 to 1.
    pub base_colour: [f64; 4],
    /// A factor of [`base_colour`](Self::base_colour).
    pub base_colour_texture: Option<Texture>,
    /// 0 for a dielectric, 1 for a metal.
    pub metallic: f64,
    /// 0 for a mirror, 1 for chalk.
    pub roughness: f64,
    /// Green is a factor of the roughness, blue of the metallic part.
    pub metallic_roughness_texture: Option<Texture>,
    /// Normals in the frame of [`Tangent`](crate::Tangent), (r, g, b) = (n + 1) / 2.
    pub normal_texture: Option<Texture>,
    /// A factor of the first two coordinates of the normals in the texture.
    pub normal_scale: f64,
    /// Red is the part of the ambient light that arrives.
    pub occlusion_texture: Option<Texture>,
    /// How much of the occlusion is applied: the light is a factor 1 + strength (red − 1).
    pub occlusion_strength: f64,
    /// Red, green, blue of the light that the surface emits; not negative.
    pub emissive: [f64; 3],
    /// A factor of [`emissive`](Self::emissive).
    pub emissive_texture: Option<Texture>,
    /// What opacity means.
    pub alpha_mode: AlphaMode,
    /// Whether the back of each face is seen too.
    pub double_sided: bool,
    /// Whether the base colour is shown as it is, without light.
    pub unlit: bool,
    /// The same surface in the terms of Phong's model, where its source says them.
    pub phong: Option<Phong>,
}

/// Phong's model of reflection as in Wavefront MTL, but for the diffuse colour, the emission and
/// the opacity, which a [`Material`] has itself.
///
/// The default is what MTL takes where a file says nothing: black, exponent 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Phong {
    /// The factor of the ambient light, `Ka`.
    pub ambient: [f64; 3],
    /// The colour of the highlight, `Ks`.
    pub specular: [f64; 3],
    /// The exponent of the highlight, `Ns`; not negative.
    pub exponent: f64,
    /// The index of refraction, `Ni`.
    pub refraction: Option<f64>,
    /// The number of the illumination model, `illum`, 0 to 10.
    pub illumination: Option<u8>,
    /// A factor of the ambient colour, `map_Ka`.
    pub ambient_texture: Option<Texture>,
    /// A factor of the specular colour, `map_Ks`.
    pub specular_texture: Option<Texture>,
    /// A factor of the exponent, `map_Ns`.
    pub exponent_texture: Option<Texture>,
    /// A factor of the opacity, `map_d`.
    pub opacity_texture: Option<Texture>,
    /// Heights of the surface, `bump` or `map_bump`.
    pub bump_texture: Option<Texture>,
}

/// What the opacity of a surface means.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum AlphaMode {
    /// Nothing: the surface is opaque.
    #[default]
    Opaque,
    /// The surface is opaque where its opacity is at least `cutoff`, else not there.
    Mask {
        /// The least opacity that shows; not negative.
        cutoff: f64,
    },
    /// What lies behind shows through.
    Blend,
}

/// A picture laid on a surface.
///
/// At the texture coordinate p the picture is taken at q = R S p + o, where S scales, R rotates
/// counter-clockwise and o is the offset; [`Texture::place`] computes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The picture.
    pub image: Image,
    /// Which set of texture coordinates of the mesh places it, counted from 0.
    pub set: u32,
    /// o.
    pub offset: [f64; 2],
    /// The angle of R in radians.
    pub rotation: f64,
    /// The factors of S.
    pub scale: [f64; 2],
    /// What is seen beyond the picture's edges, along u and along v.
    pub wrap: [Wrap; 2],
    /// How the picture is enlarged, if its source says so.
    pub magnification: Option<Filter>,
    /// How the picture is reduced, if its source says so.
    pub minification: Option<Minification>,
}

/// Where the pixels of a texture are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Image {
    /// In a file: its path relative to the folder of the file that names it, with `/` between
    /// folders.
    File(String),
    /// Here.
    Embedded {
        /// The MIME type, such as `image/png`.
        media_type: String,
        /// The contents of an image file. Textures of the same image share them.
        bytes: Arc<[u8]>,
    },
}

/// What a texture shows beyond its edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// The picture again.
    #[default]
    Repeat,
    /// The picture again, every other time mirrored.
    MirroredRepeat,
    /// The pixels at the edge.
    ClampToEdge,
}

/// How pixels are mixed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The nearest one alone.
    Nearest,
    /// Linearly between neighbours.
    Linear,
}

/// How a picture is reduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Minification {
    /// How pixels of one level are mixed.
    pub filter: Filter,
    /// How levels of a pyramid of pictures are mixed; `None` uses the full picture alone.
    pub levels: Option<Filter>,
}

impl Material {
    /// A material of this name that is otherwise the default.
    #[must_use]
    pub fn named(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            ..Self::default()
        }
    }

    /// The roughness that corresponds to an exponent of Phong's model, as stated for [`Material`].
    #[must_use]
    pub fn roughness_of_exponent(exponent: f64) -> f64 {
        (2.0 / (exponent.max(0.0) + 2.0)).sqrt().sqrt()
    }

    /// The exponent of Phong's model that corresponds to a roughness, as stated for [`Material`];
    /// at most 10⁶.
    #[must_use]
    pub fn exponent_of_roughness(roughness: f64) -> f64 {
        (2.0 / roughness.powi(4) - 2.0).clamp(0.0, 1e6)
    }

    /// The terms of Phong's model: those of the source, or else those that correspond as stated for
    /// [`Material`].
    #[must_use]
    pub fn to_phong(&self) -> Phong {
        let [red, green, blue, _] = self.base_colour;
        let colour = [red, green, blue];
        self.phong.clone().unwrap_or_else(|| Phong {
            ambient: colour,
            specular: colour.map(|c| 0.04 * (1.0 - self.metallic) + self.metallic * c),
            exponent: Self::exponent_of_roughness(self.roughness),
            ..Phong::default()
        })
    }

    /// All textures of the material.
    pub fn textures(&self) -> impl Iterator<Item = &Texture> {
        let phong = self.phong.as_ref();
        [
            self.base_colour_texture.as_ref(),
            self.metallic_roughness_texture.as_ref(),
            self.normal_texture.as_ref(),
            self.occlusion_texture.as_ref(),
            self.emissive_texture.as_ref(),
            phong.and_then(|phong| phong.ambient_texture.as_ref()),
            phong.and_then(|phong| phong.specular_texture.as_ref()),
            phong.and_then(|phong| phong.exponent_texture.as_ref()),
            phong.and_then(|phong| phong.opacity_texture.as_ref()),
            phong.and_then(|phong| phong.bump_texture.as_ref()),
        ]
        .into_iter()
        .flatten()
    }

    /// All textures of the material, to be changed.
    pub fn textures_mut(&mut self) -> impl Iterator<Item = &mut Texture> {
        let mut phong: [Option<&mut Texture>; 5] = Default::default();
        if let Some(terms) = &mut self.phong {
            phong = [
                terms.ambient_texture.as_mut(),
                terms.specular_texture.as_mut(),
                terms.exponent_texture.as_mut(),
                terms.opacity_texture.as_mut(),
                terms.bump_texture.as_mut(),
            ];
        }
        [
            self.base_colour_texture.as_mut(),
            self.metallic_roughness_texture.as_mut(),
            self.normal_texture.as_mut(),
            self.occlusion_texture.as_mut(),
            self.emissive_texture.as_mut(),
        ]
        .into_iter()
        .chain(phong)
        .flatten()
    }

    /// The name of a number that is out of its range.
    pub(crate) fn faulty_number(&self) -> Option<&'static str> {
        let fraction = |numbers: &[f64]| numbers.iter().all(|n| (0.0..=1.0).contains(n));
        let not_negative = |numbers: &[f64]| numbers.iter().all(|n| *n >= 0.0 && n.is_finite());
        let finite = |numbers: &[f64]| numbers.iter().all(|n| n.is_finite());
        let cutoff = match self.alpha_mode {
            AlphaMode::Mask { cutoff } => cutoff,
            AlphaMode::Opaque | AlphaMode::Blend => 0.0,
        };
        let phong = self.phong.as_ref();
        let placed = |texture: &Texture| {
            finite(&texture.offset) && finite(&texture.scale) && texture.rotation.is_finite()
        };
        [
            ("base colour", fraction(&self.base_colour)),
            ("metallic part", fraction(&[self.metallic])),
            ("roughness", fraction(&[self.roughness])),
            ("normal scale", finite(&[self.normal_scale])),
            ("occlusion strength", fraction(&[self.occlusion_strength])),
            ("emission", not_negative(&self.emissive)),
            ("alpha cutoff", not_negative(&[cutoff])),
            (
                "ambient colour",
                phong.is_none_or(|phong| not_negative(&phong.ambient)),
            ),
            (
                "specular colour",
                phong.is_none_or(|phong| not_negative(&phong.specular)),
            ),
            (
                "exponent",
                phong.is_none_or(|phong| not_negative(&[phong.exponent])),
            ),
            (
                "index of refraction",
                phong.is_none_or(|phong| not_negative(&[phong.refraction.unwrap_or(1.0)])),
            ),
            ("placement of a texture", self.textures().all(placed)),
        ]
        .into_iter()
        .find_map(|(name, fits)| (!fits).then_some(name))
    }
}

impl Default for Material {
    /// A white dielectric without shine: base colour 1, metallic 0, roughness 1.
    fn default() -> Self {
        Self {
            name: String::new(),
            base_colour: [1.0; 4],
            base_colour_texture: None,
            metallic: 0.0,
            roughness: 1.0,
            metallic_roughness_texture: None,
            normal_texture: None,
            normal_scale: 1.0,
            occlusion_texture: None,
            occlusion_strength: 1.0,
            emissive: [0.0; 3],
            emissive_texture: None,
            alpha_mode: AlphaMode::Opaque,
            double_sided: false,
            unlit: false,
            phong: None,
        }
    }
}

impl Texture {
    /// This picture, placed by the first set of texture coordinates and repeated.
    #[must_use]
    pub fn new(image: Image) -> Self {
        Self {
            image,
            set: 0,
            offset: [0.0; 2],
            rotation: 0.0,
            scale: [1.0; 2],
            wrap: [Wrap::Repeat; 2],
            magnification: None,
            minification: None,
        }
    }

    /// The picture in the file of this path, placed as by [`Texture::new`].
    #[must_use]
    pub fn file(path: impl Into<String>) -> Self {
        Self::new(Image::File(path.into()))
    }

    /// Where the picture is taken for a texture coordinate p of the mesh: q = R S p + o, that is
    ///
    /// ```text
    /// q_u = s_u u cos α − s_v v sin α + o_u
    /// q_v = s_u u sin α + s_v v cos α + o_v
    /// ```
    ///
    /// with the scale s, the rotation α and the offset o. Both coordinates have v up. The order is
    /// that of the extension `KHR_texture_transform` of glTF, whose coordinates have v down; the
    /// readers and writers of glTF convert the offset.
    ///
    /// ```
    /// use ga_mesh::Texture;
    ///
    /// let texture = Texture {
    ///     scale: [3.0, 1.0],
    ///     rotation: std::f64::consts::FRAC_PI_2,
    ///     offset: [0.5, 0.0],
    ///     ..Texture::file("wood.png")
    /// };
    /// let [u, v] = texture.place([1.0, 0.0]);
    /// assert!((u - 0.5).abs() < 1e-12 && (v - 3.0).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn place(&self, coordinates: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = self.rotation.sin_cos();
        let [u, v] = [0, 1].map(|axis| self.scale[axis] * coordinates[axis]);
        let [offset_u, offset_v] = self.offset;
        [
            cosine * u - sine * v + offset_u,
            sine * u + cosine * v + offset_v,
        ]
    }

    /// Whether another texture is read at the same place of the mesh as this one: from the same set
    /// of texture coordinates, with the same offset, rotation and scale.
    ///
    /// ```
    /// use ga_mesh::Texture;
    ///
    /// let wood = Texture::file("wood.png");
    /// assert!(wood.has_same_place(&Texture::file("grain.png")));
    /// assert!(!wood.has_same_place(&Texture { set: 1, ..wood.clone() }));
    /// ```
    #[must_use]
    pub fn has_same_place(&self, other: &Self) -> bool {
        self.set == other.set
            && self.offset == other.offset
            && self.rotation == other.rotation
            && self.scale == other.scale
    }
}
