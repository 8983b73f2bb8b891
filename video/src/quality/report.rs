//! The measures of pictures and videos in the numbers and words that are reported. Infinite numbers
//! are null in JSON.

use serde::{Serialize, Serializer};

use super::measure::{MEASURES, Measure, Scale};
use super::measures::psnr_of;
use super::pooling::Pooled;
use super::video::FrameQuality;

/// The measures of a picture, as an object with their keys.
#[derive(Clone, Debug, Serialize)]
pub struct PictureQuality {
    #[serde(flatten, serialize_with = "by_key")]
    values: Vec<(Measure, Option<f64>)>,
    #[serde(flatten)]
    reasons: Reasons,
}

/// The measures of a video, as an object with the keys of their means over the frames.
#[derive(Clone, Debug, Serialize)]
pub struct VideoQuality {
    #[serde(flatten, serialize_with = "by_key")]
    means: Vec<(Measure, Option<f64>)>,
    /// The number of frames.
    pub frames: usize,
    /// PSNR of the mean of the squared errors of all frames, in decibels.
    pub psnr_of_mean_mse: f64,
    /// The measures of luma over the frames.
    #[serde(serialize_with = "by_key")]
    pooled: Vec<(Measure, Option<Pooled>)>,
    #[serde(flatten)]
    reasons: Reasons,
    /// Why the comparison ended before the videos.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
}

/// The measures that frames are too small for, and why.
#[derive(Clone, Debug)]
struct Reasons(Vec<(Measure, String)>);

impl Reasons {
    fn of(size: [usize; 2]) -> Self {
        let reason = |measure: Measure| Some((measure, (measure.reason_for_none)(size)?));
        Self(MEASURES.into_iter().filter_map(reason).collect())
    }

    fn iter(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let reasons = self.0.iter();
        reasons.map(|(measure, reason)| (measure.key, reason.as_str()))
    }
}

impl Serialize for Reasons {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let reasons = self.iter();
        serializer.collect_map(reasons.map(|(key, reason)| (format!("{key}_reason"), reason)))
    }
}

fn by_key<V: Serialize, S: Serializer>(
    values: &[(Measure, V)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(values.iter().map(|(measure, value)| (measure.key, value)))
}

/// A measure in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeasureRow {
    /// The name of the measure.
    pub name: &'static str,
    /// The number, or what stands for it.
    pub number: String,
    /// The unit after a space, or a remark after a colon.
    pub remark: String,
}

impl MeasureRow {
    fn index(name: &'static str, value: f64) -> Self {
        Self {
            name,
            number: format!("{value:.6}"),
            remark: String::new(),
        }
    }

    /// `equal` says what it means that the number is infinite.
    fn decibels(name: &'static str, value: f64, equal: &str) -> Self {
        let (number, remark) = match value.is_finite() {
            true => (format!("{value:.4}"), " dB".to_owned()),
            false => (INFINITE.to_owned(), format!(": {equal}")),
        };
        Self {
            name,
            number,
            remark,
        }
    }
}

/// What an infinite number is called.
pub(super) const INFINITE: &str = "infinite";

/// Why a PSNR is infinite.
const EQUAL: &str = "nothing differs";
const EQUAL_FRAME: &str = "nothing differs in a frame";

/// The names of the columns of [`VideoQuality::pooled_rows`], but that of the measure.
pub const POOLED: [&str; 7] = ["harmonic", "least", "5 %", "25 %", "50 %", "75 %", "95 %"];

impl PictureQuality {
    /// Of a picture with this number of columns and rows.
    #[must_use]
    pub fn new(picture: &FrameQuality, size: [usize; 2]) -> Self {
        let of_luma = MEASURES.into_iter().filter(|measure| measure.of_luma);
        Self {
            values: of_luma
                .map(|measure| (measure, (measure.value)(picture)))
                .collect(),
            reasons: Reasons::of(size),
        }
    }

    /// The keys of the measures that the picture is too small for, and why.
    pub fn reasons(&self) -> impl Iterator<Item = (&'static str, &str)> {
        self.reasons.iter()
    }

    /// The measures in words.
    #[must_use]
    pub fn rows(&self) -> Vec<MeasureRow> {
        rows(&self.values, &self.reasons, EQUAL)
    }
}

impl VideoQuality {
    /// Of the measured frames, which have this number of columns and rows, and numbers in this
    /// range; `None` when there are none.
    #[must_use]
    pub fn new(frames: &[FrameQuality], size: [usize; 2], range: f64) -> Option<Self> {
        let pooled = MEASURES.map(|measure| {
            let values: Option<Vec<f64>> = frames.iter().map(measure.value).collect();
            (measure, values.and_then(Pooled::new))
        });
        let means = pooled.map(|(measure, pooled)| (measure, pooled.map(|pooled| pooled.mean)));
        let of_luma = pooled.into_iter().filter(|(measure, _)| measure.of_luma);
        let mean_mse = Pooled::new(frames.iter().map(|frame| frame.luma.mse))?.mean;
        Some(Self {
            means: means.to_vec(),
            frames: frames.len(),
            psnr_of_mean_mse: psnr_of(mean_mse, range),
            pooled: of_luma.collect(),
            reasons: Reasons::of(size),
            error: None,
        })
    }

    /// The keys of the measures that the frames are too small for, and why.
    pub fn reasons(&self) -> impl Iterator<Item = (&'static str, &str)> {
        self.reasons.iter()
    }

    /// The means over the frames in words.
    #[must_use]
    pub fn rows(&self) -> Vec<MeasureRow> {
        // A mean is infinite where one frame has no error.
        let mut rows = rows(&self.means, &self.reasons, EQUAL_FRAME);
        let all = MeasureRow::decibels("PSNR of mean MSE", self.psnr_of_mean_mse, EQUAL);
        rows.push(all);
        rows
    }

    /// Over the frames: the name of each measure, and numbers as [`POOLED`] names them.
    #[must_use]
    pub fn pooled_rows(&self) -> Vec<(&'static str, [String; POOLED.len()])> {
        let rows = self.pooled.iter().filter_map(|(measure, pooled)| {
            let pooled = pooled.as_ref()?;
            let [a, b, c, d, e] = pooled.percentiles;
            let harmonic = pooled.harmonic_mean.unwrap_or(f64::NAN);
            let numbers = [harmonic, pooled.least, a, b, c, d, e].map(|number| match number {
                _ if number.is_nan() => "-".to_owned(),
                _ if number.is_infinite() => INFINITE.to_owned(),
                _ => format!("{number:.4}"),
            });
            Some((measure.name, numbers))
        });
        rows.collect()
    }
}

/// Values in words. `reasons` say why there are none, `equal` what it means that a number is
/// infinite. Grey pictures have no rows for colour differences.
fn rows(values: &[(Measure, Option<f64>)], reasons: &Reasons, equal: &str) -> Vec<MeasureRow> {
    let reason = |key: &str| {
        let found = reasons.iter().find(|(without, _)| *without == key);
        found.map_or("it is not defined", |(_, reason)| reason)
    };
    let row = |(measure, value): &(Measure, Option<f64>)| match (measure.scale, value) {
        (Scale::Decibels, Some(value)) => Some(MeasureRow::decibels(measure.name, *value, equal)),
        (Scale::Index, Some(value)) => Some(MeasureRow::index(measure.name, *value)),
        (_, None) => measure.of_luma.then(|| MeasureRow {
            name: measure.name,
            number: "none".to_owned(),
            remark: format!(": {}", reason(measure.key)),
        }),
    };
    values.iter().filter_map(row).collect()
}
