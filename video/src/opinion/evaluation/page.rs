//! The evaluation of a measure as a page.

use ga_draw::document::{Page, percent};

use super::super::performance::Interval;
use super::Evaluation;

impl Evaluation {
    /// The page: the scores with the curves, which the chart `svg` shows, what the measure is
    /// worth, and the curves. `source` says where the scores are from.
    #[must_use]
    pub fn page(&self, source: &str, svg: &str) -> Page {
        let mut page = Page::new("A measure of quality against opinion scores");
        page.paragraph(&format!(
            "{} scores of {source}. Unfitted PLCC, SROCC and KROCC are those of the measure \
             itself; PLCC, RMSE and the outlier ratio are those of the prediction by the monotone \
             curve with five parameters. Intervals of {} % by the bootstrap: {} draws, \
             seed {}.",
            self.scores,
            percent(self.bootstrap.confidence),
            self.bootstrap.draws,
            self.bootstrap.seed
        ));
        if let Some(warning) = self.too_few() {
            page.warning(&warning);
        }
        for note in self.held_monotone() {
            page.note(&note);
        }
        page.svg(svg);
        page.heading("How well the measure predicts opinions");
        let rows = self.performance.named().map(|(name, found)| {
            let Interval { value, low, high } = found;
            [
                name.to_owned(),
                format!("{value:.4}"),
                format!("{low:.4} to {high:.4}"),
            ]
        });
        page.table(["statistic", "value", "interval"], rows);
        self.add_curves(&mut page);
        self.add_comparison(&mut page);
        page
    }

    fn add_curves(&self, page: &mut Page) {
        page.heading("Curves");
        page.paragraph(
            "4 parameters: β₂ + (β₁ − β₂) / (1 + exp(−(x − β₃) / |β₄|)). 5 parameters: \
             β₁ (½ − 1 / (1 + exp(β₂ (x − β₃)))) + β₄ x + β₅.",
        );
        let curves = [
            ("logistic, 4 parameters", &self.logistic4),
            ("logistic, 5 parameters", &self.logistic5),
        ];
        let rows = curves.map(|(name, curve)| {
            let mut parameters = curve.parameters.iter();
            let [b1, b2, b3, b4, b5] = [(); 5].map(|()| {
                let value = parameters.next();
                value.map_or_else(String::new, |value| format!("{value:.6}"))
            });
            let sum_of_squares = format!("{:.6}", curve.sum_of_squares);
            let correlation = format!("{:.4}", curve.linear_correlation);
            let name = name.to_owned();
            [name, b1, b2, b3, b4, b5, sum_of_squares, correlation]
        });
        let names = [
            "curve",
            "β₁",
            "β₂",
            "β₃",
            "β₄",
            "β₅",
            "sum of squares",
            "PLCC",
        ];
        page.table(names, rows);
    }

    fn add_comparison(&self, page: &mut Page) {
        let Some(against) = &self.against else { return };
        page.heading(&format!("Against the measure {}", against.column));
        let found = &against.difference;
        let rows = [
            ("PLCC", found.linear_correlation),
            ("SROCC", found.spearman),
        ];
        let rows = rows.map(|(name, Interval { value, low, high })| {
            [
                name.to_owned(),
                format!("{value:+.4}"),
                format!("{low:+.4} to {high:+.4}"),
            ]
        });
        page.table(["statistic", "difference", "interval"], rows);
        page.paragraph(&format!(
            "Probability of such differences where the measures are equally good: {:.3e} by the \
             test of Meng, Rosenthal and Rubin for the correlations, {:.3e} by the F test of the \
             errors.",
            found.correlation_p_value, found.error_p_value
        ));
    }
}
