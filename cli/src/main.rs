//! The `nullcone` program: animation and stereo vision on conformal geometric algebra, and a look
//! into its compiler.

mod buffer_files;
mod camera_file;
mod chart;
mod checks;
mod commands;
mod failure;
mod figure;
mod figure_file;
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
mod storyboard;
mod summary;
mod svg;
mod two_views;
mod view;
mod view_files;
mod warning;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use commands::{
    animate, body, capture, clip, contour, curve, demo, draw, expand, mesh, quality, render, skin,
    stereo, texture, video,
};

/// Animation, stereo vision and pictures on conformal geometric algebra.
#[derive(Parser)]
#[command(version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Print nothing but errors.
    #[arg(short, long, global = true, display_order = 100)]
    quiet: bool,
}

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
}

fn main() -> ExitCode {
    let cli = Cli::parse();
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
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}", failure::text(&error));
            ExitCode::FAILURE
        }
    }
}
