//! What is drawn over the figure: its bones, and the paths of joints.

use ga_anim::character::Character;
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::skeleton::SkeletonError;
use ga_image::colour::LinearColour;
use ga_render::{Polyline, Visibility};

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
#[derive(Clone, Debug)]
pub struct Overlay<'a> {
    /// The character that moves.
    pub character: &'a Character,
    /// Its motion.
    pub clip: &'a Clip,
    /// Whether the bones are drawn.
    pub bones: bool,
    /// The joints whose paths during the last second are drawn, each in a colour of its own.
    pub joints: Vec<usize>,
}

/// The overlay of one moment.
#[derive(Clone, Debug)]
pub struct Marks {
    /// Head and tail of each bone, where bones are drawn.
    pub bones: Vec<[[f64; 3]; 2]>,
    pieces: Vec<Piece>,
}

/// A piece of a path.
#[derive(Clone, Copy, Debug)]
struct Piece {
    ends: [[f64; 3]; 2],
    colour: LinearColour,
    /// As a share of the picture's height.
    width: f64,
}

impl Overlay<'_> {
    /// What is drawn over the picture of a pose at a time in seconds.
    ///
    /// # Errors
    ///
    /// [`SkeletonError`] for a pose of another skeleton.
    pub fn marks(&self, time: f64, pose: &Pose) -> Result<Marks, SkeletonError> {
        let bones = match self.bones {
            true => pose.bones(&self.character.skeleton)?,
            false => Vec::new(),
        };
        let mut pieces = Vec::new();
        if !self.joints.is_empty() {
            let mut newer = self.character.joints(pose)?;
            for piece in 0..PIECES {
                let age = (piece + 1) as f64 / PIECES as f64;
                let before = time - age * WINDOW;
                if before < 0.0 {
                    break;
                }
                let older = self.character.joints(&self.clip.sample(before))?;
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
    /// The paths on a picture of this height in pixels.
    #[must_use]
    pub fn lines(&self, height: u32) -> Vec<Polyline<'_>> {
        let lines = self.pieces.iter().map(|piece| Polyline {
            points: &piece.ends,
            colour: piece.colour,
            width: (piece.width * f64::from(height)).max(1.0),
            visibility: Visibility::OnTop,
        });
        lines.collect()
    }
}
