//! `nullcone quality`: measures of pictures and videos, and people's judgement of them.

mod compare;
mod fit;
mod ratings;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;

use crate::frame::{self, Context};

/// The quality of pictures and videos, and people's judgement of it.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Compare(compare::Arguments),
    Fit(fit::Arguments),
    Ratings(ratings::Arguments),
}

pub(crate) fn run(arguments: &Arguments, context: &Context) -> Result<ExitCode> {
    match &arguments.command {
        Command::Compare(arguments) => frame::run(arguments, context),
        Command::Fit(arguments) => frame::run(arguments, context),
        Command::Ratings(arguments) => frame::run(arguments, context),
    }
}
