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

use anyhow::Result;
use clap::Subcommand;

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

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match &arguments.command {
        Command::Calibrate(arguments) => calibrate::run(arguments, quiet),
        Command::Match(arguments) => match_views::run(arguments, quiet),
        Command::Evaluate(arguments) => evaluate::run(arguments, quiet),
        Command::Pose(arguments) => pose::run(arguments, quiet),
        Command::Rectify(arguments) => rectify::run(arguments, quiet),
        Command::Undistort(arguments) => undistort::run(arguments, quiet),
        Command::Diagnose(arguments) => diagnose::run(arguments, quiet),
        Command::Reconstruct(arguments) => reconstruct::run(arguments, quiet),
    }
}
