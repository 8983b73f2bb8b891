//! `nullcone quality ratings`: what people say about a video.

mod arguments;
mod classes;
mod page;
mod plot;
mod report;
mod table;

pub(crate) use arguments::Arguments;

use std::collections::BTreeMap;

use anyhow::{Context as _, Result};
use ga_video::opinion::ratings::{MeanOpinion, Ratings};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::output;
use ga_draw::document::Page;
use report::{
    AgreementReport, DifferenceReport, OpinionReport, QuestionReport, Report, ScreeningReport,
    number,
};

impl Command for Arguments {
    type Report = Shown;

    fn run(&self, context: &Context) -> Result<Shown> {
        rate(self, context)
    }
}

/// What was found, and its page.
#[derive(Serialize)]
pub(crate) struct Shown {
    #[serde(flatten)]
    report: Report,
    #[serde(skip)]
    page: Option<Page>,
}

impl frame::Report for Shown {
    fn text(&self) -> String {
        text(&self.report)
    }

    fn page(&self) -> Option<Page> {
        self.page.clone()
    }
}

fn rate(arguments: &Arguments, context: &Context) -> Result<Shown> {
    let mut files = context.files([&arguments.table])?;
    files.write_if_given("--plot", arguments.plot.as_ref(), &[Format::Svg])?;
    let path = &arguments.table;
    let bytes = std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let all = table::parse(&bytes).with_context(|| path.display().to_string())?;
    let screening = all.screening();
    let rejected: Vec<usize> = (0..screening.len())
        .filter(|rater| screening[*rater].is_rejected)
        .collect();
    let ratings = match arguments.screen {
        true => all.without(&rejected)?,
        false => all.clone(),
    };
    let questions = (0..ratings.questions().len())
        .map(|question| question_report(&ratings, question, arguments.confidence))
        .collect::<Result<Vec<_>>>()?;
    let agreement = ratings.agreement();
    let name = |rater: usize| all.raters()[rater].name.clone();
    let report = Report {
        raters: ratings.raters().len(),
        questions,
        agreement: AgreementReport {
            krippendorff_alpha_interval: agreement.alpha_interval,
            krippendorff_alpha_ordinal: agreement.alpha_ordinal,
            kendall_w: agreement.concordance,
        },
        screening: screening
            .iter()
            .enumerate()
            .map(|(rater, found)| ScreeningReport {
                rater: name(rater),
                above: found.above,
                below: found.below,
                ratings: found.ratings,
                correlation: found.correlation,
                rejected: found.is_rejected,
            })
            .collect(),
        rejected: rejected.iter().map(|rater| name(*rater)).collect(),
        screened: arguments.screen,
        confidence: arguments.confidence,
    };
    let with_page = context.report().is_some();
    let mut page = None;
    if arguments.plot.is_some() || with_page {
        let svg = plot::svg(&ratings, arguments.confidence)?;
        page = with_page.then(|| page::of(arguments, &report, &svg));
        if let Some(path) = &arguments.plot {
            output::write(path, svg.as_bytes())?;
        }
    }
    Ok(Shown { report, page })
}

fn question_report(ratings: &Ratings, question: usize, confidence: f64) -> Result<QuestionReport> {
    let opinion = |group| ratings.mean_opinion(question, group, confidence);
    let mut counts = BTreeMap::new();
    for rating in ratings.of_question(question, None) {
        *counts.entry(rating.to_string()).or_default() += 1;
    }
    let names = ratings.groups();
    let (mut groups, mut differences) = (BTreeMap::new(), Vec::new());
    for (place, first) in names.iter().enumerate() {
        if ratings.of_question(question, Some(first)).is_empty() {
            continue;
        }
        groups.insert((*first).to_owned(), opinion_report(opinion(Some(first))?));
        for second in &names[place + 1..] {
            if let Some(found) = ratings.group_difference(question, [first, second]) {
                differences.push(DifferenceReport {
                    first: (*first).to_owned(),
                    second: (*second).to_owned(),
                    difference: found.difference,
                    p_value: found.p_value,
                });
            }
        }
    }
    Ok(QuestionReport {
        question: ratings.questions()[question].clone(),
        opinion: opinion_report(opinion(None)?),
        counts,
        groups,
        differences,
    })
}

fn opinion_report(opinion: MeanOpinion) -> OpinionReport {
    let mean = opinion.mean;
    OpinionReport {
        mean_opinion_score: mean,
        interval: opinion.half_width.map(|half| [mean - half, mean + half]),
        standard_deviation: opinion.deviation,
        ratings: opinion.ratings,
    }
}

fn text(report: &Report) -> String {
    let opinion = |o: &OpinionReport| match o.interval {
        Some([low, high]) => format!("{:.2} ({low:.2} to {high:.2})", o.mean_opinion_score),
        None => format!("{:.2}", o.mean_opinion_score),
    };
    let mut text = format!("{} raters\n", report.raters);
    for question in &report.questions {
        text += &format!("{}: {}", question.question, opinion(&question.opinion));
        for (group, found) in &question.groups {
            text += &format!("; {group} {}", opinion(found));
        }
        for difference in &question.differences {
            let DifferenceReport { first, second, .. } = difference;
            if let Some(p) = difference.p_value {
                text += &format!("; {first} against {second}: p = {p:.3}");
            }
        }
        text.push('\n');
    }
    text += &format!(
        "agreement: Krippendorff's alpha {} (interval), {} (ordinal), Kendall's W {}\n",
        number(report.agreement.krippendorff_alpha_interval),
        number(report.agreement.krippendorff_alpha_ordinal),
        number(report.agreement.kendall_w)
    );
    let rejected = match report.rejected.as_slice() {
        [] => "none".to_owned(),
        names => names.join(", "),
    };
    let done = if report.screened { "left out" } else { "found" };
    text + &format!("raters without order {done} (ITU-R BT.500): {rejected}\n")
}
