//! `nullcone demo`: a figure and a walk that the program generates.

use std::path::Path;
use std::time::Instant;

use anyhow::{Context as _, Result};
use ga_mannequin::{Human, KEY_TIME, KEYS_PER_STRIDE, walk};

use crate::figure::Figure;
use crate::frame::{Command, Context};
use crate::pipeline::{self, OutputArguments, Performance, perform};
use crate::report::{Input, MotionInput};
use crate::storyboard::{self, Numbering, STEPS, Storyboard};
use crate::summary::Performed;

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
        walking_person(self, context)
    }
}

fn walking_person(arguments: &Arguments, context: &Context) -> Result<Performed> {
    let begin = Instant::now();
    let no_inputs: [&Path; 0] = [];
    arguments.output.check(context.files(no_inputs)?)?;
    let progress = context.progress(pipeline::STEPS + 1);
    progress.step("making a person");
    let human = Human::new();
    let paint = human.texture(TEXTURE_SIZE);
    let Human {
        mesh,
        skeleton,
        weights,
    } = human;
    let keys = walk(STRIDES);
    let clip = keys
        .resampled(STEPS as f64 / KEY_TIME)
        .context("the walk has no frames")?;

    let made = || "made by nullcone".to_owned();
    let input = Input {
        mesh: made(),
        rig: made(),
        weights: made(),
        motion: MotionInput {
            name: "walk".to_owned(),
            joints: skeleton.len(),
            frames: keys.frames().len(),
            frames_per_second: 1.0 / KEY_TIME,
            first_frame: 0,
            last_frame: keys.frames().len() - 1,
            calibration_frame_left_out: false,
            joints_without_counterpart: Vec::new(),
            metres_per_unit: 1.0,
        },
    };
    let numbering = Numbering {
        first: 0,
        per_frame: STEPS,
    };
    let performance = Performance {
        command: "demo",
        input,
        storyboard: Storyboard::new(
            &keys,
            &storyboard::spans_of_keys(&keys, KEYS_PER_STRIDE),
            numbering,
        ),
        figure: Figure {
            name: "mannequin".to_owned(),
            mesh,
            skeleton,
            weights,
            paint: Some(paint),
        },
        group: None,
        metres_per_unit: 1.0,
        clip,
        clip_name: "walk".to_owned(),
        title: format!(
            "Walk: {KEYS_PER_STRIDE} key poses a stride, 3 in-betweens after each by screw motion"
        ),
        in_between_deviation: None,
    };
    perform(&performance, &arguments.output, &progress, begin)
}
