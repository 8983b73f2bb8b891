//! Stereoscopic video that is measured in parts.
//!
//! A part has what each of its frames shows by itself, which takes most of the time. Cuts, the
//! delay between the eyes, their order and the pictures of the page need the frames around; they
//! are found of the whole video when the parts are joined, as in one process.

use std::collections::VecDeque;
use std::ops::ControlFlow;
use std::path::Path;

use anyhow::{Result, ensure};
use ga_video::comfort::{self, FrameMeasures};

use super::{Arguments, LayoutName};
use crate::format::Format;
use crate::frame::{Context, Shown};
use crate::part::{About, Frames, Outputs, Part, PartWritten, Parts};

/// The words of the command.
pub(crate) const COMMAND: &str = "video comfort";

/// What may be made of the parts: the summary and the table.
pub(crate) const FORMATS: [Format; 2] = [Format::Json, Format::Csv];

impl Arguments {
    /// Measures some frames, and writes what was measured.
    pub(super) fn measure(
        &self,
        asked: Frames,
        path: &Path,
        context: &Context,
    ) -> Result<Shown<Option<PartWritten>>> {
        let layout = LayoutName::of(self.layout, self.right.as_deref())?;
        let mut source = layout.open(&self.video, self.right.as_deref())?;
        let mut found: Vec<FrameMeasures> = Vec::new();
        let is_last = comfort::measure(&mut source, asked.first, |measures| {
            if asked.end_at(asked.first + found.len()) {
                return ControlFlow::Break(());
            }
            found.push(measures);
            ControlFlow::Continue(())
        })?;
        ensure!(
            !found.is_empty(),
            "--frames {asked}: {} has no such frame",
            self.video.display()
        );
        let frames = asked.first..asked.first + found.len();
        let inputs = [&self.video].into_iter().chain(&self.right);
        let inputs = inputs.map(AsRef::as_ref);
        let about = About::new(COMMAND, self, inputs, frames, is_last)?;
        let written = PartWritten::new(path, &about);
        Part::new(about, found).write(path, context.outputs())?;
        let text = written.text();
        Ok(Shown::new(Some(written), text))
    }
}

/// What the command says that analyses all frames.
pub(crate) fn merged(
    parts: &Parts,
    outputs: &Outputs,
    context: &Context,
) -> Result<Shown<Option<PartWritten>>> {
    parts.check_inputs()?;
    let arguments = Arguments {
        summary: outputs.of(Format::Json),
        ..parts.arguments()?
    };
    let mut all = VecDeque::new();
    for part in parts.contents() {
        let (_, measures): (_, Vec<FrameMeasures>) = part?;
        all.extend(measures);
    }
    arguments.observe(all, outputs.of(Format::Csv).as_deref(), context)
}
