//! A measure over the frames, as it is reported.

use serde::{Serialize, Serializer};

use super::measure::Measure;
use super::pooling::Pooled;

/// A measure over the frames of a video.
#[derive(Clone, Debug)]
pub(super) struct PooledEntry {
    pub(super) measure: Measure,
    pub(super) pooled: Option<Pooled>,
    /// Why there is none, or why its mean is infinite.
    pub(super) reason: Option<String>,
}

/// An object with the keys of the measures. Where numbers are null, `null_reason` says why beside
/// them, or the key with `_reason` behind it where there are no numbers.
pub(super) fn by_measure<S: Serializer>(
    entries: &[PooledEntry],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    #[serde(untagged)]
    enum Value<'a> {
        Numbers {
            #[serde(flatten)]
            pooled: &'a Pooled,
            #[serde(skip_serializing_if = "Option::is_none")]
            null_reason: Option<&'a str>,
        },
        Reason(&'a str),
        None(()),
    }
    serializer.collect_map(entries.iter().flat_map(|entry| {
        let (key, reason) = (entry.measure.key, entry.reason.as_deref());
        match &entry.pooled {
            Some(pooled) => {
                let not_positive = pooled.harmonic_mean.is_none().then_some(NOT_POSITIVE);
                let null_reason = reason.or(not_positive);
                let numbers = Value::Numbers {
                    pooled,
                    null_reason,
                };
                vec![(key.to_owned(), numbers)]
            }
            None => {
                let reason = Value::Reason(reason.unwrap_or_default());
                let none = (key.to_owned(), Value::None(()));
                vec![none, (format!("{key}_reason"), reason)]
            }
        }
    }))
}

/// Why there is no harmonic mean.
const NOT_POSITIVE: &str = "a value is not positive";
