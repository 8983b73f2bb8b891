//! `nullcone curve`: a smooth curve through the keys of a table.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use ga_anim::curve::table::KeyTable;
use ga_anim::curve::{ChannelEnds, Curve, Distance, resample_channels, sample_channels};
use ga_draw::document::{LineChart, Series};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::output;

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
    keys: usize,
    channels: Vec<String>,
    ends: String,
    first_time: f64,
    last_time: f64,
    rows: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    tolerance: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    distance: Option<Distance>,
    #[serde(skip_serializing_if = "Option::is_none")]
    max_deviation: Option<f64>,
}

/// Times, and the values of all channels at each.
struct Rows {
    times: Vec<f64>,
    values: Vec<Vec<f64>>,
    max_deviation: Option<f64>,
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
        let name = || self.keys.display().to_string();
        let curves = table.splines(&self.ends).with_context(name)?;
        let distance = self.distance.unwrap_or(match curves.len() {
            1 => Distance::EqualTime,
            _ => Distance::Geometric,
        });
        let rows = match self.tolerance {
            Some(tolerance) => {
                let found = resample_channels(&curves, tolerance, distance, MOST_ROWS);
                let found = found.with_context(name)?;
                Rows {
                    times: found.times,
                    values: found.values,
                    max_deviation: Some(found.max_deviation),
                }
            }
            None => {
                let times = curves[0].even_times(self.samples.unwrap_or(1000));
                Rows {
                    values: sample_channels(&curves, &times),
                    times,
                    max_deviation: None,
                }
            }
        };

        progress.step("writing");
        self.write(&table, &curves, &rows)?;
        let shown = |path: &Option<PathBuf>| path.as_ref().map(|path| path.display().to_string());
        Ok(Report {
            out: shown(&self.out),
            plot: shown(&self.plot),
            keys: table.times.len(),
            channels: table.names[1..].to_vec(),
            ends: self.ends.to_string(),
            first_time: table.times[0],
            last_time: table.times[table.times.len() - 1],
            rows: rows.times.len(),
            tolerance: self.tolerance,
            distance: self.tolerance.map(|_| distance),
            max_deviation: rows.max_deviation,
        })
    }
}

impl Arguments {
    /// Writes the table and the picture that are asked for. Both are complete before either is
    /// written, so that an error in one leaves no other behind.
    fn write(&self, table: &KeyTable, curves: &[Curve<f64>], rows: &Rows) -> Result<()> {
        let mut files: Vec<(&PathBuf, Vec<u8>)> = Vec::new();
        if let Some(path) = &self.plot {
            let svg = self
                .picture(table, curves, rows)
                .with_context(|| format!("cannot draw {}", path.display()))?;
            files.push((path, svg.into_bytes()));
        }
        if let Some(path) = &self.out {
            let text = table.with_rows(&rows.times, &rows.values);
            files.push((path, text.into_bytes()));
        }
        output::write_together(files)
    }

    /// The channels over time as SVG, with the vertices of a polyline unless they hide the curve.
    fn picture(&self, table: &KeyTable, curves: &[Curve<f64>], rows: &Rows) -> Result<String> {
        const HEIGHT: f64 = 560.0;
        const MOST_VERTICES: usize = 400;
        let (name, keys) = (self.keys.file_name().unwrap_or_default(), &table.times);
        let ends = match &self.ends {
            ChannelEnds::Slopes(_) => "given slopes at the ends".to_owned(),
            other => format!("{other} ends"),
        };
        let is_marked = rows.max_deviation.is_some() && rows.times.len() <= MOST_VERTICES;
        let vertices = rows.times.iter().zip(&rows.values).filter(|_| is_marked);
        let series = curves.iter().enumerate().map(|(channel, curve)| Series {
            name: table.names[channel + 1].clone(),
            line: curve.drawn(HEIGHT),
            dots: (keys.iter().copied())
                .zip(table.channels[channel].iter().copied())
                .collect(),
            rings: (vertices.clone())
                .map(|(&time, values)| (time, values[channel]))
                .collect(),
        });
        let series: Vec<Series> = series.collect();
        let chart = LineChart {
            title: &format!(
                "{}: cubic spline through {} keys, {ends}",
                name.to_string_lossy(),
                keys.len()
            ),
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
        let out = out.map(|path| format!("wrote {path}: {} rows\n", self.rows));
        let plot = self.plot.as_ref().map(|path| format!("wrote {path}\n"));
        out.into_iter().chain(plot).collect()
    }
}
