//! `nullcone quality fit`: how well a measure predicts what people say.

use std::path::PathBuf;

use anyhow::{Context as _, Result};
use ga_draw::document::percent;
use ga_files::table::Table;
use ga_video::opinion::evaluation::{Evaluation, Fitted};
use ga_video::opinion::performance::{Bootstrap, Interval, UNFITTED};

use crate::format::Format;
use crate::frame::{Command, Context, Shown, Warning};

/// Fit opinion scores by a measure of quality, and say how well the measure predicts them.
///
/// SCORES.csv has a line of names and the columns objective (the scores of the measure) and
/// subjective (the mean opinion scores), perhaps also deviation (the standard deviation of each
/// mean opinion score). The correlations of the measure itself come first: unfitted PLCC (Pearson),
/// SROCC (Spearman) and KROCC (Kendall). Then logistic curves with four and five parameters are
/// fitted, among those that rise or fall all over the range of the scores (ITU-T P.1401); of the
/// prediction by the curve with five follow the linear correlation (PLCC), the error (RMSE) and the
/// part of outliers. "held_monotone" says that a curve that bends back would fit better. Fewer than
/// 10 scores are warned of, a number that is missing (an empty cell, NA) is an error. Intervals
/// come from the bootstrap.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Arguments {
    /// The scores.
    #[arg(value_name = "SCORES.csv")]
    scores: PathBuf,
    /// Compare with another measure, whose scores stand in this column, and say whether the
    /// difference is significant.
    #[arg(long, value_name = "COLUMN")]
    against: Option<String>,
    /// The confidence of the intervals.
    #[arg(long, value_name = "PART", default_value_t = 0.95)]
    confidence: f64,
    /// How often the scores are drawn again for the intervals.
    #[arg(long, value_name = "N", default_value_t = 1000,
        value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    draws: u32,
    /// The seed of the draws.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Write a picture of the scores with the fitted curves.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

impl Command for Arguments {
    type Report = Shown<Evaluation>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        let mut files = context.files([&self.scores])?;
        files.write_if_given("--plot", self.plot.as_ref(), &[Format::Svg])?;
        let progress = context.progress(4);
        let source = self.scores.display().to_string();
        let table = ga_files::read(&self.scores, Table::with_names)?;
        let bootstrap = Bootstrap {
            confidence: self.confidence,
            draws: self.draws as usize,
            seed: self.seed,
        };
        progress.step("fitting curves");
        let fitted = Fitted::of_column(&table, "objective").with_context(|| source.clone())?;
        progress.step("drawing scores again");
        let mut found = fitted.evaluate(bootstrap)?;
        if let Some(column) = &self.against {
            progress.step("comparing the measures");
            let comparison = fitted.compare(&table, column, &bootstrap);
            found.against = Some(comparison.with_context(|| source.clone())?);
        }
        progress.step("drawing");
        let few = found.too_few().into_iter();
        let few = few.map(|message| Warning::new("few_scores", message));
        let held = found.held_monotone().into_iter();
        let held = held.map(|message| Warning::new("held_monotone", message).into_note());
        let warnings = few.chain(held).collect();
        let text = text(&found);
        let shown = Shown {
            warnings: Some(warnings),
            ..Shown::new(found, text)
        };
        shown.with_plot(
            self.plot.as_ref(),
            context,
            |found| fitted.svg(&found.performance),
            |found, svg| found.page(&source, svg),
        )
    }
}

fn text(found: &Evaluation) -> String {
    let mut text = format!("{} scores\n", found.scores);
    let percent = percent(found.bootstrap.confidence);
    let row = |(name, found): (&str, Interval)| {
        let Interval { value, low, high } = found;
        format!("{name:<14}  {value:>8.4}   {low:.4} to {high:.4}\n")
    };
    let named = found.performance.named();
    let (unfitted, fitted) = named.split_at(UNFITTED);
    text += &format!("{:<14}  {:>8}   {percent} % interval\n", "measure", "value");
    text.extend(unfitted.iter().copied().map(row));
    let curves = [
        ("4 parameters", &found.logistic4),
        ("5 parameters", &found.logistic5),
    ];
    for (name, curve) in curves {
        let parameters: Vec<String> = curve.parameters.iter().map(|p| format!("{p:.6}")).collect();
        text += &format!(
            "logistic curve, {name}: {}; sum of squares {:.6}, PLCC {:.4}\n",
            parameters.join(", "),
            curve.sum_of_squares,
            curve.linear_correlation
        );
    }
    text += &format!(
        "prediction by the curve with {} parameters\n",
        found.logistic5.parameters.len()
    );
    text.extend(fitted.iter().copied().map(row));
    if let Some(against) = &found.against {
        let Interval { value, low, high } = against.difference.linear_correlation;
        text += &format!(
            "against {}: PLCC {:.4}, difference {value:+.4} ({low:+.4} to {high:+.4}), p = {:.3e} \
             by the correlations, {:.3e} by the errors\n",
            against.column,
            against.linear_correlation,
            against.difference.correlation_p_value,
            against.difference.error_p_value
        );
    }
    text
}
