//! `nullcone body`: people in views.

mod evaluate;
mod fit;

use anyhow::Result;
use clap::Subcommand;

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

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match &arguments.command {
        Command::Fit(arguments) => fit::run(arguments, quiet),
        Command::Evaluate(arguments) => evaluate::run(arguments, quiet),
    }
}
