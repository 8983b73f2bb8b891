//! The report as a page.

use super::Arguments;
use super::report::{OpinionReport, Report, number};
use crate::output::percent;
use ga_draw::document::Page;

/// The charts, the opinions about each question, agreement and screening.
pub(super) fn of(arguments: &Arguments, report: &Report, svg: &str) -> Page {
    let mut page = Page::new("Ratings");
    page.paragraph(&format!(
        "{} raters and {} questions of {}. Intervals of {} % by Student's t.",
        report.raters,
        report.questions.len(),
        arguments.table.display(),
        percent(report.confidence)
    ));
    page.svg(svg);
    page.heading("Mean opinion scores");
    let row = |question: &str, group: &str, opinion: &OpinionReport| {
        let interval = opinion.interval;
        [
            question.to_owned(),
            group.to_owned(),
            format!("{:.3}", opinion.mean_opinion_score),
            interval.map_or_else(String::new, |[low, high]| format!("{low:.3} to {high:.3}")),
            number(opinion.standard_deviation),
            opinion.ratings.to_string(),
        ]
    };
    let questions = &report.questions;
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
        page.paragraph("p: the probability of a difference as great where there is none (Welch).");
        let rows = questions.iter().flat_map(|question| {
            question.differences.iter().map(|found| {
                [
                    question.question.clone(),
                    format!("{} − {}", found.first, found.second),
                    format!("{:+.3}", found.difference),
                    number(found.p_value),
                ]
            })
        });
        page.table(["question", "groups", "difference", "p"], rows);
    }
    page.heading("Agreement of the raters");
    let agreement = &report.agreement;
    let rows = [
        (
            "Krippendorff's α, interval",
            agreement.krippendorff_alpha_interval,
        ),
        (
            "Krippendorff's α, ordinal",
            agreement.krippendorff_alpha_ordinal,
        ),
        ("Kendall's W", agreement.kendall_w),
    ];
    let rows = rows.map(|(name, value)| [name.to_owned(), number(value)]);
    page.table(["coefficient", "value"], rows);
    page.heading("Screening of the raters (ITU-R BT.500)");
    page.paragraph(match report.screened {
        true => "Rejected raters are left out of everything above.",
        false => "Rejected raters are counted in everything above.",
    });
    let rows = report.screening.iter().map(|found| {
        [
            found.rater.clone(),
            found.ratings.to_string(),
            found.above.to_string(),
            found.below.to_string(),
            number(found.correlation),
            if found.rejected { "rejected" } else { "kept" }.to_owned(),
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
