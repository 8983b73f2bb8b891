//! `nullcone quality`: measures of pictures and videos.

mod compare;

use anyhow::Result;
use clap::Subcommand;

/// The quality of pictures and videos.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Compare(compare::Arguments),
}

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match &arguments.command {
        Command::Compare(arguments) => compare::run(arguments, quiet),
    }
}
