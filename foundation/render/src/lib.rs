//! Pictures of triangle meshes: a small software renderer.
//!
//! [`render`] draws the objects of a [`Scene`], given as plain positions and triangles, on a level
//! ground that shows their shadow, and lines and dots over them. It returns the picture and its
//! [`DepthMap`]. [`Buffers`] are what is seen at the centre of each pixel as numbers: which
//! triangle, how far away, with which texture coordinates. [`sheet`] puts the pictures of an
//! animation side by side, [`panel`] pictures of numbers with their scales; [`text`] writes on
//! pictures.
//!
//! | type | what it is |
//! | --- | --- |
//! | [`Scene`], [`Object`], [`Polyline`], [`Dot`], [`Ground`] | what is drawn |
//! | [`model`] | models from files as such scenes |
//! | [`bake`] | pictures for the maps of [`ga_mesh::bake`] |
//! | [`Appearance`], [`texture::Mipmap`] | the appearance of surfaces |
//! | [`View`], [`ViewDirection`] | from where it is seen: of a [`ga_camera::Camera`], or from a
//! side |
//! | [`Segment`] | lines and dots over a picture that is there already |
//! | [`Viewpoint`] | the same as text, and the views of a turntable |
//! | [`view_file`] | views as cameras of files |
//! | [`Style`], [`Lighting`] | size, light and colours of the picture |
//!
//! Hidden surfaces are removed by a depth buffer with several samples for each pixel. A triangle is
//! shaded once for each pixel, in linear light, and the pixel is the mean of its samples. Equal
//! input gives equal pictures, bit for bit, for any number of threads. The world's *y* axis points
//! up; lengths are in the unit of the model.
//!
//! ```
//! use ga_render::{View, Scene, Style, ViewDirection, render};
//!
//! let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
//! let scene = Scene::new(&positions, &triangles);
//! let style = Style { width: 60, height: 80, ..Style::default() };
//! let view = View::fit(positions, ViewDirection::default(), 0.5, style.aspect(), 0.1)?;
//! let picture = render(&scene, &view, &style)?;
//! assert_eq!([picture.colour.width(), picture.colour.height()], [60, 80]);
//! let [column, row, depth] = view.project([0.3, 0.3, 0.3], 60, 80).unwrap();
//! assert!(picture.depth.get(column as u32, row as u32).unwrap() < depth);
//! # Ok::<(), ga_render::RenderError>(())
//! ```

mod appearance;
pub mod bake;
mod barycentric;
pub mod buffer_files;
mod buffers;
mod check;
mod clip;
mod cut;
mod depth;
mod depth_contrast;
mod error;
mod fragment;
mod ground;
mod ground_shading;
mod layers;
mod lens;
pub mod model;
mod occlusion;
pub mod panel;
mod raster;
mod resolve;
mod scene;
mod segment;
mod shade;
mod shadow;
mod shadow_map;
pub mod sheet;
mod space;
mod stroke;
mod style;
mod surface;
pub mod text;
pub mod texture;
mod view;
pub mod view_file;
mod viewpoint;
mod world;

use ga_image::colour::SrgbEncoder;
use ga_image::plane::Plane;
use space::{LARGEST_COORDINATE, Vector};
use surface::Pass;

pub use appearance::{Appearance, CoordinateSet, Placement, Placements};
pub use buffers::{Buffers, SurfacePoint};
pub use depth::DepthMap;
pub use error::RenderError;
pub use ground::Ground;
pub use scene::{Attribute, Dot, MaterialChoice, Normals, Object, Polyline, Scene, Visibility};
pub use segment::Segment;
pub use shade::{Light, Lighting};
pub use style::{Shading, Style};
pub use view::{View, ViewDirection};
pub use viewpoint::{Viewpoint, ViewpointError};

/// A picture and the depths in it.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// The shaded picture, sRGB.
    pub colour: Plane<[u8; 3]>,
    /// The depth of the mesh at every pixel.
    pub depth: DepthMap,
}

/// Draws a scene.
///
/// Triangles without area are left out. Parts nearer than the camera's near depth or beyond its far
/// depth are cut off exactly. Transparent surfaces are blended from back to front in every sample,
/// also where they cross each other; the depth is that of opaque surfaces.
///
/// # Errors
///
/// [`RenderError`] for numbers that are not finite, indices out of range, and unusable styles.
pub fn render(scene: &Scene, view: &View, style: &Style) -> Result<Rendering, RenderError> {
    style.check()?;
    check::check(scene)?;
    let world = world::World::new(scene, view)?;
    let size = [style.width, style.height];
    let samples = surface::Samples::draw(&world, view, size, style.supersampling, Pass::Opaque);
    let layers = layers::Layers::draw(&world, view, style, &samples);
    let (mut light, depth) =
        resolve::resolve(&world, scene.ground, view, style, &samples, &layers)?;
    depth_contrast::darken_behind_edges(&mut light, &depth, world.extent(), style.depth_contrast);
    stroke::draw(&mut light, scene, &world, view, style, &samples);

    let encoder = SrgbEncoder::new();
    let codes = light.iter().map(|&colour| encoder.encode(colour)).collect();
    let colour = Plane::from_values(style.width as usize, style.height as usize, codes)
        .map_err(|_| RenderError::Style("it is too large"))?;
    Ok(Rendering { colour, depth })
}
