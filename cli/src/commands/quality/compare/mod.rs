//! `nullcone quality compare`: a picture or a video against its reference.

mod arguments;
mod page;
mod picture;
mod plot;
mod report;
mod table;

pub(crate) use arguments::Arguments;

use std::fs::File;
use std::io::Read;
use std::path::Path;

use anyhow::{Context as _, Error, Result, bail, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::quality::{MULTISCALE_LEAST_SIDE, Weights};
use ga_video::VideoError;
use ga_video::quality::{FrameQuality, VideoComparison};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::output;
use ga_draw::document::Page;
use report::{PictureReport, VideoReport};

impl Command for Arguments {
    type Report = Compared;

    fn run(&self, context: &Context) -> Result<Compared> {
        compare(self, context)
    }
}

/// What was measured, and its page.
#[derive(Serialize)]
pub(crate) struct Compared {
    #[serde(flatten)]
    measures: Measures,
    #[serde(skip)]
    warnings: Vec<Warning>,
    #[serde(skip)]
    page: Option<Page>,
    /// Why the videos were not compared to their ends.
    #[serde(skip)]
    failure: Option<Error>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Measures {
    Pictures(PictureReport),
    Videos(VideoReport),
}

impl Compared {
    fn new(measures: Measures) -> Self {
        let reason = match &measures {
            Measures::Pictures(report) => &report.ms_ssim_reason,
            Measures::Videos(report) => &report.ms_ssim_reason,
        };
        let warning =
            |reason: &String| Warning::new("too_few_pixels", format!("ms_ssim is null: {reason}"));
        Self {
            warnings: reason.iter().map(warning).collect(),
            measures,
            page: None,
            failure: None,
        }
    }
}

impl frame::Report for Compared {
    fn text(&self) -> String {
        match &self.measures {
            Measures::Pictures(report) => report.lines(),
            Measures::Videos(report) => report.lines(),
        }
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn page(&self) -> Option<Page> {
        self.page.clone()
    }

    fn failure(&mut self) -> Option<Error> {
        self.failure.take()
    }
}

fn compare(arguments: &Arguments, context: &Context) -> Result<Compared> {
    let paths = [&arguments.reference, &arguments.distorted];
    ensure!(
        !paths.iter().all(|path| path.as_os_str() == "-"),
        "standard input can be one of the two videos only"
    );
    let inputs = paths.into_iter().chain(&arguments.attention);
    let mut files = context.files(inputs)?;
    files.write_if_given("--csv", arguments.csv.as_ref(), &[Format::Csv])?;
    files.write_if_given("--plot", arguments.plot.as_ref(), &[Format::Svg])?;
    match paths.map(|path| is_picture(path)) {
        // What is missing beside a picture is a picture: its reader says what is wrong.
        [Some(true), Some(true) | None] | [None, Some(true)] => pictures(arguments, context),
        [Some(true), Some(false)] => bail!(
            "{} is a picture and {} is not",
            paths[0].display(),
            paths[1].display()
        ),
        [Some(false), Some(true)] => bail!(
            "{} is a picture and {} is not",
            paths[1].display(),
            paths[0].display()
        ),
        _ => videos(arguments, context),
    }
}

/// Whether a file begins as a picture does; `None` where it cannot be read.
fn is_picture(path: &Path) -> Option<bool> {
    if path.as_os_str() == "-" {
        return Some(false);
    }
    let mut start = Vec::new();
    File::open(path)
        .ok()?
        .take(16)
        .read_to_end(&mut start)
        .ok()?;
    Some(file::Format::detect(&start).is_some_and(|format| format != file::Format::Y4m))
}

fn pictures(arguments: &Arguments, context: &Context) -> Result<Compared> {
    ensure!(
        arguments.plot.is_none(),
        "--plot draws measures over time, and pictures have none"
    );
    let [reference, distorted] = [&arguments.reference, &arguments.distorted].map(file::read);
    let (reference, distorted) = (reference?, distorted?);
    let size = [reference.width(), reference.height()];
    let map = read_map(arguments, size)?;
    let measures = picture::measure(&reference, &distorted, map);
    let measures = measures.with_context(|| arguments.names())?;
    let frame = FrameQuality {
        index: 0,
        time_seconds: 0.0,
        luma: measures,
        psnr_differences: None,
    };
    let report = PictureReport::new(&frame, too_small(size));
    let mut page = None;
    if context.report().is_some() {
        let map = picture::similarity_png(&reference, &distorted)?;
        page = Some(page::of_pictures(arguments, &report, &map));
    }
    if let Some(path) = &arguments.csv {
        output::write(path, table::csv(&[frame]).as_bytes())?;
    }
    Ok(Compared {
        page,
        ..Compared::new(Measures::Pictures(report))
    })
}

fn videos(arguments: &Arguments, context: &Context) -> Result<Compared> {
    let reference = ga_video::open(&arguments.reference)?;
    let distorted = ga_video::open(&arguments.distorted)?;
    let size = reference.properties().size;
    let range = f64::from((1u32 << reference.properties().bit_depth) - 1);
    let map = read_map(arguments, size)?;
    let comparison = VideoComparison::new(reference, distorted, map);
    let mut comparison = comparison.with_context(|| arguments.names())?;

    let count = comparison.frame_count();
    let progress = context.progress(count.unwrap_or(0) as u64);
    progress.step("comparing");
    let mut frames = Vec::new();
    let failure: Option<VideoError> = loop {
        match comparison.next() {
            Some(Ok(frame)) => frames.push(frame),
            Some(Err(error)) => break Some(error),
            None => break None,
        }
        // Where no length is stated, the bar is that of the frames so far.
        let done = frames.len();
        progress.at(done as u64, count.unwrap_or(done).max(done) as u64);
    };
    drop(progress);
    let Some(mut report) = VideoReport::new(&frames, range) else {
        return match failure {
            Some(error) => Err(error).with_context(|| arguments.names()),
            None => bail!("{}: the videos have no frames", arguments.names()),
        };
    };
    report.error = failure.as_ref().map(ToString::to_string);
    report.ms_ssim_reason = too_small(size);
    let mut files = Vec::new();
    if let Some(path) = &arguments.csv {
        files.push((path, table::csv(&frames).into_bytes()));
    }
    if let Some(path) = &arguments.plot {
        let svg = plot::svg(&frames, &arguments.distorted);
        let svg = svg.with_context(|| format!("cannot draw {}", path.display()))?;
        files.push((path, svg.into_bytes()));
    }
    let mut page = None;
    if let Some(path) = context.report() {
        let drawn = page::of_videos(arguments, &report, &frames);
        page = Some(drawn.with_context(|| format!("cannot draw {}", path.display()))?);
    }
    output::write_together(files)?;
    let failure = failure.map(|error| {
        let done = frames.len();
        Error::new(error).context(format!("{}: {done} frames are reported", arguments.names()))
    });
    Ok(Compared {
        page,
        failure,
        ..Compared::new(Measures::Videos(report))
    })
}

/// The weights of a picture in grey, as it states them.
fn read_map(arguments: &Arguments, [width, height]: [usize; 2]) -> Result<Option<Weights>> {
    let Some(path) = &arguments.attention else {
        return Ok(None);
    };
    let map: Plane = file::read(path)?.to_grey(Luma::Bt601);
    ensure!(
        [map.width(), map.height()] == [width, height],
        "{} has {} × {} pixels, and {} has {width} × {height}",
        path.display(),
        map.width(),
        map.height(),
        arguments.reference.display()
    );
    let weights = Weights::new(map).with_context(|| path.display().to_string())?;
    Ok(Some(weights))
}

/// Why there is no MS-SSIM.
fn too_small([width, height]: [usize; 2]) -> Option<String> {
    (width.min(height) < MULTISCALE_LEAST_SIDE).then(|| {
        format!(
            "{width} × {height} pixels are too few, five scales need {MULTISCALE_LEAST_SIDE} × \
             {MULTISCALE_LEAST_SIDE}"
        )
    })
}
