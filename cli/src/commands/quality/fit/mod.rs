//! `nullcone quality fit`: how well a measure predicts what people say.

mod arguments;
mod page;
mod plot;
mod report;

pub(crate) use arguments::Arguments;

use anyhow::{Context as _, Result};
use ga_files::table::Table;
use ga_video::opinion::Scores;
use ga_video::opinion::logistic::{Curve, Fit, Logistic4, Logistic5};
use ga_video::opinion::performance::{self, Bootstrap, Interval};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::output;
use ga_draw::document::Page;
use report::{AgainstReport, CurveReport, Report};

impl Command for Arguments {
    type Report = Shown;

    fn run(&self, context: &Context) -> Result<Shown> {
        fit(self, context)
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

fn fit(arguments: &Arguments, context: &Context) -> Result<Shown> {
    let mut files = context.files([&arguments.scores])?;
    files.write_if_given("--plot", arguments.plot.as_ref(), &[Format::Svg])?;
    let progress = context.progress(4);
    let path = &arguments.scores;
    let bytes = std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let table = Table::with_names(&bytes).with_context(|| path.display().to_string())?;
    let scores = scores(&table, "objective").with_context(|| path.display().to_string())?;
    let bootstrap = Bootstrap {
        draws: arguments.draws as usize,
        confidence: arguments.confidence,
        seed: arguments.seed,
    };
    progress.step("fitting curves");
    let four = Logistic4::fit(&scores).with_context(|| path.display().to_string())?;
    let five = Logistic5::fit(&scores).with_context(|| path.display().to_string())?;
    progress.step("drawing scores again");
    let found = performance::with_intervals(&scores, &five, &bootstrap)?;
    progress.step("comparing the measures");
    let against = arguments.against.as_deref();
    let against = against.map(|column| compare(&table, column, (&scores, &five), &bootstrap));
    let against = against
        .transpose()
        .with_context(|| path.display().to_string())?;
    let report = Report {
        scores: scores.len(),
        logistic4: curve_report(&scores, &four, &four.curve.parameters),
        logistic5: curve_report(&scores, &five, &five.curve.parameters),
        plcc: found.linear_correlation.value,
        plcc_interval: ends(found.linear_correlation),
        srocc: found.spearman.value,
        srocc_interval: ends(found.spearman),
        krocc: found.kendall.value,
        krocc_interval: ends(found.kendall),
        rmse: found.root_mean_square_error.value,
        rmse_interval: ends(found.root_mean_square_error),
        outlier_ratio: found.outlier_ratio.value,
        outlier_ratio_interval: ends(found.outlier_ratio),
        confidence: arguments.confidence,
        draws: arguments.draws,
        seed: arguments.seed,
        against,
    };
    let with_page = context.report().is_some();
    let mut page = None;
    if arguments.plot.is_some() || with_page {
        progress.step("drawing");
        let svg = plot::svg(&scores, &four.curve, &five.curve, &found)?;
        page = with_page.then(|| page::of(arguments, &report, &svg));
        if let Some(path) = &arguments.plot {
            output::write(path, svg.as_bytes())?;
        }
    }
    Ok(Shown { report, page })
}

fn scores(table: &Table, objective: &str) -> Result<Scores> {
    let scores = Scores::new(table.numbers(objective)?, table.numbers("subjective")?)?;
    Ok(match table.column("deviation").is_some() {
        true => scores.with_deviations(table.numbers("deviation")?)?,
        false => scores,
    })
}

fn compare(
    table: &Table,
    column: &str,
    (scores, fit): (&Scores, &Fit<Logistic5>),
    bootstrap: &Bootstrap,
) -> Result<AgainstReport> {
    let other = self::scores(table, column)?;
    let other_fit = Logistic5::fit(&other)?;
    let found = performance::difference([scores, &other], [fit, &other_fit], bootstrap)?;
    Ok(AgainstReport {
        column: column.to_owned(),
        plcc: performance::of(&other, &other_fit).linear_correlation,
        plcc_difference: found.linear_correlation.value,
        plcc_difference_interval: ends(found.linear_correlation),
        srocc_difference: found.spearman.value,
        srocc_difference_interval: ends(found.spearman),
        correlation_p_value: found.correlation_p_value,
        error_p_value: found.error_p_value,
    })
}

fn curve_report<C: Curve>(scores: &Scores, fit: &Fit<C>, parameters: &[f64]) -> CurveReport {
    let found = performance::of(scores, fit);
    CurveReport {
        parameters: parameters.to_vec(),
        sse: fit.sum_of_squares,
        plcc: found.linear_correlation,
        rmse: found.root_mean_square_error,
        outlier_ratio: found.outlier_ratio,
    }
}

fn ends(interval: Interval) -> [f64; 2] {
    [interval.low, interval.high]
}

fn text(report: &Report) -> String {
    let mut text = format!("{} scores\n", report.scores);
    for (name, curve) in [
        ("4 parameters", &report.logistic4),
        ("5 parameters", &report.logistic5),
    ] {
        let parameters: Vec<String> = curve.parameters.iter().map(|p| format!("{p:.6}")).collect();
        let parameters = parameters.join(", ");
        text += &format!(
            "logistic curve, {name}: {parameters}; sum of squares {:.6}, PLCC {:.4}\n",
            curve.sse, curve.plcc
        );
    }
    let percent = output::percent(report.confidence);
    text += &format!("{:<14}  {:>8}   {percent} % interval\n", "measure", "value");
    for (name, value, [low, high]) in report.measures() {
        text += &format!("{name:<14}  {value:>8.4}   {low:.4} to {high:.4}\n");
    }
    if let Some(against) = &report.against {
        let [low, high] = against.plcc_difference_interval;
        text += &format!(
            "against {}: PLCC {:.4}, difference {:+.4} ({low:+.4} to {high:+.4}), p = {:.3e} by \
             the correlations, {:.3e} by the errors\n",
            against.column,
            against.plcc,
            against.plcc_difference,
            against.correlation_p_value,
            against.error_p_value
        );
    }
    text
}
