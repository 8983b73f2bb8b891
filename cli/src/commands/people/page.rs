//! The page of the report.

use anyhow::Result;
use ga_body::character::{CharacterReport, FittedCharacter, ViewReport};
use ga_camera::Camera;
use ga_draw::document::{LineChart, Motion, MotionCamera, Page, Series};
use ga_numerics::order_statistics::median;
use ga_runtime::cga3::Point;

use super::drawing::Drawn;
use super::figure::Figure;
use crate::frame::{Verdict, Warning, judge};

/// How far from the centre of a camera the base of its pyramid is, in metres.
const PYRAMID: f64 = 0.3;
/// More contacts than this are not listed.
const MOST_CONTACTS: usize = 60;

/// What a page shows.
pub(super) struct Contents<'a> {
    pub(super) title: &'a str,
    /// The line by which the command was called, where the page is to say it.
    pub(super) command: Option<String>,
    pub(super) verdict: Verdict,
    pub(super) warnings: &'a [Warning],
    pub(super) figure: &'a Figure,
    pub(super) fitted: &'a FittedCharacter,
    /// For each view the size of its pictures, where it is known.
    pub(super) sizes: &'a [Option<[usize; 2]>],
    pub(super) films: Vec<Drawn>,
}

/// The page.
pub(super) fn page(contents: Contents<'_>) -> Result<Page> {
    let report = &contents.fitted.report;
    let mut page = Page::new(contents.title);
    say(&mut page, contents.verdict, contents.warnings, report);
    let (fitted, figure) = (contents.fitted, contents.figure);
    motion(&mut page, figure, fitted, contents.sizes, contents.films)?;
    page.heading("Views");
    views(&mut page, &report.per_view);
    if let Some(chart) = chart(fitted)? {
        page.wide_svg(
            &chart,
            "How far joints were found from where the body has them: the median of each view in \
             each frame, in pixels of the view.",
        );
    }
    page.fold("The lengths of all bones", bones(report));
    contacts(&mut page, report);
    if let Some(command) = &contents.command {
        page.heading("Command");
        page.code(command);
    }
    Ok(page)
}

/// The result in words.
fn say(page: &mut Page, verdict: Verdict, warnings: &[Warning], report: &CharacterReport) {
    judge(page, Some(verdict), warnings);
    let ground = match &report.ground {
        Some(ground) if ground.floor.is_some() => "It stands on the floor, with y up.",
        Some(_) => "y is up; how high the floor is could not be found.",
        None => "Which way is up could not be found.",
    };
    page.paragraph(&format!(
        "{} frames ({:.2} s) of {} joints in {}. Half of the joints that were found are within \
         {} px of where the body has them. {ground}",
        report.frames,
        report.frames as f64 / report.frames_per_second,
        report.joints.len(),
        match report.views {
            1 => "1 view".to_owned(),
            views => format!("{views} views"),
        },
        match report.reprojection_median_px {
            median @ ..1.0 => format!("{median:.2}"),
            median => format!("{median:.1}"),
        }
    ));
    let count = report.joints_unseen;
    if count > 0 {
        page.paragraph(&format!(
            "In {} frames there are joints that no view shows, {count} in all: there the body \
             follows from the frames around and from the joints beside.",
            report.frames_with_unseen_joints
        ));
    }
}

/// The figure beside its films.
fn motion(
    page: &mut Page,
    figure: &Figure,
    fitted: &FittedCharacter,
    sizes: &[Option<[usize; 2]>],
    films: Vec<Drawn>,
) -> Result<()> {
    let report = &fitted.report;
    let cameras = fitted.cameras.iter().zip(&report.per_view).zip(sizes);
    let cameras = cameras.map(|((camera, view), size)| pyramid(camera, &view.name, *size));
    let step = films.iter().map(|drawn| drawn.step).max();
    let caption = match step {
        None => "The fitted body; no films were given.".to_owned(),
        Some(1) => "The fitted body, and over each frame of the films.".to_owned(),
        Some(step) => format!(
            "The fitted body, and over the films, of which every {step}th frame is on this page \
             at most."
        ),
    };
    let floor = report.ground.as_ref().and_then(|ground| ground.floor);
    let motion = Motion {
        frames_per_second: report.frames_per_second,
        names: figure.names.clone(),
        bones: figure.bones.clone(),
        frames: figure.frames.iter().cloned().map(Some).collect(),
        floor: floor.map(|_| 0.0),
        cameras: cameras.collect(),
        films: films.into_iter().map(|drawn| drawn.film).collect(),
    };
    let legend = "In the films, dots are joints that were found; a cross is one that is more than \
                  three standard deviations from where the body has it, with a line to there.";
    let caption = match step {
        None => caption,
        Some(_) => format!("{caption} {legend}"),
    };
    Ok(page.motion(&motion, &caption)?)
}

/// A camera as the tip and the base of a pyramid. Distortion is left out.
fn pyramid(camera: &Camera, name: &str, size: Option<[usize; 2]>) -> MotionCamera {
    let (focal, principal) = (camera.intrinsics.focal(), camera.intrinsics.principal());
    // Without a size, pictures are as wide and high to both sides of the principal point.
    let size = size.map_or(principal.map(|middle| 2.0 * middle), |size| {
        size.map(|side| side as f64)
    });
    let to_world = camera.world_to_camera.reverse();
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|corner: [f64; 2]| {
        let [x, y] = [0, 1].map(|k| PYRAMID * (size[k] * corner[k] - principal[k]) / focal[k]);
        to_world.transform(Point::new(x, y, PYRAMID)).coordinates()
    });
    MotionCamera {
        name: name.to_owned(),
        centre: camera.centre().coordinates(),
        corners,
    }
}

fn views(page: &mut Page, views: &[ViewReport]) {
    let names = [
        "view",
        "joints found",
        "median, px",
        "RMS, px",
        "begins at frame",
        "rotated by",
        "frames with exchanged sides",
    ];
    let known = |value: Option<f64>, unit: &str, deviation: Option<f64>| match (value, deviation) {
        (Some(value), Some(deviation)) => format!("{value:.2} ± {deviation:.2}{unit}"),
        (Some(value), None) => format!("{value:.2}{unit}"),
        (None, _) => "not known".to_owned(),
    };
    let rows = views.iter().map(|view| {
        [
            view.name.clone(),
            view.joints_seen.to_string(),
            format!("{:.2}", view.reprojection_median_px),
            format!("{:.2}", view.reprojection_rms_px),
            known(view.offset_frames, "", view.offset_deviation_frames),
            known(view.rotation_degrees, "°", view.rotation_deviation_degrees),
            view.frames_with_exchanged_sides.len().to_string(),
        ]
    });
    page.table(names, rows);
    page.paragraph(
        "A view begins at the frame that shows what frame 0 of the first view shows. A camera is \
         rotated against where its file has it. Numbers after ± are standard deviations.",
    );
}

/// The median distance of each view over the frames; `None` for one frame.
fn chart(fitted: &FittedCharacter) -> Result<Option<String>> {
    if fitted.poses.len() < 2 {
        return Ok(None);
    }
    let views = fitted.report.per_view.iter().enumerate();
    let series = views.map(|(view, report)| {
        let frames = fitted.poses.iter().enumerate();
        let line = frames.filter_map(|(frame, fit)| {
            let seen = fit.residuals_px[view].iter().copied().flatten();
            Some((frame as f64, median(&mut seen.collect::<Vec<_>>())?))
        });
        Series {
            name: report.name.clone(),
            line: line.collect(),
            ..Series::default()
        }
    });
    let series: Vec<Series> = series.collect();
    if series.iter().all(|series| series.line.is_empty()) {
        return Ok(None);
    }
    let chart = LineChart {
        title: "Distance of joints from the body",
        horizontal: "frame",
        vertical: "pixels",
        series: &series,
        dots: "",
        rings: "",
    };
    Ok(Some(chart.to_svg()?))
}

fn bones(report: &CharacterReport) -> Page {
    let mut page = Page::new("Bones");
    let rows = report.bones.iter().map(|bone| {
        let deviation = match bone.deviation_metres {
            Some(deviation) => format!("± {:.1}", 1e3 * deviation),
            None => "as the character has it".to_owned(),
        };
        [
            bone.joint.clone(),
            format!("{:.1}", 1e3 * bone.length_metres),
            deviation,
        ]
    });
    page.table(
        [
            "joint",
            "distance from the joint above, mm",
            "deviation, mm",
        ],
        rows,
    );
    page
}

fn contacts(page: &mut Page, report: &CharacterReport) {
    let all = report.ground.as_ref().map(|ground| &ground.contacts);
    let all = all.map_or(&[][..], Vec::as_slice);
    if all.is_empty() {
        page.paragraph("No foot stands.");
        return;
    }
    let mut table = Page::new("Standing feet");
    let seconds = |frame: usize| frame as f64 / report.frames_per_second;
    let rows = all.iter().take(MOST_CONTACTS).map(|contact| {
        [
            contact.joint.clone(),
            format!("{} to {}", contact.start, contact.end),
            format!(
                "{:.2} to {:.2}",
                seconds(contact.start),
                seconds(contact.end)
            ),
            format!("{:.1}", 1e3 * contact.slide_metres),
        ]
    });
    table.table(["joint", "frames", "seconds", "slides by, mm"], rows);
    if let more @ 1.. = all.len().saturating_sub(MOST_CONTACTS) {
        table.paragraph(&format!("{more} more are in report.json."));
    }
    page.fold("When feet stand", table);
}
