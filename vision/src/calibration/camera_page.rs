//! The calibration of one camera as a page.

use ga_draw::document::{Page, Svg};
use ga_image::png;

use super::board_views::{CameraOfBoards, PARTS};

/// The width of the drawings of the picture, in pixels of the page.
const WIDTH: f64 = 720.0;
/// How long the largest of most differences is drawn, in pixels of the page.
const LONGEST: f64 = 40.0;
/// How many of the worst boards are listed.
const WORST: usize = 10;

impl CameraOfBoards {
    /// The page: parameters with their deviations, the differences of corners over the picture,
    /// where corners are, and the worst boards.
    #[must_use]
    pub fn page(&self) -> Page {
        let mut page = Page::new("Calibration of a camera");
        page.paragraph(&format!(
            "{} boards in pictures of {} × {} pixels; corners are {:.4} px from their projections \
             (root mean square). The lens is {}.",
            self.views.len(),
            self.size[0],
            self.size[1],
            self.camera.rms,
            self.terms
        ));
        for doubt in self.doubts() {
            page.warning(&doubt.to_string());
        }
        page.heading("Parameters");
        let rows = self.parameters().into_iter().map(|parameter| {
            [
                parameter.name.to_owned(),
                format!("{:.6}", parameter.value),
                format!("{:.2e}", parameter.deviation),
            ]
        });
        page.table(["parameter", "value", "standard deviation"], rows);
        page.heading("Lenses that were tried");
        let rows = self.tried.iter().map(|tried| {
            let number = |value: Option<f64>, digits: usize| match value {
                Some(value) => format!("{value:.digits$}"),
                None => "not determined".to_owned(),
            };
            [
                tried.lens.clone(),
                number(tried.rms_px, 4),
                number(tried.schwarz, 1),
            ]
        });
        page.table(["lens", "rms in px", "Schwarz's criterion"], rows);
        page.heading("Residuals over the picture");
        let (svg, factor) = self.residuals();
        page.wide_svg(
            &svg,
            &format!("From each corner towards its projection, {factor:.0} times as long."),
        );
        page.heading("Coverage");
        page.wide_svg(
            &self.covered(),
            &format!(
                "How many corners are in each part of the picture: some in {:.0} % of the parts.",
                self.coverage_percent()
            ),
        );
        page.heading("The worst boards");
        let rows = self.views.iter().take(WORST);
        let rows = rows.map(|view| {
            let points = view.points.to_string();
            [view.picture.clone(), points, format!("{:.4}", view.rms_px)]
        });
        page.table(["picture", "corners", "rms in px"], rows);
        if !self.rejected.is_empty() {
            page.heading("Pictures that were left out");
            let rows = self.rejected.iter();
            page.text_table(
                ["picture", "reason"],
                rows.map(|view| [view.picture.clone(), view.reason.clone()]),
            );
        }
        page
    }

    /// The size of a drawing of the picture, and its scale.
    fn drawing(&self) -> ([f64; 2], f64) {
        let scale = WIDTH / self.size[0] as f64;
        ([WIDTH, self.size[1] as f64 * scale], scale)
    }

    /// The differences of corners, drawn longer by a factor.
    fn residuals(&self) -> (String, f64) {
        let (size, scale) = self.drawing();
        let lengths = self
            .corners
            .iter()
            .map(|it| it.difference[0].hypot(it.difference[1]));
        let mut lengths: Vec<f64> = lengths.collect();
        lengths.sort_by(f64::total_cmp);
        let most = lengths
            .get(lengths.len() * 95 / 100)
            .copied()
            .unwrap_or(0.0);
        let factor = match most > 0.0 {
            true => LONGEST / (scale * most),
            false => 1.0,
        };
        let mut svg = Svg::new(size, "residuals of corners over the picture");
        svg.rectangle([0.0; 2], size, "fill=\"#fff\" stroke=\"#889\"");
        if let Some(Ok(bytes)) = self.picture.as_ref().map(png::encode) {
            svg.picture([0.0; 2], size, ("png", &bytes), "opacity=\"0.35\"");
        }
        for it in &self.corners {
            let from = it.corner.map(|x| (x + 0.5) * scale);
            let to = [0, 1].map(|k| from[k] + it.difference[k] * scale * factor);
            svg.line(from, to, "stroke=\"#d55e00\" stroke-width=\"1\"");
            svg.circle(from, 1.2, "fill=\"#0072b2\"");
        }
        (svg.into_text(), factor)
    }

    /// The number of corners in each part of the picture.
    fn covered(&self) -> String {
        let (size, scale) = self.drawing();
        let counts = self.coverage();
        let most = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
        let cell = [0, 1].map(|k| size[k] / PARTS[k] as f64);
        let mut svg = Svg::new(size, "corners in each part of the picture");
        for (index, count) in counts.into_iter().enumerate() {
            let [column, row] = [index % PARTS[0], index / PARTS[0]];
            let place = [column as f64 * cell[0], row as f64 * cell[1]];
            let opacity = 0.75 * count as f64 / most;
            let fill = format!("fill=\"#0072b2\" fill-opacity=\"{opacity:.3}\" stroke=\"#dde\"");
            svg.rectangle(place, cell, &fill);
            let text = [place[0] + 5.0, place[1] + 15.0];
            let anchor = ga_draw::document::Anchor::Start;
            svg.text(text, 12.0, anchor, "fill=\"#223\"", &count.to_string());
        }
        for it in &self.corners {
            svg.circle(
                it.corner.map(|x| (x + 0.5) * scale),
                0.8,
                "fill=\"#d55e00\"",
            );
        }
        svg.into_text()
    }
}
