//! `nullcone camera`: cameras and their files.

mod calibrate;
mod convert;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;

use crate::frame::{self, Context};

/// One camera: its calibration, and the conversion of files of cameras.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Calibrate(calibrate::Arguments),
    Convert(convert::Arguments),
}

pub(crate) fn run(arguments: &Arguments, context: &Context) -> Result<ExitCode> {
    match &arguments.command {
        Command::Calibrate(arguments) => frame::run(arguments, context),
        Command::Convert(arguments) => frame::run(arguments, context),
    }
}
