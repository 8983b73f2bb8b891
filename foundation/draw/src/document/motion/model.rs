//! What a motion consists of.

use std::ops::Range;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

use crate::colour::{Colour, PALETTE};

/// A figure of points and bones that moves, beside films of the same frames. Lengths are in metres,
/// y is up, frames count from 0.
///
/// ```
/// use ga_draw::document::{Bone, Motion, Page, Side};
///
/// let motion = Motion {
///     frames_per_second: 25.0,
///     names: vec!["elbow".into(), "wrist".into()],
///     bones: vec![Bone { ends: [0, 1], side: Side::Left }],
///     frames: vec![
///         Some(vec![[0.0, 1.2, 0.0], [0.25, 1.2, 0.0]]),
///         None,
///         Some(vec![[0.0, 1.2, 0.0], [0.24, 1.3, 0.0]]),
///     ],
///     floor: Some(0.0),
///     cameras: vec![],
///     films: vec![],
/// };
/// let mut page = Page::new("An arm");
/// page.motion(&motion, "The left arm is lifted.")?;
/// assert!(page.into_html().contains("<figcaption>The left arm is lifted.</figcaption>"));
/// # Ok::<(), ga_draw::document::MotionError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// The number of frames in a second.
    pub frames_per_second: f64,
    /// The names of the points, which are shown under the mouse.
    pub names: Vec<String>,
    /// The lines between points.
    pub bones: Vec<Bone>,
    /// For each frame the places of all points; `None` where the pose is not known.
    pub frames: Vec<Option<Vec<[f64; 3]>>>,
    /// The height of the floor, on which a grid is drawn.
    pub floor: Option<f64>,
    /// The cameras that are shown in space.
    pub cameras: Vec<MotionCamera>,
    /// The films that are shown beside the figure.
    pub films: Vec<MotionFilm>,
}

/// A line between two points of a [`Motion`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bone {
    /// The indices of the points.
    pub ends: [usize; 2],
    /// The side of the body, which gives the colour.
    pub side: Side,
}

/// A side of a body, as the person calls it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The person's left.
    Left,
    /// The person's right.
    Right,
    /// Neither, as the spine.
    Middle,
}

impl Side {
    /// All sides.
    pub(super) const ALL: [Self; 3] = [Self::Left, Self::Right, Self::Middle];

    /// The colour in which it is drawn; people with any colour vision tell the sides apart.
    #[must_use]
    pub fn colour(self) -> Colour {
        match self {
            Self::Left => PALETTE[0],
            Self::Right => PALETTE[1],
            Self::Middle => PALETTE[6],
        }
    }
}

/// A camera, drawn as a pyramid with the centre of projection at its tip.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionCamera {
    /// The name that stands beside it.
    pub name: String,
    /// The centre of projection in metres.
    pub centre: [f64; 3],
    /// The corners of the base in metres: points that are seen at the corners of the picture, from
    /// the upper left one clockwise.
    pub corners: [[f64; 3]; 4],
}

/// A film beside a [`Motion`].
#[derive(Clone, Debug, PartialEq)]
pub struct MotionFilm {
    /// The name that stands below it.
    pub name: String,
    /// The width and height of its pictures in pixels.
    pub size: [u32; 2],
    /// Its pictures in the order of frames. Frames without a picture are shown as such.
    pub pictures: Vec<MotionPicture>,
}

/// A picture of a [`MotionFilm`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MotionPicture {
    /// The frames at which it is shown: one, or several where the film has fewer pictures.
    pub frames: Range<usize>,
    /// The format of the file.
    pub encoding: Encoding,
    /// The bytes of the file.
    pub bytes: Vec<u8>,
}

/// The format of a picture, as browsers read it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// JPEG.
    Jpeg,
    /// PNG.
    Png,
}

impl Encoding {
    /// The address under which a page has a picture in itself.
    pub(in crate::document) fn address(self, bytes: &[u8]) -> String {
        let kind = match self {
            Self::Jpeg => "jpeg",
            Self::Png => "png",
        };
        format!("data:image/{kind};base64,{}", BASE64_STANDARD.encode(bytes))
    }
}
