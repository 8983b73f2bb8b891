//! `nullcone body`: people in views.

mod evaluate;
mod fit;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;

use crate::frame::{self, Context};

/// People in views: poses from their joints in pictures.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Fit(fit::Arguments),
    Evaluate(evaluate::Arguments),
}

pub(crate) fn run(arguments: &Arguments, context: &Context) -> Result<ExitCode> {
    match &arguments.command {
        Command::Fit(arguments) => frame::run(arguments, context),
        Command::Evaluate(arguments) => frame::run(arguments, context),
    }
}
