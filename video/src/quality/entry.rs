//! A number that is reported, or why there is none.

use serde::{Serialize, Serializer};

use super::measure::{Measure, Scale};

/// A number that is reported, under a key of JSON: `null` where it is not finite or does not exist,
/// and the reason under the key with `_reason` behind it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) name: String,
    pub(super) scale: Scale,
    /// Perhaps infinite.
    pub(super) value: Option<f64>,
    /// Why it is not a finite number.
    pub(super) reason: Option<String>,
}

impl Entry {
    /// A measure of frames of this size. `infinite` says what it means that the number is infinite.
    pub(super) fn of(
        measure: &Measure,
        value: Option<f64>,
        size: [usize; 2],
        infinite: impl FnOnce() -> String,
    ) -> Self {
        let reason = match value {
            None => Some((measure.reason_for_none)(size)),
            Some(value) if value.is_nan() => Some("a sample is not a number".to_owned()),
            Some(value) if value.is_infinite() => Some(infinite()),
            Some(_) => None,
        };
        Self {
            key: measure.key.to_owned(),
            name: measure.name.to_owned(),
            scale: measure.scale,
            value: value.filter(|value| !value.is_nan()),
            reason,
        }
    }

    /// The entry in words.
    pub(super) fn row(&self) -> MeasureRow {
        let number = match self.value {
            None => "none".to_owned(),
            Some(value) if value.is_infinite() => INFINITE.to_owned(),
            Some(value) if self.scale == Scale::Index => format!("{value:.6}"),
            Some(value) => format!("{value:.4}"),
        };
        let remark = match (&self.reason, self.scale) {
            (Some(reason), _) => format!(": {reason}"),
            (None, Scale::Decibels) => " dB".to_owned(),
            (None, Scale::Index | Scale::Difference) => String::new(),
        };
        MeasureRow {
            name: self.name.clone(),
            number,
            remark,
        }
    }
}

/// Entries as an object with their keys.
pub(super) fn by_key<S: Serializer>(entries: &[Entry], serializer: S) -> Result<S::Ok, S::Error> {
    /// A number or a text.
    #[derive(Serialize)]
    #[serde(untagged)]
    enum Value<'a> {
        Number(Option<f64>),
        Reason(&'a str),
    }
    serializer.collect_map(entries.iter().flat_map(|entry| {
        let number = (entry.key.clone(), Value::Number(entry.value));
        let reason = entry.reason.as_deref();
        let reason = reason.map(|text| (format!("{}_reason", entry.key), Value::Reason(text)));
        std::iter::once(number).chain(reason)
    }))
}

/// A measure in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeasureRow {
    /// The name of the measure.
    pub name: String,
    /// The number, or what stands for it.
    pub number: String,
    /// The unit after a space, or a remark after a colon.
    pub remark: String,
}

/// What an infinite number is called.
pub(super) const INFINITE: &str = "infinite";
