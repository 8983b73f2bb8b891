//! One number for many.

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pooled {
    /// The arithmetic mean.
    pub mean: f64,
    /// n / Σ 1/x, which low values pull down more; `None` unless all are positive. The reciprocal
    /// of an infinite value is 0.
    pub harmonic_mean: Option<f64>,
    /// The least value.
    pub least: f64,
    /// The values below which 5, 25, 50, 75 and 95 per cent of all lie: see [`percentile`].
    pub percentiles: [f64; PERCENTILES.len()],
}

impl Pooled {
    /// Of values that are not NaN; `None` when there are none, or one is NaN.
    #[must_use]
    pub fn new(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut values: Vec<f64> = values.into_iter().collect();
        if values.is_empty() || values.iter().any(|value| value.is_nan()) {
            return None;
        }
        values.sort_by(f64::total_cmp);
        let count = values.len() as f64;
        let reciprocals: f64 = values.iter().map(|value| value.recip()).sum();
        Some(Self {
            mean: values.iter().sum::<f64>() / count,
            harmonic_mean: (values[0] > 0.0).then(|| count / reciprocals),
            least: values[0],
            percentiles: PERCENTILES.map(|p| percentile(&values, f64::from(p) / 100.0)),
        })
    }
}

/// The median, after which the values are sorted; NaN when there are none.
#[cfg(feature = "comfort")]
pub(crate) fn median(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    percentile(values, 0.5)
}

/// The value below which a share from 0 to 1 of the sorted values lies: linear between the value of
/// index ⌊h⌋ and the next, for h = (n − 1) share (R. J. Hyndman and Y. Fan, "Sample quantiles in
/// statistical packages", 1996, type 7). NaN when there are no values.
///
/// ```
/// use ga_video::quality::percentile;
///
/// assert_eq!(percentile(&[1.0, 2.0, 4.0], 0.75), 3.0);
/// ```
#[must_use]
pub fn percentile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else {
        return f64::NAN;
    };
    let place = last as f64 * share.clamp(0.0, 1.0);
    let below = sorted[place as usize];
    let above = sorted[(place as usize + 1).min(last)];
    let part = place.fract();
    // An infinite value above does not count where its part is zero.
    if part == 0.0 || above == below {
        below
    } else {
        below + part * (above - below)
    }
}
