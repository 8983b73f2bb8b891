//! `nullcone stereo`: two views of a scene.

mod evaluate;
mod picture;

use anyhow::Result;
use clap::Subcommand;

/// Two views of a scene: disparities, and how far they are from the truth.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Evaluate(evaluate::Arguments),
}

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match &arguments.command {
        Command::Evaluate(arguments) => evaluate::run(arguments, quiet),
    }
}
