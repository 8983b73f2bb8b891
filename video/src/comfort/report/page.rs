//! The page.

use crate::comfort::{Dimension, RowSummary, Scale, Score, Summary, Viewing, comfortable_shift};
use crate::keyframe::timecode::TimeBase;
use ga_image::file::FormatError;

use super::thumbnail::{self, Video};
use super::verdict::{self, Problem};
use super::{About, Report, axis, depth, heat, notes, raw, words};
use ga_draw::document::{Cell, Page, Tint};

impl Report {
    /// The page about the frames so far. `failure` says why the video could not be read further.
    ///
    /// # Errors
    /// A picture that is shown cannot be encoded.
    pub fn page(&self, summary: &Summary, failure: Option<&str>) -> Result<Page, FormatError> {
        page(self, summary, failure)
    }
}

/// The page of a report; `failure` says why the video could not be read further.
fn page(report: &Report, summary: &Summary, failure: Option<&str>) -> Result<Page, FormatError> {
    let about = &report.about;
    let viewing = &about.viewing;
    let rate = report.rate(summary.frames);
    let place = |frame: usize| format!("at {} (frame {frame})", timecode(frame, rate));
    let problems = verdict::problems(summary, &report.moments, &report.heights, viewing);
    let mut page = Page::new(&format!("Viewing comfort of {}", about.title));
    if let Some(failure) = failure {
        let frames = match summary.frames {
            1 => "frame".into(),
            count => format!("{count} frames"),
        };
        page.warning(&format!(
            "The video could not be read to its end: {failure}. This page is about the {frames} \
             before that."
        ));
    }
    page.heading("In short");
    page.paragraph(&verdict::sentences(summary, &problems, viewing, place).join(" "));
    add_command(&mut page, report, &problems);
    page.paragraph(&conditions(report, summary, rate));

    page.heading("All checks");
    page.paragraph(
        "Each frame has a score from 0 to 15 in each check: up to 7 is comfortable (green), up to \
         13 strains after a while (orange), above that is severe (red).",
    );
    add_table(&mut page, summary, &problems, rate);
    notes(summary).iter().for_each(|note| page.paragraph(note));

    page.heading("Scores over time");
    let axis = axis::TimeAxis::new(&report.timeline);
    let many = match report.timeline.seconds() {
        Some(_) => {
            " Colours and numbers are the mean of an interval; where its worst frame is \
                     worse, a strip above has the colour of that one."
        }
        None => "",
    };
    let caption = format!(
        "Each column is {}.{many} Grey: the frames do not show what is needed, such as motion for \
         the delay of one eye.",
        axis.unit()
    );
    page.wide_svg(&heat::svg(&report.timeline, summary), &caption);

    page.heading("Depth budget");
    let comfortable = |dimension| {
        let scale = Scale::of(dimension, viewing);
        words::number(scale.map_or(0.0, |scale| scale.comfortable()), 1)
    };
    let caption = format!(
        "The darker, the more points have this parallax: the horizontal distance of a point in the \
         right view from that in the left one. At 0 it appears on the screen, above behind it, \
         below in front of it. Between the limits of comfort the eyes converge at most {}° more \
         and {}° less than on the screen; outside of the dashed lines, broadcasters allow depth for \
         short moments only (BSkyB: −1 to +2 % on screens of 46 to 70 inches).",
        comfortable(Dimension::OverConvergence),
        comfortable(Dimension::OverDivergence)
    );
    page.wide_svg(&depth::svg(&report.timeline, viewing)?, &caption);

    if !problems.is_empty() {
        add_problems(&mut page, report, &problems, (summary, rate))?;
    }
    page.heading("What the checks mean");
    let rows = Dimension::ALL.map(|dimension| {
        [
            dimension.in_words().to_owned(),
            dimension.name().to_owned(),
            words::explanation(dimension).to_owned(),
            words::limits(dimension, viewing),
        ]
    });
    page.text_table(["check", "name in files", "what it says", "limits"], rows);
    page.paragraph(
        "′ is an arc minute, the sixtieth part of a degree, at the eye of the viewer. Times are \
         hours:minutes:seconds:frames; frames are counted from 0.",
    );
    Ok(page)
}

/// The command that removes what can be removed.
fn add_command(page: &mut Page, report: &Report, problems: &[Problem<'_>]) {
    let about = &report.about;
    let shift = recommended_shift(report, problems);
    let names: Vec<String> = problems
        .iter()
        .filter(|problem| {
            words::can_align(&problem.worst().record, problem.dimension, &about.viewing)
        })
        .map(|problem| {
            let record = &problem.worst().record;
            words::trouble(record, problem.dimension, &about.viewing).to_lowercase()
        })
        .collect();
    if names.is_empty() && shift == 0.0 {
        return;
    }
    match &about.align {
        Some(command) if names.is_empty() => {
            page.paragraph(&moved(shift, about));
            page.code(&format!("{command} {}", about.shift));
        }
        Some(command) => {
            page.paragraph(&format!(
                "This command writes the video without {}; measure it again afterwards:",
                words::listed(&names)
            ));
            page.code(command);
            if shift != 0.0 {
                page.paragraph(&format!(
                    "{} as well:",
                    moved(shift, about).trim_end_matches(':')
                ));
                page.code(&format!("{command} {}", about.shift));
            }
        }
        None if names.is_empty() => {}
        None => page.paragraph(&format!(
            "“nullcone video align” removes {}, if the video is in a file.",
            words::listed(&names)
        )),
    }
}

/// The shift of parallax in per cent of the width that makes the depth comfortable, or less
/// uncomfortable, where points are too far in front or behind for no other reason.
fn recommended_shift(report: &Report, problems: &[Problem<'_>]) -> f64 {
    let is_limit = |problem: &Problem| {
        let limits = [Dimension::OverConvergence, Dimension::OverDivergence];
        limits.contains(&problem.dimension) && problem.cause.is_none()
    };
    let ends = report.timeline.ends();
    match ends.filter(|_| problems.iter().any(is_limit)) {
        Some(ends) => comfortable_shift(ends, &report.about.viewing),
        None => 0.0,
    }
}

/// What a shift of parallax does.
fn moved(shift: f64, about: &About) -> String {
    let direction = if shift > 0.0 { "back" } else { "forward" };
    format!(
        "This command moves the whole scene {direction} by {}° ({} % of the width):",
        words::number(about.viewing.degrees_of_parallax(shift).abs(), 2),
        words::number(shift.abs(), 2)
    )
}

/// The video and the eyes before it, in a sentence or two.
fn conditions(report: &Report, summary: &Summary, rate: [u32; 2]) -> String {
    let About {
        properties,
        viewing,
        ..
    } = &report.about;
    let [width, height] = properties.size;
    let seconds = summary.frames as f64 * f64::from(rate[1]) / f64::from(rate[0].max(1));
    let length = match seconds < 60.0 {
        true => format!("{seconds:.1} seconds"),
        false => format!("{} minutes:seconds", axis::clock(seconds)),
    };
    let frames = match summary.frames {
        1 => "one frame".into(),
        count => format!("{count} frames"),
    };
    let shots = match summary.shots {
        1 => "one shot".into(),
        count => format!("{count} shots"),
    };
    format!(
        "The video has {frames} of {width} × {height} pixels for each eye, {shots}, {length}. It \
         is judged for a screen {:.2} m wide, seen from {:.2} m by eyes {:.0} mm apart: there, 1 % \
         of the picture's width is an angle of {:.0}′, and the eyes look parallel at {}. On \
         a larger screen the same video has more depth: --screen-inches and --distance-metres \
         state another one.",
        viewing.width(),
        viewing.distance(),
        1000.0 * viewing.interocular(),
        60.0 * viewing.degrees_of_parallax(1.0),
        words::signed_percent(viewing.parallel_percent()),
    )
}

/// The table in the shape of Cui's table 6.
fn add_table(page: &mut Page, summary: &Summary, problems: &[Problem<'_>], rate: [u32; 2]) {
    let rows = Dimension::ALL.map(|dimension| {
        let row = summary.row(dimension);
        let problem = problems
            .iter()
            .find(|problem| problem.dimension == dimension);
        // The frame whose picture is shown is the worst one among equal scores.
        let worst_frame = match (problem, row.worst) {
            (Some(problem), _) => Some(problem.worst().record.frame),
            (None, worst) => worst.map(|(_, frame)| frame),
        };
        let [green, orange, red] = row.levels.map(|count| share(count, summary.frames));
        let missing = |count: usize| match count {
            0 => Cell::from(String::new()),
            _ => Cell {
                text: share(count, summary.frames),
                tint: Some(Tint::Grey),
            },
        };
        let tinted = |text: String, count: usize, tint: Tint| Cell {
            text,
            tint: (count > 0).then_some(tint),
        };
        [
            Cell::from(dimension.in_words().to_owned()),
            mean(row),
            worst(row),
            Cell::from(worst_frame.map_or(String::new(), |frame| {
                format!("{} ({frame})", timecode(frame, rate))
            })),
            tinted(green, row.levels[0], Tint::Green),
            tinted(orange, row.levels[1], Tint::Orange),
            tinted(red, row.levels[2], Tint::Red),
            Cell::from(
                row.mean_raw()
                    .map_or(String::new(), |raw| words::amount(dimension, raw)),
            ),
            missing(row.not_measurable()),
            missing(row.unknown()),
        ]
    });
    let names = [
        "check",
        "mean score",
        "worst",
        "at (frame)",
        "green",
        "orange",
        "red",
        "mean measured",
        "not measurable",
        "unknown",
    ];
    page.tinted_table(names, rows);
}

fn mean(row: &RowSummary) -> Cell {
    match row.mean_score() {
        Some(mean) => Cell {
            text: format!("{mean:.1}"),
            tint: row.mean_level().map(heat::tint),
        },
        None => none(),
    }
}

fn worst(row: &RowSummary) -> Cell {
    match row.worst {
        Some((score, _)) => Cell {
            text: score.to_string(),
            tint: Some(heat::tint(Score::new(score).level())),
        },
        None => none(),
    }
}

fn none() -> Cell {
    Cell {
        text: "–".into(),
        tint: Some(Tint::Grey),
    }
}

/// When a frame is shown: hours, minutes, seconds and frames, or seconds where frames are slower
/// than those are counted.
fn timecode(frame: usize, rate: [u32; 2]) -> String {
    let seconds = frame as f64 * f64::from(rate[1]) / f64::from(rate[0].max(1));
    match TimeBase::new(rate, None) {
        Ok(base) => base.code(seconds),
        Err(_) => format!("{seconds:.3} s"),
    }
}

/// A number of frames in per cent of all; empty for none.
fn share(count: usize, all: usize) -> String {
    let percent = 100.0 * count as f64 / all.max(1) as f64;
    match count {
        0 => String::new(),
        _ if percent < 0.5 => "< 1 %".into(),
        _ if percent > 99.5 && count < all => "> 99 %".into(),
        _ => format!("{percent:.0} %"),
    }
}

/// What to mend in which order, the measured numbers over time, and the worst moments.
fn add_problems(
    page: &mut Page,
    report: &Report,
    problems: &[Problem<'_>],
    (summary, rate): (&Summary, [u32; 2]),
) -> Result<(), FormatError> {
    let viewing = &report.about.viewing;
    page.heading("What to mend, in this order");
    page.numbered(problems.iter().map(|problem| {
        let record = &problem.worst().record;
        let text = format!(
            "{}. At {} (frame {}), {}. {}{}",
            verdict::frames(problem.frames(), summary.frames),
            timecode(record.frame, rate),
            record.frame,
            words::finding(record, problem.dimension, viewing),
            words::advice(record, problem.dimension, viewing, summary.shots),
            problem.explanation()
        );
        let level = match problem.is_red() {
            true => "severe",
            false => "strains after a while",
        };
        (
            format!(
                "{} ({level}),",
                words::trouble(record, problem.dimension, viewing)
            ),
            text,
        )
    }));
    let charted = |problem: &&Problem<'_>| Scale::of(problem.dimension, viewing).is_some();
    if problems.iter().any(|problem| charted(&problem)) {
        page.heading("Measured numbers over time");
        for problem in problems.iter().filter(charted) {
            let svg = raw::svg(&report.timeline, problem.dimension, viewing);
            let caption = match problem.dimension {
                Dimension::FocalGap => {
                    "This is sharpness only. Where the check is orange or red and this is \
                     comfortable, the views differ in size."
                }
                _ => "",
            };
            page.wide_svg(&svg, caption);
        }
    }
    page.heading("The worst moments");
    let video = Video {
        viewing,
        colours: report.about.properties.colours,
    };
    for problem in problems {
        for moment in problem.moments {
            add_moment(page, problem.dimension, moment, video, rate)?;
        }
    }
    Ok(())
}

fn add_moment(
    page: &mut Page,
    dimension: Dimension,
    moment: &super::moments::Moment,
    video: Video<'_>,
    rate: [u32; 2],
) -> Result<(), FormatError> {
    let record = &moment.record;
    let score = record.row(dimension).score.unwrap_or_default();
    page.subheading(&format!(
        "{}: {} (frame {}), score {score}, {}",
        words::trouble(record, dimension, video.viewing),
        timecode(record.frame, rate),
        record.frame,
        score.level().name()
    ));
    let drawn = thumbnail::draw(moment, dimension, video)?;
    let finding = words::finding(record, dimension, video.viewing);
    page.wide_svg(
        &drawn.svg,
        &caption(&finding, dimension, video.viewing, &drawn.words),
    );
    Ok(())
}

fn caption(finding: &str, dimension: Dimension, viewing: &Viewing, seen: &str) -> String {
    let mut characters = finding.chars();
    let first = characters
        .next()
        .map(|first| first.to_uppercase().to_string());
    let finding = first.unwrap_or_default() + characters.as_str();
    let limits = match Scale::of(dimension, viewing) {
        Some(_) => format!("; {}", words::limits(dimension, viewing)),
        None => String::new(),
    };
    format!("{finding}{limits}. {seen}")
}
