//! The report as a page.

use anyhow::Result;
use ga_video::quality::FrameQuality;

use super::report::{POOLED, PictureReport, Row, VideoReport};
use super::{Arguments, plot};
use ga_draw::document::Page;

/// How many of the frames that differ most are listed.
const WORST: usize = 5;

/// The measures of two pictures, and where they differ.
pub(super) fn of_pictures(arguments: &Arguments, report: &PictureReport, map_png: &[u8]) -> Page {
    let mut page = Page::new(&format!("Quality of {}", arguments.distorted_name()));
    page.paragraph(&format!(
        "Reference: {}. {}",
        arguments.reference.display(),
        attention(arguments)
    ));
    measures(&mut page, &report.rows());
    page.heading("SSIM around each pixel");
    page.paragraph("White: the pictures are alike. Black: they have no structure in common.");
    page.png("A map of SSIM", map_png);
    page
}

/// The measures of two videos over time.
pub(super) fn of_videos(
    arguments: &Arguments,
    report: &VideoReport,
    frames: &[FrameQuality],
) -> Result<Page> {
    let mut page = Page::new(&format!("Quality of {}", arguments.distorted_name()));
    page.paragraph(&format!(
        "{} frames. Reference: {}. {}",
        report.frames,
        arguments.reference.display(),
        attention(arguments)
    ));
    if let Some(error) = &report.error {
        page.warning(&format!(
            "The videos were not compared to their ends: {error}"
        ));
    }
    page.svg(&plot::svg(frames, &arguments.distorted)?);
    page.heading("Means over the frames");
    measures(&mut page, &report.rows());
    page.heading("Distribution over the frames");
    page.paragraph(
        "The harmonic mean, the least value, and the values below which a share of the frames lies.",
    );
    let mut names = POOLED;
    names[0] = "measure";
    page.table(names, report.pooled_rows());
    page.heading("Frames with the least SSIM");
    let mut order: Vec<&FrameQuality> = frames.iter().collect();
    order.sort_by(|a, b| a.luma.ssim.total_cmp(&b.luma.ssim));
    let rows = order.into_iter().take(WORST).map(|frame| {
        let [psnr, attention_psnr] =
            [frame.luma.psnr, frame.luma.attention_psnr].map(|psnr| match psnr.is_finite() {
                true => format!("{psnr:.4}"),
                false => "infinite".to_owned(),
            });
        [
            frame.index.to_string(),
            format!("{:.3}", frame.time_seconds),
            psnr,
            format!("{:.6}", frame.luma.ssim),
            attention_psnr,
            format!("{:.6}", frame.luma.attention_ssim),
        ]
    });
    let names = [
        "frame",
        "time (s)",
        "PSNR (dB)",
        "SSIM",
        "attention PSNR (dB)",
        "attention SSIM",
    ];
    page.table(names, rows);
    Ok(page)
}

fn attention(arguments: &Arguments) -> String {
    match &arguments.attention {
        Some(map) => format!("Attention: the map {}.", map.display()),
        None => "Attention: by contours and motion of the reference.".to_owned(),
    }
}

fn measures(page: &mut Page, rows: &[Row]) {
    let rows = rows.iter().map(|row| [row.name.to_owned(), row.value()]);
    page.table(["measure", "value"], rows);
}
