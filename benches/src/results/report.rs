//! The tables of a report.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use super::measurements::median;
use super::targets::{TOLERANCE, target};
use super::{Group, Measurements, Record, ResultsError};

/// The data of a report.
#[derive(Debug)]
pub struct Report {
    /// The date of the measurement.
    pub date: String,
    /// The processor's name.
    pub processor: String,
    /// Times, for each setting of the compiler.
    pub settings: Vec<Setting>,
    /// Instructions by kernel and contender.
    pub instructions: Vec<Record>,
    /// Build times: what was built, the limit in words, and the figure.
    pub build_times: Vec<Record>,
}

/// The times under one setting of the compiler.
#[derive(Debug)]
pub struct Setting {
    /// The flags given to rustc; empty for none.
    pub flags: String,
    /// The measurements of criterion.
    pub measurements: Measurements,
}

/// Writes a report as Markdown, either completely or not at all.
///
/// # Errors
/// [`ResultsError::Write`]; an earlier file of that name is then unchanged.
pub fn write(path: &Path, report: &Report) -> Result<(), ResultsError> {
    Ok(ga_files::write(path, report.to_markdown().as_bytes())?)
}

impl Report {
    /// The report as Markdown.
    #[must_use]
    pub fn to_markdown(&self) -> String {
        let mut text = String::from("# Results\n\n");
        line(
            &mut text,
            &format!(
                "Measured on {}, {}. [METHODOLOGY.md](METHODOLOGY.md) describes how.",
                self.date, self.processor
            ),
        );
        line(
            &mut text,
            "Times are in nanoseconds for one operation, medians over the runs. A ratio is our time divided by the rival's \
             within one run; the table has the median over the runs and the range. Compare ratios, not times.",
        );
        for setting in &self.settings {
            let flags = if setting.flags.is_empty() {
                "none"
            } else {
                &setting.flags
            };
            line(&mut text, &format!("\n## Flags: `{flags}`"));
            for (family, groups) in families(&setting.measurements) {
                line(&mut text, &format!("\n### {family}\n"));
                if groups
                    .iter()
                    .any(|(_, group)| group.ours().next().is_some())
                {
                    comparisons(&mut text, &setting.flags, &groups);
                } else {
                    times(&mut text, &groups);
                }
            }
        }
        if !self.instructions.is_empty() {
            line(&mut text, "\n## Instructions for one operation\n");
            line(
                &mut text,
                "Counted by callgrind, `-C target-cpu=x86-64-v3`.\n",
            );
            instructions(&mut text, &self.instructions);
        }
        if !self.build_times.is_empty() {
            line(&mut text, "\n## Build times\n");
            line(
                &mut text,
                "| what | measured | at most |\n| --- | --- | --- |",
            );
            for Record {
                name,
                contender,
                value,
            } in &self.build_times
            {
                line(&mut text, &format!("| {name} | {value} | {contender} |"));
            }
        }
        text
    }
}

fn line(text: &mut String, line: &str) {
    let _ = writeln!(text, "{line}");
}

/// Groups by the part of their names before the slash.
fn families(measurements: &Measurements) -> BTreeMap<&str, Vec<(&str, &Group)>> {
    let mut families: BTreeMap<&str, Vec<_>> = BTreeMap::new();
    for (name, group) in &measurements.groups {
        let family = name.split('/').next().unwrap_or(name);
        families
            .entry(family)
            .or_default()
            .push((name.as_str(), group));
    }
    families
}

fn comparisons(text: &mut String, flags: &str, groups: &[(&str, &Group)]) {
    line(
        text,
        "| operation | ours | its time, ns | beside | its time, ns | ratio | range | at most |",
    );
    line(text, "| --- | --- | ---: | --- | ---: | ---: | --- | --- |");
    for (name, group) in groups {
        let operation = name
            .split_once('/')
            .map_or(*name, |(_, operation)| operation);
        for ours in group.ours() {
            let Some(own) = group.median(ours).map(number) else {
                continue;
            };
            let start = format!("| {operation} | {ours} | {own} |");
            if group.rivals().next().is_none() {
                line(text, &format!("{start} | | | | |"));
            }
            for rival in group.rivals() {
                let goal = target(flags, name, ours, rival);
                if let Some(rest) = compared(group, ours, rival, goal) {
                    line(text, &format!("{start} {rest}"));
                }
            }
        }
    }
}

/// The cells of a rival: name, time, ratio, range of ratios, verdict.
fn compared(group: &Group, ours: &str, rival: &str, goal: Option<f64>) -> Option<String> {
    let ratios = group.ratios(ours, rival);
    let ratio = median(ratios.clone())?;
    let range = match ratios[..] {
        [first, .., last] => format!("{}–{}", number(first), number(last)),
        _ => String::new(),
    };
    let verdict = goal.map(|goal| judged(ratio, goal)).unwrap_or_default();
    let (time, ratio) = (number(group.median(rival)?), number(ratio));
    Some(format!(
        "{rival} | {time} | {ratio} | {range} | {verdict} |"
    ))
}

fn judged(ratio: f64, goal: f64) -> String {
    let verdict = if ratio <= goal * (1.0 + TOLERANCE) {
        "reached"
    } else {
        "missed"
    };
    format!("{goal}, {verdict}")
}

fn times(text: &mut String, groups: &[(&str, &Group)]) {
    line(text, "| what | time |\n| --- | ---: |");
    for (name, group) in groups {
        let operation = name
            .split_once('/')
            .map_or(*name, |(_, operation)| operation);
        for contender in group.contenders.keys() {
            let Some(time) = group.median(contender) else {
                continue;
            };
            line(
                text,
                &format!("| {operation} {contender} | {} ms |", number(time / 1e6)),
            );
        }
    }
}

fn instructions(text: &mut String, records: &[Record]) {
    line(
        text,
        "| operation | ours | beside | its count | ratio |\n| --- | ---: | --- | ---: | ---: |",
    );
    let mut own: Option<&Record> = None;
    let mut pending = false;
    for record in records {
        if record.contender == "nullcone" {
            flush(text, own.filter(|_| pending));
            (own, pending) = (Some(record), true);
            continue;
        }
        let Some(ours) = own.filter(|ours| ours.name == record.name) else {
            continue;
        };
        pending = false;
        let ratio = number(ours.value / record.value);
        let (name, rival) = (&record.name, &record.contender);
        let (a, b) = (number(ours.value), number(record.value));
        line(text, &format!("| {name} | {a} | {rival} | {b} | {ratio} |"));
    }
    flush(text, own.filter(|_| pending));
}

/// A kernel without a rival.
fn flush(text: &mut String, alone: Option<&Record>) {
    if let Some(Record { name, value, .. }) = alone {
        line(text, &format!("| {name} | {} | | | |", number(*value)));
    }
}

/// Three significant digits, or all digits before the decimal point.
fn number(value: f64) -> String {
    let digits = if value >= 99.95 {
        0
    } else if value >= 9.995 {
        1
    } else if value >= 0.0995 {
        2
    } else if value >= 0.00995 {
        3
    } else {
        5
    };
    format!("{value:.digits$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn runs(times: &[f64]) -> BTreeMap<String, f64> {
        let named = times
            .iter()
            .enumerate()
            .map(|(run, time)| (format!("run-{run}"), *time));
        named.collect()
    }

    fn report() -> Report {
        let mut group = Group::default();
        group
            .contenders
            .insert("nullcone".to_owned(), runs(&[0.9, 1.0, 1.1]));
        group
            .contenders
            .insert("glam Mat4".to_owned(), runs(&[1.0, 1.0, 1.0]));
        group
            .contenders
            .insert("clifford".to_owned(), runs(&[5.0, 5.0, 5.0]));
        let mut measurements = Measurements::default();
        measurements
            .groups
            .insert("sandwich/motor-point-f32".to_owned(), group);
        let record = |contender: &str, value| Record {
            name: "motor-point".to_owned(),
            contender: contender.to_owned(),
            value,
        };
        Report {
            date: "2026-01-02".to_owned(),
            processor: "a processor".to_owned(),
            settings: vec![Setting {
                flags: String::new(),
                measurements,
            }],
            instructions: vec![record("nullcone", 30.0), record("glam Mat4", 40.0)],
            build_times: vec![record("0.1 s", 0.05)],
        }
    }

    #[test]
    fn a_report_judges_ratios_by_their_targets() {
        let text = report().to_markdown();
        for expected in [
            "| motor-point-f32 | nullcone | 1.00 | glam Mat4 | 1.00 | 1.00 | 0.90–1.10 | 1, reached |",
            "| motor-point-f32 | nullcone | 1.00 | clifford | 5.00 | 0.20 | 0.18–0.22 | 0.1, missed |",
            "| motor-point | 30.0 | glam Mat4 | 40.0 | 0.75 |",
            "| motor-point | 0.05 | 0.1 s |",
        ] {
            assert!(
                text.lines().any(|line| line == expected),
                "{expected} in\n{text}"
            );
        }
    }

    #[test]
    fn a_report_replaces_the_last_one_or_names_the_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("RESULTS.md");
        std::fs::write(&path, "old").unwrap();
        write(&path, &report()).unwrap();
        assert_eq!(
            std::fs::read_to_string(&path).unwrap(),
            report().to_markdown()
        );
        let below_a_file = path.join("tables.md");
        let error = write(&below_a_file, &report()).unwrap_err();
        assert!(error.to_string().contains("tables.md"), "{error}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
