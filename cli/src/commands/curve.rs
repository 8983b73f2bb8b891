//! `nullcone curve`: a smooth curve through the keys of a table.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use ga_anim::curve::table::KeyTable;
use ga_anim::curve::{ChannelEnds, Distance, SampledTable, Sampling};
use ga_draw::document::{LineChart, Series};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::output::Staging;

/// More rows than this are taken for a mistake.
const MOST_ROWS: usize = 10_000_000;

/// Draw a smooth curve through keys.
///
/// KEYS.csv has a column of rising times and a column for each channel, and perhaps a first line
/// with their names. Through each channel goes a cubic spline with two continuous derivatives. It
/// is written at equal steps of time, or at as few vertices as keep the straight lines between them
/// within a tolerance of the curve, which is proven, not sampled.
///
/// At least one of --out, --plot, --json and --report says what is made of it. --json prints
/// {"keys": …, "channels": […], "ends": …, "first_time": …, "last_time": …, "rows": …,
/// "tolerance": …, "distance": …, "max_deviation": …}, in the units of the table.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The keys: a column of times, then the channels.
    #[arg(value_name = "KEYS.csv")]
    keys: PathBuf,
    /// The conditions at the ends: natural (no curvature), clamped (slope 0), slopes:A,B (the
    /// slopes at the start and at the end, for all channels, or all slopes at the start and then
    /// all at the end), not-a-knot (the first two pieces are one polynomial, and the last two), or
    /// periodic.
    #[arg(long, default_value = "natural", allow_hyphen_values = true)]
    ends: ChannelEnds,
    /// Write this many rows at equal steps of time, from the first key to the last [default: 1000
    /// without --tolerance].
    #[arg(long, value_name = "N", conflicts_with = "tolerance")]
    samples: Option<usize>,
    /// Write the vertices of a polyline that stays within this distance of the curve.
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    tolerance: Option<f64>,
    /// The distance that the tolerance bounds: between the paths of the channels together, or
    /// between curve and polyline at the same time [default: equal-time for one channel, geometric
    /// for more].
    #[arg(long, value_name = "WHICH", requires = "tolerance", value_parser = distance())]
    distance: Option<Distance>,
    /// Write the rows, times first, as CSV.
    #[arg(long, value_name = "FILE.csv")]
    out: Option<PathBuf>,
    /// Write a picture of the channels over time with the keys as dots.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

fn distance() -> impl TypedValueParser<Value = Distance> {
    let words = PossibleValuesParser::new(["geometric", "equal-time"]);
    words.map(|word| match word.as_str() {
        "equal-time" => Distance::EqualTime,
        _ => Distance::Geometric,
    })
}

/// What is printed.
#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    out: Option<String>,
    #[serde(skip)]
    plot: Option<String>,
    #[serde(flatten)]
    sampled: SampledTable,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        if let Some(samples) = self.samples {
            ensure!(
                (2..=MOST_ROWS).contains(&samples),
                "--samples {samples}: from 2 to {MOST_ROWS} rows can be written"
            );
        }
        if let Some(tolerance) = self.tolerance {
            ensure!(
                tolerance.is_finite() && tolerance > 0.0,
                "--tolerance {tolerance}: it must be above 0"
            );
        }
        let is_asked = self.out.is_some() || self.plot.is_some();
        context.need_result(is_asked, "--out, --plot")?;
        let mut files = context.files([&self.keys])?;
        files.write_if_given("--out", self.out.as_ref(), &[Format::Csv])?;
        files.write_if_given("--plot", self.plot.as_ref(), &[Format::Svg])?;
        let progress = context.progress(3);
        progress.step("reading");
        let table = ga_files::read(&self.keys, KeyTable::decode)?;
        progress.step("fitting");
        let sampling = match self.tolerance {
            Some(tolerance) => Sampling::Within {
                tolerance,
                distance: self.distance,
                most: MOST_ROWS,
            },
            None => Sampling::Even(self.samples.unwrap_or(1000)),
        };
        let sampled = SampledTable::new(&table, &self.ends, sampling)
            .with_context(|| self.keys.display().to_string())?;
        progress.step("writing");
        self.write(&table, &sampled, context.outputs())?;
        let shown = |path: &Option<PathBuf>| path.as_ref().map(|path| path.display().to_string());
        Ok(Report {
            out: shown(&self.out),
            plot: shown(&self.plot),
            sampled,
        })
    }
}

impl Arguments {
    /// Writes the table and the picture that are asked for.
    fn write(&self, table: &KeyTable, sampled: &SampledTable, outputs: &Staging) -> Result<()> {
        if let Some(path) = &self.plot {
            let svg = self
                .picture(table, sampled)
                .with_context(|| format!("cannot draw {}", path.display()))?;
            outputs.write(path, svg)?;
        }
        if let Some(path) = &self.out {
            outputs.write(path, table.with_rows(&sampled.times, &sampled.values))?;
        }
        Ok(())
    }

    /// The channels over time as SVG, with the vertices of a polyline unless they hide the curve.
    fn picture(&self, table: &KeyTable, sampled: &SampledTable) -> Result<String> {
        const HEIGHT: f64 = 560.0;
        const MOST_VERTICES: usize = 400;
        let (name, keys) = (ga_files::name(&self.keys), &table.times);
        let ends = match &self.ends {
            ChannelEnds::Slopes(_) => "given slopes at the ends".to_owned(),
            other => format!("{other} ends"),
        };
        let is_marked = sampled.tolerance.is_some() && sampled.rows <= MOST_VERTICES;
        let vertices = sampled.times.iter().zip(&sampled.values);
        let vertices = vertices.filter(|_| is_marked);
        let series = sampled.curves.iter().enumerate().map(|(channel, curve)| {
            let ring = |(&time, values): (&f64, &Vec<f64>)| (time, values[channel]);
            let values = table.channels[channel].iter().copied();
            Series {
                name: sampled.channels[channel].clone(),
                line: curve.drawn(HEIGHT),
                dots: keys.iter().copied().zip(values).collect(),
                rings: vertices.clone().map(ring).collect(),
            }
        });
        let series: Vec<Series> = series.collect();
        let chart = LineChart {
            title: &format!("{name}: cubic spline through {} keys, {ends}", keys.len()),
            horizontal: &table.names[0],
            vertical: match &series[..] {
                [one] => &one.name,
                _ => "value",
            },
            series: &series,
            dots: "key",
            rings: "vertex",
        };
        Ok(chart.to_svg()?)
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let out = self.out.as_ref();
        let out = out.map(|path| format!("wrote {path}: {} rows\n", self.sampled.rows));
        let plot = self.plot.as_ref().map(|path| format!("wrote {path}\n"));
        out.into_iter().chain(plot).collect()
    }
}
