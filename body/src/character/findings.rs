//! What makes a result doubtful, and what to do about it.

use std::fmt;
use std::ops::RangeInclusive;

use ga_camera::Camera;
use ga_numerics::order_statistics::median;
use ga_runtime::vga3::Vector;

use super::report::CharacterReport;
use crate::agreement::{Agreement, OUTLIER};
use crate::ground::{Ground, UpSource};
use crate::registration::{Registration, is_upside_down};
use crate::{FittedPose, Observation};

/// Distances from pixels are doubtful where their median is more than this part of the height of
/// the person in the pictures, and the result is not to be used where it is more than the other.
const DOUBTFUL: f64 = 0.03;
const FAILED: f64 = 0.08;
/// What is found of cameras and times is said where it is more than three standard deviations, and
/// more than this, in degrees and in frames.
const ROTATION: f64 = 0.3;
const OFFSET: f64 = 0.5;
/// A camera that is lower than this beside the floor, in metres, cannot see it from above.
const BELOW: f64 = -0.2;
/// Feet that stand should not slide farther than this, in metres: an ankle moves by 3 cm while the
/// heel rises.
const SLIDE: f64 = 0.05;
/// A direction that is up should be known to this, in degrees.
const UP: f64 = 3.0;

/// How much a finding says against a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// It was put right, and should be known.
    Note,
    /// The result should be looked at.
    Doubtful,
    /// The result is not to be used.
    Failed,
}

/// Something that was found of the views of a person.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What it is, as one word for programs.
    pub kind: &'static str,
    /// The sentence for people.
    pub message: String,
    /// How much it says against the result.
    pub severity: Severity,
    /// The view.
    pub view: Option<String>,
    /// The joint.
    pub joint: Option<String>,
    /// The first frame.
    pub frame: Option<usize>,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message.fmt(f)
    }
}

impl Finding {
    fn new(kind: &'static str, severity: Severity, message: String) -> Self {
        Self {
            kind,
            message,
            severity,
            view: None,
            joint: None,
            frame: None,
        }
    }

    fn of_view(self, view: &str) -> Self {
        let view = Some(view.to_owned());
        Self { view, ..self }
    }

    fn at_frame(self, frame: Option<usize>) -> Self {
        Self { frame, ..self }
    }
}

/// What findings are made of.
pub(super) struct Found<'a> {
    pub(super) views: &'a [&'a str],
    pub(super) report: &'a CharacterReport,
    pub(super) agreement: &'a Agreement,
    pub(super) poses: &'a [FittedPose],
    /// In a world with y up where the ground is known.
    pub(super) cameras: &'a [Camera],
    pub(super) observations: &'a [Observation],
    /// The views that the poses do not depend on.
    pub(super) left_out: &'a [usize],
    /// The views whose cameras are in the other pose of a planar board.
    pub(super) mirrored: &'a [usize],
    pub(super) is_synchronised: bool,
    pub(super) is_refined: bool,
    /// How views stand to each other, where it was found.
    pub(super) registration: Option<&'a Registration>,
    /// Whether the ground was found, where it was asked for.
    pub(super) is_on_ground: bool,
}

/// What was found, the worst first.
pub(super) fn of(found: &Found<'_>) -> Vec<Finding> {
    let mut all: Vec<Finding> = [
        size_of_errors(found),
        views(found),
        frames(found),
        exchanged(found),
        cameras(found),
        times(found),
        ground(found),
        not_done(found),
    ]
    .concat();
    all.sort_by_key(|finding| std::cmp::Reverse(finding.severity));
    all
}

/// Distances from pixels beside the size of the person.
fn size_of_errors(found: &Found<'_>) -> Vec<Finding> {
    let Some(height) = height_px(found.observations) else {
        return Vec::new();
    };
    let error = found.report.reprojection_median_px;
    let part = error / height;
    let severity = match part {
        part if part > FAILED => Severity::Failed,
        part if part > DOUBTFUL => Severity::Doubtful,
        _ => return Vec::new(),
    };
    let message = format!(
        "half of the joints are more than {error:.1} px from where the body has them, {:.1} % of \
         the height of the person: the joints, the cameras, or the names of the joints are wrong",
        100.0 * part
    );
    vec![Finding::new("large_error", severity, message)]
}

/// The median of the larger side of what views show of the person.
fn height_px(observations: &[Observation]) -> Option<f64> {
    let views = observations
        .iter()
        .flat_map(|observation| &observation.views);
    let heights = views.filter_map(|pixels| {
        let extent = |k: usize| {
            let all = pixels.iter().flatten().map(|pixel| pixel.position[k]);
            let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
            high - low
        };
        let larger = extent(0).max(extent(1));
        (larger > 0.0).then_some(larger)
    });
    median(&mut heights.collect::<Vec<_>>())
}

/// Views that disagree with the others.
fn views(found: &Found<'_>) -> Vec<Finding> {
    let per_view = &found.report.per_view;
    let mut bad: Vec<Finding> = Vec::new();
    for (index, view) in per_view.iter().enumerate() {
        let others = per_view
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index);
        let mut others: Vec<f64> = others
            .map(|(_, view)| view.reprojection_median_px)
            .collect();
        if view.joints_seen == 0 {
            let message = format!("the view {} shows no joint in any frame", view.name);
            bad.push(Finding::new("unseen_view", Severity::Doubtful, message).of_view(&view.name));
        }
        let own = view.reprojection_median_px;
        let of_view = found
            .agreement
            .of_views
            .get(index)
            .copied()
            .flatten()
            .unwrap_or(0.0);
        if found.left_out.contains(&index) {
            let others = median(&mut others).unwrap_or_default();
            let message = format!(
                "the view {} disagrees with the others and is left out: half of its joints are \
                 more than {own:.1} px off, and {others:.1} px in the others: look at its camera, \
                 its time and its joints",
                view.name
            );
            bad.push(Finding::new("bad_view", Severity::Doubtful, message).of_view(&view.name));
        } else if of_view > OUTLIER {
            let message = format!(
                "the view {} is {of_view:.1} standard deviations from its pixels, as the root mean \
                 square",
                view.name
            );
            bad.push(Finding::new("large_error", Severity::Doubtful, message).of_view(&view.name));
        }
    }
    bad
}

/// Frames that are fitted badly, in one sentence.
fn frames(found: &Found<'_>) -> Vec<Finding> {
    let bad: Vec<(usize, f64)> = found.agreement.bad_frames().collect();
    let numbers: Vec<usize> = bad.iter().map(|(frame, _)| *frame).collect();
    let Some((worst, value)) = bad.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else {
        return Vec::new();
    };
    let message = format!(
        "{} {} badly fitted: more than {OUTLIER} standard deviations from their pixels, as the \
         root mean square; the worst is {worst}, with {value:.1}",
        shown(&numbers),
        if numbers.len() == 1 { "is" } else { "are" }
    );
    let finding = Finding::new("large_error", Severity::Doubtful, message);
    vec![finding.at_frame(numbers.first().copied())]
}

/// Sides that were exchanged, and are put right.
fn exchanged(found: &Found<'_>) -> Vec<Finding> {
    let views = found.report.per_view.iter();
    let exchanged = views.filter(|view| !view.frames_with_exchanged_sides.is_empty());
    let findings = exchanged.map(|view| {
        let frames = &view.frames_with_exchanged_sides;
        let message = format!(
            "the view {} exchanges left and right in {}; this is put right",
            view.name,
            shown(frames)
        );
        let finding = Finding::new("exchanged_sides", Severity::Note, message);
        finding
            .of_view(&view.name)
            .at_frame(frames.first().copied())
    });
    findings.collect()
}

/// Cameras that are rotated, or upside down beside the person.
fn cameras(found: &Found<'_>) -> Vec<Finding> {
    let of_board = found.mirrored.iter().map(|&view| {
        let view = found.views[view];
        let message = format!(
            "the camera of the view {view} is in the wrong one of two poses in which a flat board \
             on the floor looks alike: the other one is taken, which the joints fit, but know to \
             about a degree only: calibrate it with a board that is held in several directions"
        );
        Finding::new("mirrored_pose", Severity::Doubtful, message).of_view(view)
    });
    let mut findings: Vec<Finding> = of_board.collect();
    for (view, camera) in found.report.per_view.iter().zip(found.cameras) {
        if let (Some(angle), Some(deviation)) =
            (view.rotation_degrees, view.rotation_deviation_degrees)
            && angle > ROTATION
            && angle > 3.0 * deviation
        {
            let (severity, what) = match found.is_refined {
                true => (Severity::Note, "this is put right"),
                false => (Severity::Doubtful, "--refine-cameras rotates it"),
            };
            let message = format!(
                "the camera of the view {} is rotated by {angle:.1}° against the others; {what}",
                view.name
            );
            findings.push(Finding::new("rotated_camera", severity, message).of_view(&view.name));
        }
        let [_, height, _] = camera.centre().coordinates();
        let is_on_floor = |ground: &Ground| ground.floor.is_some();
        if found.report.ground.as_ref().is_some_and(is_on_floor) && height < BELOW {
            let message = format!(
                "the camera of the view {} is {:.1} m below the floor on which the person stands: \
                 a flat board has two poses that look alike, and the calibration may have taken \
                 the wrong one",
                view.name, -height
            );
            let finding = Finding::new("below_floor", Severity::Doubtful, message);
            findings.push(finding.of_view(&view.name));
        }
        if found.report.ground.is_some() && is_upside_down(camera, Vector::Y) {
            let message = format!(
                "the camera of the view {} is upside down beside the person: a flat board has two \
                 poses that look alike, and the calibration may have taken the wrong one",
                view.name
            );
            let finding = Finding::new("upside_down", Severity::Doubtful, message);
            findings.push(finding.of_view(&view.name));
        }
    }
    findings
}

/// Views that do not begin together.
fn times(found: &Found<'_>) -> Vec<Finding> {
    let first = found.views.first().copied().unwrap_or_default();
    let per_view = found.report.per_view.iter();
    let findings = per_view.filter_map(|view| {
        let (offset, deviation) = (view.offset_frames?, view.offset_deviation_frames?);
        if offset.abs() < OFFSET || offset.abs() < 3.0 * deviation {
            return None;
        }
        let (severity, what) = match found.is_synchronised {
            true => (Severity::Note, "this is put right"),
            false => (Severity::Doubtful, "--synchronise shifts them"),
        };
        let message = format!(
            "the views {first} and {} differ by {offset:.1} frames; {what}",
            view.name
        );
        Some(Finding::new("offset", severity, message).of_view(&view.name))
    });
    findings.collect()
}

/// What is not known of the ground.
fn ground(found: &Found<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    let Some(ground) = &found.report.ground else {
        return findings;
    };
    if ground.up_is == UpSource::Posture && ground.up_deviation_degrees > UP {
        let message = format!(
            "which way is up is known by the posture of the person alone, to {:.0}°: give --up",
            ground.up_deviation_degrees
        );
        findings.push(Finding::new("unclear_up", Severity::Note, message));
    }
    if ground.floor.is_none() {
        let message = "no foot stands: the height of the floor is not known: give --floor";
        findings.push(Finding::new("no_floor", Severity::Note, message.to_owned()));
    }
    let slides = ground
        .contacts
        .iter()
        .filter(|contact| contact.slide_metres > SLIDE);
    findings.extend(slides.map(|contact| {
        let message = format!(
            "{} slides by {:.0} mm while it stands in frames {}–{}",
            contact.joint,
            1e3 * contact.slide_metres,
            contact.start,
            contact.end
        );
        let finding = Finding::new("sliding_foot", Severity::Doubtful, message);
        Finding {
            joint: Some(contact.joint.clone()),
            ..finding.at_frame(Some(contact.start))
        }
    }));
    findings
}

/// What was asked for and could not be done, and what one view does not show.
fn not_done(found: &Found<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    let is_asked = found.is_synchronised || found.is_refined;
    if is_asked && found.registration.is_none() && found.cameras.len() > 1 {
        let message = "how the views stand to each other could not be found: neither cameras nor \
                       times are changed";
        let finding = Finding::new("not_registered", Severity::Doubtful, message.to_owned());
        findings.push(finding);
    }
    let registered = found.registration.map_or(&[][..], |found| &found.views);
    for (view, registered) in found.views.iter().zip(registered) {
        let message = match registered {
            own if own.is_offset_at_limit => format!(
                "the view {view} seems to begin {:.0} frames or more {} the view {}, farther than \
                 is searched: by how many is not decided, and neither its time nor its camera is \
                 changed: cut the films so that they begin nearly together",
                own.offset_frames.abs(),
                if own.offset_frames > 0.0 {
                    "before"
                } else {
                    "after"
                },
                found.views[0]
            ),
            own if found.is_synchronised && own.offset_deviation.is_infinite() => {
                format!("the motion does not show when the view {view} begins: it is not shifted")
            }
            _ => continue,
        };
        let finding = Finding::new("unknown_offset", Severity::Doubtful, message);
        findings.push(finding.of_view(view));
    }
    if !found.is_on_ground {
        let message = "the character has not two arms and two legs: the result stays in the world \
                       of the cameras";
        findings.push(Finding::new(
            "no_ground",
            Severity::Doubtful,
            message.to_owned(),
        ));
    }
    if found.cameras.len() == 1 && !found.poses.is_empty() {
        let message = "one view shows neither the size of the person nor, for sure, which limbs \
                       point towards the camera";
        findings.push(Finding::new("one_view", Severity::Note, message.to_owned()));
    }
    findings
}

/// Numbers of frames as ranges: `frames 41–61, 63 and 65`.
fn shown(frames: &[usize]) -> String {
    let mut ranges: Vec<RangeInclusive<usize>> = Vec::new();
    for &frame in frames {
        match ranges.last_mut() {
            Some(last) if *last.end() + 1 == frame => *last = *last.start()..=frame,
            _ => ranges.push(frame..=frame),
        }
    }
    let words = ranges
        .iter()
        .map(|range| match range.start() == range.end() {
            true => range.start().to_string(),
            false => format!("{}–{}", range.start(), range.end()),
        });
    let mut words: Vec<String> = words.collect();
    let last = words.pop().unwrap_or_default();
    let noun = if frames.len() == 1 { "frame" } else { "frames" };
    match words.is_empty() {
        true => format!("{noun} {last}"),
        false => format!("{noun} {} and {last}", words.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_shown_as_ranges() {
        assert_eq!(shown(&[4]), "frame 4");
        assert_eq!(shown(&[4, 5, 6]), "frames 4–6");
        assert_eq!(shown(&[0, 2, 3, 9]), "frames 0, 2–3 and 9");
    }
}
