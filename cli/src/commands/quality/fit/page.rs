//! The report as a page.

use super::Arguments;
use super::report::Report;
use crate::output::percent;
use ga_draw::document::Page;

/// The scores with the curves, what the measure is worth, and the curves.
pub(super) fn of(arguments: &Arguments, report: &Report, svg: &str) -> Page {
    let mut page = Page::new("A measure of quality against opinion scores");
    page.paragraph(&format!(
        "{} scores of {}. PLCC, RMSE and the outlier ratio are those of the prediction by the \
         curve with five parameters. Intervals of {} % by the bootstrap: {} draws, seed {}.",
        report.scores,
        arguments.scores.display(),
        percent(report.confidence),
        report.draws,
        report.seed
    ));
    page.svg(svg);
    page.heading("How well the measure predicts opinions");
    let number = |value: f64| format!("{value:.4}");
    let rows = report.measures().map(|(name, value, [low, high])| {
        let interval = format!("{low:.4} to {high:.4}");
        [name.to_owned(), number(value), interval]
    });
    page.table(["statistic", "value", "interval"], rows);
    page.heading("Curves");
    page.paragraph(
        "4 parameters: β₂ + (β₁ − β₂) / (1 + exp(−(x − β₃) / |β₄|)). 5 parameters: \
         β₁ (½ − 1 / (1 + exp(β₂ (x − β₃)))) + β₄ x + β₅.",
    );
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
    let curves = [
        ("logistic, 4 parameters", &report.logistic4),
        ("logistic, 5 parameters", &report.logistic5),
    ];
    let rows = curves.map(|(name, curve)| {
        let parameter = |k: usize| {
            let value = curve.parameters.get(k);
            value.map_or_else(String::new, |value| format!("{value:.6}"))
        };
        [
            name.to_owned(),
            parameter(0),
            parameter(1),
            parameter(2),
            parameter(3),
            parameter(4),
            format!("{:.6}", curve.sse),
            number(curve.plcc),
        ]
    });
    page.table(names, rows);
    if let Some(against) = &report.against {
        page.heading(&format!("Against the measure {}", against.column));
        let signed = |value: f64| format!("{value:+.4}");
        let row = |name: &str, value: f64, [low, high]: [f64; 2]| {
            let interval = format!("{low:+.4} to {high:+.4}");
            [name.to_owned(), signed(value), interval]
        };
        let rows = [
            row(
                "PLCC",
                against.plcc_difference,
                against.plcc_difference_interval,
            ),
            row(
                "SROCC",
                against.srocc_difference,
                against.srocc_difference_interval,
            ),
        ];
        page.table(["statistic", "difference", "interval"], rows);
        page.paragraph(&format!(
            "Probability of such differences where the measures are equally good: {:.3e} by the \
             test of Meng, Rosenthal and Rubin for the correlations, {:.3e} by the F test of the \
             errors.",
            against.correlation_p_value, against.error_p_value
        ));
    }
    page
}
