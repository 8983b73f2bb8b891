//! Who is filmed, and what it does.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result};
use ga_anim::clip::Clip;
use ga_anim::recording::Recording;
use ga_character::storyboard::{STEPS, Storyboard};
use ga_character::{Animation, Figure, model};
use ga_mannequin::{Human, KEY_TIME, KEYS_PER_STRIDE, skeleton, walk};

use super::inputs::FRAMES;
use super::studio::FRAMES_PER_SECOND;
use crate::frame::Warning;
use crate::person::{Dotted, HueSeed, MANNEQUIN};
use crate::pipeline::{self, Performance};
use crate::report::{Input, MotionInput};
use crate::retargeted::{End, FigureFiles, RetargetedArguments};

/// Two steps each.
const STRIDES: u16 = 2;
/// Rows and columns of the painted skin.
pub(super) const TEXTURE_SIZE: usize = 1024;

/// Who is filmed, by files.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct SubjectArguments {
    /// Film this character in place of the mannequin, with dots on its skin: a skinned mesh in glTF
    /// 2.0, in metres with y up, which stands upright at rest.
    #[arg(long, value_name = "FILE.glb")]
    character: Option<PathBuf>,
    /// Film this motion in place of the walk: BVH in any unit, the first animation of a glTF file,
    /// or a compressed clip. It is put on the figure as by `nullcone animate`, and its first second
    /// is filmed; a shorter one stays in its last pose.
    #[arg(long, value_name = "FILE.bvh|FILE.glb|FILE.clip")]
    motion: Option<PathBuf>,
    #[command(flatten)]
    retargeting: RetargetedArguments,
}

/// The figure in its motion.
pub(super) struct Subject {
    pub(super) performance: Performance,
    /// The motion of which the first second is filmed.
    pub(super) clip: Clip,
    /// The file of the character, where it is not the mannequin.
    character: Option<PathBuf>,
    /// What is unusual about the files.
    pub(super) warnings: Vec<Warning>,
}

impl SubjectArguments {
    /// The files that are read.
    pub(super) fn inputs(&self) -> impl Iterator<Item = &PathBuf> {
        let files = self.character.iter().chain(&self.motion);
        files.chain(self.retargeting.inputs())
    }

    /// Reads the files.
    pub(super) fn read(&self) -> Result<Subject> {
        let mut warnings = Vec::new();
        let figure = match &self.character {
            Some(path) => {
                let mut figure = Figure::read_gltf(path, 1.0)?;
                // The current folder becomes another one.
                figure.file = Some(std::path::absolute(path)?);
                warnings.extend(pipeline::not_in_obj(&figure, Some(path))?);
                figure
            }
            None => mannequin(),
        };
        let (performance, clip) = match (&self.character, &self.motion) {
            (None, None) => {
                let clip = walk(STRIDES);
                (walking(figure, &clip)?, clip)
            }
            (character, motion) => {
                let rate = f64::from(FRAMES_PER_SECOND);
                let second = End::Seconds(FRAMES as f64 / rate);
                let (name, files) = match character {
                    Some(path) => (path.display().to_string(), files_of(path)),
                    None => (MANNEQUIN.to_owned(), own_files()),
                };
                let onto = (&figure.character, name.as_str());
                let retargeted = match motion {
                    Some(file) => self
                        .retargeting
                        .retarget(file, second, onto, &mut warnings)?,
                    None => self.retargeting.retarget_recording(
                        Path::new("walk"),
                        (&walk_of_mannequin(rate)?, 1.0),
                        second,
                        onto,
                        &mut warnings,
                    )?,
                };
                let clip = retargeted.transfer.clip.clone();
                (retargeted.performance("demo", files, figure, rate)?, clip)
            }
        };
        Ok(Subject {
            performance,
            clip,
            character: self.character.clone(),
            warnings,
        })
    }
}

impl Subject {
    /// The figure with the dots that are filmed.
    pub(super) fn dotted(&self) -> Result<Dotted> {
        let hues = HueSeed { seed: 1 };
        let figure = &self.performance.figure;
        let character = figure.character.clone();
        let Some(path) = &self.character else {
            let human = Human {
                mesh: character.mesh,
                skeleton: character.skeleton,
                weights: character.weights,
            };
            return Ok(Dotted::mannequin(human, hues));
        };
        let dotted = Dotted::own(figure.name.clone(), character, hues);
        dotted.with_context(|| path.display().to_string())
    }

    /// The file of the results that has the character, where it is not the mannequin.
    pub(super) fn model(&self) -> Option<&'static str> {
        self.character.as_ref().map(|_| model::GLB)
    }
}

fn files_of(path: &Path) -> FigureFiles {
    let [mesh, rig, weights] = [(); 3].map(|()| ga_files::name(path));
    FigureFiles { mesh, rig, weights }
}

/// The walk as a recording of the mannequin.
fn walk_of_mannequin(rate: f64) -> Result<Recording> {
    let clip = walk(STRIDES).resampled(rate)?;
    Ok(Recording::from_clip(&skeleton(), &clip)?)
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
