//! The frame around every command: what it prints, as text, JSON or a page, its warnings, its
//! verdict and its status. A command parses its arguments, calls a library and gives a report.

mod context;
mod page;
mod progress;
mod verdict;
mod warning;

use std::process::ExitCode;

use anyhow::{Error, Result};
use serde::Serialize;

pub(crate) use context::{Context, Options};
pub(crate) use progress::Progress;
pub(crate) use verdict::{Check, Verdict};
pub(crate) use warning::Warning;

use crate::output;
use ga_draw::document::Page;

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

    /// The page of `--report`; a page with the text and the values of the report by default.
    fn page(&self, title: &str) -> Result<Page>
    where
        Self: Sized,
    {
        plain_page(self, title)
    }

    /// An error after which the rest is still worth saying.
    fn failure(&mut self) -> Option<Error> {
        None
    }
}

/// The page of a report that has none of its own.
pub(crate) fn plain_page(report: &impl Report, title: &str) -> Result<Page> {
    let warnings = report.warnings().unwrap_or_default();
    let values = serde_json::to_value(report)?;
    let (verdict, text) = (report.verdict(), report.text());
    Ok(page::of(title, verdict, warnings, &text, &values))
}

/// A report as JSON.
#[derive(Serialize)]
struct Object<'a, R> {
    #[serde(skip_serializing_if = "Option::is_none")]
    verdict: Option<Verdict>,
    #[serde(flatten)]
    report: &'a R,
    #[serde(skip_serializing_if = "Option::is_none")]
    warnings: Option<&'a [Warning]>,
}

/// The status of the program where a verdict is checked and not good.
const NOT_GOOD: u8 = 3;

/// Runs a command, and prints its report as it is asked for.
pub(crate) fn run<C: Command>(command: &C, context: &Context) -> Result<ExitCode> {
    let mut report = command.run(context)?;
    let failure = report.failure();
    if let Some(path) = context.report() {
        let page = report.page(&context.title())?;
        output::write(path, page.into_html().as_bytes())?;
    }
    if !context.is_quiet() {
        warning::print(report.warnings().unwrap_or_default());
    }
    if context.is_json() {
        if !report.is_printed_as_json() {
            output::print_json(&Object {
                verdict: report.verdict(),
                report: &report,
                warnings: report.warnings(),
            })?;
        }
    } else if report.is_result() || !context.is_quiet() {
        let next = report.next().filter(|_| !context.is_quiet());
        let next = next.map(|next| format!("next: {next}\n"));
        output::print(&(report.text() + &next.unwrap_or_default()))?;
    }
    match (failure, report.verdict()) {
        (Some(error), _) => Err(error),
        (None, Some(Verdict::Doubtful | Verdict::Failed)) if command.is_check() => {
            Ok(ExitCode::from(NOT_GOOD))
        }
        _ => Ok(ExitCode::SUCCESS),
    }
}

/// The status of a command that prints for itself.
pub(crate) fn unframed(result: Result<()>) -> Result<ExitCode> {
    result.map(|()| ExitCode::SUCCESS)
}
