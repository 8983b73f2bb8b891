//! `nullcone capture`: the pose of a head, its expression, and the motion of its surface.

mod arguments;
mod report;
mod surface;

pub(crate) use arguments::Arguments;

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context as _, Result, anyhow, ensure};
use ga_runtime::cga3::{Motor, Point};
use ga_vision::capture::table::{PointTable, expressions_csv, matrices_csv, poses_csv};
use ga_vision::capture::{Capture, CaptureError, CapturedFrame, PoseOptions};

use crate::format::Format;
use crate::frame::{Command, Context};
use crate::output;
use report::Report;
use surface::{Motion, Surface};

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let formats = check(arguments, context)?;
        let begin = Instant::now();
        let progress = context.progress(4);
        progress.step("reading");
        let points = ga_files::read(&arguments.points, PointTable::decode)?;
        let named = || arguments.points.display().to_string();
        let reference =
            frame(arguments.reference.as_deref(), "--reference", &points).with_context(named)?;
        let one = frame(arguments.frame.as_deref(), "--frame", &points).with_context(named)?;
        let calibrated = calibrated(arguments, &points).with_context(named)?;

        progress.step("separating pose and expression");
        let rest = at_rest(&points, reference).with_context(named)?;
        let options = PoseOptions {
            threshold: arguments.threshold,
            seed: arguments.seed,
            ..PoseOptions::default()
        };
        let capture = Capture::new(rest, calibrated, options);
        let capture = capture
            .map_err(|error| text(error, &points, reference))
            .with_context(named)?;
        let rows: Vec<_> = points
            .frames
            .iter()
            .map(|frame| &frame.points[..])
            .collect();
        let frames = capture.frames(&rows);
        let frames = frames
            .map_err(|error| text(error, &points, reference))
            .with_context(named)?;

        progress.step("moving the surface");
        let surface = arguments.mesh.as_ref().map(|path| {
            let surface = Surface::new(path, arguments, &points, capture.rest())?;
            let motion = surface.follow(&frames, &points, arguments.tolerance);
            let motion = motion.with_context(named)?;
            Ok::<_, anyhow::Error>((surface, motion))
        });
        let surface = surface.transpose()?;
        let surface = surface.as_ref().map(|(surface, motion)| (surface, motion));
        let files = files(arguments, &formats, &points, &frames, surface, one)?;
        let calibrated = capture.calibrated();
        let mut report = Report::new(arguments, &points, calibrated, reference, &frames, surface);

        progress.step("writing");
        output::write_together(files.iter().map(|(path, contents)| (path, contents)))?;
        drop(progress);
        report.seconds = begin.elapsed().as_secs_f64();
        report.files = files.into_iter().map(|(path, _)| path).collect();
        Ok(report)
    }
}

/// Checks the arguments that need no file, and says of which format each --out is.
fn check(arguments: &Arguments, context: &Context) -> Result<Vec<Format>> {
    for (name, value) in [
        ("--threshold", arguments.threshold.unwrap_or(1.0)),
        ("--fps", arguments.fps),
    ] {
        ensure!(
            value.is_finite() && value > 0.0,
            "{name} {value}: it must be above 0"
        );
    }
    ensure!(
        arguments.tolerance.is_finite() && arguments.tolerance >= 0.0,
        "--tolerance {}: it must not be below 0",
        arguments.tolerance
    );
    let inputs = [&arguments.points].into_iter().chain(&arguments.mesh);
    let mut files = context.files(inputs.chain(&arguments.keys))?;
    let is_asked =
        !arguments.out.is_empty() || arguments.pose.is_some() || arguments.matrix.is_some();
    context.need_result(is_asked, "--out, --pose, --matrix")?;
    let mut formats = Vec::with_capacity(arguments.out.len());
    for path in &arguments.out {
        let known = [Format::Csv, Format::Glb, Format::Obj, Format::Ply];
        let format = files.write("--out", path, &known)?;
        ensure!(
            format == Format::Csv || arguments.mesh.is_some(),
            "--out {}: a surface needs --mesh",
            path.display()
        );
        ensure!(
            matches!(format, Format::Csv | Format::Glb) || arguments.frame.is_some(),
            "--out {}: a surface without animation needs --frame",
            path.display()
        );
        formats.push(format);
    }
    files.write_if_given("--pose", arguments.pose.as_ref(), &[Format::Csv])?;
    files.write_if_given("--matrix", arguments.matrix.as_ref(), &[Format::Csv])?;
    Ok(formats)
}

/// The frame of this name, or the first.
fn frame(name: Option<&str>, option: &str, points: &PointTable) -> Result<usize> {
    let Some(name) = name else {
        return Ok(0);
    };
    let found = points.frames.iter().position(|frame| frame.label == name);
    found.with_context(|| {
        let [first, last] = [points.frames.first(), points.frames.last()]
            .map(|frame| frame.map_or("", |frame| frame.label.as_str()));
        format!("{option} {name}: there is no such frame; they are {first} to {last}")
    })
}

fn calibrated(arguments: &Arguments, points: &PointTable) -> Result<Vec<usize>> {
    let words = arguments.calibrated.iter().map(|word| word.trim());
    let point = |word: &str| {
        points.point(word).with_context(|| {
            let names = match points.names.len() {
                0..=30 => points.names.join(", "),
                count => format!("{} and {} others", points.names[..8].join(", "), count - 8),
            };
            format!("--calibrated {word}: this is not a point; the points are {names}")
        })
    };
    words.map(point).collect()
}

/// The points of the reference frame, which must all be there.
fn at_rest(points: &PointTable, reference: usize) -> Result<Vec<Point<f64>>> {
    let row = points.frames[reference].points.iter().zip(&points.names);
    let place = |(place, name): (&Option<Point<f64>>, &String)| {
        place.with_context(|| {
            let place = points.place(reference);
            format!("{place}: point {name} is missing in the reference frame")
        })
    };
    row.map(place).collect()
}

/// An error with the names of frames and points.
fn text(error: CaptureError, points: &PointTable, reference: usize) -> anyhow::Error {
    let name = |point: &usize| points.names[*point].as_str();
    match error {
        CaptureError::Twice(point) => anyhow!("--calibrated: {} is named twice", name(&point)),
        CaptureError::Rest(error) => match *error {
            CaptureError::TooFew { found, needed } => {
                anyhow!("--calibrated: {needed} points are needed for a pose, not {found}")
            }
            error => anyhow!("{}: {error}", points.place(reference)),
        },
        CaptureError::Frame { frame, problem } => {
            let place = points.place(frame);
            match *problem {
                CaptureError::Missing {
                    seen,
                    needed,
                    missing,
                } => {
                    let missing: Vec<_> = missing.iter().map(name).collect();
                    anyhow!(
                        "{place}: {seen} calibrated points are seen, and {needed} are needed; \
                         missing: {}",
                        missing.join(", ")
                    )
                }
                CaptureError::PoseOfSeen { missing, error } => {
                    let missing: Vec<_> = missing.iter().map(name).collect();
                    anyhow!("{place}: {error}; missing: {}", missing.join(", "))
                }
                problem => anyhow!("{place}: {problem}"),
            }
        }
        error => anyhow!(error),
    }
}

/// The contents of all files.
fn files(
    arguments: &Arguments,
    formats: &[Format],
    points: &PointTable,
    frames: &[CapturedFrame],
    surface: Option<(&Surface, &Motion)>,
    one: usize,
) -> Result<Vec<(PathBuf, Vec<u8>)>> {
    let mut files = Vec::new();
    let poses: Vec<Motor<f64>> = frames.iter().map(CapturedFrame::motor).collect();
    for (path, &format) in arguments.out.iter().zip(formats) {
        match (format, surface) {
            (Format::Glb, Some((surface, motion))) => {
                let times = points.times(arguments.fps);
                let glb = surface.glb(path, arguments, motion, &poses, &times);
                files.push((path.clone(), glb.with_context(|| cannot(path))?));
            }
            (Format::Obj | Format::Ply, Some((surface, motion))) => {
                let place = (path.as_path(), format);
                let found = surface.frame_files(place, arguments, motion, one, poses[one]);
                files.extend(found.with_context(|| cannot(path))?);
            }
            _ => files.push((path.clone(), expressions_csv(points, frames).into_bytes())),
        }
    }
    if let Some(path) = &arguments.pose {
        files.push((path.clone(), poses_csv(points, frames).into_bytes()));
    }
    if let Some(path) = &arguments.matrix {
        files.push((path.clone(), matrices_csv(points, frames).into_bytes()));
    }
    Ok(files)
}

fn cannot(path: &Path) -> String {
    format!("cannot make {}", path.display())
}
