//! `nullcone video`: the shots and key frames of videos, and the comfort of stereoscopic ones.

mod comfort;
mod keyframes;
mod score;
mod shots;
mod statistics;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;

use crate::frame::{self, Context};

/// Videos: cuts, shots, key frames, how well cuts are found, and the comfort of two views.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Align(comfort::align::Arguments),
    Comfort(comfort::Arguments),
    Keyframes(keyframes::Arguments),
    Score(score::Arguments),
    Statistics(statistics::Arguments),
}

pub(crate) fn run(arguments: &Arguments, context: &Context) -> Result<ExitCode> {
    match &arguments.command {
        Command::Align(arguments) => frame::run(arguments, context),
        Command::Comfort(arguments) => frame::run(arguments, context),
        Command::Keyframes(arguments) => frame::run(arguments, context),
        Command::Score(arguments) => frame::run(arguments, context),
        Command::Statistics(arguments) => frame::run(arguments, context),
    }
}
