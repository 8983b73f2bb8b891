//! What is seen at the centre of each pixel, as numbers.

use ga_image::plane::Plane;
use rayon::prelude::*;

use crate::check::check;
use crate::fragment::Fragment;
use crate::style::check_size;
use crate::surface::{NO_TRIANGLE, Pass, Samples};
use crate::world::World;
use crate::{RenderError, Scene, Vector, View};

/// What is seen at the centre of each pixel of a picture: which triangle, where, how far away.
///
/// There is no anti-aliasing: every number is that of one place of one surface, which may be a
/// transparent one. The ground, lines, dots and bones are not included. Each buffer is made when it
/// is asked for.
///
/// ```
/// use ga_render::{Buffers, View, Scene};
///
/// let positions = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
/// let triangles = [[0, 1, 2]];
/// let scene = Scene::new(&positions, &triangles);
/// let camera = View::look_at([0.0, 0.0, 4.0], [0.0; 3], [0.0, 1.0, 0.0], 1.0, 0.1)?;
/// let buffers = Buffers::new(&scene, &camera, 65, 65)?;
/// let seen = buffers.get(32, 32).unwrap();
/// assert_eq!((seen.object, seen.triangle, seen.depth), (0, 0, 4.0));
/// assert_eq!(buffers.depth().get(0, 0), Some(f32::INFINITY));
/// # Ok::<(), ga_render::RenderError>(())
/// ```
pub struct Buffers<'a> {
    world: World<'a>,
    view: View,
    samples: Samples,
}

/// A place of a surface that is seen. Elements are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The object.
    pub object: usize,
    /// The triangle of the object.
    pub triangle: usize,
    /// Its material; `None` for the style's.
    pub material: Option<u32>,
    /// The barycentric coordinates of the place in the triangle.
    pub barycentric: [f64; 3],
    /// The place in the world.
    pub position: [f64; 3],
    /// The distance along the viewing direction.
    pub depth: f64,
    /// The distance from the eye.
    pub distance: f64,
    /// The unit normal for shading, without normal maps, in the world: on the side of the
    /// triangle's orientation, whichever side is seen.
    pub normal: [f64; 3],
    /// Texture coordinates, if the triangle has any: u to the right, v up.
    pub texture_coordinates: Option<[f64; 2]>,
}

impl<'a> Buffers<'a> {
    /// Finds what a picture of this size shows.
    ///
    /// # Errors
    ///
    /// [`RenderError`] as [`render`](crate::render) gives for the scene, and
    /// [`RenderError::Style`] for a size that is zero or beyond 16,384.
    pub fn new(
        scene: &'a Scene<'a>,
        view: &View,
        width: u32,
        height: u32,
    ) -> Result<Self, RenderError> {
        check_size([width, height], 1)?;
        check(scene)?;
        let world = World::new(scene, view)?;
        let samples = Samples::draw(&world, view, [width, height], 1, Pass::All);
        Ok(Self {
            world,
            view: *view,
            samples,
        })
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.samples.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.samples.height
    }

    /// What is seen at the centre of a pixel; `None` where there is no surface, and outside the
    /// picture.
    pub fn get(&self, column: usize, row: usize) -> Option<SurfacePoint> {
        if column >= self.width() || row >= self.height() {
            return None;
        }
        let triangle = self.samples.triangle[row * self.width() + column];
        if triangle == NO_TRIANGLE {
            return None;
        }
        let face = self.world.face(triangle);
        let lens = &self.samples.lens;
        let ray = lens.ray(column as f64 + 0.5, row as f64 + 0.5);
        let fragment = Fragment::new(face, ray, &self.view, lens, 1.0)?;
        let offset = fragment.point - Vector::from(self.view.eye());
        Some(SurfacePoint {
            object: face.object,
            triangle: face.triangle,
            material: face.placed.object.material.of(face.triangle),
            barycentric: fragment.weights(),
            position: fragment.point.coordinates(),
            depth: offset.dot(self.view.forward().into()),
            distance: offset.length(),
            normal: fragment.smooth.coordinates(),
            texture_coordinates: fragment.texture_coordinates(),
        })
    }

    /// The depth at each pixel, along the viewing direction; infinite where there is no surface.
    pub fn depth(&self) -> Plane {
        self.plane(|seen| seen.map_or(f32::INFINITY, |seen| seen.depth as f32))
    }

    /// The distance from the eye at each pixel; infinite where there is no surface.
    pub fn distance(&self) -> Plane {
        self.plane(|seen| seen.map_or(f32::INFINITY, |seen| seen.distance as f32))
    }

    /// Texture coordinates u and v, and a mask that is 1 where there are any, else 0; where it is
    /// 0, u and v are 0.
    pub fn texture_coordinates(&self) -> Plane<[f32; 3]> {
        self.plane(|seen| {
            let coordinates = seen.and_then(|seen| seen.texture_coordinates);
            coordinates.map_or([0.0; 3], |[u, v]| [u as f32, v as f32, 1.0])
        })
    }

    /// The unit normals for shading in the world; zero where there is no surface.
    pub fn normals(&self) -> Plane<[f32; 3]> {
        self.plane(|seen| seen.map_or([0.0; 3], |seen| seen.normal.map(|c| c as f32)))
    }

    /// The places in the world; infinite where there is no surface.
    pub fn positions(&self) -> Plane<[f32; 3]> {
        self.plane(|seen| seen.map_or([f32::INFINITY; 3], |seen| seen.position.map(|c| c as f32)))
    }

    /// What is seen in each pixel.
    pub fn points(&self) -> Plane<Option<SurfacePoint>> {
        self.plane(|seen| seen)
    }

    fn plane<T: Copy + Send>(&self, value: impl Fn(Option<SurfacePoint>) -> T + Sync) -> Plane<T> {
        let width = self.width();
        let values: Vec<T> = (0..width * self.height())
            .into_par_iter()
            .map(|index| value(self.get(index % width, index / width)))
            .collect();
        Plane::from_fn(width, self.height(), |column, row| {
            values[row * width + column]
        })
    }
}
