//! The report as a page that needs no other file.

use std::fmt::Write;

use anyhow::Result;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;

use super::input::Analysed;
use super::plot;
use super::report::Report;
use ga_vision::keyframe::scenes::timecode;
use ga_vision::keyframe::statistics::Statistics;

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:1040px;margin:2em auto;\
    padding:0 1em;color:#2c3440;background:#fafafc}table{border-collapse:collapse}\
    td,th{padding:.2em .9em;text-align:right;border-bottom:1px solid #dde}\
    svg,img{max-width:100%;height:auto}";

/// The page: counts, the curves, the shots and the key frames.
pub(super) fn html(
    analysed: &Analysed,
    report: &Report,
    sheet_png: &[u8],
    title: &str,
) -> Result<String> {
    let analysis = &analysed.analysis;
    let statistics = Statistics::of(&analysis.shots);
    let [width, height] = analysed.properties.size;
    let name = escaped(title);
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{name}</title>\
         <style>{STYLE}</style></head><body>\n<h1>{name}</h1>\n<p>{} frames of {width} × {height} \
         pixels, {} shots ({} with static, {} with dynamic background), {} key frames.</p>\n",
        report.frames,
        statistics.shots(),
        statistics.static_shots,
        statistics.dynamic_shots,
        report.key_frames.len()
    );
    page += &plot::svg(analysis, title)?;
    page += &transitions(report);
    page += "\n<h2>Shots</h2>\n<table><tr><th>shot</th><th>from</th><th>to</th><th>frames</th>\
             <th>background</th></tr>\n";
    let rate = analysed.rate();
    for (number, shot) in analysis.shots.iter().enumerate() {
        // Writing to a string does not fail.
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}–{}</td><td>{}</td></tr>",
            number + 1,
            timecode(shot.frames.start, rate),
            timecode(shot.frames.end, rate),
            shot.frames.start,
            shot.frames.end,
            shot.background.name()
        );
    }
    let _ = write!(
        page,
        "</table>\n<h2>Key frames</h2>\n<img alt=\"The key frames\" \
         src=\"data:image/png;base64,{}\">\n</body></html>\n",
        BASE64_STANDARD.encode(sheet_png)
    );
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
    format!("\n<p>{cuts}.{shaded}</p>")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}
