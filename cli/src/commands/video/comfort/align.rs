//! Stereoscopic video without the defects that were measured in it.

use std::path::PathBuf;
use std::str::FromStr;

use anyhow::{Context as _, Result, ensure};
use ga_video::comfort::align::{CommonDelay, Plan};
use ga_video::comfort::stereoscopy::Stereoscopy;
use ga_video::comfort::{Viewing, comfortable_shift, meaning};
use ga_video::stereo::Layout;
use serde::Serialize;

use super::input::LayoutName;
use super::screen::Screen;
use crate::format::Format;
use crate::frame::{Command, Context, Shown, Warning};
use crate::shell::quoted;

/// Remove differences between the views of stereoscopic video that they should not have.
///
/// What `nullcone video comfort` measures is applied backwards: the delay of one eye in whole
/// frames, views that are exchanged, vertical shift, rotation and size of the right view, its
/// brightness and its colours. Within a shot the right view is changed by the same amounts in all
/// frames, unless the defect itself changes. The left view stays as it is; so does sharpness. A
/// part of a frame by which an eye is late remains. Frames that do not show the order of the eyes
/// have that of their shot.
///
/// Parallax stays too, unless --shift-parallax moves the whole scene: back by a positive number of
/// degrees, forward by a negative one, or as is recommended, which is the smallest shift after
/// which nothing is too far in front of the screen or behind it for viewers at this screen.
///
/// Where the right view is moved, what lies outside it is mirrored at its border. Where one eye is
/// late, frames at both ends have no partner and are left out.
///
/// The video is read twice, and up to four times where one eye is late or views are exchanged, so
/// that it cannot come from standard input. The result keeps the rate of frames (its mean, where
/// it varies), the depth of 8 or 10 bits, the sampling of colours and the shape of pixels. It has
/// both views in each frame, in the layout of IN, and side by side for two files. It has no sound,
/// since Y4M cannot hold any: a command of ffmpeg that joins it is printed.
///
/// For instance
///
///   nullcone video align film.y4m --out aligned.y4m
///   nullcone video comfort aligned.y4m --layout side-by-side
///
/// With --json it prints {"out": …, "frames": …, "exchanged_frames": …, "undecided_frames": …,
/// "delay_frames": …, "delay_remaining_frames": …, "frames_with_delay": …,
/// "frames_with_this_delay": …, "shift_parallax_degrees": …, "shift_parallax_percent": …}.
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
    /// Move the whole scene back by this angle, forward if it is negative, or as is recommended.
    #[arg(
        long,
        value_name = "DEGREES|recommended",
        allow_negative_numbers = true
    )]
    shift_parallax: Option<Shift>,
    #[command(flatten)]
    screen: Screen,
}

/// By how much parallax is shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shift {
    Recommended,
    Degrees(f64),
}

/// The greatest shift in degrees: what is searched for in the other view is not farther away.
const MOST_DEGREES: f64 = 5.0;

impl FromStr for Shift {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match (text, text.parse()) {
            ("recommended", _) => Ok(Self::Recommended),
            (_, Ok(degrees)) if f64::abs(degrees) <= MOST_DEGREES => Ok(Self::Degrees(degrees)),
            _ => Err(format!(
                "it must be “recommended” or degrees from −{MOST_DEGREES} to {MOST_DEGREES}"
            )),
        }
    }
}

impl Shift {
    /// The shift in per cent of the width.
    fn percent(self, plan: &Plan, viewing: &Viewing) -> Result<f64> {
        match self {
            Self::Degrees(degrees) => Ok(viewing.parallax_of_degrees(degrees)),
            Self::Recommended => {
                let ends = plan.ends().context(
                    "--shift-parallax recommended: too few points are found in both views of any \
                     frame, so that the depth is not known",
                )?;
                Ok(comfortable_shift(ends, viewing))
            }
        }
    }
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
        let viewing = self.screen.viewing()?;
        let mut warnings: Vec<Warning> = layout.doubt(&source).into_iter().collect();
        let progress = context.progress(1);
        let count = source.properties().frame_count;
        let show = |frame: usize| {
            let frame = frame as u64 + 1;
            if frame.is_multiple_of(8) {
                progress.at(frame, count.map_or(2 * frame, |count| count as u64));
            }
        };
        progress.step("measuring");
        let threads = rayon::current_num_threads();
        let mut plan = Plan::of(open, layout.halves(), threads, |reading, frame| {
            if reading > 0 && frame == 0 {
                progress.step("measuring again");
            }
            show(frame);
        })?;
        let shift = self.shift_parallax;
        let shift = shift.map_or(Ok(0.0), |shift| shift.percent(&plan, &viewing))?;
        if shift != 0.0 {
            plan = plan.with_parallax(shift);
        }
        progress.step("aligning");
        let halves = layout.halves().unwrap_or(Layout::SideBySide);
        let degrees = viewing.degrees_of_parallax(shift);
        let report = Report::new(out.display().to_string(), &plan, [shift, degrees]);
        let text = report.text();
        if plan.undecided().frames() > 0 {
            let message = format!(
                "the order of the eyes could not be decided in {}, which stay as they are: {}",
                plan.undecided(),
                meaning(Stereoscopy::Unknown)
            );
            warnings.push(Warning::new("undecided_order", message));
        }
        warnings.extend(self.without_sound(&plan));
        let mut shown = Shown::new(report, text);
        shown.warnings = Some(warnings).filter(|warnings| !warnings.is_empty());
        context.outputs().write_with(out, |file| {
            let written = plan.write(&mut source, halves, file, show);
            written.with_context(|| format!("cannot write {}", out.display()))
        })?;
        shown.next = Format::Y4m.fits(out).then(|| {
            let (out, layout) = (quoted(out), LayoutName::of_halves(halves).word());
            format!("nullcone video comfort {out} --layout {layout}")
        });
        Ok(shown)
    }
}

impl Arguments {
    /// Says that sound is not kept, and how it is joined, where the input may have some.
    fn without_sound(&self, plan: &Plan) -> Option<Warning> {
        let is_picture = ga_image::file::detect(&self.video).is_ok_and(|found| found.is_some());
        if !self.video.is_file() || is_picture || Format::Y4m.fits(&self.video) {
            return None;
        }
        // The first frames of a late left eye are left out.
        let (frames, last_seconds) = plan.source_frames();
        let seconds = last_seconds / frames.saturating_sub(1).max(1) as f64;
        let late = plan.delay().frames.min(0).unsigned_abs() as f64 * seconds;
        let start = match late > 0.0 {
            true => format!("-ss {late:.3} "),
            false => String::new(),
        };
        let (video, out) = (quoted(&self.video), quoted(&self.out));
        Some(
            Warning::new(
                "no_sound",
                format!(
                    "Y4M has no sound, so that it is not kept. If the video has some, this joins \
                     it: ffmpeg -i {out} {start}-i {video} -map 0:v -map 1:a -c:v libx264 -crf 16 \
                     -c:a copy -shortest joined.mp4"
                ),
            )
            .into_note(),
        )
    }
}

/// What was done.
#[derive(Serialize)]
pub(in crate::commands::video) struct Report {
    out: String,
    frames: usize,
    /// How many frames have their views exchanged.
    exchanged_frames: usize,
    /// How many frames stay as they are since the order of the eyes could not be decided.
    undecided_frames: usize,
    /// The delay of the right view that was removed, and what remains of it; `None` where there is
    /// none that is the same in most frames.
    delay_frames: i64,
    delay_remaining_frames: Option<f64>,
    /// How many frames show a delay, and how many show the one that was removed.
    frames_with_delay: usize,
    frames_with_this_delay: usize,
    /// How far the whole scene was moved back.
    shift_parallax_degrees: f64,
    shift_parallax_percent: f64,
}

impl Report {
    fn new(out: String, plan: &Plan, [percent, degrees]: [f64; 2]) -> Self {
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
            undecided_frames: plan.undecided().frames(),
            delay_frames: frames,
            delay_remaining_frames: (agreeing > 0).then_some(rest_frames),
            frames_with_delay: measured,
            frames_with_this_delay: agreeing,
            // Not −0.
            shift_parallax_degrees: degrees + 0.0,
            shift_parallax_percent: percent + 0.0,
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
                let mut text = match self.delay_frames {
                    0 => "no delay of a whole frame".to_owned(),
                    1 | -1 => format!("delay of {} frame removed", self.delay_frames),
                    frames => format!("delay of {frames} frames removed"),
                };
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
        let direction = match self.shift_parallax_percent > 0.0 {
            true => "back",
            false => "forward",
        };
        let shift = match self.shift_parallax_percent == 0.0 {
            true => String::new(),
            false => format!(
                "; the scene moved {direction} by {:.2}° ({:.2} % of the width)",
                self.shift_parallax_degrees.abs(),
                self.shift_parallax_percent.abs()
            ),
        };
        format!(
            "{}: {} frames; views exchanged in {}; {delay}{shift}\n",
            self.out, self.frames, self.exchanged_frames
        )
    }
}
