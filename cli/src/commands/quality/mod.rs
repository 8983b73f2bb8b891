//! `nullcone quality`: measures of pictures and videos, and people's judgement of them.

mod compare;
mod fit;
mod ratings;

use anyhow::Result;
use clap::Subcommand;

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

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match &arguments.command {
        Command::Compare(arguments) => compare::run(arguments, quiet),
        Command::Fit(arguments) => fit::run(arguments, quiet),
        Command::Ratings(arguments) => ratings::run(arguments, quiet),
    }
}
