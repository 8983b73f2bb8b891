//! `nullcone mesh`: polygon meshes in files.

mod bake;
mod convert;
mod info;
mod input;
mod subdivide;

use anyhow::Result;
use clap::Subcommand;

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

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    match &arguments.command {
        Command::Info(arguments) => info::run(arguments, quiet),
        Command::Convert(arguments) => convert::run(arguments, quiet),
        Command::Subdivide(arguments) => subdivide::run(arguments, quiet),
        Command::Bake(arguments) => bake::run(arguments, quiet),
    }
}
