//! What is printed.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use ga_body::FittedPose;
use ga_body::agreement::{Agreement, OUTLIER};
use ga_body::format::JointViews;
use serde::Serialize;

use super::Arguments;
use super::matched::Matched;
use crate::format::Format;
use crate::frame::{self, Verdict, Warning};
use crate::shell::quoted;

#[derive(Serialize)]
pub(crate) struct Report {
    character: String,
    out: String,
    views: usize,
    frames: usize,
    frames_per_second: f64,
    joints: Vec<String>,
    joints_without_counterpart: Vec<String>,
    reprojection_rms_px: f64,
    reprojection_max_px: f64,
    joints_unseen: usize,
    frames_with_unseen_joints: usize,
    milliseconds_per_frame: f64,
    /// By the name of the joint at which a bone ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    length_factors: Option<BTreeMap<String, f64>>,
    per_view: Vec<ViewReport>,
    per_frame: Vec<FrameReport>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

#[derive(Serialize)]
struct ViewReport {
    name: String,
    joints_seen: usize,
    reprojection_rms_px: f64,
}

#[derive(Serialize)]
struct FrameReport {
    reprojection_rms_px: f64,
    joints_unseen: Vec<String>,
}

/// What remains between pixels and projections.
#[derive(Default)]
struct Residuals {
    squares: f64,
    max: f64,
    count: usize,
}

impl Residuals {
    fn of<'a>(residuals: impl Iterator<Item = &'a f64>) -> Self {
        residuals.fold(Self::default(), |found, residual| Self {
            squares: found.squares + residual * residual,
            max: found.max.max(*residual),
            count: found.count + 1,
        })
    }

    fn root_mean_square(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }
}

impl Report {
    pub(super) fn new(
        arguments: &Arguments,
        joints: &JointViews,
        matched: &Matched,
        fitted: &[FittedPose],
        [frames_per_second, seconds]: [f64; 2],
    ) -> Self {
        let points = matched.model.points();
        let per_frame = fitted.iter().map(|fit| FrameReport {
            reprojection_rms_px: fit.root_mean_square_px,
            joints_unseen: fit
                .unseen
                .iter()
                .map(|&point| points[point].name.clone())
                .collect(),
        });
        let per_frame: Vec<FrameReport> = per_frame.collect();
        let per_view = joints.views().iter().enumerate().map(|(view, joints)| {
            let of_view = fitted.iter().flat_map(|fit| fit.residuals_px[view].iter());
            let residuals = Residuals::of(of_view.flatten());
            ViewReport {
                name: joints.name.clone(),
                joints_seen: residuals.count,
                reprojection_rms_px: residuals.root_mean_square(),
            }
        });
        let all = fitted.iter().flat_map(|fit| fit.residuals_px.iter());
        let residuals = Residuals::of(all.flatten().flatten());
        let unseen = per_frame.iter().map(|frame| frame.joints_unseen.len());
        Self {
            character: arguments.character.display().to_string(),
            out: arguments.out.display().to_string(),
            views: joints.views().len(),
            frames: fitted.len(),
            frames_per_second,
            joints: points.iter().map(|point| point.name.clone()).collect(),
            joints_without_counterpart: matched.without_counterpart.clone(),
            reprojection_rms_px: residuals.root_mean_square(),
            reprojection_max_px: residuals.max,
            joints_unseen: unseen.clone().sum(),
            frames_with_unseen_joints: unseen.filter(|count| *count > 0).count(),
            milliseconds_per_frame: 1e3 * seconds / fitted.len().max(1) as f64,
            length_factors: matched.length_factors.clone(),
            per_view: per_view.collect(),
            per_frame,
            warnings: Vec::new(),
        }
    }

    /// With the views and the frames whose pixels are farther from their projections than the
    /// deviations of the pixels explain.
    pub(super) fn with_warnings(mut self, agreement: &Agreement) -> Self {
        let large = |value: &Option<f64>| value.filter(|value| *value > OUTLIER);
        let message = |what: &str, value: f64| {
            let deviations = "standard deviations from its pixels, as the root mean square";
            Warning::new("large_error", format!("{what} is {value:.1} {deviations}"))
        };
        for (view, value) in self.per_view.iter().zip(&agreement.of_views) {
            if let Some(value) = large(value) {
                self.warnings.push(Warning {
                    view: Some(view.name.clone()),
                    ..message(&format!("the view {}", view.name), value)
                });
            }
        }
        for (frame, value) in agreement.of_frames.iter().enumerate() {
            if let Some(value) = large(value) {
                self.warnings.push(Warning {
                    frame: Some(frame),
                    ..message(&format!("frame {frame}"), value)
                });
            }
        }
        self
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(match self.warnings.is_empty() {
            true => Verdict::Good,
            false => Verdict::Doubtful,
        })
    }

    fn next(&self) -> Option<String> {
        let is_file = Format::Glb.fits(Path::new(&self.out));
        is_file.then(|| {
            let out = quoted(&self.out);
            format!("nullcone skin {out} --animation 0 --time 0 --method motor --out frame.obj")
        })
    }

    fn text(&self) -> String {
        let many = |count: usize, of: &str| match count {
            1 => format!("1 {of}"),
            count => format!("{count} {of}s"),
        };
        let mut lines = format!(
            "{}: {} of {} in {}\n",
            self.out,
            many(self.frames, "frame"),
            many(self.joints.len(), "joint"),
            many(self.views, "view")
        );
        // Writing to a string does not fail.
        let _ = writeln!(
            lines,
            "reprojection   {:.2} px RMS, {:.2} px at most",
            self.reprojection_rms_px, self.reprojection_max_px
        );
        if self.views > 1 {
            for view in &self.per_view {
                let rms = view.reprojection_rms_px;
                let _ = writeln!(lines, "  {:12} {rms:.2} px RMS", view.name);
            }
        }
        let _ = writeln!(
            lines,
            "unseen         {} in {}",
            many(self.joints_unseen, "joint"),
            many(self.frames_with_unseen_joints, "frame")
        );
        if let Some(factors) = &self.length_factors {
            let (least, most) = factors.values().fold(
                (f64::INFINITY, f64::NEG_INFINITY),
                |(least, most), &factor| (least.min(factor), most.max(factor)),
            );
            let _ = writeln!(
                lines,
                "lengths        {least:.3} to {most:.3} times the character's"
            );
        }
        let _ = writeln!(
            lines,
            "time           {:.2} ms a frame",
            self.milliseconds_per_frame
        );
        if !self.joints_without_counterpart.is_empty() {
            let names = self.joints_without_counterpart.join(", ");
            let _ = writeln!(lines, "not of the skeleton: {names}");
        }
        lines
    }
}
