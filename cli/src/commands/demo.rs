//! `nullcone demo`: a figure and a walk that the program generates.

use std::path::Path;
use std::time::Instant;

use anyhow::{Context as _, Result};
use ga_character::storyboard::{STEPS, Storyboard};
use ga_character::{Animation, Figure};
use ga_mannequin::{Human, KEY_TIME, KEYS_PER_STRIDE, walk};

use crate::frame::{Command, Context};
use crate::pipeline::{self, OutputArguments, Performance, perform};
use crate::report::{Input, MotionInput, Performed};

/// Generate a person that walks; needs no input.
///
/// Writes model.obj (the mesh at rest) with model.mtl and skin.png (its painted skin), model.glb
/// (mesh, painted skin, skeleton, skin weights and the walk), sheet.png (the key frames of a stride
/// with three in-betweens after each, shaded and as depth) and report.json. Lengths are metres, y
/// points up. --json prints what report.json holds, with the paths of the files as "written" and
/// the time that it took as "seconds".
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(flatten)]
    output: OutputArguments,
}

/// Two steps each.
const STRIDES: u16 = 2;

/// Rows and columns of the painted skin.
const TEXTURE_SIZE: usize = 1024;

impl Command for Arguments {
    type Report = Performed;

    fn run(&self, context: &Context) -> Result<Performed> {
        let begin = Instant::now();
        let no_inputs: [&Path; 0] = [];
        self.output.check(context.files(no_inputs)?)?;
        let progress = context.progress(pipeline::STEPS + 1);
        progress.step("making a person");
        let human = Human::new();
        let figure = Figure {
            paint: Some(human.texture(TEXTURE_SIZE)),
            ..Figure::new("mannequin", human.into())
        };
        let keys = walk(STRIDES);
        let clip = keys.resampled(STEPS as f64 / KEY_TIME);
        let made = || "made by nullcone".to_owned();
        let performance = Performance {
            command: "demo",
            input: Input {
                mesh: made(),
                rig: made(),
                weights: made(),
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
                storyboard: Storyboard::of_keys(&keys, KEYS_PER_STRIDE),
                title: format!(
                    "Walk: {KEYS_PER_STRIDE} key poses a stride, 3 in-betweens after each by screw \
                     motion"
                ),
                in_between_deviation: None,
            },
            checks: None,
        };
        perform(performance, &self.output, &progress, begin)
    }
}
