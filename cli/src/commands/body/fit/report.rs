//! What is printed.

use std::path::Path;

use ga_anim::motion_file::Loss;
use ga_body::character::{CharacterReport, FittedCharacter};
use ga_body::format::JointsNote;
use serde::Serialize;

use super::Arguments;
use crate::counted::counted;
use crate::format::Format;
use crate::frame::{self, Verdict, Warning};
use crate::motion_file::lost;
use crate::person::{judged, noted};
use crate::shell::quoted;

#[derive(Serialize)]
pub(crate) struct Report {
    character: String,
    out: String,
    #[serde(flatten)]
    fit: CharacterReport,
    /// Of the fit, whatever the format leaves out.
    #[serde(skip)]
    verdict: Verdict,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl Report {
    /// With warnings of what was found of the person, of what was done with the detections, and of
    /// what of
    /// the poses is not in the file.
    pub(super) fn new(
        arguments: &Arguments,
        fitted: FittedCharacter,
        notes: &[JointsNote],
        losses: &[Loss],
    ) -> Self {
        let (verdict, mut warnings) = judged(&fitted.findings);
        warnings.extend(notes.iter().map(noted));
        warnings.extend(losses.iter().map(|loss| lost(loss, &arguments.out)));
        Self {
            character: arguments.character.display().to_string(),
            out: arguments.out.display().to_string(),
            verdict,
            warnings,
            fit: fitted.report,
        }
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(self.verdict)
    }

    fn next(&self) -> Option<String> {
        let is_file = Format::Glb.fits(Path::new(&self.out));
        is_file.then(|| {
            let out = quoted(&self.out);
            format!("nullcone skin {out} --animation 0 --time 0 --method motor --out frame.obj")
        })
    }

    fn text(&self) -> String {
        let Self { out, fit, .. } = self;
        let frames = counted(fit.frames, "frame");
        let (joints, views) = (
            counted(fit.joints.len(), "joint"),
            counted(fit.views, "view"),
        );
        let mut lines = vec![
            format!("{out}: {frames} of {joints} in {views}"),
            format!(
                "reprojection   {:.2} px RMS, {:.2} px at most",
                fit.reprojection_rms_px, fit.reprojection_max_px
            ),
        ];
        if fit.views > 1 {
            lines.extend(fit.per_view.iter().map(|view| {
                let rms = view.reprojection_rms_px;
                format!("  {:12} {rms:.2} px RMS", view.name)
            }));
        }
        let unseen = counted(fit.joints_unseen, "joint");
        let frames = counted(fit.frames_with_unseen_joints, "frame");
        lines.push(format!("unseen         {unseen} in {frames}"));
        if let Some(factors) = &fit.length_factors {
            let least = factors.values().copied().fold(f64::INFINITY, f64::min);
            let most = factors.values().copied().fold(0.0, f64::max);
            lines.push(format!(
                "lengths        {least:.3} to {most:.3} times the character's"
            ));
        }
        let time = fit.milliseconds_per_frame;
        lines.push(format!("time           {time:.2} ms a frame"));
        if !fit.joints_without_counterpart.is_empty() {
            let names = fit.joints_without_counterpart.join(", ");
            lines.push(format!("not of the skeleton: {names}"));
        }
        lines.join("\n") + "\n"
    }
}
