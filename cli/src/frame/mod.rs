//! The frame around every command: what it prints, as text, JSON or a page, its warnings, its
//! verdict and its status. A command parses its arguments, calls a library and gives a report.

mod command;
mod context;
mod group;
mod next;
mod page;
mod progress;
mod recorded;
mod shown;
mod verdict;
mod warning;

use std::path::Path;
use std::process::ExitCode;

use anyhow::Result;
use serde::Serialize;

pub(crate) use command::{Command, Kept, Report};
pub(crate) use context::{Context, Options};
pub(crate) use group::{Execute, group};
pub(crate) use next::command_line;
pub(crate) use page::judge;
pub(crate) use progress::Progress;
pub(crate) use recorded::Recorded;
pub(crate) use shown::Shown;
pub(crate) use verdict::{Check, Verdict};
pub(crate) use warning::{Warning, keep_for_failure, warn};

use crate::output;

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

/// Runs a command, and prints its report as it is asked for. Its files and those of the report take
/// their names together, or none of them does.
fn run<C: Command>(command: &C, context: &Context) -> Result<ExitCode> {
    warning::forget();
    let mut report = match command.run(context) {
        Ok(report) => report,
        Err(error) => {
            if !context.is_quiet() {
                warning::print_of_failure();
            }
            return Err(error);
        }
    };
    let failure = report.failure();
    let of_files = warning::of_files();
    let warnings = match (report.warnings(), of_files.as_slice()) {
        (None, []) => None,
        (own, of_files) => Some([own.unwrap_or_default(), of_files].concat()),
    };
    let warnings = warnings.as_deref();
    let verdict = report.verdict().map(Verdict::with_files);
    let outputs = context.outputs();
    let kept = report.kept();
    let of_option = context.report().into_iter();
    let paths = of_option.chain(kept.as_ref().and_then(|kept| kept.page.as_deref()));
    let paths: Vec<&Path> = paths.collect();
    if !paths.is_empty() {
        let page = match report.page() {
            Some(page) => page::with_warnings(page, &of_files),
            None => page::of(
                &report,
                verdict,
                warnings.unwrap_or_default(),
                &context.title(),
            )?,
        };
        let html = page.into_html();
        for path in paths {
            outputs.write(path, &html)?;
        }
    }
    let object = Object {
        verdict,
        report: &report,
        warnings,
    };
    if let Some(path) = kept.and_then(|kept| kept.json) {
        let text = serde_json::to_string_pretty(&object)? + "\n";
        outputs.write(path, text)?;
    }
    outputs.finish()?;
    if let Some(recorder) = context.recorder() {
        *recorder.borrow_mut() = Recorded {
            values: serde_json::to_value(&object)?,
            verdict,
            page: report.page(),
        };
        return failure.map_or(Ok(ExitCode::SUCCESS), Err);
    }
    if !context.is_quiet() {
        warning::print(warnings.unwrap_or_default());
    }
    if context.is_json() {
        if !report.is_printed_as_json() {
            output::print_json(&object)?;
        }
    } else if report.is_result() || !context.is_quiet() {
        let next = report.next().filter(|_| !context.is_quiet());
        let next = next.map(|next| format!("next: {next}\n"));
        output::print(&(report.text() + &next.unwrap_or_default()))?;
    }
    match (failure, verdict) {
        (Some(error), _) => Err(error),
        (None, Some(Verdict::Doubtful | Verdict::Failed)) if command.is_check() => {
            Ok(ExitCode::from(NOT_GOOD))
        }
        _ => Ok(ExitCode::SUCCESS),
    }
}
