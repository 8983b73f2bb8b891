//! Surfaces as clouds and meshes, with the colours of the left view.

use std::sync::Arc;

use ga_image::colour::linear_from_srgb;
use ga_image::plane::PlaneView;
use ga_mesh::{CornerAttribute, Faces, Image, Material, Mesh, Rgba, Texture, Wrap};

use super::Surface;
use crate::disparity::DisparityMapError;

impl Surface {
    /// The colour of each point in the left view, whose pixels are in sRGB with 8 bits, as linear
    /// light.
    ///
    /// # Errors
    /// [`DisparityMapError::PictureSize`].
    pub fn colours<'a>(
        &self,
        picture: impl Into<PlaneView<'a, [u8; 3]>>,
    ) -> Result<Vec<Rgba>, DisparityMapError> {
        let picture = picture.into();
        let size = [picture.width(), picture.height()];
        if size != self.size() {
            return Err(DisparityMapError::PictureSize {
                picture: size,
                map: self.size(),
            });
        }
        let light: Vec<f64> = (0..=255_u8)
            .map(|code| linear_from_srgb(f64::from(code) / 255.0))
            .collect();
        let colour = |[column, row]: &[u32; 2]| {
            let pixel = picture.row(*row as usize)[*column as usize];
            let [red, green, blue] = pixel.map(|code| light[usize::from(code)]);
            [red, green, blue, 1.0]
        };
        Ok(self.pixels().iter().map(colour).collect())
    }

    /// All points as a cloud with the colours of the left view.
    ///
    /// # Errors
    /// As [`colours`](Self::colours).
    pub fn to_cloud<'a>(
        &self,
        picture: impl Into<PlaneView<'a, [u8; 3]>>,
    ) -> Result<Mesh, DisparityMapError> {
        let colours = self.colours(picture)?;
        let mesh = Mesh::new(self.points().to_vec(), Faces::default())?;
        let all = (0..self.points().len() as u32).collect();
        Ok(mesh.with_points(all)?.with_colours(colours)?)
    }

    /// The triangles as a mesh with normals and the colours of the left view at its vertices.
    /// Points without a triangle are left out.
    ///
    /// # Errors
    /// [`DisparityMapError::NoTriangles`], [`DisparityMapError::PictureSize`] and
    /// [`DisparityMapError::Mesh`].
    pub fn to_mesh<'a>(
        &self,
        picture: impl Into<PlaneView<'a, [u8; 3]>>,
    ) -> Result<Mesh, DisparityMapError> {
        let surface = self
            .without_single_points()
            .ok_or(DisparityMapError::NoTriangles)?;
        let colours = surface.colours(picture)?;
        Ok(surface.shape()?.with_colours(colours)?)
    }

    /// The triangles as a mesh with normals and a picture of the left view as its texture, which is
    /// not lit: the picture already shows the light of the scene.
    ///
    /// # Errors
    /// [`DisparityMapError::NoTriangles`] and [`DisparityMapError::Mesh`].
    pub fn to_textured_mesh(
        &self,
        media_type: &str,
        picture: Arc<[u8]>,
    ) -> Result<Mesh, DisparityMapError> {
        let surface = self
            .without_single_points()
            .ok_or(DisparityMapError::NoTriangles)?;
        let [width, height] = surface.size().map(|count| count as f64);
        let place = |[column, row]: &[u32; 2]| {
            let [u, v] = [column, row].map(|x| f64::from(*x) + 0.5);
            [u / width, 1.0 - v / height]
        };
        let places = surface.pixels().iter().map(place).collect();
        let mesh = surface.shape()?;
        let coordinates = CornerAttribute::of_vertices(places, mesh.faces());
        let faces = mesh.faces().len();
        let texture = Texture {
            wrap: [Wrap::ClampToEdge; 2],
            ..Texture::new(Image::Embedded {
                media_type: media_type.into(),
                bytes: picture,
            })
        };
        let material = Material {
            base_colour_texture: Some(texture),
            unlit: true,
            double_sided: true,
            ..Material::named("left view")
        };
        Ok(mesh
            .with_texture_coordinates(vec![coordinates])?
            .with_materials(vec![material], vec![Some(0); faces])?)
    }

    /// Positions, triangles and normals.
    fn shape(&self) -> Result<Mesh, DisparityMapError> {
        let faces = Faces::from_uniform(self.triangles().to_vec())?;
        let mesh = Mesh::new(self.points().to_vec(), faces)?;
        let normals = self.normals().into_iter().map(Option::unwrap_or_default);
        let normals = CornerAttribute::of_vertices(normals.collect(), mesh.faces());
        Ok(mesh.with_normals(normals)?)
    }
}
