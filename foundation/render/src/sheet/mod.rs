//! Contact sheets: the frames of an animation side by side, with key frames marked.
//!
//! [`contact_sheet`] draws every frame with one camera direction and one scale, chosen so that the
//! whole figure with its shadow is in every picture, and puts the pictures under each other in rows
//! with captions. A [`Frame`] is the mesh at one moment: plain positions, however they were found.
//! [`captioned_sheet`] puts pictures of any origin side by side.
//!
//! ```
//! use ga_render::sheet::{Frame, Kind, Options, contact_sheet};
//!
//! let triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
//! let corners = |x: f64| [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
//! let places = [corners(0.0), corners(0.3), corners(0.6)];
//! let frames: Vec<_> = places
//!     .iter()
//!     .enumerate()
//!     .map(|(number, positions)| Frame {
//!         number,
//!         time: number as f64 / 30.0,
//!         kind: if number == 1 { Kind::InBetween { step: 1, steps: 2 } } else { Kind::Key },
//!         positions,
//!         bones: &[],
//!         lines: &[],
//!     })
//!     .collect();
//! let sheet = contact_sheet(&frames, &triangles, &Options::default())?;
//! assert_eq!(sheet.pictures.len(), 3);
//! ga_image::png::write(std::env::temp_dir().join("nullcone-doctest-sheet.png"), &sheet.image)?;
//! # std::fs::remove_file(std::env::temp_dir().join("nullcone-doctest-sheet.png"))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod captioned;
mod error;
mod frame;
mod framing;
mod layout;
mod options;
mod paint;
mod sequence;

use ga_image::plane::Plane;
use rayon::prelude::*;

use crate::{Appearance, Ground, Object, Rendering, Scene, Style, View, render};
pub use captioned::{Captioned, captioned_sheet};
pub use error::SheetError;
pub use frame::{Frame, Kind};
pub use sequence::{Sequence, Shooting};

pub use options::{Framing, Layout, Options};

/// What moves: all about it but the places of its vertices.
#[derive(Clone, Debug)]
pub struct Subject<'a> {
    /// The surface; a frame's positions are drawn in place of the object's own.
    pub object: Object<'a>,
    /// The materials that the object names by index.
    pub materials: &'a [Appearance<'a>],
}

impl<'a> Subject<'a> {
    /// A mesh in the style's colour.
    pub fn new(triangles: &'a [[u32; 3]]) -> Self {
        Self {
            object: Object::new(&[], triangles),
            materials: &[],
        }
    }

    /// The picture of a frame.
    fn picture(
        &self,
        frame: &Frame,
        ground: Ground,
        view: &View,
        style: &Style,
    ) -> Result<Rendering, SheetError> {
        let scene = Scene {
            objects: vec![Object {
                positions: frame.positions,
                ..self.object.clone()
            }],
            materials: self.materials,
            lines: frame.lines,
            bones: frame.bones,
            ground: Some(ground),
            ..Scene::default()
        };
        render(&scene, view, style).map_err(|source| SheetError::Frame {
            number: frame.number,
            source,
        })
    }
}

/// A contact sheet and what is on it.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The sheet.
    pub image: Plane<[u8; 3]>,
    /// The picture of each frame, in the order of the frames.
    pub pictures: Vec<Rendering>,
    /// The least and greatest depth in any picture: the range of all depth pictures on the sheet.
    /// `None` when no picture shows anything.
    pub depth_range: Option<(f64, f64)>,
}

/// Draws the frames of one mesh and lays them out on a sheet.
///
/// All frames stand on one ground and are drawn at one scale, the largest that shows each of them
/// whole.
///
/// # Errors
///
/// [`SheetError`] when there is nothing to be drawn or a frame holds numbers that are not finite.
pub fn contact_sheet(
    frames: &[Frame],
    triangles: &[[u32; 3]],
    options: &Options,
) -> Result<Sheet, SheetError> {
    contact_sheet_of(frames, &Subject::new(triangles), options)
}

/// As [`contact_sheet`], of a surface with normals, materials and textures.
///
/// # Errors
///
/// As [`contact_sheet`].
pub fn contact_sheet_of(
    frames: &[Frame],
    subject: &Subject,
    options: &Options,
) -> Result<Sheet, SheetError> {
    let rows = options.layout.rows(frames)?;
    let size = layout::Size::new(&rows, options)?;
    let outlines = frames
        .iter()
        .map(|frame| framing::Outline::new(frame, options));
    let outlines = outlines.collect::<Result<Vec<_>, _>>()?;
    let stage = framing::Stage::new(&outlines, options)?;
    let pictures = frames
        .par_iter()
        .enumerate()
        .map(|(index, frame)| {
            let view = &stage.views[index];
            subject.picture(frame, stage.ground, view, &options.style)
        })
        .collect::<Result<Vec<_>, _>>()?;
    let depth_range = pictures
        .iter()
        .filter_map(|picture| picture.depth.range())
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    let image = paint::sheet(frames, &pictures, &rows, &size, depth_range, options);
    Ok(Sheet {
        image,
        pictures,
        depth_range,
    })
}
