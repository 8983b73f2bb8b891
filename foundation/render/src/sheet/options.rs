//! How sheets are made.

use crate::{Style, ViewDirection};

/// Which pictures stand side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// A row for each two neighbouring key frames: the one, the frames between, the other. A key
    /// frame in the middle of an animation so ends one row and begins the next.
    KeyToKey,
    /// Rows of this many pictures, each frame once.
    Columns(usize),
}

/// Whether the camera follows the figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Framing {
    /// One camera for all frames: the figure crosses the picture.
    Fixed,
    /// The camera moves level with the middle of the figure: the ground passes below it.
    Following,
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
