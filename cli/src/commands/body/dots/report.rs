//! What is printed.

use std::path::PathBuf;

use ga_body::BodyError;
use ga_body::agreement::OUTLIER;
use ga_body::format::JointViews;
use serde::Serialize;

use super::arguments::Arguments;
use super::films::Films;
use super::found::Found;
use crate::counted::counted;
use crate::format::Format;
use crate::frame::{self, Verdict, Warning};
use crate::shell::quoted;

#[derive(Serialize)]
pub(crate) struct Report {
    out: String,
    seed: u64,
    frames: usize,
    frames_per_second: Option<f64>,
    frames_without_joints: usize,
    joints: Vec<String>,
    joints_left_out: usize,
    frames_with_joints_left_out: usize,
    reprojection_rms_px: Option<f64>,
    milliseconds_per_frame: f64,
    views: Vec<View>,
    per_frame: Vec<Frame>,
    #[serde(skip)]
    verdict: Verdict,
    #[serde(skip)]
    warnings: Vec<Warning>,
    #[serde(skip)]
    next: Option<String>,
}

/// What was found in a view.
#[derive(Serialize)]
struct View {
    name: String,
    film: String,
    dots: usize,
    dots_recognised: usize,
    reprojection_rms_px: Option<f64>,
}

/// What was found in a frame.
#[derive(Serialize)]
struct Frame {
    dots: Vec<usize>,
    dots_recognised: Vec<usize>,
    reprojection_rms_px: Option<f64>,
    joints_left_out: Vec<String>,
}

impl Report {
    pub(super) fn new(
        arguments: &Arguments,
        films: &Films,
        joints: &JointViews,
        found: &[Found],
        seconds: f64,
    ) -> Self {
        let fits = || found.iter().filter_map(|frame| frame.fit.as_ref().ok());
        let of_view = |view: usize| fits().flat_map(move |fit| &fit.residuals_px[view]);
        let views = films.all.iter().enumerate();
        let views = views.map(|(view, film)| View {
            name: film.name.clone(),
            film: film.path.display().to_string(),
            dots: found.iter().map(|frame| frame.dots[view]).sum(),
            dots_recognised: of_view(view).count(),
            reprojection_rms_px: rms(of_view(view)),
        });
        let views: Vec<View> = views.collect();
        let names = joints.joints();
        let per_frame = found.iter().map(|frame| Frame::new(frame, names));
        let per_frame: Vec<Frame> = per_frame.collect();
        let without = found.iter().filter(|frame| frame.fit.is_err()).count();
        let left_out = || fits().map(|fit| fit.left_out().count());
        let mut warnings = not_recognised(found, &joints.view_names());
        warnings.extend(far(found));
        warnings.extend(unseen(&views));
        warnings.extend(films.ended.clone());
        warnings.extend(films.other_rates());
        Self {
            out: arguments.out.display().to_string(),
            seed: arguments.character.seed(),
            frames: found.len(),
            frames_per_second: joints.frames_per_second(),
            frames_without_joints: without,
            joints: names.to_vec(),
            joints_left_out: left_out().sum(),
            frames_with_joints_left_out: left_out().filter(|count| *count > 0).count(),
            reprojection_rms_px: rms(fits().flat_map(|fit| fit.residuals_px.iter().flatten())),
            milliseconds_per_frame: 1e3 * seconds / found.len().max(1) as f64,
            views,
            per_frame,
            verdict: match 2 * without > found.len() {
                true => Verdict::Failed,
                false => Verdict::of(&warnings),
            },
            warnings,
            next: next(arguments),
        }
    }
}

impl Frame {
    fn new(found: &Found, names: &[String]) -> Self {
        let views = found.dots.len();
        let (recognised, rms, left_out) = match &found.fit {
            Ok(fit) => (
                fit.residuals_px.iter().map(Vec::len).collect(),
                rms(fit.residuals_px.iter().flatten()),
                fit.left_out().map(|joint| names[joint].clone()).collect(),
            ),
            Err(_) => (vec![0; views], None, names.to_vec()),
        };
        Self {
            dots: found.dots.clone(),
            dots_recognised: recognised,
            reprojection_rms_px: rms,
            joints_left_out: left_out,
        }
    }
}

/// The root mean square; `None` of nothing.
fn rms<'a>(values: impl Iterator<Item = &'a f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0), |(sum, count), x| (sum + x * x, count + 1));
    (count > 0).then(|| (sum / f64::from(count)).sqrt())
}

/// Why the body is not recognised, with views by their names.
pub(super) fn reason<N: AsRef<str>>(error: &BodyError, views: &[N]) -> String {
    match error {
        BodyError::NoDots { view } => format!("the view {} shows no dots", views[*view].as_ref()),
        error => error.to_string(),
    }
}

/// Frames without a body, of those that follow one another in one warning.
fn not_recognised(found: &[Found], views: &[&str]) -> Vec<Warning> {
    let mut warnings: Vec<Warning> = Vec::new();
    let mut first = 0;
    for run in found.chunk_by(|a, b| a.fit.is_err() == b.fit.is_err()) {
        let last = first + run.len() - 1;
        if let Err(error) = &run[0].fit {
            let reason = reason(error, views);
            let message = match run.len() {
                1 => format!("the body is not recognised in frame {first}: {reason}"),
                _ => format!(
                    "the body is not recognised in the frames {first} to {last}: in the first of \
                     them, {reason}"
                ),
            };
            warnings.push(Warning {
                frame: Some(first),
                count: Some(run.len()),
                ..Warning::new("not_recognised", message)
            });
        }
        first = last + 1;
    }
    warnings
}

/// Frames whose dots are far from the body.
fn far(found: &[Found]) -> Option<Warning> {
    let frames = found.iter().enumerate();
    let far = frames.filter_map(|(frame, found)| {
        let deviations = found.fit.as_ref().ok()?.deviations?;
        (deviations > OUTLIER).then_some((frame, deviations))
    });
    let far: Vec<(usize, f64)> = far.collect();
    let worst = far.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let message = format!(
        "in {} frames the dots are far from the body, most in frame {}: {:.1} standard deviations \
         as the root mean square",
        far.len(),
        worst.0,
        worst.1
    );
    Some(Warning {
        frame: Some(worst.0),
        count: Some(far.len()),
        ..Warning::new("large_error", message)
    })
}

/// Views in which far fewer of the dots are recognised than in others.
fn unseen(views: &[View]) -> Vec<Warning> {
    /// A part of the best view's.
    const FEW: f64 = 0.5;
    let share = |view: &View| view.dots_recognised as f64 / view.dots.max(1) as f64;
    let Some(best) = views.iter().max_by(|a, b| share(a).total_cmp(&share(b))) else {
        return Vec::new();
    };
    let few = views.iter().filter(|view| share(view) < FEW * share(best));
    let warnings = few.map(|view| {
        let message = format!(
            "in the view {} {:.0} % of the dots are recognised, and in the view {} {:.0} %: does \
             its camera stand elsewhere, or is it out of step?",
            view.name,
            100.0 * share(view),
            best.name,
            100.0 * share(best)
        );
        Warning {
            view: Some(view.name.clone()),
            ..Warning::new("bad_view", message)
        }
    });
    warnings.collect()
}

/// The command that makes a character of the joints.
fn next(arguments: &Arguments) -> Option<String> {
    let path = |path: &PathBuf| quoted(path);
    let films = arguments.films.iter().map(path).collect::<Vec<_>>();
    let cameras = arguments.cameras.path().map(path)?;
    let option = match arguments.cameras.has_world() {
        true => "--views",
        false => "--rig",
    };
    Format::Json.fits(&arguments.out).then(|| {
        format!(
            "nullcone people {} --joints {} {option} {cameras} --out person",
            films.join(" "),
            quoted(&arguments.out)
        )
    })
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(self.verdict)
    }

    fn next(&self) -> Option<String> {
        self.next.clone()
    }

    fn text(&self) -> String {
        let pixels = |rms: Option<f64>| match rms {
            Some(rms) => format!("{rms:.2} px RMS"),
            None => "nothing".to_owned(),
        };
        let mut lines = vec![
            format!("the result is {}", self.verdict.with_files().word()),
            format!(
                "{}: {} of {} in {}",
                self.out,
                counted(self.frames, "frame"),
                counted(self.joints.len(), "joint"),
                counted(self.views.len(), "view")
            ),
            format!("reprojection   {}", pixels(self.reprojection_rms_px)),
        ];
        lines.extend(self.views.iter().map(|view| {
            format!(
                "  {:12} {}; {} of {} recognised",
                view.name,
                pixels(view.reprojection_rms_px),
                view.dots_recognised,
                counted(view.dots, "dot")
            )
        }));
        if self.joints_left_out > 0 {
            lines.push(format!(
                "left out       {} in {}",
                counted(self.joints_left_out, "joint"),
                counted(self.frames_with_joints_left_out, "frame")
            ));
        }
        if self.frames_without_joints > 0 {
            let frames = counted(self.frames_without_joints, "frame");
            lines.push(format!("not recognised {frames}"));
        }
        let time = self.milliseconds_per_frame;
        lines.push(format!("time           {time:.1} ms a frame"));
        lines.join("\n") + "\n"
    }
}
