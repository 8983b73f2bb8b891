//! The `nullcone` program: animation and stereo vision on conformal geometric algebra, and a look
//! into its compiler.

mod board;
mod camera_file;
mod chosen_animation;
mod commands;
mod examples;
mod failure;
mod files;
mod film_file;
mod format;
mod frame;
mod interruption;
mod mesh_file;
mod motion_file;
mod output;
mod person;
mod picture_file;
mod pipeline;
mod reading;
mod report;
mod shell;
mod standard_output;
mod transfer;

use std::iter;
use std::process::ExitCode;

use anyhow::Result;
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};

use commands::completions::Completions;
use commands::man::Manual;
use commands::{
    animate, body, camera, capture, clip, completions, contour, curve, demo, draw, expand, man,
    mesh, people, quality, render, skin, stereo, texture, video,
};
use frame::{Context, Execute, Options};

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
    #[command(flatten)]
    options: Options,
}

/// What the status of the program says.
const STATUS: &str = "\
Status:
  0    success
  1    the input or a value is wrong, or the work failed
  2    the arguments cannot be read
  3    the verdict of a command with --check is not good
  130  ended by Ctrl-C, and so on: 128 and the number of the signal

Example: nullcone demo --out out";

#[derive(Subcommand)]
enum Command {
    Demo(demo::Arguments),
    Animate(animate::Arguments),
    Body(body::Arguments),
    Camera(camera::Arguments),
    Capture(capture::Arguments),
    Expand(expand::Arguments),
    Clip(clip::Arguments),
    Contour(contour::Arguments),
    Curve(curve::Arguments),
    Draw(draw::Arguments),
    Mesh(mesh::Arguments),
    People(people::Arguments),
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
    let command = with_negative_numbers(examples::with_examples(Cli::command()));
    let matches = command.get_matches();
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    if let Err(error) = interruption::clean_up_at_signals() {
        output::print_error(&format!(
            "warning: temporary files will be left where a signal ends the program: {error}\n"
        ));
    }
    let words = iter::successors(matches.subcommand(), |(_, below)| below.subcommand());
    let words = words.map(|(word, _): (&str, &ArgMatches)| word.to_owned());
    if cli.options.is_strict() {
        reading::be_strict();
    }
    let context = Context::new(cli.options.clone(), words.collect());
    match run(&cli.command, &context) {
        Ok(status) => status,
        Err(error) => match error.downcast::<clap::Error>() {
            Ok(wrong_arguments) => wrong_arguments.exit(),
            Err(error) => {
                output::print_error(&format!("{}\n", failure::text(&error)));
                ExitCode::FAILURE
            }
        },
    }
}

/// Takes negative numbers as values everywhere, so that an error names the option and says what it
/// may be.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    let takes_them = |argument: clap::Arg| {
        let takes_values = argument.get_action().takes_values();
        argument.allow_negative_numbers(takes_values)
    };
    command
        .mut_args(takes_them)
        .mut_subcommands(with_negative_numbers)
}

fn run(command: &Command, context: &Context) -> Result<ExitCode> {
    match command {
        Command::Demo(arguments) => arguments.execute(context),
        Command::Animate(arguments) => arguments.execute(context),
        Command::Body(arguments) => arguments.execute(context),
        Command::Camera(arguments) => arguments.execute(context),
        Command::Capture(arguments) => arguments.execute(context),
        Command::Expand(arguments) => arguments.execute(context),
        Command::Clip(arguments) => arguments.execute(context),
        Command::Contour(arguments) => arguments.execute(context),
        Command::Curve(arguments) => arguments.execute(context),
        Command::Draw(arguments) => arguments.execute(context),
        Command::Mesh(arguments) => arguments.execute(context),
        Command::People(arguments) => arguments.execute(context),
        Command::Quality(arguments) => arguments.execute(context),
        Command::Render(arguments) => arguments.execute(context),
        Command::Skin(arguments) => arguments.execute(context),
        Command::Stereo(arguments) => arguments.execute(context),
        Command::Texture(arguments) => arguments.execute(context),
        Command::Video(arguments) => arguments.execute(context),
        Command::Completions(arguments) => {
            let program = Cli::command();
            Completions { arguments, program }.execute(context)
        }
        Command::Man(arguments) => {
            let program = examples::with_examples(Cli::command());
            Manual { arguments, program }.execute(context)
        }
    }
}
