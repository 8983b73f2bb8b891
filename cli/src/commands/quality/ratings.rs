//! `nullcone quality ratings`: what people say about a video.

use std::path::PathBuf;

use anyhow::Result;
use ga_files::table::Table;
use ga_video::opinion::OpinionError;
use ga_video::opinion::ratings::{Evaluation, MeanOpinion, Ratings, Rows};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{Command, Context, Shown};

/// Evaluate a table of ratings: mean opinion scores with intervals, groups, agreement, screening.
///
/// TABLE.csv has a line of names, and a row for each rater and a column for each clip or question,
/// or the other way round. The name of its first column says which: rater, observer, subject,
/// participant and the like for rows of raters; clip, stimulus, video, image, pvs, src and the like
/// for rows of clips. Where it says neither, --rows does. Of rows of raters, a column group, such
/// as expert and lay, is compared by the test of Welch. A rating may be missing (an empty cell,
/// NA). Raters who answer without order are found by the rule of ITU-R BT.500; with --screen they
/// are left out.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Arguments {
    /// The ratings.
    #[arg(value_name = "TABLE.csv")]
    table: PathBuf,
    /// What the rows are, where the first column does not say it or says it wrongly.
    #[arg(long, value_name = "KIND", value_enum)]
    rows: Option<RowsArgument>,
    /// The confidence of the intervals.
    #[arg(long, value_name = "PART", default_value_t = 0.95)]
    confidence: f64,
    /// Leave out the raters who are rejected by the screening.
    #[arg(long)]
    screen: bool,
    /// Write a picture of the opinions and of how many people gave which rating.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum RowsArgument {
    Raters,
    Stimuli,
}

/// The evaluation, and how the table was read.
#[derive(Serialize)]
pub(super) struct Evaluated {
    rows: Rows,
    #[serde(flatten)]
    evaluation: Evaluation,
}

impl Command for Arguments {
    type Report = Shown<Evaluated>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        let mut files = context.files([&self.table])?;
        files.write_if_given("--plot", self.plot.as_ref(), &[Format::Svg])?;
        let (rows, ratings) = ga_files::read(&self.table, |bytes| self.read(bytes))?;
        let evaluation = ratings.evaluate(self.confidence, self.screen)?;
        let kind = match rows {
            Rows::Raters => "raters",
            Rows::Stimuli => "stimuli",
        };
        let text = text(&evaluation, kind);
        let source = format!("{}, whose rows are {kind}", self.table.display());
        Shown::new(Evaluated { rows, evaluation }, text).with_plot(
            self.plot.as_ref(),
            context,
            |found| found.evaluation.svg(),
            |found, svg| found.evaluation.page(&source, svg),
        )
    }
}

impl Arguments {
    fn read(&self, bytes: &[u8]) -> Result<(Rows, Ratings), OpinionError> {
        let table = Table::with_names(bytes)?;
        let rows = match self.rows {
            Some(RowsArgument::Raters) => Rows::Raters,
            Some(RowsArgument::Stimuli) => Rows::Stimuli,
            None => Rows::of(&table)?,
        };
        Ok((rows, Ratings::of_table(&table, rows)?))
    }
}

fn text(found: &Evaluation, rows: &str) -> String {
    let opinion = |opinion: &MeanOpinion| match opinion.interval() {
        Some([low, high]) => format!("{:.2} ({low:.2} to {high:.2})", opinion.mean),
        None => format!("{:.2}", opinion.mean),
    };
    let mut text = format!("{} raters; the rows are {rows}\n", found.raters);
    for question in &found.questions {
        text += &format!("{}: {}", question.question, opinion(&question.opinion));
        for (group, found) in &question.groups {
            text += &format!("; {group} {}", opinion(found));
        }
        for pair in &question.differences {
            if let Some(p) = pair.found.p_value {
                text += &format!("; {} against {}: p = {p:.3}", pair.first, pair.second);
            }
        }
        text.push('\n');
    }
    let number =
        |value: Option<f64>| value.map_or("none".to_owned(), |value| format!("{value:.3}"));
    text += &format!(
        "agreement: Krippendorff's alpha {} (interval), {} (ordinal), Kendall's W {}\n",
        number(found.agreement.alpha_interval),
        number(found.agreement.alpha_ordinal),
        number(found.agreement.concordance)
    );
    let rejected = match found.rejected.as_slice() {
        [] => "none".to_owned(),
        names => names.join(", "),
    };
    let done = if found.screened { "left out" } else { "found" };
    text + &format!("raters without order {done} (ITU-R BT.500): {rejected}\n")
}
