//! The cuts, shots and key frames of a video.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Error, Result, ensure};
use ga_files::Staged;
use ga_image::png;
use ga_video::keyframe::{Options, scenes};
use serde::Serialize;

use super::input::{Analysed, Blocks, analyse};
use super::report::Report;
use super::spool::Spool;
use super::{page, plot, sheet};
use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::output;
use ga_draw::document::Page;

/// Find cuts, dissolves, fades, shots and key frames of a video.
///
/// Shots are divided at cuts and in the middle of dissolves. The background of a shot is static or
/// dynamic. Key frames are chosen in two stages: frames whose background, or whose objects, differ
/// from the last candidate, and of these the ones that have little mutual information with it; the
/// first clear frame of each shot is always one. No key frame is nearly black or blended.
///
/// --json prints {"frames": 720, "cuts": [285, …], "dissolves": [{"start", "end"}, …],
/// "fades": [{"start", "end", "direction", "colour"}, …], "shots": [{"start", "end",
/// "background"}, …], "key_frames": [{"index", "time", "reason", "score"}, …]}. Frames are counted
/// from 0, intervals are half-open, a cut is the first frame of the new shot, times are in seconds.
///
/// For instance
///
///   nullcone video keyframes film.y4m --out keys --contact-sheet sheet.png --plot curves.svg
///   ffmpeg -i film.mp4 -f yuv4mpegpipe -pix_fmt yuv420p - | nullcone video keyframes - --json
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(super) struct Arguments {
    /// The video; - is Y4M from standard input.
    #[arg(value_name = "FILE")]
    video: PathBuf,
    /// Write the key frames as PNG into this folder.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Choose at most this number of key frames: the first of each shot, then those with most that
    /// is new.
    #[arg(long, value_name = "COUNT")]
    budget: Option<usize>,
    /// The least part that is new in a key frame, from 0 to 1, by mutual information with the
    /// candidate before it.
    #[arg(long, value_name = "PART", default_value_t = Options::default().threshold)]
    threshold: f64,
    /// How frames are divided into blocks.
    #[arg(long, value_enum, default_value_t = Blocks::Five)]
    layout: Blocks,
    /// The least number of frames of a shot.
    #[arg(long, value_name = "FRAMES", default_value_t = 1)]
    min_shot: usize,
    /// Write the shots as a table (.csv) or as an edit decision list (.edl); may be repeated.
    #[arg(long, value_name = "FILE")]
    scenes: Vec<PathBuf>,
    /// Write the differences and the mutual information of all frames as a chart, as Cui's fig. 6.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// Write the key frames side by side as one picture.
    #[arg(long, value_name = "FILE.png")]
    contact_sheet: Option<PathBuf>,
}

/// The formats of tables of shots.
const SCENES: [Format; 2] = [Format::Csv, Format::Edl];

/// What was found, and where it is shown.
#[derive(Serialize)]
pub(super) struct Found {
    #[serde(flatten)]
    report: Report,
    #[serde(skip)]
    page: Option<Page>,
    /// Why the video was not read to its end.
    #[serde(skip)]
    failure: Option<Error>,
}

impl Command for Arguments {
    type Report = Found;

    fn run(&self, context: &Context) -> Result<Found> {
        self.check(context)?;
        let progress = context.progress(1);
        progress.step("analysing");
        let options = Options {
            layout: self.layout.into(),
            minimum_shot: self.min_shot,
            threshold: self.threshold,
            budget: self.budget,
        };
        let with_page = context.report().is_some();
        let pictures = self.out.is_some() || self.contact_sheet.is_some() || with_page;
        let mut spool = pictures.then(Spool::new).transpose()?;
        let mut analysed = analyse(&self.video, options, spool.as_mut(), &progress)?;
        let report = Report::new(&analysed.analysis);
        // What was analysed before an error is reported, without files beside the page.
        let failure = analysed.failure.take();
        progress.step("writing");
        let sheet = match &mut spool {
            Some(spool) if self.contact_sheet.is_some() || with_page => {
                let sheet = sheet::draw(&report, spool, &self.title())?;
                Some(png::encode(&sheet).context("cannot encode the contact sheet")?)
            }
            _ => None,
        };
        let page = match &sheet {
            Some(sheet) if with_page => {
                let title = self.title();
                Some(page::of(
                    &analysed,
                    &report,
                    sheet,
                    &title,
                    failure.as_ref(),
                )?)
            }
            _ => None,
        };
        if failure.is_none() {
            self.write(&analysed, &report, spool.as_mut(), sheet.as_deref())?;
        }
        Ok(Found {
            report,
            page,
            failure,
        })
    }
}

impl frame::Report for Found {
    fn text(&self) -> String {
        self.report.text()
    }

    fn page(&self) -> Option<Page> {
        self.page.clone()
    }

    fn failure(&mut self) -> Option<Error> {
        self.failure.take()
    }
}

impl Arguments {
    fn check(&self, context: &Context) -> Result<()> {
        ensure!(
            (0.0..=1.0).contains(&self.threshold),
            "--threshold {}: it must be from 0 to 1",
            self.threshold
        );
        let mut files = context.files([&self.video])?;
        if let Some(folder) = &self.out {
            files.write_folder("--out", folder, [""; 0])?;
        }
        for path in &self.scenes {
            files.write("--scenes", path, &SCENES)?;
        }
        files.write_if_given("--plot", self.plot.as_ref(), &[Format::Svg])?;
        files.write_if_given(
            "--contact-sheet",
            self.contact_sheet.as_ref(),
            &[Format::Png],
        )?;
        Ok(())
    }

    /// The name of the video, without folders.
    fn title(&self) -> String {
        let name = self.video.file_name().filter(|name| *name != "-");
        name.map_or("standard input".into(), |name| {
            name.to_string_lossy().into_owned()
        })
    }

    /// Writes the files that were asked for, all of them or none.
    fn write(
        &self,
        analysed: &Analysed,
        report: &Report,
        spool: Option<&mut Spool>,
        sheet: Option<&[u8]>,
    ) -> Result<()> {
        let mut files = Staged::default();
        let title = self.title();
        for path in &self.scenes {
            let shots = &analysed.analysis.shots;
            let text = match Format::Edl.fits(path) {
                true => scenes::edl(shots, analysed.rate(), &title),
                false => scenes::csv(shots, analysed.rate()),
            };
            output::stage(&mut files, path, text.as_bytes())?;
        }
        if let Some(path) = &self.plot {
            let svg = plot::svg(&analysed.analysis, &title)?;
            output::stage(&mut files, path, svg.as_bytes())?;
        }
        if let (Some(folder), Some(spool)) = (&self.out, spool) {
            for key in &report.key_frames {
                if let Some(bytes) = spool.png(key.index)? {
                    output::stage(&mut files, &key_path(folder, key.index), &bytes)?;
                }
            }
        }
        if let (Some(path), Some(sheet)) = (&self.contact_sheet, sheet) {
            output::stage(&mut files, path, sheet)?;
        }
        Ok(files.finish()?)
    }
}

fn key_path(folder: &Path, index: usize) -> PathBuf {
    folder.join(format!("frame_{index:06}.png"))
}
