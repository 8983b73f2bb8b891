//! The appearance of surfaces.

use ga_image::colour::LinearColour;

use crate::texture::Mipmap;

/// The appearance of a surface: the metallic–roughness model of glTF 2.0.
///
/// A surface with base colour *c*, metallic part *m*, roughness *r* and unit normal *n* that
/// receives light of colour *E* from the unit direction *l* sends towards the unit direction *v*
///
/// ```text
/// (n·l) E ((1 − m) c + π D V F)
/// D = α² / (π ((n·h)² (α² − 1) + 1)²),   α = r²,   h = (l + v) / |l + v|
/// V = 1 / (2 (n·l √((n·v)² (1 − α²) + α²) + n·v √((n·l)² (1 − α²) + α²)))
/// F = F₀ + (F₉₀ − F₀) (1 − v·h)⁵,   F₀ = (1 − m) reflectance + m c,   F₉₀ = min(1, 25 F₀)
/// ```
///
/// so that a white surface without highlights that faces a light shows the light's colour. (D is
/// the distribution of Trowbridge and Reitz, "GGX"; V the visibility by Smith's shadowing, F
/// Schlick's form of Fresnel's equations.) Light from all around adds (1 − m) c times what arrives
/// from the side of the normal, and F for v·n times what arrives from the mirrored direction,
/// with F₉₀ scaled by 1 − r. What the surface emits is added.
///
/// Where there is a texture, the number or colour is a factor of what the texture says. All colours
/// are linear light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Appearance<'a> {
    /// The share of each channel that is reflected.
    pub base_colour: LinearColour,
    /// Opacity, 0 to 1; see [`cutoff`](Self::cutoff) and [`transparent`](Self::transparent).
    pub opacity: f64,
    /// A factor of the base colour and the opacity.
    pub base_colour_map: Option<&'a Mipmap>,
    /// 0 for a dielectric, 1 for a metal.
    pub metallic: f64,
    /// 0 for a mirror, 1 for chalk.
    pub roughness: f64,
    /// Green is a factor of the roughness, blue of the metallic part.
    pub metallic_roughness_map: Option<&'a Mipmap>,
    /// The share of light that a dielectric reflects at a right angle, 0.04 for most; 0 for no
    /// highlights.
    pub reflectance: f64,
    /// Normals in the frame of tangent, bitangent and normal: `(r, g, b) = (n + 1) / 2`.
    pub normal_map: Option<&'a Mipmap>,
    /// A factor of the first two coordinates of the normals in the map.
    pub normal_scale: f64,
    /// Red is the share of the light from all around that arrives.
    pub occlusion_map: Option<&'a Mipmap>,
    /// How much of the occlusion is applied: the light is a factor 1 + strength (red − 1).
    pub occlusion_strength: f64,
    /// The light that the surface sends by itself.
    pub emission: LinearColour,
    /// A factor of the emission.
    pub emission_map: Option<&'a Mipmap>,
    /// Where on the surface the textures lie.
    pub placements: Placements,
    /// The surface is not there where its opacity is below this. `None` draws it everywhere.
    pub cutoff: Option<f64>,
    /// Whether what lies behind shows through: with the opacity α the surface adds α times its own
    /// light, and lets 1 − α of the light behind it pass. Otherwise it is opaque.
    pub transparent: bool,
    /// Whether the back of each triangle is drawn too.
    pub double_sided: bool,
    /// Whether the base colour is shown as it is, without light.
    pub unlit: bool,
}

/// Where on the surface each texture of an [`Appearance`] lies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placements {
    /// That of the base colour's texture.
    pub base_colour: Placement,
    /// That of the roughness and the metallic part.
    pub metallic_roughness: Placement,
    /// That of the normals.
    pub normal: Placement,
    /// That of the occlusion.
    pub occlusion: Placement,
    /// That of the emission.
    pub emission: Placement,
}

/// Where on a surface a texture lies: it is read at A (u, v) + o, where (u, v) are the texture
/// coordinates of the surface, A is a matrix and o an offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Which texture coordinates of the [`Object`](crate::Object) are taken.
    pub set: CoordinateSet,
    /// The rows of the matrix A.
    pub matrix: [[f64; 2]; 2],
    /// The offset o.
    pub offset: [f64; 2],
}

/// One of the two sets of texture coordinates of an [`Object`](crate::Object).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CoordinateSet {
    /// [`texture_coordinates`](crate::Object::texture_coordinates).
    #[default]
    First,
    /// [`second_texture_coordinates`](crate::Object::second_texture_coordinates).
    Second,
}

impl Default for Placement {
    /// The first set as it is.
    fn default() -> Self {
        Self {
            set: CoordinateSet::First,
            matrix: [[1.0, 0.0], [0.0, 1.0]],
            offset: [0.0; 2],
        }
    }
}

impl Placement {
    /// Where the texture is read.
    #[must_use]
    pub fn place(&self, coordinates: [f64; 2]) -> [f64; 2] {
        let moved = self.change(coordinates);
        [0, 1].map(|axis| moved[axis] + self.offset[axis])
    }

    /// How that place changes where the texture coordinates change by a step.
    pub(crate) fn change(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        self.matrix.map(|[a, b]| a * u + b * v)
    }
}

impl Placements {
    fn are_finite(&self) -> bool {
        let all = [
            self.base_colour,
            self.metallic_roughness,
            self.normal,
            self.occlusion,
            self.emission,
        ];
        let numbers = all.iter().flat_map(|placement| {
            let [[a, b], [c, d]] = placement.matrix;
            let [u, v] = placement.offset;
            [a, b, c, d, u, v]
        });
        numbers.into_iter().all(f64::is_finite)
    }
}

impl Default for Appearance<'_> {
    /// White, without metal, of roughness 0.5, opaque, with both sides.
    fn default() -> Self {
        Self {
            base_colour: LinearColour::WHITE,
            opacity: 1.0,
            base_colour_map: None,
            metallic: 0.0,
            roughness: 0.5,
            metallic_roughness_map: None,
            reflectance: 0.04,
            normal_map: None,
            normal_scale: 1.0,
            occlusion_map: None,
            occlusion_strength: 1.0,
            emission: LinearColour::BLACK,
            emission_map: None,
            placements: Placements::default(),
            cutoff: None,
            transparent: false,
            double_sided: true,
            unlit: false,
        }
    }
}

impl Appearance<'_> {
    /// The name of a number that is out of its range.
    pub(crate) fn faulty_number(&self) -> Option<&'static str> {
        let fraction = |number: f64| (0.0..=1.0).contains(&number);
        let light = |colour: LinearColour| {
            let channels = colour.channels();
            channels.iter().all(|c| c.is_finite() && *c >= 0.0)
        };
        [
            ("base colour", light(self.base_colour)),
            ("opacity", fraction(self.opacity)),
            ("metallic part", fraction(self.metallic)),
            ("roughness", fraction(self.roughness)),
            ("reflectance", fraction(self.reflectance)),
            ("normal scale", self.normal_scale.is_finite()),
            ("occlusion strength", fraction(self.occlusion_strength)),
            ("emission", light(self.emission)),
            ("cutoff", self.cutoff.is_none_or(f64::is_finite)),
            ("placement of a texture", self.placements.are_finite()),
        ]
        .into_iter()
        .find_map(|(name, fits)| (!fits).then_some(name))
    }
}
