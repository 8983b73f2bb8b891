//! Pictures of triangle meshes: a small software renderer.
//!
//! [`render`] draws a mesh, given as plain positions and triangles, with smooth shading, on a level
//! ground that shows its shadow, and optionally line segments such as bones on top. It returns the
//! picture and its [`DepthMap`]. Hidden surfaces are removed by a depth buffer at several samples
//! per pixel, and lighting is computed in linear light. Equal input gives equal pictures, bit for
//! bit, for any number of threads. The world's *y* axis points up; lengths are in the unit of the
//! model. [`sheet`] puts the pictures of an animation side by side.
//!
//! ```
//! use ga_render::{Camera, Scene, Style, ViewDirection, render};
//!
//! let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
//! let scene = Scene::new(&positions, &triangles);
//! let style = Style { width: 60, height: 80, ..Style::default() };
//! let camera = Camera::fit(positions, ViewDirection::default(), 0.5, style.aspect(), 0.1)?;
//! let picture = render(&scene, &camera, &style)?;
//! assert_eq!(picture.colour.dimensions(), (60, 80));
//! let [column, row, depth] = camera.project([0.3, 0.3, 0.3], 60, 80).unwrap();
//! assert!(picture.depth.get(column as u32, row as u32).unwrap() < depth);
//! # Ok::<(), ga_render::RenderError>(())
//! ```

mod camera;
mod clip;
mod depth;
mod depth_contrast;
mod ground;
mod overlay;
mod raster;
mod resolve;
mod shade;
mod shadow;
pub mod sheet;
mod style;
mod surface;

use ga_image::colour::SrgbEncoder;
use image::RgbImage;

pub use camera::{Camera, ViewDirection};
pub use depth::DepthMap;
pub use ground::Ground;
pub use shade::{Light, Lighting};
pub use style::Style;

/// What a picture shows.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// One point for each vertex.
    pub positions: &'a [[f64; 3]],
    /// Three vertex indices for each triangle, counter-clockwise seen from outside.
    pub triangles: &'a [[u32; 3]],
    /// Segments drawn over the picture, with a dot at each end; hidden by nothing.
    pub bones: &'a [[[f64; 3]; 2]],
    /// The ground, if there is one.
    pub ground: Option<Ground>,
}

impl<'a> Scene<'a> {
    /// A mesh alone.
    pub fn new(positions: &'a [[f64; 3]], triangles: &'a [[u32; 3]]) -> Self {
        Self {
            positions,
            triangles,
            bones: &[],
            ground: None,
        }
    }
}

/// A picture and the depths in it.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// The shaded picture, sRGB.
    pub colour: RgbImage,
    /// The depth of the mesh at every pixel.
    pub depth: DepthMap,
}

/// Why a scene cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RenderError {
    /// A position has a coordinate that is NaN, infinite, or beyond 10³⁰.
    #[error("vertex {vertex} has a coordinate that is not finite or beyond 1e30")]
    Position {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {vertex}, but there are {vertices} vertices")]
    Triangle {
        /// Index of the triangle.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// The number of vertices there are.
        vertices: usize,
    },
    /// An end of a bone has a coordinate that is NaN, infinite, or beyond 10³⁰.
    #[error("bone {bone} has an end with a coordinate that is not finite or beyond 1e30")]
    Bone {
        /// Index of the bone.
        bone: usize,
    },
    /// The ground's height is not finite or its grid is not positive.
    #[error("the ground's height is not finite or its grid not positive")]
    Ground,
    /// The camera is not usable; the text says why.
    #[error("invalid camera: {0}")]
    Camera(&'static str),
    /// The style is not usable; the text says why.
    #[error("invalid picture: {0}")]
    Style(&'static str),
}

/// Draws a scene.
///
/// The mesh is drawn two-sided; triangles without area are left out. Parts nearer than the camera's
/// near depth are cut off exactly.
///
/// # Errors
///
/// [`RenderError`] for coordinates that are not finite, indices out of range, and unusable styles.
pub fn render(scene: &Scene, camera: &Camera, style: &Style) -> Result<Rendering, RenderError> {
    style.check()?;
    check(scene)?;
    let samples = surface::Samples::draw(scene, camera, style);
    let (mut light, depth) = resolve::resolve(scene, camera, style, &samples)?;
    let extent = bounding_diagonal(scene.positions);
    depth_contrast::darken_behind_edges(&mut light, &depth, extent, style.depth_contrast);
    overlay::draw_bones(&mut light, scene.bones, camera, style);

    let encoder = SrgbEncoder::new();
    let bytes = light.iter().flat_map(|&c| encoder.encode(c)).collect();
    let colour = RgbImage::from_vec(style.width, style.height, bytes)
        .ok_or(RenderError::Style("it is too large"))?;
    Ok(Rendering { colour, depth })
}

/// A vector in the world, or in a camera's frame: right offset, up offset and depth.
type Vector = ga_runtime::vga3::Vector<f64>;

/// Squares and triple products of coordinates up to here stay finite.
const LARGEST_COORDINATE: f64 = 1e30;

fn check(scene: &Scene) -> Result<(), RenderError> {
    let reasonable = |p: &[f64; 3]| p.iter().all(|c| c.abs() <= LARGEST_COORDINATE);
    if let Some(vertex) = scene.positions.iter().position(|p| !reasonable(p)) {
        return Err(RenderError::Position { vertex });
    }
    let vertices = scene.positions.len();
    for (triangle, corners) in scene.triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Err(RenderError::Triangle {
                triangle,
                vertex,
                vertices,
            });
        }
    }
    if let Some(bone) = scene
        .bones
        .iter()
        .position(|ends| !ends.iter().all(reasonable))
    {
        return Err(RenderError::Bone { bone });
    }
    match scene.ground {
        Some(ground)
            if !(ground.height.abs() <= LARGEST_COORDINATE
                && ground.grid.is_normal()
                && ground.grid > 0.0) =>
        {
            Err(RenderError::Ground)
        }
        _ => Ok(()),
    }
}

/// The length of the bounding box's diagonal; 0 without positions.
fn bounding_diagonal(positions: &[[f64; 3]]) -> f64 {
    let corners = positions.iter().map(|&p| [Vector::from(p); 2]);
    let bounds = corners.reduce(|[low, high], [a, b]| [low.min(a), high.max(b)]);
    bounds.map_or(0.0, |[low, high]| low.distance(high))
}
