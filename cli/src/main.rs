//! The `nullcone` program: animation and stereo vision on conformal geometric algebra, and a look
//! into its compiler.

mod buffer_files;
mod camera_file;
mod chart;
mod checks;
mod commands;
mod examples;
mod failure;
mod figure;
mod figure_file;
mod file_list;
mod files;
mod format;
mod interruption;
mod mesh_file;
mod model;
mod output;
mod overlay;
mod page;
mod pipeline;
mod progress;
mod recording;
mod report;
mod rotation;
mod sheet;
mod standard_output;
mod storyboard;
mod summary;
mod svg;
mod two_views;
mod view;
mod view_files;
mod warning;

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use commands::{
    animate, body, capture, clip, completions, contour, curve, demo, draw, expand, man, mesh,
    quality, render, skin, stereo, texture, video,
};

/// Animation, stereo vision and pictures on conformal geometric algebra.
///
/// A file that is written replaces one of its name without a question, unless that is read-only or
/// an input of the same command; of several files all are written or none. The ending of a name, in
/// small or capital letters, says the format. `-` as the name of one output is standard output, and
/// devices and pipes are written to.
#[derive(Parser)]
#[command(version, propagate_version = true, after_help = STATUS)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Print nothing but errors.
    #[arg(short, long, global = true, display_order = 100)]
    quiet: bool,
}

/// What the status of the program says.
const STATUS: &str = "\
Status:
  0    success
  1    the input is wrong, or the work failed
  2    the arguments are wrong
  130  ended by Ctrl-C, and so on: 128 and the number of the signal

Example: nullcone demo --out out";

#[derive(Subcommand)]
enum Command {
    Demo(demo::Arguments),
    Animate(animate::Arguments),
    Body(body::Arguments),
    Capture(capture::Arguments),
    Expand(expand::Arguments),
    Clip(clip::Arguments),
    Contour(contour::Arguments),
    Curve(curve::Arguments),
    Draw(draw::Arguments),
    Mesh(mesh::Arguments),
    Quality(quality::Arguments),
    Render(render::Arguments),
    Skin(skin::Arguments),
    Stereo(stereo::Arguments),
    Texture(texture::Arguments),
    Video(video::Arguments),
    Completions(completions::Arguments),
    Man(man::Arguments),
}

fn main() -> ExitCode {
    let matches = examples::with_examples(Cli::command()).get_matches();
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    if let Err(error) = interruption::clean_up_at_signals() {
        eprintln!("warning: temporary files will be left where a signal ends the program: {error}");
    }
    let result = match &cli.command {
        Command::Demo(arguments) => demo::run(arguments, cli.quiet),
        Command::Animate(arguments) => animate::run(arguments, cli.quiet),
        Command::Body(arguments) => body::run(arguments, cli.quiet),
        Command::Capture(arguments) => capture::run(arguments, cli.quiet),
        Command::Expand(arguments) => expand::run(arguments),
        Command::Clip(arguments) => clip::run(arguments, cli.quiet),
        Command::Contour(arguments) => contour::run(arguments, cli.quiet),
        Command::Curve(arguments) => curve::run(arguments, cli.quiet),
        Command::Draw(arguments) => draw::run(arguments, cli.quiet),
        Command::Mesh(arguments) => mesh::run(arguments, cli.quiet),
        Command::Quality(arguments) => quality::run(arguments, cli.quiet),
        Command::Render(arguments) => render::run(arguments, cli.quiet),
        Command::Skin(arguments) => skin::run(arguments, cli.quiet),
        Command::Stereo(arguments) => stereo::run(arguments, cli.quiet),
        Command::Texture(arguments) => texture::run(arguments, cli.quiet),
        Command::Video(arguments) => video::run(arguments, cli.quiet),
        Command::Completions(arguments) => completions::run(arguments, Cli::command()),
        Command::Man(arguments) => man::run(
            arguments,
            examples::with_examples(Cli::command()),
            cli.quiet,
        ),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}", failure::text(&error));
            ExitCode::FAILURE
        }
    }
}
