//! `nullcone quality fit`: how well a measure predicts what people say.

use std::path::PathBuf;

use anyhow::{Context as _, Result};
use ga_draw::document::percent;
use ga_files::table::Table;
use ga_video::opinion::evaluation::{Evaluation, Fitted};
use ga_video::opinion::performance::{Bootstrap, Interval};

use crate::format::Format;
use crate::frame::{Command, Context, Shown};

/// Fit opinion scores by a measure of quality, and say how well the measure predicts them.
///
/// SCORES.csv has a line of names and the columns objective (the scores of the measure) and
/// subjective (the mean opinion scores), perhaps also deviation (the standard deviation of each
/// mean opinion score). Logistic curves with four and five parameters are fitted. Of the prediction
/// by the curve with five follow the linear correlation (PLCC), the error (RMSE) and the part of
/// outliers; the rank correlations SROCC and KROCC need no curve. Intervals come from the
/// bootstrap.
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
        let text = text(&found);
        Shown::new(found, text).with_plot(
            self.plot.as_ref(),
            context,
            |found| fitted.svg(&found.performance),
            |found, svg| found.page(&source, svg),
        )
    }
}

fn text(found: &Evaluation) -> String {
    let mut text = format!("{} scores\n", found.scores);
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
    let percent = percent(found.bootstrap.confidence);
    text += &format!("{:<14}  {:>8}   {percent} % interval\n", "measure", "value");
    for (name, Interval { value, low, high }) in found.performance.named() {
        text += &format!("{name:<14}  {value:>8.4}   {low:.4} to {high:.4}\n");
    }
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
