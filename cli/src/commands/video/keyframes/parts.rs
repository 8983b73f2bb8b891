//! Videos that are measured in parts.
//!
//! A part has the mutual information of neighbouring frames, which takes most of the time. Cuts and
//! key frames follow from all frames, and are found of the whole video when the parts are joined,
//! as in one process.

use std::ops::ControlFlow;
use std::path::Path;

use anyhow::{Result, ensure};
use ga_video::keyframe::{Analysed, information};

use super::Arguments;
use crate::format::Format;
use crate::frame::{Context, Shown};
use crate::part::{About, Frames, Outputs, Part, PartWritten, Parts};

/// The words of the command.
pub(crate) const COMMAND: &str = "video keyframes";

/// What may be made of the parts beside the folder of key frames: the values, tables of shots, the
/// chart and the contact sheet.
pub(crate) const FORMATS: [Format; 5] = [
    Format::Json,
    Format::Csv,
    Format::Edl,
    Format::Svg,
    Format::Png,
];

impl Arguments {
    /// Measures some frames, and writes what was measured.
    pub(super) fn measure(
        &self,
        asked: Frames,
        path: &Path,
        context: &Context,
    ) -> Result<Shown<PartWritten>> {
        let mut found: Vec<Option<f64>> = Vec::new();
        let is_last = information(&self.video, asked.first, |bits| {
            if asked.end_at(asked.first + found.len()) {
                return ControlFlow::Break(());
            }
            found.push(bits);
            ControlFlow::Continue(())
        })?;
        ensure!(
            !found.is_empty(),
            "--frames {asked}: {} has no such frame",
            self.video.display()
        );
        let frames = asked.first..asked.first + found.len();
        let about = About::new(COMMAND, self, [self.video.as_path()], frames, is_last)?;
        let written = PartWritten::new(path, &about);
        let text = written.text();
        Part::new(about, found).write(path, context.outputs())?;
        Ok(Shown::new(written, text))
    }
}

/// What the command says that analyses all frames.
pub(crate) fn merged(
    parts: &Parts,
    outputs: &Outputs,
    context: &Context,
) -> Result<Shown<Analysed>> {
    parts.check_inputs()?;
    let scenes = [Format::Csv, Format::Edl].map(|format| outputs.of(format));
    let arguments = Arguments {
        out: outputs.folder(),
        scenes: scenes.into_iter().flatten().collect(),
        plot: outputs.of(Format::Svg),
        contact_sheet: outputs.of(Format::Png),
        ..parts.arguments()?
    };
    let mut all = Vec::new();
    for part in parts.contents() {
        let (_, measured): (_, Vec<Option<f64>>) = part?;
        all.extend(measured);
    }
    arguments.analyse(all, context)
}
