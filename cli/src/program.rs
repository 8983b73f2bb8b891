//! The commands of the program, and how a line of words becomes one of them.

use std::ffi::OsString;
use std::iter;
use std::process::ExitCode;

use anyhow::{Context as _, Result};
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};
use rayon::ThreadPoolBuilder;

use crate::commands::completions::Completions;
use crate::commands::man::Manual;
use crate::commands::{
    animate, body, camera, capture, clip, completions, contour, curve, demo, draw, expand, man,
    merge, mesh, people, quality, render, skin, stereo, texture, video,
};
use crate::frame::{Context, Execute, Options, Recorded};
use crate::{examples, reading};

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
    Merge(merge::Arguments),
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

/// Does what a line of words says, the first of which is the name of the program.
///
/// # Errors
///
/// [`clap::Error`] where the words cannot be read; otherwise that of the command.
pub(crate) fn run(line: impl IntoIterator<Item = OsString>) -> Result<ExitCode> {
    let line: Vec<OsString> = line.into_iter().collect();
    let matches = parser().try_get_matches_from(&line)?;
    let cli = Cli::from_arg_matches(&matches)?;
    if cli.options.is_strict() {
        reading::be_strict();
    }
    if let Some(count) = cli.options.threads() {
        let threads = ThreadPoolBuilder::new().num_threads(count).build_global();
        threads.with_context(|| format!("--threads {count}"))?;
    }
    let context = Context::new(cli.options.clone(), words(&matches), line, record);
    execute(&cli.command, &context)
}

/// As [`run`], for a command within another: it prints nothing, and what it would say is returned.
///
/// # Errors
///
/// As [`run`].
fn record(line: &[OsString]) -> Result<Recorded> {
    let matches = parser().try_get_matches_from(line)?;
    let cli = Cli::from_arg_matches(&matches)?;
    let context = Context::new(cli.options.clone(), words(&matches), line.to_vec(), record);
    let context = context.recording();
    execute(&cli.command, &context)?;
    Ok(context.into_recorded())
}

fn parser() -> clap::Command {
    with_negative_numbers(examples::with_examples(Cli::command()))
}

/// The words by which a command was called, as `stereo` and `pose`.
fn words(matches: &ArgMatches) -> Vec<String> {
    let words = iter::successors(matches.subcommand(), |(_, below)| below.subcommand());
    words.map(|(word, _)| word.to_owned()).collect()
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

fn execute(command: &Command, context: &Context) -> Result<ExitCode> {
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
        Command::Merge(arguments) => arguments.execute(context),
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
