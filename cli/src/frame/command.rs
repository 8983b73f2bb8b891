//! What a command is, and what it says at the end.

use std::path::PathBuf;

use anyhow::{Error, Result};
use ga_draw::document::Page;
use serde::Serialize;

use super::context::Context;
use super::verdict::Verdict;
use super::warning::Warning;

/// Files in which a report is kept.
#[derive(Default)]
pub(crate) struct Kept {
    pub(crate) page: Option<PathBuf>,
    pub(crate) json: Option<PathBuf>,
}

/// A command with its arguments.
pub(crate) trait Command {
    /// What is said at the end.
    type Report: Report;

    /// Does the work.
    fn run(&self, context: &Context) -> Result<Self::Report>;

    /// Whether a verdict that is not good is to be seen in the status: `--check`, which commands
    /// have that judge.
    fn is_check(&self) -> bool {
        false
    }
}

/// What a command says at the end. As JSON it is one object with the keys of the report, its
/// verdict and its warnings.
pub(crate) trait Report: Serialize {
    /// The report for people: lines with their ends.
    fn text(&self) -> String;

    /// Whether the text is what the command is for, as a table that is asked for. It is printed
    /// even where nothing is to be said of the work.
    fn is_result(&self) -> bool {
        false
    }

    /// Whether the objects of `--json` were printed one by one during the work.
    fn is_printed_as_json(&self) -> bool {
        false
    }

    /// What users should know about the result; `None` for commands that never warn.
    fn warnings(&self) -> Option<&[Warning]> {
        None
    }

    /// How good the result is; `None` for commands that do not judge.
    fn verdict(&self) -> Option<Verdict> {
        None
    }

    /// A command that goes on from here.
    fn next(&self) -> Option<String> {
        None
    }

    /// The page of `--report`, where it is another than one with the text and the values.
    fn page(&self) -> Option<Page> {
        None
    }

    /// Where the page and the object of JSON are written as well, whatever the options are.
    fn kept(&self) -> Option<Kept> {
        None
    }

    /// An error after which the rest is still worth saying.
    fn failure(&mut self) -> Option<Error> {
        None
    }
}
