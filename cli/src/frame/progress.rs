//! The progress of the work, on a terminal only.

use std::sync::atomic::{AtomicU64, Ordering};

use indicatif::{ProgressBar, ProgressStyle};

/// A bar on standard error with the name of the current step. It is not shown where standard error
/// is not a terminal, and disappears when it is dropped.
pub(crate) struct Progress {
    bar: ProgressBar,
    /// The share of the current part.
    share: AtomicU64,
}

impl Progress {
    pub(crate) fn new(steps: u64, quiet: bool) -> Self {
        Self::with_template(steps, quiet, "{bar:24} {msg}")
    }

    /// The progress of [parts](Self::part) with these shares together, and the time that is left.
    pub(crate) fn of_parts(shares: u64, quiet: bool) -> Self {
        Self::with_template(shares, quiet, "{bar:24} {msg}, {eta} left")
    }

    fn with_template(steps: u64, quiet: bool, template: &str) -> Self {
        let bar = if quiet {
            ProgressBar::hidden()
        } else {
            let style = ProgressStyle::with_template(template);
            let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
            ProgressBar::new(steps).with_style(style)
        };
        Self {
            bar,
            share: AtomicU64::new(0),
        }
    }

    /// Begins the next part of the work, with its share of the whole time.
    pub(crate) fn part(&self, name: &'static str, share: u64) {
        self.bar.inc(self.share.swap(share, Ordering::Relaxed));
        self.bar.set_message(name);
        self.bar.tick();
    }

    /// Says how much of the current step is done: `done` of `steps`, over the whole bar.
    pub(crate) fn at(&self, done: u64, steps: u64) {
        self.bar.set_length(steps);
        self.bar.set_position(done);
    }

    /// Begins the next step.
    pub(crate) fn step(&self, name: &'static str) {
        if !self.bar.message().is_empty() {
            self.bar.inc(1);
        }
        self.bar.set_message(name);
        self.bar.tick();
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
