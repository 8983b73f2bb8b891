//! Reports that are made of their parts.

use std::path::PathBuf;

use anyhow::{Context as _, Error, Result};
use ga_draw::document::Page;
use ga_draw::document::chart::ChartError;
use serde::Serialize;

use super::command::Report;
use super::context::Context;
use super::verdict::Verdict;
use super::warning::Warning;

/// A report whose values are those of a library. A command fills in what else it has to say.
#[derive(Serialize)]
pub(crate) struct Shown<V> {
    #[serde(flatten)]
    pub(crate) values: V,
    /// Lines with their ends.
    #[serde(skip)]
    pub(crate) text: String,
    #[serde(skip)]
    pub(crate) warnings: Option<Vec<Warning>>,
    #[serde(skip)]
    pub(crate) verdict: Option<Verdict>,
    #[serde(skip)]
    pub(crate) next: Option<String>,
    /// Whether the objects of `--json` were printed during the work.
    #[serde(skip)]
    pub(crate) is_printed_as_json: bool,
    #[serde(skip)]
    pub(crate) page: Option<Page>,
    /// Why the values are not of the whole input.
    #[serde(skip)]
    pub(crate) failure: Option<Error>,
}

impl<V> Shown<V> {
    pub(crate) fn new(values: V, text: String) -> Self {
        Self {
            values,
            text,
            warnings: None,
            verdict: None,
            next: None,
            is_printed_as_json: false,
            page: None,
            failure: None,
        }
    }

    /// The same report of other values.
    pub(crate) fn map<W>(self, values: impl FnOnce(V) -> W) -> Shown<W> {
        Shown {
            values: values(self.values),
            text: self.text,
            warnings: self.warnings,
            verdict: self.verdict,
            next: self.next,
            is_printed_as_json: self.is_printed_as_json,
            page: self.page,
            failure: self.failure,
        }
    }

    /// Draws a chart for the file of `--plot` and for the page of `--report`, where one of them is
    /// asked for.
    pub(crate) fn with_plot(
        mut self,
        plot: Option<&PathBuf>,
        context: &Context,
        svg: impl FnOnce(&V) -> Result<String, ChartError>,
        page: impl FnOnce(&V, &str) -> Page,
    ) -> Result<Self> {
        if plot.is_none() && context.report().is_none() {
            return Ok(self);
        }
        let svg = svg(&self.values).with_context(|| match plot {
            Some(path) => format!("cannot draw {}", path.display()),
            None => "cannot draw the chart of --report".to_owned(),
        })?;
        if context.report().is_some() {
            self.page = Some(page(&self.values, &svg));
        }
        if let Some(path) = plot {
            context.outputs().write(path, svg)?;
        }
        Ok(self)
    }
}

impl<V: Serialize> Report for Shown<V> {
    fn text(&self) -> String {
        self.text.clone()
    }

    fn warnings(&self) -> Option<&[Warning]> {
        self.warnings.as_deref()
    }

    fn verdict(&self) -> Option<Verdict> {
        self.verdict
    }

    fn next(&self) -> Option<String> {
        self.next.clone()
    }

    fn is_printed_as_json(&self) -> bool {
        self.is_printed_as_json
    }

    fn page(&self) -> Option<Page> {
        self.page.clone()
    }

    fn failure(&mut self) -> Option<Error> {
        self.failure.take()
    }
}
