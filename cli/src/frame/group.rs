//! Commands with others below them.

use std::process::ExitCode;

use anyhow::Result;

use super::command::Command;
use super::context::Context;

/// A command, or a group of them of which one was called.
pub(crate) trait Execute {
    /// Does the work and prints what there is to say; the result is the status of the program.
    fn execute(&self, context: &Context) -> Result<ExitCode>;
}

impl<C: Command> Execute for C {
    fn execute(&self, context: &Context) -> Result<ExitCode> {
        super::run(self, context)
    }
}

/// The arguments of a group: the name of each command below it, with the module of its own
/// arguments.
macro_rules! group {
    ($(#[$attribute:meta])* $($name:ident: $module:path),+ $(,)?) => {
        #[derive(Clone, Debug, clap::Args)]
        $(#[$attribute])*
        pub(crate) struct Arguments {
            #[command(subcommand)]
            command: Command,
        }

        #[derive(Clone, Debug, clap::Subcommand)]
        enum Command {
            $($name($module),)+
        }

        impl $crate::frame::Execute for Arguments {
            fn execute(
                &self,
                context: &$crate::frame::Context,
            ) -> anyhow::Result<std::process::ExitCode> {
                match &self.command {
                    $(Command::$name(arguments) => {
                        $crate::frame::Execute::execute(arguments, context)
                    })+
                }
            }
        }
    };
}

pub(crate) use group;
