//! What is printed. Infinite numbers are null in JSON.

use ga_video::quality::{FrameQuality, MEASURES, Measure, Pooled, Scale};
use serde::{Serialize, Serializer};

/// Measures of a picture, or their means over a video, by key.
#[derive(Clone)]
pub(super) struct Values(Vec<(Measure, Option<f64>)>);

impl Serialize for Values {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(measure, value)| (measure.key, value)))
    }
}

/// The measures of a picture.
#[derive(Serialize)]
pub(super) struct PictureReport {
    #[serde(flatten)]
    values: Values,
    /// Why `ms_ssim` is null.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) ms_ssim_reason: Option<String>,
}

/// The measures of a video.
#[derive(Serialize)]
pub(super) struct VideoReport {
    #[serde(flatten)]
    means: Values,
    pub(super) frames: usize,
    /// PSNR of the mean of the squared errors of all frames.
    psnr_of_mean_mse: f64,
    pooled: PooledMeasures,
    /// Why `ms_ssim` is null.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) ms_ssim_reason: Option<String>,
    /// Why the comparison ended before the videos.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) error: Option<String>,
}

/// The measures of luma over the frames, by key.
struct PooledMeasures(Vec<(Measure, Option<PooledReport>)>);

impl Serialize for PooledMeasures {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(measure, pooled)| (measure.key, pooled)))
    }
}

#[derive(Serialize)]
struct PooledReport {
    mean: f64,
    harmonic_mean: Option<f64>,
    min: f64,
    p5: f64,
    p25: f64,
    p50: f64,
    p75: f64,
    p95: f64,
}

impl Values {
    /// As text. `reason` says why there is no MS-SSIM, `equal` what it means that a number is
    /// infinite. Grey pictures have no rows for colour differences.
    fn rows(&self, reason: Option<&str>, equal: &str) -> Vec<Row> {
        let row = |(measure, value): &(Measure, Option<f64>)| match (measure.scale, value) {
            (Scale::Decibels, Some(value)) => Some(Row::decibels(measure.name, *value, equal)),
            (Scale::Index, Some(value)) => Some(Row::index(measure.name, *value)),
            (_, None) => measure.of_luma.then(|| Row {
                name: measure.name,
                number: "none".to_owned(),
                rest: format!(": {}", reason.unwrap_or("it is not defined")),
            }),
        };
        self.0.iter().filter_map(row).collect()
    }
}

impl PictureReport {
    pub(super) fn new(picture: &FrameQuality, ms_ssim_reason: Option<String>) -> Self {
        let of_luma = MEASURES.into_iter().filter(|measure| measure.of_luma);
        let values = of_luma.map(|measure| (measure, (measure.value)(picture)));
        Self {
            values: Values(values.collect()),
            ms_ssim_reason,
        }
    }

    /// As text.
    pub(super) fn rows(&self) -> Vec<Row> {
        self.values.rows(self.ms_ssim_reason.as_deref(), EQUAL)
    }

    /// As lines.
    pub(super) fn lines(&self) -> String {
        self.rows().iter().map(Row::line).collect()
    }
}

/// Why a PSNR is infinite.
const EQUAL: &str = "nothing differs";
const EQUAL_FRAME: &str = "nothing differs in a frame";

/// A measure as text.
pub(super) struct Row {
    pub(super) name: &'static str,
    number: String,
    /// The unit, or a remark.
    rest: String,
}

impl Row {
    fn index(name: &'static str, value: f64) -> Self {
        Self {
            name,
            number: format!("{value:.6}"),
            rest: String::new(),
        }
    }

    /// `equal` says what it means that the number is infinite.
    fn decibels(name: &'static str, value: f64, equal: &str) -> Self {
        let (number, rest) = if value.is_finite() {
            (format!("{value:.4}"), " dB".to_owned())
        } else {
            ("infinite".to_owned(), format!(": {equal}"))
        };
        Self { name, number, rest }
    }

    /// The number with its unit.
    pub(super) fn value(&self) -> String {
        format!("{}{}", self.number, self.rest)
    }

    fn line(&self) -> String {
        format!("{:16}{:>10}{}\n", self.name, self.number, self.rest)
    }
}

impl VideoReport {
    /// Of the measured frames; `None` when there are none.
    pub(super) fn new(frames: &[FrameQuality], range: f64) -> Option<Self> {
        let pool = |measure: Measure| {
            let values: Option<Vec<f64>> = frames.iter().map(measure.value).collect();
            (measure, values.and_then(Pooled::new))
        };
        let pooled = MEASURES.map(pool);
        let means = pooled.map(|(measure, pooled)| (measure, pooled.map(|pooled| pooled.mean)));
        let of_luma = pooled.into_iter().filter(|(measure, _)| measure.of_luma);
        let of_luma = of_luma.map(|(measure, pooled)| (measure, pooled.map(PooledReport::new)));
        let mean_mse = Pooled::new(frames.iter().map(|frame| frame.luma.mse))?.mean;
        Some(Self {
            means: Values(means.to_vec()),
            frames: frames.len(),
            psnr_of_mean_mse: 10.0 * (range * range / mean_mse).log10(),
            pooled: PooledMeasures(of_luma.collect()),
            ms_ssim_reason: None,
            error: None,
        })
    }

    /// The means over the frames as text.
    pub(super) fn rows(&self) -> Vec<Row> {
        // A mean is infinite where one frame has no error.
        let mut rows = self.means.rows(self.ms_ssim_reason.as_deref(), EQUAL_FRAME);
        let all = Row::decibels("PSNR of mean MSE", self.psnr_of_mean_mse, EQUAL);
        rows.push(all);
        rows
    }

    /// Over the frames: the name of each measure, and numbers as [`POOLED`] names them.
    pub(super) fn pooled_rows(&self) -> Vec<[String; 8]> {
        let rows = self.pooled.0.iter().filter_map(|(measure, pooled)| {
            let [a, b, c, d, e, f, g] = pooled.as_ref()?.numbers();
            Some([measure.name.to_owned(), a, b, c, d, e, f, g])
        });
        rows.collect()
    }

    /// As lines: the means, then a table.
    pub(super) fn lines(&self) -> String {
        let mut lines = format!("{} frames, means:\n", self.frames);
        lines.extend(self.rows().iter().map(Row::line));
        lines.push('\n');
        let names = POOLED.map(String::from);
        for [name, numbers @ ..] in std::iter::once(names).chain(self.pooled_rows()) {
            let columns = numbers.map(|number| format!("{number:>10}"));
            lines += &format!("{name:16}{}\n", columns.concat());
        }
        lines
    }
}

/// The columns of the table of pooled measures.
pub(super) const POOLED: [&str; 8] = [
    "over frames",
    "harmonic",
    "least",
    "5 %",
    "25 %",
    "50 %",
    "75 %",
    "95 %",
];

impl PooledReport {
    fn new(pooled: Pooled) -> Self {
        let [p5, p25, p50, p75, p95] = pooled.percentiles;
        Self {
            mean: pooled.mean,
            harmonic_mean: pooled.harmonic_mean,
            min: pooled.least,
            p5,
            p25,
            p50,
            p75,
            p95,
        }
    }

    fn numbers(&self) -> [String; 7] {
        let harmonic = self.harmonic_mean.unwrap_or(f64::NAN);
        let numbers = [
            harmonic, self.min, self.p5, self.p25, self.p50, self.p75, self.p95,
        ];
        numbers.map(|number| match number {
            _ if number.is_nan() => "-".to_owned(),
            _ if number.is_infinite() => "infinite".to_owned(),
            _ => format!("{number:.4}"),
        })
    }
}
