//! What every command is told beside its own arguments.

use std::cell::RefCell;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::Result;
use clap::error::ErrorKind;

use super::{Progress, Recorded, command_line};
use crate::files::Files;
use crate::format::Format;
use crate::output::Staging;

/// The options that every command has.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Options {
    /// Print one JSON object instead of text.
    #[arg(long, global = true, display_order = 100)]
    json: bool,
    /// Write a page with the results; it needs no other file.
    #[arg(long, global = true, value_name = "PAGE.html", display_order = 101)]
    report: Option<PathBuf>,
    /// Refuse meshes and motions that deviate from their formats, where other programs read them
    /// and a warning would say so.
    #[arg(long, global = true, display_order = 103)]
    strict: bool,
    /// Print nothing but errors and what is asked for by name.
    #[arg(short, long, global = true, display_order = 102)]
    quiet: bool,
    /// How many threads compute; by default as many as the machine can run at the same time.
    /// Results do not depend on it.
    #[arg(
        long,
        global = true,
        value_name = "N",
        value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS),
        display_order = 104
    )]
    threads: Option<u16>,
}

/// More threads than this are taken for a mistake.
const MOST_THREADS: i64 = 1024;

impl Options {
    /// How many threads are to compute, where that is said.
    pub(crate) fn threads(&self) -> Option<usize> {
        self.threads.map(usize::from)
    }

    /// Whether files that deviate from their formats are refused.
    pub(crate) fn is_strict(&self) -> bool {
        self.strict
    }
}

/// Does what a line of words says, and prints nothing.
type Program = fn(&[OsString]) -> Result<Recorded>;

/// The options of every command, and the words that it was called by.
#[derive(Debug)]
pub(crate) struct Context {
    options: Options,
    words: Vec<String>,
    line: Vec<OsString>,
    /// Runs another command.
    program: Program,
    /// What was said, where it is not to be printed.
    recorded: Option<RefCell<Recorded>>,
    outputs: Staging,
}

impl Context {
    /// The context of a command that was called by these words, as `stereo` and `pose`, in this
    /// line.
    pub(crate) fn new(
        options: Options,
        words: Vec<String>,
        line: Vec<OsString>,
        program: Program,
    ) -> Self {
        Self {
            options,
            words,
            line,
            program,
            recorded: None,
            outputs: Staging::default(),
        }
    }

    /// Does what a line of words says, and returns what would be printed of it.
    ///
    /// # Errors
    ///
    /// [`clap::Error`] where the words cannot be read; otherwise that of the command.
    pub(crate) fn record(&self, line: &[OsString]) -> Result<Recorded> {
        (self.program)(line)
    }

    /// The same, with all that would be printed kept.
    pub(crate) fn recording(mut self) -> Self {
        self.options.quiet = true;
        self.recorded = Some(RefCell::default());
        self
    }

    /// Whether what would be printed is kept, and the same on each run: without measured times.
    pub(crate) fn is_recording(&self) -> bool {
        self.recorded.is_some()
    }

    /// Where to keep what would be printed.
    pub(super) fn recorder(&self) -> Option<&RefCell<Recorded>> {
        self.recorded.as_ref()
    }

    /// What was kept.
    pub(crate) fn into_recorded(self) -> Recorded {
        self.recorded.map(RefCell::into_inner).unwrap_or_default()
    }

    /// The whole line, as a shell reads it.
    pub(crate) fn line(&self) -> String {
        let words = self.line.iter().skip(1).map(AsRef::as_ref);
        command_line(std::iter::once("nullcone".as_ref()).chain(words))
    }

    /// Whether the report is printed as JSON.
    pub(crate) fn is_json(&self) -> bool {
        self.options.json
    }

    /// Whether nothing is to be said of the work.
    pub(crate) fn is_quiet(&self) -> bool {
        self.options.quiet
    }

    /// Where a page is to be written.
    pub(crate) fn report(&self) -> Option<&Path> {
        self.options.report.as_deref()
    }

    /// The heading of a page.
    pub(crate) fn title(&self) -> String {
        format!("nullcone {}", self.words.join(" "))
    }

    /// Fails where nothing would come of the work: neither `is_asked`, an output of the command by
    /// one of these options, nor a report.
    pub(crate) fn need_result(&self, is_asked: bool, options: &str) -> Result<()> {
        if is_asked || self.options.json || self.options.report.is_some() {
            return Ok(());
        }
        let text = format!("nothing is to be made: give one of {options}, --json and --report\n");
        Err(clap::Error::raw(ErrorKind::MissingRequiredArgument, text).into())
    }

    /// Where the command writes all its files.
    pub(crate) fn outputs(&self) -> &Staging {
        &self.outputs
    }

    /// The progress of work in steps.
    pub(crate) fn progress(&self, steps: u64) -> Progress {
        Progress::new(steps, self.options.quiet)
    }

    /// The files that the command reads; the outputs that every command may have are checked.
    pub(crate) fn files<P: AsRef<Path>>(
        &self,
        inputs: impl IntoIterator<Item = P>,
    ) -> Result<Files> {
        let mut files = Files::reading(inputs).printing("--json", self.options.json);
        files.write_if_given("--report", self.options.report.as_ref(), &[Format::Html])?;
        Ok(files)
    }
}
