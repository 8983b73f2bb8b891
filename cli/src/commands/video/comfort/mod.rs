//! The comfort of stereoscopic video.

pub(super) mod align;
mod input;
mod parts;
mod screen;
mod table;

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use anyhow::{Error, Result, bail, ensure};
use ga_video::comfort::monitor::{Options, observe_measured};
use ga_video::comfort::report::{self, About, Report};
use ga_video::comfort::{FrameMeasures, Level, Observer, Record, Summary, Viewing};
use ga_video::{Frame, Properties};
use serde::{Deserialize, Serialize};

use crate::format::Format;
use crate::frame::{Check, Command, Context, Progress, Shown, Verdict};
use crate::output;
use crate::part::{PartArguments, PartWritten};
use crate::shell::quoted;
use crate::standard_output;
use input::LayoutName;
pub(crate) use parts::{COMMAND, FORMATS, merged};
use screen::Screen;

/// Measure how comfortable stereoscopic video is, frame by frame.
///
/// Eleven quantities get a score from 0 to 15: green up to 7, orange up to 13, red above. The
/// picture's width is the screen's, of 16:9 and 55 inches at three picture heights if nothing else
/// is stated. Where a frame does not show a quantity, its score is null, its state is
/// "not measurable" or "unknown", and its reason says why in words.
///
/// Views that are squeezed to half of their width or height are measured in the shape in which
/// they are shown; so are pixels that are not square, as the video states them.
///
/// --json prints one line for each frame, while the video is read:
/// {"frame": 0, "rows": {"brightness": {"score", "level", "raw", "unit", "offset_codes"},
/// "colour", "vertical": {…, "shift_px", "rotation_degrees", "zoom_percent"},
/// "asynchrony": {…, "frames"}, "parallax_deviation": {…, "median_px"},
/// "stereoscopy": {…, "verdict"}, "weak_depth", "rich_depth", "over_convergence",
/// "over_divergence", "focal_gap": {…, "sharpness_log2", "zoom_percent"}}}.
/// Numbers are those of the right view less those of the left one: it is brighter by offset_codes,
/// lower by shift_px, rotated counter-clockwise, larger by zoom_percent, and late by frames.
/// median_px is the median of x_L − x_R, positive in front of the screen.
///
/// --out writes a page that shows the same to those who make the video: what is good and what to
/// mend first, all scores over time, the depth budget, and the worst moments as pictures with what
/// is wrong drawn into them. It needs no other file and no network. If the video breaks off, the
/// page is about the frames before that.
///
/// The verdict, which --summary has too, is good where no check is orange or red in any frame,
/// failed where one is red, otherwise doubtful, also where nothing could be measured. Too little
/// depth does not count, since it does not strain the eyes.
///
/// For instance
///
///   nullcone video comfort film.y4m --layout side-by-side --out report.html
///   nullcone video comfort film.y4m --layout side-by-side --json
///   nullcone video comfort left.y4m right.y4m --layout two-files --csv > comfort.csv
#[derive(Clone, Debug, Serialize, Deserialize, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The video of both views, or of the left one; - is Y4M from standard input.
    #[arg(value_name = "FILE")]
    video: PathBuf,
    /// The video of the right view.
    #[arg(value_name = "RIGHT")]
    right: Option<PathBuf>,
    /// Where the views lie; two-files if RIGHT is given.
    #[arg(long, value_enum)]
    layout: Option<LayoutName>,
    #[command(flatten)]
    #[serde(flatten)]
    screen: Screen,
    /// Print a table with a line for each frame.
    #[arg(long, conflicts_with_all = ["json", "part"])]
    #[serde(skip)]
    csv: bool,
    /// Write a page with a verdict, charts and the worst moments; it needs no other file.
    #[arg(long, value_name = "FILE.html", conflicts_with = "part")]
    #[serde(skip)]
    out: Option<PathBuf>,
    /// Write the summary as JSON.
    #[arg(long, value_name = "FILE.json", conflicts_with = "part")]
    #[serde(skip)]
    summary: Option<PathBuf>,
    #[command(flatten)]
    #[serde(skip)]
    part: PartArguments,
    #[command(flatten)]
    #[serde(skip)]
    check: Check,
}

impl Command for Arguments {
    type Report = Shown<Option<PartWritten>>;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Self::Report> {
        self.check_out(context)?;
        match self.part.asked() {
            Some((frames, path)) => self.measure(frames, path, context),
            None => self.observe(VecDeque::new(), None, context),
        }
    }
}

impl Arguments {
    /// Analyses the video, of whose first frames the measures may be known, and writes a table of
    /// its frames where that is asked for.
    fn observe(
        &self,
        measured: VecDeque<FrameMeasures>,
        table: Option<&Path>,
        context: &Context,
    ) -> Result<Shown<Option<PartWritten>>> {
        let viewing = self.screen.viewing()?;
        let layout = LayoutName::of(self.layout, self.right.as_deref())?;
        let mut source = layout.open(&self.video, self.right.as_deref())?;
        let properties = *source.properties();
        let doubt = layout.doubt(&source);
        let options = Options {
            viewing,
            layout: layout.halves(),
            threads: rayon::current_num_threads(),
        };
        let progress = context.progress(1);
        progress.step("analysing");
        let lines = match (context.is_json(), self.csv) {
            (true, _) => Lines::Json,
            (_, true) => Lines::Csv,
            (false, false) => Lines::None,
        };
        let about = self.about(properties, viewing, layout);
        let align = about.align.clone();
        let with_page = self.out.is_some() || context.report().is_some();
        let mut watcher = Watcher {
            lines,
            progress: &progress,
            count: properties.frame_count.map(|count| count as u64),
            summary: Summary::default(),
            printed: match lines {
                Lines::Csv => output::print(&Record::csv_header()),
                Lines::Json | Lines::None => Ok(()),
            },
            table: table.map(|_| Record::csv_header()),
            can_align: false,
            viewing,
            report: with_page.then(|| Report::new(about)),
        };
        let result = observe_measured(&mut source, options, measured, &mut watcher);
        let Watcher {
            summary,
            printed,
            table: rows,
            can_align,
            report,
            ..
        } = watcher;
        drop(progress);
        printed?;
        if summary.frames == 0 {
            result?;
            bail!("{}: the video has no frames", self.video.display());
        }
        let verdict = verdict(&summary);
        let notes = report::notes(&summary);
        let text = match lines {
            Lines::Csv => String::new(),
            Lines::Json | Lines::None => {
                let mut text = table::text(&summary, &viewing);
                if !notes.is_empty() {
                    text += &format!("\n{}\n", notes.join("\n"));
                }
                format!("{text}\nthe result is {}\n", verdict.word())
            }
        };
        let mut shown = Shown::new(None, text);
        shown.warnings = doubt.map(|warning| vec![warning]);
        shown.is_printed_as_json = true;
        shown.verdict = Some(verdict);
        shown.next = align.filter(|_| can_align && lines == Lines::None);
        if let Some(report) = &report {
            // What was analysed before an error is reported.
            let failure = result.as_ref().err().map(ToString::to_string);
            shown.page = Some(report.page(&summary, failure.as_deref())?);
        }
        if let (Some(path), Some(page)) = (&self.out, &shown.page) {
            let html = page.clone().into_html();
            context.outputs().write(path, html)?;
        }
        if let Some(path) = self.summary.as_ref().filter(|_| result.is_ok()) {
            let mut object = summary.json(&viewing);
            object["verdict"] = serde_json::to_value(verdict)?;
            let text = serde_json::to_string_pretty(&object)? + "\n";
            context.outputs().write(path, text)?;
        }
        if let (Some(path), Some(rows)) = (table, rows) {
            context.outputs().write(path, rows)?;
        }
        shown.failure = result.err().map(Error::from);
        Ok(shown)
    }
}

/// How the program judges what a video is to its viewers.
fn verdict(summary: &Summary) -> Verdict {
    match summary.strain() {
        Some(Level::Green) => Verdict::Good,
        Some(Level::Orange) | None => Verdict::Doubtful,
        Some(Level::Red) => Verdict::Failed,
    }
}

/// What is printed of each frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Lines {
    None,
    Json,
    Csv,
}

impl Arguments {
    /// Fails before the work begins where the files could not be written after it.
    fn check_out(&self, context: &Context) -> Result<()> {
        let files = context.files([&self.video].into_iter().chain(&self.right))?;
        ensure!(
            !(self.csv && standard_output::is_taken()),
            "--report -: --csv prints to standard output too"
        );
        let mut files = files.printing("--csv", self.csv);
        files.write_if_given("--out", self.out.as_ref(), &[Format::Html])?;
        files.write_if_given("--summary", self.summary.as_ref(), &[Format::Json])?;
        self.part.check(&mut files)?;
        Ok(())
    }

    fn about(&self, properties: Properties, viewing: Viewing, layout: LayoutName) -> About {
        let paths = || std::iter::once(&self.video).chain(&self.right);
        let is_stream = |path: &PathBuf| path.as_os_str() == "-";
        let names = paths().map(|path| match path.file_name() {
            Some(name) if !is_stream(path) => name.to_string_lossy().into_owned(),
            _ => "standard input".into(),
        });
        let names: Vec<String> = names.collect();
        let quoted: Vec<String> = paths().map(quoted).collect();
        About {
            title: names.join(" and "),
            align: (!paths().any(is_stream)).then(|| {
                format!(
                    "nullcone video align {} --layout {} --out aligned.y4m",
                    quoted.join(" "),
                    layout.word()
                )
            }),
            shift: format!("--shift-parallax recommended{}", self.screen.words()),
            properties,
            viewing,
        }
    }
}

/// Prints what is known of each frame, and gathers what is written at the end.
struct Watcher<'a> {
    lines: Lines,
    progress: &'a Progress,
    /// The number of frames, where it is known.
    count: Option<u64>,
    summary: Summary,
    printed: Result<()>,
    /// The table that is written at the end.
    table: Option<String>,
    /// Whether a frame shows what can be removed.
    can_align: bool,
    viewing: Viewing,
    report: Option<Report>,
}

impl Observer for Watcher<'_> {
    fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures) {
        if let Some(report) = &mut self.report {
            report.measured(views, measures);
        }
    }

    fn complete(&mut self, record: Record) {
        self.summary.add(&record);
        let frames = self.summary.frames as u64;
        if frames.is_multiple_of(8) {
            self.progress.at(frames, self.count.unwrap_or(2 * frames));
        }
        if self.printed.is_ok() {
            let text = match self.lines {
                Lines::Json => format!("{}\n", record.json()),
                Lines::Csv => record.csv(),
                Lines::None => String::new(),
            };
            self.printed = output::print(&text);
        }
        if let Some(table) = &mut self.table {
            table.push_str(&record.csv());
        }
        self.can_align |= report::can_align(&record, &self.viewing);
        if let Some(report) = &mut self.report {
            report.complete(record);
        }
    }
}
