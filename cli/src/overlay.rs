//! What is drawn over the figure: its bones, and the paths of joints.

use anyhow::{Result, bail};
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_image::colour::LinearColour;
use ga_render::{Polyline, Visibility};

use crate::figure::Figure;

/// What is drawn over the pictures of the figure.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct OverlayArguments {
    /// Draw the bones over the skin.
    #[arg(long)]
    pub(crate) bones: bool,
    /// Draw the paths of these joints during the last second over the picture; `all` for every
    /// joint.
    ///
    /// Example: --trails LeftHand,RightFoot
    #[arg(long, value_name = "JOINT,…", value_delimiter = ',')]
    pub(crate) trails: Vec<String>,
}

/// How long ago the older end of a path is, in seconds.
const WINDOW: f64 = 1.0;

/// Pieces of a path, each with a width and a shade of its own.
const PIECES: usize = 30;

/// The width of a path at its newer and its older end, as a share of the picture's height.
const WIDTHS: [f64; 2] = [0.008, 0.002];

/// The colours of paths, in sRGB.
const COLOURS: [[u8; 3]; 6] = [
    [214, 51, 39],
    [24, 120, 190],
    [36, 145, 60],
    [150, 60, 170],
    [225, 130, 20],
    [20, 150, 150],
];

/// The paths become this much whiter towards their older ends.
const FADING: f64 = 0.6;

/// What is to be drawn over the pictures of a motion.
pub(crate) struct Overlay<'a> {
    figure: &'a Figure,
    clip: &'a Clip,
    bones: bool,
    /// The joints whose paths are drawn.
    joints: Vec<usize>,
}

/// The overlay of one moment.
pub(crate) struct Marks {
    pub(crate) bones: Vec<[[f64; 3]; 2]>,
    pieces: Vec<Piece>,
}

/// A piece of a path.
struct Piece {
    ends: [[f64; 3]; 2],
    colour: LinearColour,
    /// As a share of the picture's height.
    width: f64,
}

impl<'a> Overlay<'a> {
    /// Fails for a joint that the figure does not have.
    pub(crate) fn new(
        figure: &'a Figure,
        clip: &'a Clip,
        arguments: &OverlayArguments,
    ) -> Result<Self> {
        let mut joints = Vec::new();
        for name in &arguments.trails {
            match figure.skeleton.index(name) {
                Some(joint) => joints.push(joint),
                None if name == "all" => joints.extend(0..figure.skeleton.len()),
                None => {
                    let all = figure.skeleton.joints().iter();
                    let names: Vec<&str> = all.map(|joint| joint.name.as_str()).collect();
                    bail!(
                        "--trails {name}: the figure has no such joint; its joints are: {}",
                        names.join(", ")
                    );
                }
            }
        }
        Ok(Self {
            figure,
            clip,
            bones: arguments.bones,
            joints,
        })
    }

    /// What is drawn over the picture of a pose at a time in seconds.
    pub(crate) fn marks(&self, time: f64, pose: &Pose) -> Result<Marks> {
        let skeleton = &self.figure.skeleton;
        let bones = if self.bones {
            pose.bones(skeleton)?
        } else {
            Vec::new()
        };
        let mut pieces = Vec::new();
        if !self.joints.is_empty() {
            let mut newer = self.figure.joints(pose)?;
            for piece in 0..PIECES {
                let age = (piece + 1) as f64 / PIECES as f64;
                let before = time - age * WINDOW;
                if before < 0.0 {
                    break;
                }
                let older = self.figure.joints(&self.clip.sample(before))?;
                for (number, &joint) in self.joints.iter().enumerate() {
                    let colour = LinearColour::from_srgb(COLOURS[number % COLOURS.len()]);
                    pieces.push(Piece {
                        ends: [newer[joint], older[joint]],
                        colour: colour.lerp(LinearColour::WHITE, FADING * age),
                        width: WIDTHS[0] + (WIDTHS[1] - WIDTHS[0]) * age,
                    });
                }
                newer = older;
            }
            // The newest pieces are drawn last.
            pieces.reverse();
        }
        Ok(Marks { bones, pieces })
    }
}

impl Marks {
    /// The paths on a picture of this height.
    pub(crate) fn lines(&self, height: u32) -> Vec<Polyline<'_>> {
        let lines = self.pieces.iter().map(|piece| Polyline {
            points: &piece.ends,
            colour: piece.colour,
            width: (piece.width * f64::from(height)).max(1.0),
            visibility: Visibility::OnTop,
        });
        lines.collect()
    }
}
