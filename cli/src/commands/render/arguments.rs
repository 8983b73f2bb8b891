//! The arguments of `nullcone render`.

use std::path::PathBuf;

use clap::ValueEnum;
use serde::Serialize;

use super::film_arguments::FilmArguments;
use crate::camera_file::LensChoice;
use crate::chosen_animation::ChosenAnimation;
use crate::part::Frames;
use crate::picture_file::picture_size;

/// Draw a model.
///
/// The model is Wavefront OBJ with its materials and textures, PLY or glTF. It is lit by a key
/// light from the upper left of the camera, a weak light from the right and light from all around;
/// objects cast shadows. Transparent surfaces show what lies behind them, and lines and points of
/// the model are drawn. Of glTF models, faces are seen from the back where their material is
/// double-sided; of others, all are.
///
/// An animated glTF model is drawn at a --time of an --animation, with its skins, morph targets and
/// moving nodes; without both, in the pose of its nodes. --film FILE draws all frames of the
/// animation, from one camera that sees the whole film, or from a --camera-node that may move.
///
/// The camera (--camera) is one of
///
///   front, side, top, three-quarter
///       a view of the whole model, whose y axis points up and which looks along +z
///   eye X,Y,Z target X,Y,Z fov DEGREES
///   eye X,Y,Z target X,Y,Z up X,Y,Z fov DEGREES
///       a place, what it looks at, the upward direction (0,1,0 by default) and the vertical field
///       of view, as one argument in quotation marks
///   FILE
///       the camera of a file of any format (docs/stereo.md lists them), which --view chooses if
///       there are several. It needs a pose; the world of a rig is the frame of its left camera.
///       Distortion is not drawn: nullcone stereo undistort removes it. In JSON, for instance:
///       intrinsics in pixels and the pose from the world to the camera, whose axes are x right,
///       y down, z forwards; (0, 0) is the middle of the first pixel. A point p falls on
///       (fx x/z + cx, fy y/z + cy), where (x, y, z) = rotation p + translation:
///
///       {"width": 640, "height": 480, "fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5,
///        "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 2]}
///
///       "skew" (0 by default), "near" and "far" may be added.
///
/// --json prints {"out": …, "width_px": …, "height_px": …, "pictures": …, "triangles": …,
/// "seconds": …, "files": […], "warnings": […]}; of an animation, also {"animation": …,
/// "animation_name": …, "time_seconds": …, "duration_seconds": …}, where the time is that of the
/// first picture and the duration that of the animation, and of a film "frames_per_second".
#[derive(Clone, Debug, Serialize, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The model: its name ends in .obj, .ply, .glb or .gltf.
    #[arg(value_name = "MODEL")]
    pub(super) model: PathBuf,
    /// From where it is seen; see above.
    #[arg(long, value_name = "VIEW", default_value = "three-quarter")]
    pub(super) camera: String,
    /// The camera of the file: its name, or its number from 0.
    #[arg(long, value_name = "NAME")]
    pub(super) view: Option<String>,
    #[command(flatten)]
    #[serde(flatten)]
    pub(super) lens: LensChoice,
    /// See the model from a camera inside the glTF document: the name of its node or of the camera,
    /// or the number of the node from 0. In a film it moves with its node.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["camera", "view"])]
    pub(super) camera_node: Option<String>,
    /// Columns and rows of the picture; by default those of the camera's file, or 1280x720, or 720
    /// rows as wide as a --camera-node says.
    #[arg(long, value_name = "WxH", value_parser = picture_size)]
    pub(super) size: Option<[usize; 2]>,
    /// The picture: PNG if its name ends in .png, or a film as of --film.
    #[arg(
        long,
        value_name = "FILE.png|FILE.y4m|FILE.mp4",
        required_unless_present = "film"
    )]
    #[serde(skip)]
    pub(super) out: Option<PathBuf>,
    #[command(flatten)]
    #[serde(flatten)]
    pub(super) animation: ChosenAnimation,
    /// The time in seconds of the animation that is drawn; by default 0.
    ///
    /// Before the first key of a channel the first key counts, after the last key the last. A time
    /// that the animation does not have is warned of.
    #[arg(long, value_name = "SECONDS", conflicts_with = "film")]
    pub(super) time: Option<f64>,
    #[command(flatten)]
    #[serde(flatten)]
    pub(super) film: FilmArguments,
    /// Draw these pictures of the film or the turntable alone, the first included and the last not,
    /// as A.. and ..B too: a part, which is described beside it in FILE.y4m.json for `nullcone
    /// merge`.
    #[arg(long, value_name = "A..B", conflicts_with_all = ["buffers", "views"])]
    #[serde(skip)]
    pub(super) frames: Option<Frames>,
    /// As many pictures with the camera moving once around the model: an animated PNG or a film
    /// with 25 pictures in a second. At most 1000, with at most 2^30 pixels together.
    #[arg(long, value_name = "N", default_value_t = 1, conflicts_with = "film")]
    pub(super) turntable: u32,
    /// Whether surfaces are lit or show their base colour.
    #[arg(long, value_enum, default_value_t = Light::Lit)]
    pub(super) shading: Light,
    /// Samples along each side of a pixel, 1 to 8, against jagged edges.
    #[arg(long, value_name = "N", default_value_t = 3)]
    pub(super) samples: u32,
    /// One colour behind the model, as six hexadecimal digits such as ffffff, in place of a
    /// gradient.
    #[arg(long, value_name = "RRGGBB")]
    pub(super) background: Option<String>,
    /// Draw the edges of all triangles.
    #[arg(long)]
    pub(super) wireframe: bool,
    /// Put the model on level ground, that of a film at its lowest place in all frames.
    #[arg(long)]
    pub(super) ground: bool,
    /// Also write what the first picture shows at the middle of each pixel, as numbers, into this
    /// folder.
    ///
    /// depth.pfm holds the distance along the viewing direction and distance.pfm that from the eye,
    /// both infinite where nothing is seen; uv.pfm texture coordinates and a mask; normal.pfm the
    /// normal in the world; identity.png, with 16 bits for each channel, the object, counted from
    /// 1, in red and the triangle, counted from 1, in green (multiples of 65536) and blue (the
    /// rest); material.png, grey with 16 bits, the material, counted from 1. Where nothing is seen,
    /// all these are 0.
    #[arg(long, value_name = "DIR", conflicts_with = "film")]
    #[serde(skip)]
    pub(super) buffers: Option<PathBuf>,
    /// Also write each picture as PNG into this folder, and views.json with their cameras, which
    /// `nullcone texture` and `nullcone body fit` read.
    #[arg(long, value_name = "DIR", conflicts_with = "film")]
    #[serde(skip)]
    pub(super) views: Option<PathBuf>,
    /// Also write the camera of the first picture, as --camera reads it.
    #[arg(long, value_name = "FILE.json")]
    #[serde(skip)]
    pub(super) camera_out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Light {
    Lit,
    Unlit,
}
