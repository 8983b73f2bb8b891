//! `nullcone capture`: the pose of a head, its expression, and the motion of its surface.

mod arguments;
mod report;
mod warnings;

pub(crate) use arguments::Arguments;

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context as _, Error, Result, anyhow, bail, ensure};
use ga_mesh::format::{Options, relocated};
use ga_mesh::gltf;
use ga_runtime::cga3::{Motor, Point};
use ga_vision::capture::summary::{ExpressionSummary, PoseSummary};
use ga_vision::capture::table::{
    Key, PointTable, PointTableError, Zeros, decode_keys, expressions_csv, matrices_csv, poses_csv,
};
use ga_vision::capture::{
    Capture, CaptureError, CapturedFrame, FrameOutcome, HeadMotion, HeadSurface, KeyFit,
    PoseOptions,
};

use crate::format::Format;
use crate::frame::{Command, Context, Warning, keep_for_failure};
use crate::mesh_file;
use report::Report;

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let formats = self.check(context)?;
        let begin = Instant::now();
        let progress = context.progress(4);
        progress.step("reading");
        let zeros = match self.keep_zeros {
            true => Zeros::Kept,
            false => Zeros::Lost,
        };
        let points = ga_files::read(&self.points, |bytes| PointTable::decode(bytes, zeros))?;
        let mut warnings = warnings::of_table(&points, &self.points);
        keep_for_failure(&warnings);
        let named = || self.points.display().to_string();
        let of_option = |option| move |error: PointTableError| anyhow!("{option} {error}");
        let frame = |name: &Option<String>, option| match name {
            Some(name) => points.frame(name).map_err(of_option(option)),
            None => Ok(0),
        };
        let reference = frame(&self.reference, "--reference").with_context(named)?;
        let shown = frame(&self.frame, "--frame").with_context(named)?;
        let words = self.calibrated.iter().map(|word| points.point(word.trim()));
        let calibrated: Result<Vec<_>, _> = words.collect();
        let calibrated = calibrated.map_err(of_option("--calibrated"));
        let calibrated = calibrated.with_context(named)?;

        progress.step("separating pose and expression");
        let rest = points.rest(reference).map_err(|error| match error {
            PointTableError::MissingAtRest {
                at_origin: true, ..
            } => {
                anyhow!("{error} (--keep-zeros keeps it, --reference takes another frame)")
            }
            error => error.into(),
        });
        let rest = rest.with_context(named)?;
        let options = PoseOptions {
            threshold: self.threshold,
            seed: self.seed,
            ..PoseOptions::default()
        };
        let rows = points.frames.iter().map(|frame| &frame.points[..]);
        let rows: Vec<_> = rows.collect();
        let found = Capture::new(rest, calibrated, options)
            .and_then(|capture| Ok((capture.frames(&rows)?, capture)));
        let found = found.map_err(|error| described(&error, &points, reference));
        let (frames, capture) = found.with_context(named)?;
        let is_solved = |(_, frame): &(usize, &FrameOutcome)| frame.is_ok();
        let mut solved = frames.iter().enumerate().filter(is_solved);
        if frames.len() > 1 && solved.all(|(frame, _)| frame == reference) {
            // At rest the points agree with themselves, which says nothing of the others.
            let others = frames.iter().enumerate();
            let mut others =
                others.filter_map(|(frame, found)| Some((frame, found.as_ref().err()?)));
            if let Some((frame, problem)) = others.next() {
                let (place, reason) = (points.place(frame), points.reason(problem));
                let error = anyhow!("no frame but the reference has a pose; {place}: {reason}");
                return Err(error).with_context(named);
            }
        }
        warnings.extend(warnings::of_frames(&points, &frames, &self.points));

        progress.step("moving the surface");
        let mut surface = None;
        if let Some(path) = &self.mesh {
            let head = self.surface(path, &points, capture.rest(), &mut warnings)?;
            let motion = head.follow(&frames, &points, self.tolerance);
            let motion = motion.with_context(named)?;
            warnings.extend(warnings::of_motion(&points, &frames, &motion, &self.points));
            surface = Some((head, motion));
        }
        let files = self.files(&formats, &points, &frames, surface.as_ref(), shown)?;

        progress.step("writing");
        context.outputs().write_all(&files)?;
        drop(progress);
        let calibrated = capture.calibrated();
        let names = calibrated.iter().map(|&point| points.names[point].clone());
        Ok(Report {
            warnings,
            files: files.into_iter().map(|(path, _)| path).collect(),
            frames: frames.len(),
            frames_without_pose: frames.iter().filter(|frame| frame.is_err()).count(),
            points: points.names.len(),
            calibrated: names.collect(),
            reference_frame: points.frames[reference].label.clone(),
            expression: ExpressionSummary::new(&points, &frames),
            poses: PoseSummary::of_frames(&points, calibrated, &frames),
            surface: surface.map(|(head, motion)| head.summary(&motion)),
            seconds: begin.elapsed().as_secs_f64(),
        })
    }
}

/// An error with the names of frames and points, and the option that is to blame.
fn described(error: &CaptureError, points: &PointTable, reference: usize) -> Error {
    let text = points.describe(error, reference);
    let is_of_option = match error {
        CaptureError::Twice(_) => true,
        CaptureError::Rest(error) => matches!(**error, CaptureError::TooFew { .. }),
        _ => false,
    };
    match is_of_option {
        true => anyhow!("--calibrated: {text}"),
        false => anyhow!(text),
    }
}

/// Whether a surface can move in a format.
fn animates(format: Format) -> bool {
    matches!(format, Format::Mesh(format) if format.keeps_animations())
}

impl Arguments {
    /// Checks the arguments that need no file, and says of which format each --out is.
    fn check(&self, context: &Context) -> Result<Vec<Format>> {
        for (name, value) in [
            ("--threshold", self.threshold.unwrap_or(1.0)),
            ("--fps", self.fps),
        ] {
            ensure!(
                value.is_finite() && value > 0.0,
                "{name} {value}: it must be above 0"
            );
        }
        ensure!(
            self.tolerance.is_finite() && self.tolerance >= 0.0,
            "--tolerance {}: it must not be below 0",
            self.tolerance
        );
        let inputs = [&self.points].into_iter().chain(&self.mesh);
        let mut files = context.files(inputs.chain(&self.keys))?;
        let is_asked = !self.out.is_empty() || self.pose.is_some() || self.matrix.is_some();
        context.need_result(is_asked, "--out, --pose, --matrix")?;
        let mut formats = Vec::with_capacity(self.out.len());
        for path in &self.out {
            let known = [vec![Format::Csv], mesh_file::formats(|_| true)].concat();
            let format = files.write("--out", path, &known)?;
            ensure!(
                format == Format::Csv || self.mesh.is_some(),
                "--out {}: a surface needs --mesh",
                path.display()
            );
            ensure!(
                format == Format::Csv || animates(format) || self.frame.is_some(),
                "--out {}: a surface without animation needs --frame",
                path.display()
            );
            formats.push(format);
        }
        files.write_if_given("--pose", self.pose.as_ref(), &[Format::Csv])?;
        files.write_if_given("--matrix", self.matrix.as_ref(), &[Format::Csv])?;
        Ok(formats)
    }

    /// The surface of a mesh, with its keys and its area.
    fn surface(
        &self,
        path: &Path,
        points: &PointTable,
        rest: &[Point<f64>],
        warnings: &mut Vec<Warning>,
    ) -> Result<HeadSurface> {
        let (mesh, missing) = mesh_file::read(path)?;
        warnings.extend(missing);
        let (keys, fit) = match &self.keys {
            Some(path) => {
                let keys = ga_files::read(path, |bytes| decode_keys(bytes, points, &mesh))?;
                let fit = KeyFit::new(&keys, rest, self.fit_scale)
                    .with_context(|| format!("{} does not place the points", path.display()))?;
                (keys, fit)
            }
            None => {
                let keys = (0..).zip(rest);
                let keys = keys.map(|(point, &place)| Key { point, place });
                (keys.collect(), KeyFit::default())
            }
        };
        let named = || path.display().to_string();
        let mut head = HeadSurface::new(mesh, keys, fit, points).with_context(named)?;
        if let Some(area) = &self.area {
            let found = head.with_area(area.clone(), points);
            head = found.with_context(|| format!("{}: --area {area}", path.display()))?;
        }
        Ok(head.keeping_centre(self.keep_centre))
    }

    /// The contents of all files.
    fn files(
        &self,
        formats: &[Format],
        points: &PointTable,
        frames: &[FrameOutcome],
        surface: Option<&(HeadSurface, HeadMotion)>,
        shown: usize,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>> {
        let mut files = Vec::new();
        let pose = |frame: &FrameOutcome| frame.as_ref().ok().map(CapturedFrame::motor);
        let poses: Vec<Option<Motor<f64>>> = frames.iter().map(pose).collect();
        let poses = Some(poses).filter(|_| !self.still);
        for (path, &format) in self.out.iter().zip(formats) {
            let cannot = || format!("cannot make {}", path.display());
            match (format, surface, &self.mesh) {
                (format, Some((head, motion)), Some(from)) if animates(format) => {
                    let times = points.times(self.fps);
                    let moving = || -> Result<_> {
                        let rest = relocated(&head.mesh_at_rest()?, from, path)?;
                        let document = head.document(&rest, motion, poses.as_deref(), &times)?;
                        Ok(gltf::path_files(path, &document)?)
                    };
                    let named = moving().with_context(cannot)?.into_iter();
                    files.extend(named.map(|(name, bytes)| (path.with_file_name(name), bytes)));
                }
                (Format::Mesh(_), Some((head, motion)), Some(from)) => {
                    let pose = poses.as_ref().and_then(|poses| poses[shown]);
                    let in_frame = || -> Result<_> {
                        if let Err(problem) = &frames[shown] {
                            let (place, reason) = (points.place(shown), points.reason(problem));
                            bail!("{place}: {reason}");
                        }
                        let mesh = head.mesh_in_frame(motion, shown, pose)?;
                        let mesh = relocated(&mesh, from, path)?;
                        mesh_file::files(path, format, &mesh, &Options::default())
                    };
                    files.extend(in_frame().with_context(cannot)?);
                }
                _ => files.push((path.clone(), expressions_csv(points, frames).into_bytes())),
            }
        }
        let tables = [
            (&self.pose, poses_csv as fn(&_, &_) -> _),
            (&self.matrix, matrices_csv),
        ];
        for (path, table) in tables {
            let contents = |path: &PathBuf| (path.clone(), table(points, frames).into_bytes());
            files.extend(path.as_ref().map(contents));
        }
        Ok(files)
    }
}
