//! `nullcone completions`: scripts with which a shell completes commands and options.

use anyhow::Result;
use clap_complete::Shell;
use serde::Serialize;

use crate::frame::{self, Command, Context};

/// Print a script with which a shell completes commands and options of this program.
///
/// --json prints {"shell": …, "script": …}.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The shell.
    #[arg(value_enum)]
    shell: Shell,
}

/// The command together with the program that is completed.
pub(crate) struct Completions<'a> {
    pub(crate) arguments: &'a Arguments,
    pub(crate) program: clap::Command,
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    shell: String,
    script: String,
}

impl Command for Completions<'_> {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        context.files::<&str>([])?;
        let shell = self.arguments.shell;
        let mut program = self.program.clone();
        let mut script = Vec::new();
        let name = program.get_name().to_owned();
        clap_complete::generate(shell, &mut program, name, &mut script);
        Ok(Report {
            shell: shell.to_string(),
            script: String::from_utf8(script)?,
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        self.script.clone()
    }

    fn is_result(&self) -> bool {
        true
    }
}
