//! The report as a page that needs no other file.

use anyhow::{Error, Result};

use super::input::Analysed;
use super::plot;
use super::report::Report;
use ga_draw::document::Page;
use ga_video::keyframe::scenes::timecode;
use ga_video::keyframe::statistics::Statistics;

/// The page: counts, the curves, the shots and the key frames.
pub(super) fn of(
    analysed: &Analysed,
    report: &Report,
    sheet_png: &[u8],
    title: &str,
    failure: Option<&Error>,
) -> Result<Page> {
    let analysis = &analysed.analysis;
    let statistics = Statistics::of(&analysis.shots);
    let [width, height] = analysed.properties.size;
    let mut page = Page::new(title);
    if let Some(failure) = failure {
        page.warning(&format!(
            "The video could not be read to its end: {failure}"
        ));
    }
    page.paragraph(&format!(
        "{} frames of {width} × {height} pixels, {} shots ({} with static, {} with dynamic \
         background), {} key frames.",
        report.frames,
        statistics.shots(),
        statistics.static_shots,
        statistics.dynamic_shots,
        report.key_frames.len()
    ));
    page.svg(&plot::svg(analysis, title)?);
    page.paragraph(&transitions(report));
    page.heading("Shots");
    let rate = analysed.rate();
    let shots = analysis.shots.iter().enumerate();
    let rows = shots.map(|(number, shot)| {
        let frames = &shot.frames;
        [
            (number + 1).to_string(),
            timecode(frames.start, rate),
            timecode(frames.end, rate),
            format!("{}–{}", frames.start, frames.end),
            shot.background.name().to_owned(),
        ]
    });
    page.table(["shot", "from", "to", "frames", "background"], rows);
    page.heading("Key frames");
    page.png("The key frames", sheet_png);
    Ok(page)
}

/// A sentence about the cuts, dissolves and fades; the chart shades the latter two.
fn transitions(report: &Report) -> String {
    let blended = report.blended();
    let shaded = match blended.is_empty() {
        true => String::new(),
        false => format!(" Shaded: {}.", blended.join("; ")),
    };
    let cuts = report.cuts.iter().map(usize::to_string);
    let cuts = match report.cuts.len() {
        0 => "No cuts".into(),
        1..=40 => format!("Cuts at frames {}", cuts.collect::<Vec<_>>().join(", ")),
        count => format!("{count} cuts"),
    };
    format!("{cuts}.{shaded}")
}
