//! What was found of a person in views, as warnings and a verdict.

use ga_body::character::{Finding, Severity};
use ga_body::format::JointsNote;

use crate::frame::{Verdict, Warning};

/// Findings as warnings, and the verdict that they give.
pub(crate) fn judged(findings: &[Finding]) -> (Verdict, Vec<Warning>) {
    let worst = findings.iter().map(|finding| finding.severity).max();
    let verdict = match worst {
        None | Some(Severity::Note) => Verdict::Good,
        Some(Severity::Doubtful) => Verdict::Doubtful,
        Some(Severity::Failed) => Verdict::Failed,
    };
    let warnings = findings.iter().map(|finding| Warning {
        view: finding.view.clone(),
        joint: finding.joint.clone(),
        frame: finding.frame,
        is_note: finding.severity == Severity::Note,
        ..Warning::new(finding.kind, finding)
    });
    (verdict, warnings.collect())
}

/// What was done with detections.
pub(crate) fn noted(note: &JointsNote) -> Warning {
    let (kind, view, count) = match note {
        JointsNote::FramesWithoutPeople { view, missing, .. } => {
            ("frames_without_people", Some(view), Some(*missing))
        }
        JointsNote::NegativeConfidences { view, joints } => {
            ("negative_confidences", Some(view), Some(*joints))
        }
        JointsNote::NotFrameNumbers { view, .. } => ("not_frame_numbers", Some(view), None),
        JointsNote::Step { .. } => ("frame_step", None, None),
    };
    Warning {
        view: view.cloned(),
        count,
        ..Warning::new(kind, note)
    }
}
