//! Who is filmed, and what it does.

use std::path::PathBuf;

use anyhow::{Context as _, Result};
use ga_anim::clip::Clip;
use ga_character::storyboard::{STEPS, Storyboard};
use ga_character::{Animation, Figure};
use ga_mannequin::{Human, KEY_TIME, KEYS_PER_STRIDE, walk};

use super::inputs::FRAMES;
use super::studio::FRAMES_PER_SECOND;
use crate::frame::Warning;
use crate::moved::{End, FigureFiles, MovedArguments};
use crate::person::MANNEQUIN;
use crate::pipeline::Performance;
use crate::report::{Input, MotionInput};

/// Two steps each.
const STRIDES: u16 = 2;
/// Rows and columns of the painted skin.
pub(super) const TEXTURE_SIZE: usize = 1024;

/// Who is filmed, by files.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct SubjectArguments {
    /// Film this motion in place of the walk: BVH in any unit, the first animation of a glTF file,
    /// or a compressed clip. It is put on the figure as by `nullcone animate`, and its first second
    /// is filmed; a shorter one stays in its last pose.
    #[arg(long, value_name = "FILE.bvh|FILE.glb|FILE.clip")]
    motion: Option<PathBuf>,
    #[command(flatten)]
    moved: MovedArguments,
}

/// The figure in its motion.
pub(super) struct Subject {
    pub(super) performance: Performance,
    /// The motion of which the first second is filmed.
    pub(super) clip: Clip,
    /// What is unusual about the files.
    pub(super) warnings: Vec<Warning>,
}

impl SubjectArguments {
    /// The files that are read.
    pub(super) fn inputs(&self) -> impl Iterator<Item = &PathBuf> {
        self.motion.iter().chain(self.moved.inputs())
    }

    /// Reads the files.
    pub(super) fn read(&self) -> Result<Subject> {
        let figure = mannequin();
        let mut warnings = Vec::new();
        let Some(motion) = &self.motion else {
            let clip = walk(STRIDES);
            return Ok(Subject {
                performance: walking(figure, &clip)?,
                clip,
                warnings,
            });
        };
        let rate = f64::from(FRAMES_PER_SECOND);
        let second = End::Seconds(FRAMES as f64 / rate);
        let onto = (&figure.character, MANNEQUIN);
        let moved = self.moved.moved(motion, second, onto, &mut warnings)?;
        let clip = moved.transfer.clip.clone();
        let performance = moved.performance("demo", own_files(), figure, rate)?;
        Ok(Subject {
            performance,
            clip,
            warnings,
        })
    }
}

fn own_files() -> FigureFiles {
    let [mesh, rig, weights] = ["made by nullcone"; 3].map(str::to_owned);
    FigureFiles { mesh, rig, weights }
}

/// The figure that the program makes, in its clothes.
fn mannequin() -> Figure {
    let human = Human::new();
    Figure {
        paint: Some(human.texture(TEXTURE_SIZE)),
        ..Figure::new("mannequin", human.into())
    }
}

/// The figure with its walk.
fn walking(figure: Figure, keys: &Clip) -> Result<Performance> {
    let FigureFiles { mesh, rig, weights } = own_files();
    let clip = keys.resampled(STEPS as f64 / KEY_TIME);
    Ok(Performance {
        command: "demo",
        input: Input {
            mesh,
            rig,
            weights,
            motion: MotionInput {
                name: "walk".to_owned(),
                joints: figure.character.skeleton.len(),
                frames: keys.frames().len(),
                frames_per_second: 1.0 / KEY_TIME,
                first_frame: 0,
                last_frame: keys.frames().len() - 1,
                calibration_frame_left_out: false,
                joints_without_counterpart: Vec::new(),
                metres_per_unit: 1.0,
            },
        },
        figure,
        animation: Animation {
            name: "walk".to_owned(),
            clip: clip.context("the walk has no frames")?,
            storyboard: Storyboard::of_keys(keys, KEYS_PER_STRIDE),
            title: format!(
                "Walk: {KEYS_PER_STRIDE} key poses a stride, 3 in-betweens after each by screw \
                 motion"
            ),
            in_between_deviation: None,
        },
        checks: None,
    })
}
