//! What is printed. Infinite numbers are null in JSON.

use ga_video::quality::{FrameQuality, Measures, Pooled};
use serde::Serialize;

/// The measures of a picture, or their means over a video.
#[derive(Serialize)]
pub(super) struct PictureReport {
    psnr: f64,
    ssim: f64,
    ms_ssim: Option<f64>,
    attention_psnr: f64,
    attention_ssim: f64,
}

/// The measures of a video.
#[derive(Serialize)]
pub(super) struct VideoReport {
    #[serde(flatten)]
    means: PictureReport,
    pub(super) frames: usize,
    /// PSNR of the mean of the squared errors of all frames.
    psnr_of_mean_mse: f64,
    psnr_cb: Option<f64>,
    psnr_cr: Option<f64>,
    psnr_6_1_1: Option<f64>,
    pooled: PooledMeasures,
    /// Why `ms_ssim` is null.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) ms_ssim_reason: Option<String>,
    /// Why the comparison ended before the videos.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) error: Option<String>,
}

#[derive(Serialize)]
struct PooledMeasures {
    psnr: PooledReport,
    ssim: PooledReport,
    ms_ssim: Option<PooledReport>,
    attention_psnr: PooledReport,
    attention_ssim: PooledReport,
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

impl PictureReport {
    pub(super) fn new(measures: &Measures) -> Self {
        Self {
            psnr: measures.psnr,
            ssim: measures.ssim,
            ms_ssim: measures.ms_ssim,
            attention_psnr: measures.attention_psnr,
            attention_ssim: measures.attention_ssim,
        }
    }

    /// As text; `reason` says why there is no MS-SSIM.
    pub(super) fn rows(&self, reason: Option<&str>) -> [Row; 5] {
        let ms_ssim = match self.ms_ssim {
            Some(value) => Row::index("MS-SSIM", value),
            None => Row {
                name: "MS-SSIM",
                number: "none".to_owned(),
                rest: format!(": {}", reason.unwrap_or("it is not defined")),
            },
        };
        [
            Row::decibels("PSNR", self.psnr, EQUAL),
            Row::index("SSIM", self.ssim),
            ms_ssim,
            Row::decibels("attention PSNR", self.attention_psnr, EQUAL),
            Row::index("attention SSIM", self.attention_ssim),
        ]
    }

    /// As lines; `reason` says why there is no MS-SSIM.
    pub(super) fn lines(&self, reason: Option<&str>) -> String {
        self.rows(reason).iter().map(Row::line).collect()
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
        let pool = |of: fn(&FrameQuality) -> f64| Pooled::new(frames.iter().map(of));
        let psnr = pool(|frame| frame.luma.psnr)?;
        let ssim = pool(|frame| frame.luma.ssim)?;
        let attention_psnr = pool(|frame| frame.luma.attention_psnr)?;
        let attention_ssim = pool(|frame| frame.luma.attention_ssim)?;
        let pool_some = |of: &dyn Fn(&FrameQuality) -> Option<f64>| {
            let values: Option<Vec<f64>> = frames.iter().map(of).collect();
            Pooled::new(values?)
        };
        let ms_ssim = pool_some(&|frame| frame.luma.ms_ssim);
        let mean = |pooled: Option<Pooled>| pooled.map(|pooled| pooled.mean);
        let difference = |index: usize| {
            mean(pool_some(&|frame| {
                frame.psnr_differences.map(|psnr| psnr[index])
            }))
        };
        let mean_mse = pool(|frame| frame.luma.mse)?.mean;
        Some(Self {
            means: PictureReport {
                psnr: psnr.mean,
                ssim: ssim.mean,
                ms_ssim: mean(ms_ssim),
                attention_psnr: attention_psnr.mean,
                attention_ssim: attention_ssim.mean,
            },
            frames: frames.len(),
            psnr_of_mean_mse: 10.0 * (range * range / mean_mse).log10(),
            psnr_cb: difference(0),
            psnr_cr: difference(1),
            psnr_6_1_1: mean(pool_some(&FrameQuality::psnr_6_1_1)),
            pooled: PooledMeasures {
                psnr: PooledReport::new(psnr),
                ssim: PooledReport::new(ssim),
                ms_ssim: ms_ssim.map(PooledReport::new),
                attention_psnr: PooledReport::new(attention_psnr),
                attention_ssim: PooledReport::new(attention_ssim),
            },
            ms_ssim_reason: None,
            error: None,
        })
    }

    /// The means over the frames as text.
    pub(super) fn rows(&self) -> Vec<Row> {
        let means = &self.means;
        let mut rows = Vec::from(means.rows(self.ms_ssim_reason.as_deref()));
        // A mean is infinite where one frame has no error.
        rows[0] = Row::decibels("PSNR", means.psnr, EQUAL_FRAME);
        rows[3] = Row::decibels("attention PSNR", means.attention_psnr, EQUAL_FRAME);
        for (name, psnr) in [
            ("PSNR of Cb", self.psnr_cb),
            ("PSNR of Cr", self.psnr_cr),
            ("PSNR 6:1:1", self.psnr_6_1_1),
        ] {
            rows.extend(psnr.map(|psnr| Row::decibels(name, psnr, EQUAL_FRAME)));
        }
        let all = Row::decibels("PSNR of mean MSE", self.psnr_of_mean_mse, EQUAL);
        rows.push(all);
        rows
    }

    /// Over the frames: the name of each measure, and numbers as [`POOLED`] names them.
    pub(super) fn pooled_rows(&self) -> Vec<[String; 8]> {
        let pooled = &self.pooled;
        let measures = [
            ("PSNR", Some(&pooled.psnr)),
            ("SSIM", Some(&pooled.ssim)),
            ("MS-SSIM", pooled.ms_ssim.as_ref()),
            ("attention PSNR", Some(&pooled.attention_psnr)),
            ("attention SSIM", Some(&pooled.attention_ssim)),
        ];
        let rows = measures.into_iter().filter_map(|(name, pooled)| {
            let [a, b, c, d, e, f, g] = pooled?.numbers();
            Some([name.to_owned(), a, b, c, d, e, f, g])
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
