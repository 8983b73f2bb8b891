//! What is printed. Infinite numbers are null in JSON.

use std::fmt::Write;

use ga_vision::quality::{FrameQuality, Measures, Pooled};
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
    frames: usize,
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

    /// As lines; `reason` says why there is no MS-SSIM.
    pub(super) fn lines(&self, reason: Option<&str>) -> String {
        let ms_ssim = match (self.ms_ssim, reason) {
            (Some(index), _) => format!("{index:10.6}"),
            (None, reason) => format!("      none: {}", reason.unwrap_or("it is not defined")),
        };
        format!(
            "PSNR            {}\nSSIM            {:10.6}\nMS-SSIM         {ms_ssim}\n\
             attention PSNR  {}\nattention SSIM  {:10.6}\n",
            decibels(self.psnr),
            self.ssim,
            decibels(self.attention_psnr),
            self.attention_ssim
        )
    }
}

fn decibels(psnr: f64) -> String {
    if psnr.is_finite() {
        format!("{psnr:10.4} dB")
    } else {
        "  infinite: nothing differs".to_owned()
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

    /// As lines: the means, then a table.
    pub(super) fn lines(&self) -> String {
        let mut lines = format!("{} frames, means:\n", self.frames);
        lines += &self.means.lines(self.ms_ssim_reason.as_deref());
        // Writing to a string does not fail.
        for (name, psnr) in [
            ("PSNR of Cb", self.psnr_cb),
            ("PSNR of Cr", self.psnr_cr),
            ("PSNR 6:1:1", self.psnr_6_1_1),
        ] {
            if let Some(psnr) = psnr {
                let _ = writeln!(lines, "{name:16}{}", decibels(psnr));
            }
        }
        let _ = writeln!(
            lines,
            "PSNR of mean MSE{}\n\n{:16}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}",
            decibels(self.psnr_of_mean_mse),
            "over frames",
            "harmonic",
            "least",
            "5 %",
            "25 %",
            "50 %",
            "75 %",
            "95 %"
        );
        let pooled = &self.pooled;
        for (name, pooled) in [
            ("PSNR", Some(&pooled.psnr)),
            ("SSIM", Some(&pooled.ssim)),
            ("MS-SSIM", pooled.ms_ssim.as_ref()),
            ("attention PSNR", Some(&pooled.attention_psnr)),
            ("attention SSIM", Some(&pooled.attention_ssim)),
        ] {
            if let Some(pooled) = pooled {
                let _ = writeln!(lines, "{name:16}{}", pooled.columns());
            }
        }
        lines
    }
}

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

    fn columns(&self) -> String {
        let harmonic = self.harmonic_mean.unwrap_or(f64::NAN);
        let numbers = [
            harmonic, self.min, self.p5, self.p25, self.p50, self.p75, self.p95,
        ];
        let column = |number: f64| {
            if number.is_nan() {
                format!("{:>10}", "-")
            } else {
                format!("{number:10.4}")
            }
        };
        numbers.into_iter().map(column).collect()
    }
}
