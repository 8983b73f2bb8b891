//! `nullcone clip`: recordings of motion in files.

mod blend;
mod compress;
mod convert;
mod info;
mod input;
mod mirror;
mod phases;
mod resample;
mod retarget;
mod sample;
mod target;

use std::process::ExitCode;

use anyhow::Result;
use clap::Subcommand;

use crate::frame::{self, Context};

/// Compress recordings of motion within a bound; convert, sample, resample, retarget, mirror and
/// blend them.
///
/// A motion may be BVH (.bvh), glTF 2.0 (.glb, .gltf) or a compressed clip (.clip); the ending of
/// the name says which.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Clone, Debug, Subcommand)]
enum Command {
    Compress(compress::Arguments),
    Info(info::Arguments),
    Sample(sample::Arguments),
    Convert(convert::Arguments),
    Resample(resample::Arguments),
    Retarget(retarget::Arguments),
    Mirror(mirror::Arguments),
    Blend(blend::Arguments),
}

pub(crate) fn run(arguments: &Arguments, context: &Context) -> Result<ExitCode> {
    match &arguments.command {
        Command::Compress(arguments) => frame::run(arguments, context),
        Command::Info(arguments) => frame::run(arguments, context),
        Command::Sample(arguments) => frame::run(arguments, context),
        Command::Convert(arguments) => frame::run(arguments, context),
        Command::Resample(arguments) => frame::run(arguments, context),
        Command::Retarget(arguments) => frame::run(arguments, context),
        Command::Mirror(arguments) => frame::run(arguments, context),
        Command::Blend(arguments) => frame::run(arguments, context),
    }
}
