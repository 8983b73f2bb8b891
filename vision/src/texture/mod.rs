//! Textures of meshes from calibrated views.
//!
//! Several pictures of a surface, whose cameras are known, are projected into the texture of its
//! mesh (Cui, section 2.1.3). [`texture_mesh`] does this in steps:
//!
//! 1. *Atlas.* The mesh's own texture coordinates are used where every corner has one, otherwise
//!    an [`atlas`] is made. Each texel shows a point p of the surface.
//! 2. *Projection.* The texel is at the pixel `π(M p ~M)` of a view with the motor M from the
//!    world to the camera and the projection π of its lens. For a pinhole, a triangle is warped by
//!    the affine map of its corners ([`TriangleWarp`]) where that is wrong by at most 1/16 pixel
//!    ([`affine_error`] bounds it); in all other triangles, and behind lenses with distortion,
//!    each texel is projected by itself. A texel shows the mean of the light over its area; the
//!    light between the middles of pixels is the spline whose mean over each pixel is the pixel,
//!    except beside edges, where it is a cubic between the nearest pixels.
//! 3. *Visibility.* A ray through the middle of each pixel finds the surface in front. A texel is
//!    seen where the nearest pixels show the surface near its tangent plane, and well seen where
//!    all pixels that have a part in its colour do: elsewhere its colour would be mixed with that
//!    of something in front of it or behind its edge.
//! 4. *Weights.* A view counts by `f_x f_y cos²θ/r²`, its pixels for each unit of area times the
//!    cosine of the angle of incidence θ, at the distance r. Weights fall smoothly to nearly zero
//!    at the borders of what is well seen, of the picture, and for grazing angles.
//! 5. *Exposure.* A gain for each view and channel, by least squares over the overlaps, in linear
//!    light.
//! 6. *Blending* in two bands: low frequencies are the weighted mean of all views, high ones those
//!    of the view that counts most, so that there are neither seams nor double images.
//! 7. *Holes.* Texels that no view sees get the smoothest colours between their neighbours on the
//!    surface, also across the seams of the atlas. Texels that are seen at an edge alone give way
//!    to better ones nearby.
//! 8. *Gutters.* Around charts, texels are copied outwards.
//!
//! Lengths are in the unit of the mesh, which the poses share; pixels count from the middle of the
//! top left one. Equal input gives equal textures, on any number of threads. The memory is about
//! 150 bytes for each texel of the surface, and 6 more for each view.
//!
//! ```
//! use ga_image::plane::Plane;
//! use ga_mesh::obj;
//! use ga_runtime::cga3::Point;
//! use ga_camera::{Camera, Intrinsics};
//! use ga_vision::texture::{Options, View, texture_mesh};
//!
//! // A square of side 2, seen from the front at a distance of 4: 20 pixels for each unit.
//! let text = b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
//!     f 1/1 2/2 3/3 4/4\n";
//! let square = obj::decode(text)?;
//! let intrinsics = Intrinsics::new([80.0, 80.0], [32.0, 32.0])?;
//! let (eye, target) = (Point::new(0.0, 0.0, 4.0), Point::default());
//! let camera = Camera::look_at(intrinsics, eye, target, [0.0, 1.0, 0.0]).ok_or("no view")?;
//! // Red on the left, green on the right.
//! let paint = |column, _| if column < 32 { [255_u8, 0, 0] } else { [0, 255, 0] };
//! let picture = Plane::from_fn(65, 65, paint);
//! let view = View::new("front", camera, Some([65, 65]), &picture)?;
//!
//! let textured = texture_mesh(&square, &[view], &Options::with_size(32), |_| ())?;
//! assert_eq!(textured.texture.get(4, 16), Some([255, 0, 0]));
//! assert_eq!(textured.texture.get(28, 16), Some([0, 255, 0]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod blend;
mod covered;
mod error;
mod exposure;
mod front;
mod geometry;
mod gutter;
mod holes;
mod sampler;
mod target;
mod textured;
mod view;
mod warp;
mod weight;

pub use error::TextureError;
pub use textured::{Report, Textured, ViewReport};
pub use view::View;
pub use warp::{TriangleWarp, affine_error};

use ga_image::colour::{LinearColour, SrgbEncoder};
use ga_image::plane::Plane;
use ga_mesh::Mesh;
use ga_mesh::atlas;
use ga_mesh::bake::Texels;

use blend::{Blend, Layer};
use covered::Covered;
use geometry::Geometry;
use sampler::Decoder;
use target::Target;
use weight::Weights;

/// How a mesh is textured.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// The side of the square texture in texels; 2048 by default.
    pub size: u32,
    /// Make a new atlas even if the mesh has texture coordinates.
    pub unwrap: bool,
    /// In a new atlas, texels around each chart that no other chart claims; 4 by default.
    pub margin_texels: u32,
    /// Level the exposures of the views; true by default.
    pub level_exposure: bool,
    /// The number of texels over which weights fall to zero; 12 by default.
    pub feather_texels: u32,
    /// What is larger than about this number of texels is the mean of all views, and what is
    /// smaller is taken from the best one; 16 by default.
    pub band_texels: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            size: 2048,
            unwrap: false,
            margin_texels: 4,
            level_exposure: true,
            feather_texels: 12,
            band_texels: 16,
        }
    }
}

impl Options {
    /// The default for a texture of this size.
    #[must_use]
    pub fn with_size(size: u32) -> Self {
        Self {
            size,
            ..Self::default()
        }
    }
}

/// About how many texels are compared to level exposures.
const SAMPLES: usize = 200_000;

/// Projects views into the texture of a mesh; see the [module](self). `begin` is told the name of
/// each step as it begins.
///
/// # Errors
/// [`TextureError`].
pub fn texture_mesh(
    mesh: &Mesh,
    views: &[View],
    options: &Options,
    mut begin: impl FnMut(&'static str),
) -> Result<Textured, TextureError> {
    if views.is_empty() || views.len() > usize::from(u16::MAX) {
        return Err(TextureError::NoViews);
    }
    let size = options.size;
    begin("atlas");
    let atlas = atlas::Options {
        size,
        margin_texels: options.margin_texels,
        ..atlas::Options::default()
    };
    let target = Target::new(mesh, &atlas, options.unwrap)?;
    for view in views {
        view.check_place(target.corners())?;
    }
    let texels = Texels::new(&target.coordinates, size)?;
    let covered = Covered::new(&texels, &target, size)?;
    begin("visibility");
    let mut layers = Vec::with_capacity(views.len());
    for view in views {
        layers.push(layer(view, &target, &covered, options)?);
    }
    let decoder = Decoder::new();
    begin("exposure");
    let overlaps = blend::overlaps(&layers, &covered, &decoder, SAMPLES);
    if options.level_exposure {
        for (layer, gain) in layers.iter_mut().zip(overlaps.gains()) {
            layer.gain = gain;
        }
    }
    begin("blending");
    let mut blend = blend::blend(&layers, &covered, &decoder, options.band_texels as usize);
    begin("holes");
    let filled = holes::fill(&mut blend, &covered, &target);
    begin("gutters");
    let texture = picture(&blend, &covered, &texels);
    let reports = (0..).zip(&layers).map(|(number, layer)| {
        let [facing, affine] = layer.geometry.warps();
        ViewReport {
            name: layer.view.name.clone(),
            seen_texels: layer.weights.seen,
            best_texels: blend.best.iter().filter(|best| **best == number).count(),
            overlapping_views: overlaps.partners(usize::from(number)),
            gain: layer.gain,
            facing_triangles: facing,
            affine_triangles: affine,
        }
    });
    let report = Report {
        size,
        unwrapped: target.unwrapped,
        charts: target.chart_count,
        utilisation: target.report.utilisation,
        overlapping_texels: target.report.overlapping_texels,
        covered_texels: covered.len(),
        filled_texels: filled,
        views: reports.collect(),
    };
    Ok(Textured {
        texture,
        report,
        mesh: target.mesh,
    })
}

/// A view with its weights.
fn layer<'a>(
    view: &'a View,
    target: &'a Target,
    covered: &Covered,
    options: &Options,
) -> Result<Layer<'a>, TextureError> {
    let geometry = Geometry::new(target, view.camera, options.size);
    let feather = options.feather_texels as usize;
    let weights = Weights::new(view, &geometry, target, covered, feather);
    if weights.seen == 0 {
        return Err(TextureError::NoOverlap {
            view: view.name.clone(),
        });
    }
    Ok(Layer {
        view,
        geometry,
        weights,
        gain: [1.0; 3],
    })
}

/// The texture in sRGB.
fn picture(blend: &Blend, covered: &Covered, texels: &Texels) -> Plane<[u8; 3]> {
    let side = covered.size as usize;
    let mut linear = Plane::filled(side, side, [0.0_f32; 3]);
    let mut known = vec![false; side * side];
    for (texel, colour) in covered.texels.iter().zip(&blend.colours) {
        linear.values_mut()[texel.index as usize] = *colour;
        known[texel.index as usize] = true;
    }
    gutter::fill(&mut linear, &mut known, texels);
    let encoder = SrgbEncoder::new();
    linear.map(|colour| encoder.encode(LinearColour::from(colour.map(f64::from))))
}
