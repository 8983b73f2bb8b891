//! `nullcone capture`: the pose of a head, its expression, and the motion of its surface.

mod keys;
mod points;
mod report;
mod surface;
mod tables;

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Instant;

use anyhow::{Context, Result, anyhow, ensure};
use ga_runtime::cga3::{Motor, Point};
use ga_vision::capture::{
    Capture, CaptureError, CapturedFrame, FrameError, PoseError, PoseOptions,
};

use crate::files::Files;
use crate::format::Format;
use crate::output;
use crate::progress::Progress;
use points::Points;
use report::Report;
use surface::{Motion, Surface};

/// Separate captured points of a face into the pose of the head and its expression.
///
/// POINTS.csv has a row for each frame and three columns for each point, in metres. The first line
/// names them NAME_x, NAME_y, NAME_z; columns `frame` and `time_seconds` may come first. A point
/// that was not seen has empty fields. Without a line of names, points are 0, 1, 2 and so on.
///
/// Calibrated points are four or more that no expression moves, such as temples, forehead and the
/// bridge of the nose. They need not be in all frames, but four must be, and not on one line; four
/// in a plane are enough. The pose of a frame is the motion of the head since the reference frame,
/// and the expression of a point is its displacement beyond that, in the coordinates of the
/// reference frame.
///
/// With --mesh, a surface follows the points: seen from its centre of gravity, the displacements
/// of the keys are interpolated on the sphere by a smooth spline, exactly at the keys. KEYS.csv
/// says where points are on the mesh, with the columns `point,vertex` (from 0) or `point,x,y,z`;
/// without it, all points of the reference frame are in the coordinates of the mesh.
///
/// The ending of --out decides what is written, and --out may be given several times: .csv the
/// expression of each point in each frame, .glb the surface with morph targets whose weights are
/// animated together with the pose of the head, .obj or .ply the surface in one --frame.
///
/// For instance
///
///   nullcone capture points.csv --calibrated brow,nose,left,right --out expression.csv \
///     --mesh face.obj --keys keys.csv --out face.glb --json
///
/// prints {"frames": …, "points": …, "calibrated": […], "reference_frame": …,
/// "expression": {"rms_metres": …, "max_metres": …, "max_point": …, "max_frame": …,
/// "points": [{"name": …, "frames_seen": …, "rms_metres": …, "max_metres": …}, …]},
/// "poses": [{"frame": …, "translation_metres": […], "rotation_quaternion": [x, y, z, w],
/// "rotation_axis": […], "rotation_degrees": …, "rms_metres": …, "inliers": …, "outliers": […],
/// "missing": […]}, …], "surface": {"vertices": …, "keys": …, "keys_filled": …,
/// "key_fit_rms_metres": …, "sphere_centre_metres": […], "folded_triangles": …,
/// "morph_targets": …, "morph_error_max_metres": …, "metres_per_mesh_unit": …,
/// "area": {"vertices": …, "centre_metres": […], "centre_kept": …,
/// "centre_displacement_metres": [[…], …]}}, "seconds": …}. Places on the surface are in the
/// coordinates of the mesh, scaled to metres.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
#[command(group(clap::ArgGroup::new("results").required(true).multiple(true)))]
pub(crate) struct Arguments {
    /// The points in each frame.
    #[arg(value_name = "POINTS.csv")]
    points: PathBuf,
    /// The calibrated points, by name or by number from 0.
    #[arg(long, value_name = "POINT,…", value_delimiter = ',', required = true)]
    calibrated: Vec<String>,
    /// The frame in which the head is at rest, by its name in the column `frame` or else by the
    /// number of its row from 0 [default: the first].
    #[arg(long, value_name = "FRAME")]
    reference: Option<String>,
    /// Leave out calibrated points that are farther than this from where the pose takes them, in
    /// metres; by default all count.
    #[arg(long, value_name = "METRES", allow_negative_numbers = true)]
    threshold: Option<f64>,
    /// The seed of the random samples that find such points.
    #[arg(long, value_name = "N", default_value_t = PoseOptions::default().seed)]
    seed: u64,
    /// The surface that follows the points: .obj, .ply, .glb or .gltf.
    #[arg(long, value_name = "MESH")]
    mesh: Option<PathBuf>,
    /// Where points are on the mesh. Others do not move it.
    #[arg(long, value_name = "KEYS.csv", requires = "mesh")]
    keys: Option<PathBuf>,
    /// Let the mesh have another size or unit than the head. Without this, its unit is the metre.
    #[arg(long, requires = "keys")]
    fit_scale: bool,
    /// Move only what is within a radius of a key along the surface, in the unit of the mesh. The
    /// motion falls smoothly to zero at the edge.
    #[arg(long, value_name = "KEY:RADIUS", requires = "mesh")]
    area: Option<Area>,
    /// Keep the centre of gravity of the area, or of the whole surface, where it is at rest.
    #[arg(long, requires = "mesh")]
    keep_centre: bool,
    /// Leave out the pose of the head, and write the surface in the coordinates of the mesh.
    #[arg(long, requires = "mesh")]
    still: bool,
    /// How far a key may be from where morph targets take it, in metres.
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 1e-6,
        allow_negative_numbers = true
    )]
    tolerance: f64,
    /// Frames in a second, where the table has no times.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 30.0,
        allow_negative_numbers = true
    )]
    fps: f64,
    /// The frame of a surface without animation.
    #[arg(long, value_name = "FRAME", requires = "mesh")]
    frame: Option<String>,
    /// What to write: .csv, .glb, .obj or .ply. May be given several times.
    #[arg(long, value_name = "FILE", group = "results")]
    out: Vec<PathBuf>,
    /// Write the pose of each frame as CSV.
    #[arg(long, value_name = "FILE.csv", group = "results")]
    pose: Option<PathBuf>,
    /// Write the capture matrix of each frame as CSV: the homogeneous coordinates of the points
    /// with the pose taken out.
    #[arg(long, value_name = "FILE.csv", group = "results")]
    matrix: Option<PathBuf>,
    /// Print one JSON object instead of lines.
    #[arg(long, group = "results")]
    json: bool,
}

/// What is within a radius of a key.
#[derive(Clone, Debug, PartialEq)]
struct Area {
    key: String,
    radius: f64,
}

impl FromStr for Area {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.rsplit_once(':');
        let radius = |word: &str| {
            word.parse()
                .ok()
                .filter(|r: &f64| r.is_finite() && *r > 0.0)
        };
        match parts.map(|(key, word)| (key, radius(word))) {
            Some((key, Some(radius))) if !key.is_empty() => Ok(Self {
                key: key.to_owned(),
                radius,
            }),
            _ => Err("expected a key and a positive radius, such as chin:0.04".to_owned()),
        }
    }
}

pub(crate) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let formats = check(arguments)?;
    let begin = Instant::now();
    let progress = Progress::new(4, quiet);
    progress.step("reading");
    let points = ga_files::read(&arguments.points, Points::parse)?;
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
        let surface = Surface::new(path, arguments, &points, capture.rest(), quiet)?;
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
    if arguments.json {
        return output::print_json(&report);
    }
    if !quiet {
        let written = files
            .iter()
            .map(|(path, _)| format!("wrote {}\n", path.display()));
        output::print(&(report.lines() + &written.collect::<String>()))?;
    }
    Ok(())
}

/// Checks the arguments that need no file, and says of which format each --out is.
fn check(arguments: &Arguments) -> Result<Vec<Format>> {
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
    let mut files = Files::reading(inputs.chain(&arguments.keys));
    files = files.printing("--json", arguments.json);
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
fn frame(name: Option<&str>, option: &str, points: &Points) -> Result<usize> {
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

fn calibrated(arguments: &Arguments, points: &Points) -> Result<Vec<usize>> {
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
fn at_rest(points: &Points, reference: usize) -> Result<Vec<Point<f64>>> {
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
fn text(error: CaptureError, points: &Points, reference: usize) -> anyhow::Error {
    let name = |point: &usize| points.names[*point].as_str();
    match error {
        CaptureError::Twice(point) => anyhow!("--calibrated: {} is named twice", name(&point)),
        CaptureError::Rest(PoseError::TooFew { found, needed }) => {
            anyhow!("--calibrated: {needed} points are needed for a pose, not {found}")
        }
        CaptureError::Rest(error) => anyhow!("{}: {error}", points.place(reference)),
        CaptureError::Frame { frame, problem } => {
            let place = points.place(frame);
            match problem {
                FrameError::Missing {
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
                FrameError::PoseOfSeen { missing, error } => {
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
    points: &Points,
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
            _ => files.push((path.clone(), tables::expressions(points, frames)?)),
        }
    }
    if let Some(path) = &arguments.pose {
        files.push((path.clone(), tables::poses(points, frames)?));
    }
    if let Some(path) = &arguments.matrix {
        files.push((path.clone(), tables::matrices(points, frames)?));
    }
    Ok(files)
}

fn cannot(path: &Path) -> String {
    format!("cannot make {}", path.display())
}
