//! Contact sheets: the frames of an animation side by side, with key frames marked.
//!
//! [`contact_sheet`] draws every frame with one camera direction and one scale, chosen so that the
//! whole figure with its shadow is in every picture, and puts the pictures under each other in rows
//! with captions. A [`Frame`] is the mesh at one moment: plain positions, however they were found.
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

mod film;
mod framing;
mod layout;
mod paint;

use ga_image::plane::Plane;
use rayon::prelude::*;

use crate::{
    Camera, Ground, Material, Object, Polyline, RenderError, Rendering, Scene, Style,
    ViewDirection, render,
};
pub use film::{Film, Shooting};
pub use framing::Framing;
pub use layout::Layout;

/// A mesh at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The frame's number, for the caption.
    pub number: usize,
    /// The frame's time in seconds, for the caption.
    pub time: f64,
    /// Whether it was given or computed.
    pub kind: Kind,
    /// The places of the vertices.
    pub positions: &'a [[f64; 3]],
    /// Segments to draw over the picture, none or the bones of a skeleton.
    pub bones: &'a [[[f64; 3]; 2]],
    /// Lines of the world to draw over the picture, such as the paths of joints. They have no
    /// influence on the camera.
    pub lines: &'a [Polyline<'a>],
}

impl<'a> Frame<'a> {
    /// A key frame at the time 0, without bones and lines.
    #[must_use]
    pub fn new(number: usize, positions: &'a [[f64; 3]]) -> Self {
        Self {
            number,
            time: 0.0,
            kind: Kind::Key,
            positions,
            bones: &[],
            lines: &[],
        }
    }
}

/// What moves: all about it but the places of its vertices.
#[derive(Clone, Debug)]
pub struct Subject<'a> {
    /// The surface; a frame's positions are drawn in place of the object's own.
    pub object: Object<'a>,
    /// The materials that the object names by index.
    pub materials: &'a [Material<'a>],
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
        camera: &Camera,
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
        render(&scene, camera, style).map_err(|source| SheetError::Frame {
            number: frame.number,
            source,
        })
    }
}

/// The role of a frame in an animation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Given.
    Key,
    /// Computed: `step` of `steps` equal steps of time after a key frame, the next key frame being
    /// at `steps`.
    InBetween {
        /// From 1 to `steps − 1`.
        step: usize,
        /// How many steps there are from key to key: one more than there are frames between.
        steps: usize,
    },
}

/// How a sheet is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Written over the sheet, if not empty. Characters beyond Latin-1 become question marks.
    pub title: String,
    /// Size and look of each picture.
    pub style: Style,
    /// The side the figure is seen from.
    pub view: ViewDirection,
    /// Whether the camera follows the figure.
    pub framing: Framing,
    /// Which pictures stand side by side.
    pub layout: Layout,
    /// Whether there is a row of depth pictures under each row of pictures.
    pub depth: bool,
    /// The height of the ground; `None` for the level of the lowest vertex of all frames.
    pub ground: Option<f64>,
    /// The distance between the lines on the ground; `None` for a round number below a third of the
    /// figure's height.
    pub grid: Option<f64>,
}

impl Default for Options {
    /// Pictures of 240 × 320 from three quarters that follow the figure, in rows from key to key,
    /// with depth.
    fn default() -> Self {
        Self {
            title: String::new(),
            style: Style {
                width: 240,
                height: 320,
                supersampling: 3,
                ..Style::default()
            },
            view: ViewDirection::default(),
            framing: Framing::Following,
            layout: Layout::KeyToKey,
            depth: true,
            ground: None,
            grid: None,
        }
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

/// Why a sheet cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SheetError {
    /// There are no frames.
    #[error("a contact sheet needs at least one frame")]
    NoFrames,
    /// A frame cannot be drawn.
    #[error("frame {number}: {source}")]
    Frame {
        /// The frame's number.
        number: usize,
        /// Why not.
        source: RenderError,
    },
    /// The figure has no camera that sees it, or the style is not usable.
    #[error(transparent)]
    Picture(#[from] RenderError),
    /// Rows from key to key need at least two key frames, the first frame and the last among them.
    #[error(
        "rows from key to key, but the first and the last of the frames are not two key frames"
    )]
    NotKeyToKey,
    /// A sheet without columns, or one that is too large.
    #[error("a contact sheet of {columns} columns and {rows} rows cannot be made")]
    Size {
        /// Columns of pictures.
        columns: usize,
        /// Rows of pictures.
        rows: usize,
    },
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
            let camera = &stage.cameras[index];
            subject.picture(frame, stage.ground, camera, &options.style)
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
