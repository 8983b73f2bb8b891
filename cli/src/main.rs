//! The `nullcone` program: animation and stereo vision on conformal geometric algebra, and a look
//! into its compiler.

mod board;
mod camera_file;
mod chosen_animation;
mod commands;
mod counted;
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
mod part;
mod person;
mod picture_file;
mod pipeline;
mod program;
mod reading;
mod report;
mod retargeted;
mod shell;
mod standard_output;
mod transfer;

use std::process::ExitCode;

fn main() -> ExitCode {
    if let Err(error) = interruption::clean_up_at_signals() {
        output::print_error(&format!(
            "warning: temporary files will be left where a signal ends the program: {error}\n"
        ));
    }
    match program::run(std::env::args_os()) {
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
