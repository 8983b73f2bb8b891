//! The runs that criterion keeps in its folder, and plain lists of figures.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::ResultsError;

/// The benchmark groups of one folder of criterion.
#[derive(Debug, Default)]
pub struct Measurements {
    /// Groups by name.
    pub groups: BTreeMap<String, Group>,
}

/// One operation: the contenders, and the nanoseconds that each took in each run.
#[derive(Debug, Default)]
pub struct Group {
    /// For each contender, the nanoseconds of one operation by run.
    pub contenders: BTreeMap<String, BTreeMap<String, f64>>,
}

/// One figure of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// The operation or build that was measured.
    pub name: String,
    /// The contender, or the limit.
    pub contender: String,
    /// The figure.
    pub value: f64,
}

#[derive(Deserialize)]
struct Benchmark {
    group_id: String,
    function_id: Option<String>,
    throughput: Option<BTreeMap<String, f64>>,
}

#[derive(Deserialize)]
struct Estimates {
    median: Estimate,
}

#[derive(Deserialize)]
struct Estimate {
    point_estimate: f64,
}

impl Measurements {
    /// Reads the runs whose names (criterion's baselines) begin with `prefix`.
    ///
    /// # Errors
    /// If the folder cannot be read, a file in it is not criterion's, or there is no such run.
    pub fn read(folder: &Path, prefix: &str) -> Result<Self, ResultsError> {
        let mut measurements = Self::default();
        measurements.visit(folder, prefix)?;
        if measurements.groups.is_empty() {
            return Err(ResultsError::NoRuns {
                path: folder.to_path_buf(),
                prefix: prefix.to_owned(),
            });
        }
        Ok(measurements)
    }

    fn visit(&mut self, folder: &Path, prefix: &str) -> Result<(), ResultsError> {
        for path in subfolders(folder)? {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if name.starts_with(prefix) && path.join("estimates.json").is_file() {
                self.add(&path, &name)?;
            } else {
                self.visit(&path, prefix)?;
            }
        }
        Ok(())
    }

    fn add(&mut self, folder: &Path, run: &str) -> Result<(), ResultsError> {
        let benchmark: Benchmark = parse(&folder.join("benchmark.json"))?;
        let path = folder.join("estimates.json");
        let estimates: Estimates = parse(&path)?;
        let elements = benchmark
            .throughput
            .and_then(|units| units.get("Elements").copied());
        let time = estimates.median.point_estimate / elements.unwrap_or(1.0);
        if !(time.is_finite() && time > 0.0) {
            return Err(ResultsError::NoTime { path, value: time });
        }
        let group = self.groups.entry(benchmark.group_id).or_default();
        let contender = benchmark.function_id.unwrap_or_default();
        let runs = group.contenders.entry(contender).or_default();
        runs.insert(run.to_owned(), time);
        Ok(())
    }
}

impl Group {
    /// The contenders of this project, whose names begin with `nullcone`.
    pub fn ours(&self) -> impl Iterator<Item = &str> {
        let names = self.contenders.keys().map(String::as_str);
        names.filter(|name| is_ours(name))
    }

    /// The other contenders.
    pub fn rivals(&self) -> impl Iterator<Item = &str> {
        let names = self.contenders.keys().map(String::as_str);
        names.filter(|name| !is_ours(name))
    }

    /// The median time of a contender, in nanoseconds.
    #[must_use]
    pub fn median(&self, contender: &str) -> Option<f64> {
        median(self.contenders.get(contender)?.values().copied().collect())
    }

    /// The ratios of two contenders' times in the runs that both took part in, in ascending order.
    #[must_use]
    pub fn ratios(&self, contender: &str, rival: &str) -> Vec<f64> {
        let (Some(own), Some(other)) = (self.contenders.get(contender), self.contenders.get(rival))
        else {
            return Vec::new();
        };
        let both = own
            .iter()
            .filter_map(|(run, time)| Some(time / other.get(run)?));
        let mut ratios: Vec<f64> = both.collect();
        ratios.sort_by(f64::total_cmp);
        ratios
    }
}

fn is_ours(contender: &str) -> bool {
    contender.starts_with("nullcone")
}

/// Reads lines of name, contender and number, separated by tabs.
///
/// # Errors
/// If the file cannot be read or a line has another form.
pub fn records(path: &Path) -> Result<Vec<Record>, ResultsError> {
    let text = fs::read_to_string(path).map_err(|source| unreadable(path, source))?;
    let record = |(index, line): (usize, &str)| {
        let fields: Vec<&str> = line.split('\t').collect();
        let error = || ResultsError::Record {
            path: path.to_path_buf(),
            line: index + 1,
            text: line.to_owned(),
        };
        let [name, contender, number] = fields[..] else {
            return Err(error());
        };
        let value: f64 = number.parse().map_err(|_| error())?;
        if !value.is_finite() {
            return Err(error());
        }
        Ok(Record {
            name: name.to_owned(),
            contender: contender.to_owned(),
            value,
        })
    };
    text.lines().enumerate().map(record).collect()
}

/// The median of numbers: the middle one, or the mean of the two in the middle.
pub(super) fn median(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    let middle = numbers.len() / 2;
    let upper = *numbers.get(middle)?;
    Some(if numbers.len().is_multiple_of(2) {
        (numbers[middle - 1] + upper) / 2.0
    } else {
        upper
    })
}

fn subfolders(folder: &Path) -> Result<Vec<PathBuf>, ResultsError> {
    let mut folders = Vec::new();
    for entry in fs::read_dir(folder).map_err(|source| unreadable(folder, source))? {
        let path = entry.map_err(|source| unreadable(folder, source))?.path();
        if path.is_dir() {
            folders.push(path);
        }
    }
    Ok(folders)
}

fn parse<T: DeserializeOwned>(path: &Path) -> Result<T, ResultsError> {
    let text = fs::read(path).map_err(|source| unreadable(path, source))?;
    serde_json::from_slice(&text).map_err(|source| ResultsError::Criterion {
        path: path.to_path_buf(),
        source,
    })
}

fn unreadable(path: &Path, source: std::io::Error) -> ResultsError {
    ResultsError::Read {
        path: path.to_path_buf(),
        source,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn benchmark(folder: &Path, contender: &str, run: &str, median: f64) {
        let folder = folder
            .join("sandwich_motor-point-f32")
            .join(contender)
            .join(run);
        fs::create_dir_all(&folder).unwrap();
        let benchmark = serde_json::json!({
            "group_id": "sandwich/motor-point-f32", "function_id": contender, "throughput": { "Elements": 4 },
        });
        let estimates = serde_json::json!({ "median": { "point_estimate": median } });
        fs::write(folder.join("benchmark.json"), benchmark.to_string()).unwrap();
        fs::write(folder.join("estimates.json"), estimates.to_string()).unwrap();
    }

    #[test]
    fn times_are_for_one_operation_and_ratios_within_one_run() {
        let folder = tempfile::tempdir().unwrap();
        // The machine is three times slower in the second run, which does not change the ratio.
        for (run, ours, theirs) in [
            ("run-1", 4.0, 8.0),
            ("run-2", 12.0, 24.0),
            ("run-3", 4.4, 8.0),
        ] {
            benchmark(folder.path(), "nullcone", run, ours);
            benchmark(folder.path(), "glam Mat4", run, theirs);
        }
        benchmark(folder.path(), "nullcone", "new", 1000.0);
        let measurements = Measurements::read(folder.path(), "run-").unwrap();
        let group = &measurements.groups["sandwich/motor-point-f32"];
        assert!(group.ours().eq(["nullcone"]) && group.rivals().eq(["glam Mat4"]));
        assert_eq!(group.median("nullcone"), Some(1.1));
        assert_eq!(group.ratios("nullcone", "glam Mat4"), [0.5, 0.5, 0.55]);
    }

    #[test]
    fn a_folder_without_runs_and_a_damaged_file_are_errors() {
        let folder = tempfile::tempdir().unwrap();
        let error = Measurements::read(folder.path(), "run-").unwrap_err();
        assert!(matches!(error, ResultsError::NoRuns { .. }));
        benchmark(folder.path(), "nullcone", "run-1", 0.0);
        let error = Measurements::read(folder.path(), "run-").unwrap_err();
        assert!(matches!(error, ResultsError::NoTime { .. }));
        let path = folder
            .path()
            .join("sandwich_motor-point-f32/nullcone/run-1/estimates.json");
        fs::write(&path, "{").unwrap();
        let error = Measurements::read(folder.path(), "run-").unwrap_err();
        assert!(error.to_string().starts_with(&path.display().to_string()));
    }

    #[test]
    fn lists_of_figures_name_the_line_that_is_wrong() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("figures.tsv");
        fs::write(&path, "motor-point\tnullcone\t12.5\n").unwrap();
        let expected = Record {
            name: "motor-point".to_owned(),
            contender: "nullcone".to_owned(),
            value: 12.5,
        };
        assert_eq!(records(&path).unwrap(), [expected]);
        fs::write(&path, "a\tb\t1\na\tb\tNaN\n").unwrap();
        let error = records(&path).unwrap_err();
        assert!(error.to_string().contains("line 2"), "{error}");
    }

    #[test]
    fn medians() {
        assert_eq!(median(vec![]), None);
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(2.5));
    }
}
