//! Stereoscopic video without the defects that were measured in it.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use ga_video::comfort::align::{CommonDelay, Plan};
use ga_video::stereo::Layout;
use serde::Serialize;

use super::input::LayoutName;
use crate::format::Format;
use crate::frame::{Command, Context, Shown};
use crate::output;
use crate::shell::quoted;

/// Remove differences between the views of stereoscopic video that they should not have.
///
/// What `nullcone video comfort` measures is applied backwards: the delay of one eye in whole
/// frames, views that are exchanged, vertical shift, rotation and size of the right view, its
/// brightness and its colours. Within a shot the right view is changed by the same amounts in all
/// frames, unless the defect itself changes. The left view stays as it is; so do parallax and
/// sharpness. A part of a frame by which an eye is late remains.
///
/// Where the right view is moved, what lies outside it is mirrored at its border. Where one eye is
/// late, frames at both ends have no partner and are left out.
///
/// The video is read twice, and up to four times where one eye is late or views are exchanged, so
/// that it cannot come from standard input. The result keeps the rate of frames (its mean, where
/// it varies), the depth of 8 or 10 bits and the sampling of colours. It has both views in each
/// frame, one above the other if IN has them so, else side by side, also for two files. It has no
/// sound: Y4M cannot hold any.
///
/// For instance
///
///   nullcone video align film.y4m --out aligned.y4m
///   nullcone video comfort aligned.y4m --layout side-by-side
///
/// With --json it prints {"out": …, "frames": …, "exchanged_frames": …, "delay_frames": …,
/// "delay_remaining_frames": …, "frames_with_delay": …, "frames_with_this_delay": …}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(in crate::commands::video) struct Arguments {
    /// The video of both views, or of the left one.
    #[arg(value_name = "IN")]
    video: PathBuf,
    /// The video of the right view.
    #[arg(value_name = "RIGHT")]
    right: Option<PathBuf>,
    /// Where the views lie; side-by-side if nothing is said, two-files if RIGHT is given.
    #[arg(long, value_enum)]
    layout: Option<LayoutName>,
    /// The video to be written.
    #[arg(long, value_name = "OUT.y4m")]
    out: PathBuf,
}

impl Command for Arguments {
    type Report = Shown<Report>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        let (out, right) = (self.out.as_path(), self.right.as_deref());
        let videos = [self.video.as_path()].into_iter().chain(right);
        for video in videos.clone() {
            ensure!(
                video.as_os_str() != "-",
                "the video is read twice, which standard input does not allow: write it to a file \
                 first"
            );
        }
        context.files(videos)?.write("--out", out, &[Format::Y4m])?;
        let layout = match (self.layout, right) {
            (None, None) => LayoutName::SideBySide,
            (name, _) => LayoutName::of(name, right)?,
        };
        let open = || layout.open(&self.video, right);
        let mut source = open()?;
        let progress = context.progress(1);
        let count = source.properties().frame_count;
        let show = |frame: usize| {
            let frame = frame as u64 + 1;
            if frame.is_multiple_of(8) {
                progress.at(frame, count.map_or(2 * frame, |count| count as u64));
            }
        };
        progress.step("measuring");
        let plan = Plan::of(open, layout.halves(), 2, |reading, frame| {
            if reading > 0 && frame == 0 {
                progress.step("measuring again");
            }
            show(frame);
        })?;
        progress.step("aligning");
        let halves = layout.halves().unwrap_or(Layout::SideBySide);
        let report = Report::new(out.display().to_string(), &plan);
        let text = report.text();
        let mut shown = Shown::new(report, text);
        output::stage_with(&mut shown.files, out, |file| {
            let written = plan.write(&mut source, halves, file, show);
            written.with_context(|| format!("cannot write {}", out.display()))
        })?;
        shown.next = Format::Y4m.fits(out).then(|| {
            let name = match halves {
                Layout::SideBySide => LayoutName::SideBySide,
                Layout::TopBottom => LayoutName::TopBottom,
            };
            let (out, layout) = (quoted(out), name.word());
            format!("nullcone video comfort {out} --layout {layout}")
        });
        Ok(shown)
    }
}

/// What was done.
#[derive(Serialize)]
pub(in crate::commands::video) struct Report {
    out: String,
    frames: usize,
    /// How many frames have their views exchanged.
    exchanged_frames: usize,
    /// The delay of the right view that was removed, and what remains of it; `None` where there is
    /// none that is the same in most frames.
    delay_frames: i64,
    delay_remaining_frames: Option<f64>,
    /// How many frames show a delay, and how many show the one that was removed.
    frames_with_delay: usize,
    frames_with_this_delay: usize,
}

impl Report {
    fn new(out: String, plan: &Plan) -> Self {
        let CommonDelay {
            frames,
            rest_frames,
            measured,
            agreeing,
        } = *plan.delay();
        Self {
            out,
            frames: plan.frames(),
            exchanged_frames: plan.exchanged_frames(),
            delay_frames: frames,
            delay_remaining_frames: (agreeing > 0).then_some(rest_frames),
            frames_with_delay: measured,
            frames_with_this_delay: agreeing,
        }
    }

    fn text(&self) -> String {
        let delay = match self.frames_with_delay {
            0 => "no frame shows a delay".to_owned(),
            measured if self.frames_with_this_delay == 0 => {
                format!(
                    "no delay removed: it is not the same in the {measured} frames that show one"
                )
            }
            measured => {
                let mut text = format!("delay of {} frames removed", self.delay_frames);
                let others = measured - self.frames_with_this_delay;
                if others > 0 {
                    text += &format!("; {others} of {measured} frames show another delay");
                }
                match self.delay_remaining_frames {
                    Some(rest) if rest.abs() >= 0.1 => {
                        text += &format!("; {rest:.1} frames of it remain");
                    }
                    _ => {}
                }
                text
            }
        };
        format!(
            "{}: {} frames; views exchanged in {}; {delay}\n",
            self.out, self.frames, self.exchanged_frames
        )
    }
}
