//! `nullcone mesh`: polygon meshes in files.

mod bake;
mod convert;
mod info;
mod subdivide;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;
use ga_mesh::format::Format;

use crate::format::listed;
use crate::frame::{self, Context};

/// Examine, convert and refine polygon meshes, and bake maps for them.
#[derive(Clone, Debug, clap::Args)]
#[command(long_about = long_about())]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

/// With the formats of the files.
fn long_about() -> String {
    let named = |format: Format| {
        let endings = format.endings().join(", .");
        format!("{} (.{endings})", format.name())
    };
    format!(
        "Examine, convert and refine polygon meshes, and bake maps for them.\n\nFiles may be {}; the \
         ending of the name says which.",
        listed(Format::ALL.map(named))
    )
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Info(info::Arguments),
    Convert(convert::Arguments),
    Subdivide(subdivide::Arguments),
    Bake(bake::Arguments),
}

pub(crate) fn run(arguments: &Arguments, context: &Context) -> Result<ExitCode> {
    match &arguments.command {
        Command::Info(arguments) => frame::run(arguments, context),
        Command::Convert(arguments) => frame::run(arguments, context),
        Command::Subdivide(arguments) => frame::run(arguments, context),
        Command::Bake(arguments) => frame::run(arguments, context),
    }
}
