//! Lines of a key and its value, as `P0: 721.5 0 …` and `baseline=193.001`.

use std::collections::HashSet;

use super::error::{CameraFileError, Place, absent, finite, wrong_type};

/// Keys and values with their lines.
pub(super) struct KeyValues<'a>(Vec<(&'a str, usize, &'a str)>);

impl<'a> KeyValues<'a> {
    /// The keys and values of a text between which a separator stands. Empty lines are left out.
    pub(super) fn new(
        text: &'a str,
        separator: char,
        form: &'static str,
    ) -> Result<Self, CameraFileError> {
        let mut found = Vec::new();
        let mut keys = HashSet::new();
        for (index, text) in text.lines().enumerate() {
            let line = index + 1;
            if text.trim().is_empty() {
                continue;
            }
            let parts = text.split_once(separator);
            let (key, value) = parts.ok_or(CameraFileError::Unsupported {
                line,
                problem: form,
            })?;
            let key = key.trim();
            if !keys.insert(key) {
                return Err(CameraFileError::Duplicate(Place::on_line(line, key)));
            }
            found.push((key, line, value.trim()));
        }
        Ok(Self(found))
    }

    /// The keys in the order of the text.
    pub(super) fn keys(&self) -> impl Iterator<Item = &'a str> {
        self.0.iter().map(|(key, ..)| *key)
    }

    /// The line and the value of a key.
    pub(super) fn find(&self, key: &str) -> Option<(usize, &'a str)> {
        let mut entries = self.0.iter();
        let (_, line, value) = entries.find(|(other, ..)| *other == key)?;
        Some((*line, value))
    }

    /// Where a key stands, without a line where it does not.
    pub(super) fn place(&self, key: &str) -> Place {
        Place::on_line(self.find(key).map_or(0, |(line, _)| line), key)
    }

    /// The number of a key, finite.
    pub(super) fn number(&self, key: &str) -> Result<Option<f64>, CameraFileError> {
        let Some((line, text)) = self.find(key) else {
            return Ok(None);
        };
        let number = text.parse::<f64>();
        let number = number.map_err(|_| wrong_type(key, line, "a number"))?;
        finite(|| self.place(key), number).map(Some)
    }

    /// The numbers of a key, all finite.
    pub(super) fn numbers(&self, key: &str) -> Result<Option<Vec<f64>>, CameraFileError> {
        let Some((line, text)) = self.find(key) else {
            return Ok(None);
        };
        let numbers = text.split_whitespace().map(|word| {
            let number = word.parse::<f64>();
            let number = number.map_err(|_| wrong_type(key, line, "a list of numbers"))?;
            finite(|| self.place(key), number)
        });
        numbers.collect::<Result<_, _>>().map(Some)
    }

    /// As many numbers of a key as its meaning demands.
    pub(super) fn exactly<const N: usize>(
        &self,
        key: &str,
        expected: &'static str,
    ) -> Result<Option<[f64; N]>, CameraFileError> {
        let Some(values) = self.numbers(key)? else {
            return Ok(None);
        };
        let found = <[f64; N]>::try_from(values);
        found.map(Some).map_err(|values| CameraFileError::Shape {
            place: self.place(key),
            rows: 1,
            columns: values.len(),
            expected,
        })
    }

    /// As [`exactly`](Self::exactly), where the key must be there.
    pub(super) fn required<const N: usize>(
        &self,
        key: &str,
        expected: &'static str,
    ) -> Result<[f64; N], CameraFileError> {
        let found = self.exactly(key, expected)?;
        found.ok_or_else(|| absent(self.place(key)))
    }

    /// The value that a key must have beside one that is given, on whose line it is missed.
    pub(super) fn missing_beside(&self, key: &str, other: &str) -> CameraFileError {
        absent(Place {
            key: key.to_owned(),
            ..self.place(other)
        })
    }
}
