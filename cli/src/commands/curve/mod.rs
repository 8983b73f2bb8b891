//! `nullcone curve`: a smooth curve through the keys of a table.

mod plot;

use std::fmt::{Display, Formatter};
use std::path::PathBuf;
use std::str::FromStr;

use anyhow::{Context as _, Result, anyhow, bail, ensure};
use clap::ValueEnum;
use ga_anim::curve::table::KeyTable;
use ga_anim::curve::{self, Curve, CurveError, EndKind, Resampled, SplineSystem};
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
    ends: Ends,
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
    #[arg(long, value_name = "WHICH", requires = "tolerance")]
    distance: Option<Distance>,
    /// Write the rows, times first, as CSV.
    #[arg(long, value_name = "FILE.csv")]
    out: Option<PathBuf>,
    /// Write a picture of the channels over time with the keys as dots.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

#[derive(Clone, Debug, PartialEq)]
enum Ends {
    Natural,
    Clamped,
    Slopes(Vec<f64>),
    NotAKnot,
    Periodic,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Distance {
    Geometric,
    EqualTime,
}

impl FromStr for Ends {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "natural" => return Ok(Self::Natural),
            "clamped" => return Ok(Self::Clamped),
            "not-a-knot" => return Ok(Self::NotAKnot),
            "periodic" => return Ok(Self::Periodic),
            _ => {}
        }
        let Some(list) = text.strip_prefix("slopes:") else {
            return Err("expected natural, clamped, slopes:A,B, not-a-knot or periodic".into());
        };
        let slope = |word: &str| match word.trim().parse::<f64>() {
            Ok(slope) if slope.is_finite() => Ok(slope),
            _ => Err(format!("{word:?} is not a slope")),
        };
        let slopes: Vec<f64> = list.split(',').map(slope).collect::<Result<_, _>>()?;
        if slopes.len().is_multiple_of(2) {
            Ok(Self::Slopes(slopes))
        } else {
            Err(format!("{} slopes, but each channel has two", slopes.len()))
        }
    }
}

impl Display for Ends {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Natural => "natural",
            Self::Clamped => "clamped",
            Self::Slopes(_) => "slopes",
            Self::NotAKnot => "not-a-knot",
            Self::Periodic => "periodic",
        })
    }
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

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        check_arguments(arguments)?;
        let is_asked = arguments.out.is_some() || arguments.plot.is_some();
        context.need_result(is_asked, "--out, --plot")?;
        let mut files = context.files([&arguments.keys])?;
        files.write_if_given("--out", arguments.out.as_ref(), &[Format::Csv])?;
        files.write_if_given("--plot", arguments.plot.as_ref(), &[Format::Svg])?;
        let progress = context.progress(3);
        progress.step("reading");
        let table = ga_files::read(&arguments.keys, KeyTable::decode)?;
        progress.step("fitting");
        let name = || arguments.keys.display().to_string();
        let curves = splines(&table, &arguments.ends).with_context(name)?;
        let distance = arguments.distance.unwrap_or(match curves.len() {
            1 => Distance::EqualTime,
            _ => Distance::Geometric,
        });
        let rows = match arguments.tolerance {
            Some(tolerance) => vertices(&curves, tolerance, distance).with_context(name)?,
            None => even_rows(&curves, arguments.samples.unwrap_or(1000)),
        };

        progress.step("writing");
        write(arguments, &table, &curves, &rows)?;
        drop(progress);
        let shown = |path: &Option<PathBuf>| path.as_ref().map(|path| path.display().to_string());
        Ok(Report {
            out: shown(&arguments.out),
            plot: shown(&arguments.plot),
            keys: table.times.len(),
            channels: table.names[1..].to_vec(),
            ends: arguments.ends.to_string(),
            first_time: table.times[0],
            last_time: table.times[table.times.len() - 1],
            rows: rows.times.len(),
            tolerance: arguments.tolerance,
            distance: arguments.tolerance.map(|_| distance),
            max_deviation: arguments.tolerance.map(|_| rows.max_deviation),
        })
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

/// Writes the table and the picture that are asked for. Both are complete before either is written,
/// so that an error in one leaves no other behind.
fn write(
    arguments: &Arguments,
    table: &KeyTable,
    curves: &[Curve<f64>],
    rows: &Resampled<Vec<f64>>,
) -> Result<()> {
    let mut files: Vec<(&PathBuf, Vec<u8>)> = Vec::new();
    if let Some(path) = &arguments.plot {
        let title = title(arguments, table);
        let marks = arguments.tolerance.map(|_| rows);
        let svg = plot::svg(&title, table, curves, marks)
            .with_context(|| format!("cannot draw {}", path.display()))?;
        files.push((path, svg.into_bytes()));
    }
    if let Some(path) = &arguments.out {
        files.push((path, table.with_rows(rows).into_bytes()));
    }
    output::write_together(files)
}

fn check_arguments(arguments: &Arguments) -> Result<()> {
    if let Some(samples) = arguments.samples {
        ensure!(
            (2..=MOST_ROWS).contains(&samples),
            "--samples {samples}: from 2 to {MOST_ROWS} rows can be written"
        );
    }
    if let Some(tolerance) = arguments.tolerance {
        ensure!(
            tolerance.is_finite() && tolerance > 0.0,
            "--tolerance {tolerance}: it must be above 0"
        );
    }
    Ok(())
}

/// A spline for each channel.
fn splines(table: &KeyTable, ends: &Ends) -> Result<Vec<Curve<f64>>> {
    let kind = match ends {
        Ends::Natural => EndKind::Natural,
        Ends::Clamped | Ends::Slopes(_) => EndKind::Slopes,
        Ends::NotAKnot => EndKind::NotAKnot,
        Ends::Periodic => EndKind::Periodic,
    };
    let count = table.channels.len();
    let slopes = |channel: usize| match ends {
        Ends::Slopes(slopes) if slopes.len() == 2 => Some([slopes[0], slopes[1]]),
        Ends::Slopes(slopes) => Some([slopes[channel], slopes[count + channel]]),
        _ => None,
    };
    if let Ends::Slopes(slopes) = ends
        && slopes.len() != 2
        && slopes.len() != 2 * count
    {
        bail!(
            "{} slopes, but there must be two, or two for each channel: {}",
            slopes.len(),
            2 * count
        );
    }
    let system = SplineSystem::new(&table.times, kind).map_err(|error| located(error, table, 0))?;
    let channels = table.channels.iter().enumerate();
    channels
        .map(|(channel, values)| {
            match slopes(channel) {
                Some(slopes) => system.fit_with_slopes(values, slopes),
                None => system.fit(values),
            }
            .map_err(|error| located(error, table, channel + 1))
        })
        .collect()
}

/// An error with the line and the column of the table that it is about.
fn located(error: CurveError, table: &KeyTable, column: usize) -> anyhow::Error {
    let key = match error {
        CurveError::Time { key, .. }
        | CurveError::NotRising { key, .. }
        | CurveError::NotFinite { key, .. }
        | CurveError::OutOfRange { key } => Some(key),
        CurveError::NotPeriodic { first, last, .. } => {
            let line = table.lines[table.lines.len() - 1];
            return anyhow!(
                "line {line}, {}: a periodic curve ends where it begins, at {first}, not at {last}",
                table.column(column)
            );
        }
        _ => None,
    };
    match key.and_then(|key| table.lines.get(key)) {
        Some(line) => anyhow!(error).context(format!("line {line}, {}", table.column(column))),
        None => anyhow!(error),
    }
}

fn vertices(
    curves: &[Curve<f64>],
    tolerance: f64,
    distance: Distance,
) -> Result<Resampled<Vec<f64>>, CurveError> {
    let distance = match distance {
        Distance::Geometric => curve::Distance::Geometric,
        Distance::EqualTime => curve::Distance::EqualTime,
    };
    curve::resample_channels(curves, tolerance, distance, MOST_ROWS)
}

/// Rows at equal steps of time, at least two.
fn even_rows(curves: &[Curve<f64>], count: usize) -> Resampled<Vec<f64>> {
    let (start, end) = (curves[0].start(), curves[0].end());
    let times: Vec<f64> = (0..count)
        .map(|row| {
            let part = row as f64 / (count - 1) as f64;
            if row + 1 == count {
                end
            } else {
                start + (end - start) * part
            }
        })
        .collect();
    Resampled {
        values: curve::sample_channels(curves, &times),
        times,
        max_deviation: 0.0,
    }
}

fn title(arguments: &Arguments, table: &KeyTable) -> String {
    let name = arguments
        .keys
        .file_name()
        .unwrap_or_default()
        .to_string_lossy();
    let keys = table.times.len();
    let ends = match &arguments.ends {
        Ends::Slopes(_) => "given slopes at the ends".to_string(),
        other => format!("{other} ends"),
    };
    format!("{name}: cubic spline through {keys} keys, {ends}")
}
