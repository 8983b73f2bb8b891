//! `nullcone mesh`: polygon meshes in files.

mod bake;
mod convert;
mod info;
mod subdivide;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;

use crate::frame::{self, Context};

/// Examine, convert and refine polygon meshes, and bake maps for them.
///
/// Files may be Wavefront OBJ with MTL (.obj), PLY (.ply) or glTF 2.0 (.glb, .gltf); the ending of
/// the name says which.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
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
