//! Turns measurements into the tables of `RESULTS.md`.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::Parser;
use nullcone_benches::results::{self, Measurements, Report, Setting};

/// Writes a report of the runs that criterion has kept, with counts of instructions and build times
/// where they are given.
#[derive(Parser)]
struct Arguments {
    /// A folder of criterion; repeat the option for each setting of the compiler.
    #[arg(long = "criterion", default_value = "target/criterion")]
    criterion: Vec<PathBuf>,
    /// The flags that rustc was given for each folder, in the same order.
    #[arg(long, allow_hyphen_values = true)]
    flags: Vec<String>,
    /// The beginning of the names of the runs, which are criterion's baselines.
    #[arg(long, default_value = "run-")]
    prefix: String,
    /// Lines of kernel, contender and instructions for one operation, separated by tabs.
    #[arg(long)]
    instructions: Option<PathBuf>,
    /// Lines of what was built, the limit and the figure, separated by tabs.
    #[arg(long)]
    build_times: Option<PathBuf>,
    /// The date of the measurement.
    #[arg(long)]
    date: String,
    /// The name of the processor; by default the name that the system gives.
    #[arg(long)]
    processor: Option<String>,
    /// The report to write.
    #[arg(long, default_value = "benches/RESULTS.md")]
    out: PathBuf,
}

fn main() -> Result<()> {
    let arguments = Arguments::parse();
    let mut settings = Vec::new();
    for (index, folder) in arguments.criterion.iter().enumerate() {
        settings.push(Setting {
            flags: arguments.flags.get(index).cloned().unwrap_or_default(),
            measurements: Measurements::read(folder, &arguments.prefix)?,
        });
    }
    let figures = |path: Option<&Path>| path.map(results::records).transpose();
    let processor = match arguments.processor {
        Some(processor) => processor,
        None => processor()?,
    };
    let report = Report {
        date: arguments.date,
        processor,
        settings,
        instructions: figures(arguments.instructions.as_deref())?.unwrap_or_default(),
        build_times: figures(arguments.build_times.as_deref())?.unwrap_or_default(),
    };
    results::write(&arguments.out, &report)?;
    println!("wrote {}", arguments.out.display());
    Ok(())
}

fn processor() -> Result<String> {
    let path = "/proc/cpuinfo";
    let text = std::fs::read_to_string(path)
        .with_context(|| format!("cannot read {path}; give --processor"))?;
    let model = text
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    let (_, name) = model.with_context(|| format!("{path} has no model name; give --processor"))?;
    Ok(name.trim().to_owned())
}
