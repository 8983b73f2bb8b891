//! `nullcone stereo`: two views of a scene.

mod calibrate;
mod corners;
mod diagnose;
mod evaluate;
mod match_views;
mod picture;
mod pixels;
mod pose;
mod reconstruct;
mod rectify;
mod undistort;
pub(super) mod views;

pub(super) use reconstruct::Axes;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;

use crate::frame::{self, Context};

/// Two views of a scene: calibration, rectification, motion, disparities and reconstruction.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Calibrate(calibrate::Arguments),
    Match(match_views::Arguments),
    Evaluate(evaluate::Arguments),
    Pose(pose::Arguments),
    Rectify(rectify::Arguments),
    Undistort(undistort::Arguments),
    Diagnose(diagnose::Arguments),
    Reconstruct(reconstruct::Arguments),
}

pub(crate) fn run(arguments: &Arguments, context: &Context) -> Result<ExitCode> {
    let quiet = context.is_quiet();
    match &arguments.command {
        Command::Calibrate(arguments) => frame::unframed(calibrate::run(arguments, quiet)),
        Command::Match(arguments) => frame::unframed(match_views::run(arguments, quiet)),
        Command::Evaluate(arguments) => frame::unframed(evaluate::run(arguments, quiet)),
        Command::Pose(arguments) => frame::run(arguments, context),
        Command::Rectify(arguments) => frame::unframed(rectify::run(arguments, quiet)),
        Command::Undistort(arguments) => frame::run(arguments, context),
        Command::Diagnose(arguments) => frame::run(arguments, context),
        Command::Reconstruct(arguments) => frame::unframed(reconstruct::run(arguments, quiet)),
    }
}
