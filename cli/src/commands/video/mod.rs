//! `nullcone video`: the shots and key frames of videos.

mod input;
mod keyframes;
mod page;
mod plot;
mod report;
mod score;
mod sheet;
mod spool;
mod statistics;

use anyhow::Result;
use clap::Subcommand;

/// Videos: cuts, shots, key frames, and how well cuts are found.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Keyframes(keyframes::Arguments),
    Score(score::Arguments),
    Statistics(statistics::Arguments),
}

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match &arguments.command {
        Command::Keyframes(arguments) => keyframes::run(arguments, quiet),
        Command::Score(arguments) => score::run(arguments, quiet),
        Command::Statistics(arguments) => statistics::run(arguments, quiet),
    }
}
