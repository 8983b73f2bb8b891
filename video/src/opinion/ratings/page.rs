//! The evaluation of ratings as a page.

use ga_draw::document::{Page, percent};

use super::{Evaluation, MeanOpinion};

impl Evaluation {
    /// The page: the charts `svg`, the opinions about each question, agreement and screening.
    /// `source` says where the ratings are from.
    #[must_use]
    pub fn page(&self, source: &str, svg: &str) -> Page {
        let mut page = Page::new("Ratings");
        page.paragraph(&format!(
            "{} raters and {} questions of {source}. Intervals of {} % by Student's t.",
            self.raters,
            self.questions.len(),
            percent(self.confidence)
        ));
        page.svg(svg);
        page.heading("Mean opinion scores");
        let row = |question: &str, group: &str, opinion: &MeanOpinion| {
            let interval = opinion.interval();
            [
                question.to_owned(),
                group.to_owned(),
                format!("{:.3}", opinion.mean),
                interval.map_or_else(String::new, |[low, high]| format!("{low:.3} to {high:.3}")),
                number(opinion.deviation),
                opinion.ratings.to_string(),
            ]
        };
        let questions = &self.questions;
        let rows = questions.iter().flat_map(|question| {
            let groups = question.groups.iter();
            let all = row(&question.question, "all", &question.opinion);
            std::iter::once(all).chain(groups.map(|(group, opinion)| row("", group, opinion)))
        });
        let names = [
            "question",
            "group",
            "mean",
            "interval",
            "standard deviation",
            "ratings",
        ];
        page.table(names, rows);
        if questions.iter().any(|q| !q.differences.is_empty()) {
            page.heading("Differences between groups");
            page.paragraph(
                "p: the probability of a difference as great where there is none (Welch).",
            );
            let rows = questions.iter().flat_map(|question| {
                question.differences.iter().map(|pair| {
                    [
                        question.question.clone(),
                        format!("{} − {}", pair.first, pair.second),
                        format!("{:+.3}", pair.found.difference),
                        number(pair.found.p_value),
                    ]
                })
            });
            page.table(["question", "groups", "difference", "p"], rows);
        }
        page.heading("Agreement of the raters");
        let agreement = &self.agreement;
        let rows = [
            ("Krippendorff's α, interval", agreement.alpha_interval),
            ("Krippendorff's α, ordinal", agreement.alpha_ordinal),
            ("Kendall's W", agreement.concordance),
        ];
        let rows = rows.map(|(name, value)| [name.to_owned(), number(value)]);
        page.table(["coefficient", "value"], rows);
        page.heading("Screening of the raters (ITU-R BT.500)");
        page.paragraph(match self.screened {
            true => "Rejected raters are left out of everything above.",
            false => "Rejected raters are counted in everything above.",
        });
        let rows = self.screening.iter().map(|found| {
            [
                found.rater.clone(),
                found.screening.ratings.to_string(),
                found.screening.above.to_string(),
                found.screening.below.to_string(),
                number(found.screening.correlation),
                if found.screening.is_rejected {
                    "rejected"
                } else {
                    "kept"
                }
                .to_owned(),
            ]
        });
        let names = [
            "rater",
            "ratings",
            "above the limits",
            "below",
            "correlation with the others",
            "outcome",
        ];
        page.table(names, rows);
        page
    }
}

/// A number that may not exist.
fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "none".to_owned(), |value| format!("{value:.3}"))
}
