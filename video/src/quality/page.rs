//! The measures as a page.

use std::path::Path;

use ga_draw::document::Page;
use ga_image::file::FormatError;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::png;

use super::entry::{INFINITE, MeasureRow};
use super::report::{POOLED, PictureQuality, VideoQuality};
use super::video::FrameQuality;

/// What the page says of the files besides measurements.
#[derive(Clone, Copy, Debug)]
pub struct ComparedFiles<'a> {
    /// The reference.
    pub reference: &'a Path,
    /// What is measured.
    pub distorted: &'a Path,
    /// The map of weights, where one was given.
    pub map: Option<&'a Path>,
    /// What the reader should know of the comparison.
    pub notes: &'a [String],
}

/// How many of the frames that differ most are listed.
const WORST: usize = 5;

impl ComparedFiles<'_> {
    /// The last part of the path of what is measured.
    #[must_use]
    pub fn name(&self) -> String {
        ga_files::name(self.distorted)
    }

    fn page(&self, start: &str) -> Page {
        let mut page = Page::new(&format!("Quality of {}", self.name()));
        let attention = match self.map {
            Some(map) => format!("the map {}", map.display()),
            None => "by contours and motion of the reference".to_owned(),
        };
        page.paragraph(&format!(
            "{start}Reference: {}. Attention: {attention}.",
            self.reference.display()
        ));
        for note in self.notes {
            page.note(note);
        }
        page
    }
}

impl PictureQuality {
    /// The page: the measures of two pictures, the reference first, both pictures, and where they
    /// differ, by their [`similarity_map`](super::similarity_map).
    ///
    /// # Errors
    ///
    /// A picture cannot be encoded.
    pub fn page(
        &self,
        files: ComparedFiles,
        pictures: [&Picture; 2],
        similarity: &Plane<u8>,
    ) -> Result<Page, FormatError> {
        let mut page = files.page("");
        add_measures(&mut page, &self.rows());
        page.heading("The pictures, and SSIM around each pixel");
        let [reference, distorted] = pictures.map(|picture| png::encode(&picture.to_rgb::<u8>()));
        page.pictures([
            ("The reference", &reference?[..]),
            (&files.name(), &distorted?),
            (
                "SSIM. White: the pictures are alike. Black: they have no structure in common.",
                &png::encode(similarity)?,
            ),
        ]);
        Ok(page)
    }
}

impl VideoQuality {
    /// The page: the measures of two videos over time, with their [chart](super::svg).
    #[must_use]
    pub fn page(&self, files: ComparedFiles, frames: &[FrameQuality], svg: &str) -> Page {
        let mut page = files.page(&format!("{} frames. ", self.frames));
        if let Some(error) = &self.error {
            page.warning(&format!(
                "The videos were not compared to their ends: {error}"
            ));
        }
        page.svg(svg);
        page.heading("Means over the frames");
        page.paragraph(
            "PSNR of mean MSE is that of the mean of the squared errors of all frames. It is finite \
             unless all are identical; the mean of PSNRs is infinite where one is.",
        );
        add_measures(&mut page, &self.rows());
        page.heading("Distribution over the frames");
        page.paragraph(
            "The harmonic mean, the least value, and the values below which a share of the frames \
             lies.",
        );
        let [a, b, c, d, e, f, g] = POOLED;
        let rows = self.pooled_rows().into_iter().map(|(name, numbers)| {
            let [a, b, c, d, e, f, g] = numbers;
            [name.to_owned(), a, b, c, d, e, f, g]
        });
        page.table(["measure", a, b, c, d, e, f, g], rows);
        page.heading("Frames with the least SSIM, or PSNR where there is none");
        add_worst(&mut page, frames);
        page
    }
}

fn add_worst(page: &mut Page, frames: &[FrameQuality]) {
    let decibels = |psnr: f64| match psnr.is_finite() {
        true => format!("{psnr:.4}"),
        false => INFINITE.to_owned(),
    };
    let mut order: Vec<&FrameQuality> = frames.iter().collect();
    let place = |frame: &FrameQuality| frame.luma.ssim.unwrap_or(frame.luma.psnr);
    order.sort_by(|a, b| place(a).total_cmp(&place(b)));
    let index = |ssim: Option<f64>| ssim.map_or("none".to_owned(), |ssim| format!("{ssim:.6}"));
    let rows = order.into_iter().take(WORST).map(|frame| {
        [
            frame.index.to_string(),
            format!("{:.3}", frame.time_seconds),
            decibels(frame.luma.psnr),
            index(frame.luma.ssim),
            decibels(frame.luma.attention_psnr),
            index(frame.luma.attention_ssim),
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
}

fn add_measures(page: &mut Page, rows: &[MeasureRow]) {
    let rows = rows
        .iter()
        .map(|row| [row.name.clone(), format!("{}{}", row.number, row.remark)]);
    page.table(["measure", "value"], rows);
}
