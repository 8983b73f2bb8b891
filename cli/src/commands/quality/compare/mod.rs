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

use anyhow::{Context, Result, bail, ensure};
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::quality::{MULTISCALE_LEAST_SIDE, Weights};
use ga_video::VideoError;
use ga_video::quality::{FrameQuality, VideoComparison};

use crate::files::Files;
use crate::format::Format;
use crate::frame::Progress;
use crate::output;
use report::{PictureReport, VideoReport};

/// Files that are written together, each with its place.
type Written<'a> = Vec<(&'a Path, Vec<u8>)>;

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let paths = [&arguments.reference, &arguments.distorted];
    ensure!(
        !paths.iter().all(|path| path.as_os_str() == "-"),
        "standard input can be one of the two videos only"
    );
    let inputs = paths.into_iter().chain(&arguments.attention);
    let mut files = Files::reading(inputs).printing("--json", arguments.json);
    files.write_if_given("--csv", arguments.csv.as_ref(), &[Format::Csv])?;
    files.write_if_given("--plot", arguments.plot.as_ref(), &[Format::Svg])?;
    files.write_if_given("--report", arguments.report.as_ref(), &[Format::Html])?;
    match paths.map(|path| is_picture(path)) {
        // What is missing beside a picture is a picture: its reader says what is wrong.
        [Some(true), Some(true) | None] | [None, Some(true)] => pictures(arguments, quiet),
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
        _ => videos(arguments, quiet),
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

fn pictures(arguments: &Arguments, quiet: bool) -> Result<()> {
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
    let report = PictureReport::new(&frame);
    let reason = too_small(size);
    let mut files = Written::new();
    if let Some(path) = &arguments.csv {
        files.push((path, table::csv(&[frame])?));
    }
    if let Some(path) = &arguments.report {
        let map = picture::similarity_png(&reference, &distorted)?;
        let page = page::of_pictures(arguments, &report, reason.as_deref(), &map);
        files.push((path, page.into_bytes()));
    }
    output::write_together(files)?;
    if arguments.json {
        if !quiet && let Some(reason) = reason {
            eprintln!("warning: ms_ssim is null: {reason}");
        }
        output::print_json(&report)
    } else if quiet {
        Ok(())
    } else {
        output::print(&report.lines(reason.as_deref()))
    }
}

fn videos(arguments: &Arguments, quiet: bool) -> Result<()> {
    let reference = ga_video::open(&arguments.reference)?;
    let distorted = ga_video::open(&arguments.distorted)?;
    let size = reference.properties().size;
    let range = f64::from((1u32 << reference.properties().bit_depth) - 1);
    let map = read_map(arguments, size)?;
    let comparison = VideoComparison::new(reference, distorted, map);
    let mut comparison = comparison.with_context(|| arguments.names())?;

    let count = comparison.frame_count();
    let progress = Progress::new(count.unwrap_or(0) as u64, quiet);
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
    output::write_together(video_files(arguments, &report, &frames)?)?;
    if arguments.json {
        output::print_json(&report)?;
    } else if !quiet {
        output::print(&report.lines())?;
    }
    match failure {
        Some(error) => {
            let done = frames.len();
            Err(error).with_context(|| format!("{}: {done} frames are reported", arguments.names()))
        }
        None => Ok(()),
    }
}

fn video_files<'a>(
    arguments: &'a Arguments,
    report: &VideoReport,
    frames: &[FrameQuality],
) -> Result<Written<'a>> {
    let mut files = Written::new();
    if let Some(path) = &arguments.csv {
        files.push((path, table::csv(frames)?));
    }
    if let Some(path) = &arguments.plot {
        let svg = plot::svg(frames, &arguments.distorted);
        let svg = svg.with_context(|| format!("cannot draw {}", path.display()))?;
        files.push((path, svg.into_bytes()));
    }
    if let Some(path) = &arguments.report {
        let page = page::of_videos(arguments, report, frames);
        let page = page.with_context(|| format!("cannot draw {}", path.display()))?;
        files.push((path, page.into_bytes()));
    }
    Ok(files)
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
