//! One number for many.

use ga_numerics::order_statistics::Sorted;
use serde::{Serialize, Serializer};

/// The percentiles that [`Pooled`] has.
pub const PERCENTILES: [u8; 5] = [5, 25, 50, 75, 95];

/// A measure over the frames of a video.
///
/// ```
/// use ga_video::quality::Pooled;
///
/// let pooled = Pooled::new([40.0, 30.0, 60.0, f64::INFINITY]).unwrap();
/// assert_eq!(pooled.mean, f64::INFINITY);
/// assert!((pooled.harmonic_mean.unwrap() - 53.333).abs() < 1e-3);
/// assert_eq!(pooled.least, 30.0);
/// assert_eq!(pooled.percentiles[2], 50.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pooled {
    /// The arithmetic mean.
    pub mean: f64,
    /// n / Σ 1/x, which low values pull down more; `None` unless all are positive. The reciprocal
    /// of an infinite value is 0.
    pub harmonic_mean: Option<f64>,
    /// The least value.
    #[serde(rename = "min")]
    pub least: f64,
    /// The values below which 5, 25, 50, 75 and 95 per cent of all lie: see
    /// [`order_statistics`](ga_numerics::order_statistics).
    #[serde(flatten, serialize_with = "by_percentage")]
    pub percentiles: [f64; PERCENTILES.len()],
}

impl Pooled {
    /// Of values that are not NaN; `None` when there are none, or one is NaN.
    #[must_use]
    pub fn new(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut values: Vec<f64> = values.into_iter().collect();
        let sorted = Sorted::new(&mut values)?;
        let values = sorted.values();
        let count = values.len() as f64;
        let reciprocals: f64 = values.iter().map(|value| value.recip()).sum();
        Some(Self {
            mean: values.iter().sum::<f64>() / count,
            harmonic_mean: (values[0] > 0.0).then(|| count / reciprocals),
            least: values[0],
            percentiles: PERCENTILES.map(|p| sorted.quantile(f64::from(p) / 100.0)),
        })
    }
}

/// Percentiles under keys such as `p5`.
fn by_percentage<S: Serializer>(
    values: &[f64; PERCENTILES.len()],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let entries = PERCENTILES.iter().zip(values);
    serializer.collect_map(entries.map(|(percentage, value)| (format!("p{percentage}"), value)))
}
