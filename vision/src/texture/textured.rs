//! A mesh with its texture.

use std::sync::Arc;

use crate::texture::TextureError;
use ga_image::plane::Plane;
use ga_image::png;
use ga_mesh::{Image, Material, Mesh, Texture, Wrap};
use serde::Serialize;

/// A mesh with a texture from views.
#[derive(Clone, Debug)]
pub struct Textured {
    /// The mesh, whose first set of texture coordinates is that of the texture. It consists of
    /// triangles where the atlas was made here.
    pub mesh: Mesh,
    /// The texture in sRGB.
    pub texture: Plane<[u8; 3]>,
    /// What the views contributed.
    pub report: Report,
}

/// The figures of a texture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The side of the texture in texels.
    #[serde(rename = "size_texels")]
    pub size: u32,
    /// Whether a new atlas was made.
    pub unwrapped: bool,
    /// How many charts the atlas has.
    pub charts: usize,
    /// The part of the texels whose centres lie in a triangle.
    pub utilisation: f64,
    /// Texels that two triangles claim; see [`ga_mesh::atlas::Report`].
    pub overlapping_texels: usize,
    /// Texels that show the surface.
    pub covered_texels: usize,
    /// Those of them that no view sees.
    pub filled_texels: usize,
    /// One for each view.
    pub views: Vec<ViewReport>,
}

/// What a view contributed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ViewReport {
    /// Its name.
    #[serde(rename = "picture")]
    pub name: String,
    /// Texels that it sees.
    pub seen_texels: usize,
    /// Texels for which it counts most.
    pub best_texels: usize,
    /// How many other views show some of the same texels well. Where it is 0, nothing says how the
    /// exposure of the view compares with those of others.
    pub overlapping_views: usize,
    /// The factors of its linear red, green and blue that level its exposure.
    #[serde(rename = "gain_red_green_blue")]
    pub gain: [f64; 3],
    /// Triangles whose front faces the camera.
    pub facing_triangles: usize,
    /// Those of them that are warped by an affine map.
    pub affine_triangles: usize,
}

impl Textured {
    /// The mesh with one material that shows the texture, as an embedded PNG. It is not lit, since
    /// the pictures already show the light of the scene.
    ///
    /// # Errors
    /// [`TextureError`].
    pub fn to_mesh(&self) -> Result<Mesh, TextureError> {
        let texture = Texture {
            wrap: [Wrap::ClampToEdge; 2],
            ..Texture::new(Image::Embedded {
                media_type: "image/png".into(),
                bytes: Arc::from(png::encode(&self.texture)?),
            })
        };
        let material = Material {
            base_colour_texture: Some(texture),
            unlit: true,
            ..Material::named("views")
        };
        let faces = self.mesh.faces().len();
        Ok(self
            .mesh
            .clone()
            .with_materials(vec![material], vec![Some(0); faces])?)
    }
}
