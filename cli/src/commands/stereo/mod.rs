//! `nullcone stereo`: two views of a scene.

mod calibrate;
mod diagnose;
mod evaluate;
mod match_views;
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
    match &arguments.command {
        Command::Calibrate(arguments) => frame::run(arguments, context),
        Command::Match(arguments) => frame::run(arguments, context),
        Command::Evaluate(arguments) => frame::run(arguments, context),
        Command::Pose(arguments) => frame::run(arguments, context),
        Command::Rectify(arguments) => frame::run(arguments, context),
        Command::Undistort(arguments) => frame::run(arguments, context),
        Command::Diagnose(arguments) => frame::run(arguments, context),
        Command::Reconstruct(arguments) => frame::run(arguments, context),
    }
}
