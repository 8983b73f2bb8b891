//! `nullcone completions`: scripts with which a shell completes commands and options.

use anyhow::Result;
use clap::Command;
use clap_complete::Shell;

use crate::output;

/// Print a script with which a shell completes commands and options of this program.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The shell.
    #[arg(value_enum)]
    shell: Shell,
}

pub(crate) fn run(arguments: &Arguments, mut command: Command) -> Result<()> {
    let mut script = Vec::new();
    let name = command.get_name().to_owned();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    output::print(&String::from_utf8(script)?)
}
