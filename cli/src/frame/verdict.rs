//! How good a result is.

use serde::Serialize;

use super::warning::{Warning, of_files};

/// The verdict of a command that judges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Verdict {
    /// The result can be used.
    Good,
    /// Something should be looked at before the result is used: a warning says what.
    Doubtful,
    /// The result is not to be used.
    Failed,
}

impl Verdict {
    /// The verdict of a command that warns of everything that makes its result doubtful.
    pub(crate) fn of(warnings: &[Warning]) -> Self {
        match warnings {
            [] => Self::Good,
            _ => Self::Doubtful,
        }
    }

    /// The verdict with what is said of files, which is in doubt for every command.
    pub(crate) fn with_files(self) -> Self {
        match self {
            Self::Good if !of_files().is_empty() => Self::Doubtful,
            verdict => verdict,
        }
    }

    /// The word that is printed.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Doubtful => "doubtful",
            Self::Failed => "failed",
        }
    }
}

/// The option of commands that judge.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct Check {
    /// End with status 3 where the verdict is not good.
    #[arg(long)]
    pub(crate) check: bool,
}
