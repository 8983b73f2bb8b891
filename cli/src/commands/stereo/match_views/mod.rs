//! `nullcone stereo match`: the disparities of two rectified views.

mod arguments;
mod films;

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context as _, Result, ensure};
use ga_image::png;
use ga_image::sample::Sample;
use ga_vision::diagnosis::of_match::faults_of_match;
use ga_vision::disparity::range::DisparityRange;
use ga_vision::disparity::{file, picture};
use ga_vision::matcher::{Match, MatchSummary, Matcher, MatcherOptions};
use serde::Serialize;

pub(crate) use self::arguments::Arguments;
use self::films::{FilmReport, numbered};
use super::matching::{Mode, warnings};
use super::rectify::RIG;
use super::views::{self, ViewPair};
use crate::format::Format;
use crate::frame::{self, Command, Context, Verdict, Warning, command_line};

/// What is printed of two pictures or two films.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Report {
    Pair(PairReport),
    Films(FilmReport),
}

/// What is printed of two pictures.
#[derive(Serialize)]
pub(crate) struct PairReport {
    #[serde(skip)]
    out: String,
    #[serde(skip)]
    next: Option<String>,
    #[serde(skip)]
    warnings: Vec<Warning>,
    width_px: usize,
    height_px: usize,
    min_disparity_px: i32,
    max_disparity_px: i32,
    range_points: Option<usize>,
    mode: Mode,
    #[serde(flatten)]
    found: MatchSummary,
    seconds: f64,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        self.matching.check()?;
        if numbered(&self.out, 0).is_some() {
            return Ok(Report::Films(self.films(context)?));
        }
        ensure!(
            self.frames.is_none() && !self.views.paths().into_iter().any(Path::is_dir),
            "--out {}: films have many frames, whose number takes the place of %04d in the name",
            self.out.display()
        );
        Ok(Report::Pair(self.pair(context)?))
    }
}

impl Arguments {
    fn pair(&self, context: &Context) -> Result<PairReport> {
        let mut files = context.files(self.views.paths())?;
        let format = files.write("--out", &self.out, &[Format::Pfm, Format::Png])?;
        files.write_if_given("--confidence", self.confidence.as_ref(), &[Format::Png])?;
        files.write_if_given("--picture", self.picture.as_ref(), &[Format::Png])?;
        let progress = context.progress(5);
        progress.step("reading the views");
        let [left, right] = views::read_pair::<u16>(&self.views.left, &self.views.right)?;

        progress.step("finding the range");
        let threads = rayon::current_num_threads();
        let (range, range_points) = match self.matching.max_disparity {
            Some(beyond) => ([self.matching.min_disparity, beyond], None),
            None => {
                let found = DisparityRange::of(&left, &right, threads).with_context(|| {
                    format!("{}: --max-disparity gives the range", self.views.named())
                })?;
                (found.ends, Some(found.points))
            }
        };
        progress.step("matching");
        let begin = Instant::now();
        let options = MatcherOptions {
            range,
            mode: self.matching.mode.into(),
            threads,
        };
        let found = Matcher::new(options, left.width(), left.height())
            .and_then(|mut matcher| matcher.run(&left, &right))
            .with_context(|| self.views.named())?;
        let seconds = begin.elapsed().as_secs_f64();
        progress.step("checking");
        let warnings = warnings(&faults_of_match([&left, &right], &found, range));
        let found = found.at_least(self.matching.min_confidence);
        // The files need memory as well.
        drop((left, right));

        progress.step("writing");
        let map = &found.disparity;
        let files = self.encoded(&found, format, Path::to_path_buf)?;
        context.outputs().write_all(&files)?;
        drop(progress);

        Ok(PairReport {
            out: self.out.display().to_string(),
            next: self.reconstruction(),
            width_px: map.width(),
            height_px: map.height(),
            min_disparity_px: range[0],
            max_disparity_px: range[1],
            range_points,
            warnings,
            mode: self.matching.mode,
            found: found.summary(),
            seconds,
        })
    }

    /// The files of a matched pair, whose names a function gives by those of the options.
    fn encoded(
        &self,
        found: &Match,
        format: Format,
        name: impl Fn(&Path) -> PathBuf,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        let map = &found.disparity;
        let out = name(&self.out);
        let encoded = match format {
            Format::Png => file::encode_png(map).with_context(|| out.display().to_string())?,
            _ => file::encode(map)?,
        };
        let mut files = vec![(out, encoded)];
        if let Some(path) = &self.confidence {
            let levels = found.confidence.map(u8::from_unit);
            files.push((name(path), png::encode(&levels)?));
        }
        if let Some(path) = &self.picture {
            files.push((name(path), png::encode(&picture::captioned(map))?));
        }
        Ok(files)
    }

    /// How the same views are reconstructed, where the file of cameras is beside them that
    /// `nullcone stereo rectify` writes.
    fn reconstruction(&self) -> Option<String> {
        let ViewPair { left, right } = &self.views;
        let rig = left.with_file_name(RIG);
        let words = [
            "nullcone stereo reconstruct".as_ref(),
            left.as_os_str(),
            right.as_os_str(),
            "--rig".as_ref(),
            rig.as_os_str(),
            "--out".as_ref(),
            "model.glb".as_ref(),
        ];
        rig.is_file().then(|| command_line(words))
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(match self {
            Self::Pair(report) => &report.warnings,
            Self::Films(report) => &report.warnings,
        })
    }

    fn verdict(&self) -> Option<Verdict> {
        self.warnings().map(Verdict::of)
    }

    fn next(&self) -> Option<String> {
        match self {
            Self::Pair(report) => report.next.clone(),
            Self::Films(_) => None,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Pair(report) => report.text(),
            Self::Films(report) => report.text(),
        }
    }
}

impl PairReport {
    fn text(&self) -> String {
        let range = match (self.found.least, self.found.greatest) {
            (Some(least), Some(greatest)) => format!("{least:.2} to {greatest:.2} px"),
            _ => "none".into(),
        };
        let points = match self.range_points {
            Some(points) => format!(", from {points} corners"),
            None => String::new(),
        };
        format!(
            "{}: {} × {} pixels, {:.2} % known\n\
             disparities {range}, looked for from {} up to {} px{points}\n\
             mean confidence {:.3}, {:.2} % of the pixels are textured\n\
             matched in {:.3} s\n",
            self.out,
            self.width_px,
            self.height_px,
            self.found.density,
            self.min_disparity_px,
            self.max_disparity_px,
            self.found.mean_confidence,
            self.found.textured,
            self.seconds
        )
    }
}
