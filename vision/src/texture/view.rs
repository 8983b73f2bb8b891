//! A picture and the camera that took it.

use std::f64::consts::PI;

use ga_image::picture::PictureView;
use ga_image::plane::Plane;
use ga_runtime::vga3::Vector;

use crate::texture::TextureError;
use ga_camera::Camera;

/// A picture of the mesh, and the camera that took it.
#[derive(Clone, Debug)]
pub struct View {
    pub(super) name: String,
    pub(super) camera: Camera,
    pub(super) picture: Plane<[u16; 3]>,
}

impl View {
    /// A view with a name for messages. The picture is in sRGB; its alpha is not looked at. `size`
    /// is the width and height for which the camera is given, where that is known.
    ///
    /// # Errors
    /// [`TextureError::PictureSize`] and [`TextureError::NoPixels`].
    pub fn new<'a>(
        name: impl Into<String>,
        camera: Camera,
        size: Option<[usize; 2]>,
        picture: impl Into<PictureView<'a>>,
    ) -> Result<Self, TextureError> {
        let (view, picture) = (name.into(), picture.into());
        let found = [picture.width(), picture.height()];
        if found.contains(&0) {
            return Err(TextureError::NoPixels { view });
        }
        if let Some(camera) = size.filter(|size| *size != found) {
            return Err(TextureError::PictureSize {
                view,
                picture: found,
                camera,
            });
        }
        Ok(Self {
            name: view,
            camera,
            picture: picture.to_rgb(),
        })
    }

    /// The name of the view.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Fails where the camera is behind a closed surface. In a room, whose walls face it, it may
    /// be.
    pub(super) fn check_place(
        &self,
        triangles: impl Iterator<Item = [Vector<f64>; 3]>,
    ) -> Result<(), TextureError> {
        let centre = Vector::from(self.camera.centre());
        let view = || self.name.clone();
        match winding_number(centre, triangles) {
            inside if inside > 0.5 => Err(TextureError::CameraInside {
                view: view(),
                centre: centre.coordinates(),
            }),
            // It is too far away for numbers.
            unknown if unknown.is_nan() => Err(TextureError::NoOverlap { view: view() }),
            _ => Ok(()),
        }
    }
}

/// How often a surface encloses a point: the sum of the solid angles of its triangles by 4π, 1 in
/// a closed surface and 0 outside of it (A. Jacobson, L. Kavan and O. Sorkine-Hornung, Robust
/// Inside-Outside Segmentation using Generalized Winding Numbers, 2013). Each solid angle Ω has
/// tan Ω/2 = a·(b × c) / (abc + (a·b)c + (b·c)a + (c·a)b) (A. van Oosterom and J. Strackee, 1983).
fn winding_number(point: Vector<f64>, triangles: impl Iterator<Item = [Vector<f64>; 3]>) -> f64 {
    let half_angles = triangles.map(|corners| {
        let [a, b, c] = corners.map(|corner| corner - point);
        let [p, q, r] = [a, b, c].map(Vector::length);
        let below = p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q;
        a.dot(b.cross(c)).atan2(below)
    });
    half_angles.sum::<f64>() / (2.0 * PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Outside a tetrahedron, inside, and inside where it is turned inside out.
    #[test]
    fn a_closed_surface_encloses_its_inside_once() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        let all = triangles.map(|t: [usize; 3]| t.map(|i| Vector::from(corners[i])));
        let number = |x, y, z| winding_number(Vector::new(x, y, z), all.into_iter());
        assert!((number(0.2, 0.2, 0.2) - 1.0).abs() < 1e-12);
        assert!(number(0.5, 0.5, 0.5).abs() < 1e-12);
        assert!(number(-3.0, 0.1, 0.2).abs() < 1e-12);
        let back = all.map(|[a, b, c]| [a, c, b]);
        let inside = winding_number(Vector::new(0.2, 0.2, 0.2), back.into_iter());
        assert!((inside + 1.0).abs() < 1e-12);
    }
}
