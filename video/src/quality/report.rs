//! The measures of pictures and videos in the numbers and words that are reported. A number that is
//! infinite or does not exist is null in JSON, with the reason beside it.

use serde::Serialize;

use super::entry::{Entry, INFINITE, MeasureRow, by_key};
use super::mean::mean_frame;
use super::measure::{MEASURES, Measure, Part, Scale};
use super::pooled_entry::{PooledEntry, by_measure};
use super::pooling::Pooled;
use super::properties::PropertyDifference;
use super::video::FrameQuality;

/// The measures of a picture, as an object with their keys.
#[derive(Clone, Debug, Serialize)]
pub struct PictureQuality {
    #[serde(flatten, serialize_with = "by_key")]
    entries: Vec<Entry>,
    /// Whether no sample differs, also none of colours and alpha.
    pub identical: bool,
    /// What differs: `luma`, `colours`, `alpha`.
    pub differs_in: Vec<&'static str>,
}

/// The measures of a video, as an object with the keys of their means over the frames.
#[derive(Clone, Debug, Serialize)]
pub struct VideoQuality {
    /// PSNR of mean squared errors, whose keys end with `_of_mean_mse`.
    #[serde(flatten, serialize_with = "by_key")]
    of_mean_mse: Vec<Entry>,
    #[serde(flatten, serialize_with = "by_key")]
    means: Vec<Entry>,
    /// The number of frames that were compared.
    pub frames: usize,
    /// How many of them are identical.
    pub identical_frames: usize,
    /// Whether no sample of any frame differs, no property, and the videos were compared to their
    /// ends.
    pub identical: bool,
    /// What differs: `luma`, `colours`, the properties of [`PropertyDifference`], `frame times` and
    /// `length`.
    pub differs_in: Vec<&'static str>,
    /// The measures over the frames.
    #[serde(serialize_with = "by_measure")]
    pooled: Vec<PooledEntry>,
    /// Why the comparison ended before the videos.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
}

/// The names of the columns of [`VideoQuality::pooled_rows`], but that of the measure.
pub const POOLED: [&str; 7] = ["harmonic", "least", "5 %", "25 %", "50 %", "75 %", "95 %"];

/// The greatest difference of the times of frames that are shown at one time. Containers count time
/// in milliseconds or finer.
const SIMULTANEOUS_SECONDS: f64 = 1.5e-3;

impl PictureQuality {
    /// Of a picture with this number of columns and rows.
    #[must_use]
    pub fn new(picture: &FrameQuality, size: [usize; 2]) -> Self {
        let entry = |measure: &Measure| {
            let value = (measure.value)(picture);
            let infinite = || identity(measure.part, &picture.same.differing());
            Entry::of(measure, value, size, infinite)
        };
        Self {
            entries: MEASURES.iter().map(entry).collect(),
            identical: picture.same.is_all(),
            differs_in: picture.same.differing(),
        }
    }

    /// The keys of the measures that the picture is too small for, and why.
    pub fn too_small_for(&self) -> impl Iterator<Item = (&str, &str)> {
        too_small_for(&self.entries)
    }

    /// The measures in words.
    #[must_use]
    pub fn rows(&self) -> Vec<MeasureRow> {
        rows(&self.entries)
    }
}

impl VideoQuality {
    /// Of the measured frames, which have this number of columns and rows; `None` when there are
    /// none. `properties` are stated differently, and `error` ended the comparison.
    #[must_use]
    pub fn new(
        frames: &[FrameQuality],
        size: [usize; 2],
        properties: &[PropertyDifference],
        error: Option<String>,
    ) -> Option<Self> {
        let mean = mean_frame(frames)?;
        let mut differs_in = mean.same.differing();
        differs_in.extend(properties.iter().map(|property| property.what));
        if Self::first_at_another_time(frames).is_some() {
            differs_in.push("frame times");
        }
        if error.is_some() {
            differs_in.push("length");
        }
        let of_mean_mse = |measure: &Measure| {
            let infinite = || identity(measure.part, &differs_in);
            let entry = Entry::of(measure, (measure.value)(&mean), size, infinite);
            Entry {
                key: format!("{}_of_mean_mse", measure.key),
                name: format!("{} of mean MSE", measure.name),
                ..entry
            }
        };
        let decibels = MEASURES.iter().filter(|m| m.scale == Scale::Decibels);
        let of_mean_mse = decibels.map(of_mean_mse).collect();
        let pooled = MEASURES.map(|measure| {
            let values: Option<Vec<f64>> = frames.iter().map(measure.value).collect();
            (measure, values)
        });
        let means = pooled.iter().map(|(measure, values)| {
            let pooled = values.iter().flatten().copied();
            let value = values.as_ref().and_then(|_| Pooled::new(pooled));
            let infinite = || {
                let is_infinite = |value: &&f64| value.is_infinite();
                let count = values.iter().flatten().filter(is_infinite).count();
                match count == frames.len() {
                    true => identity(measure.part, &differs_in),
                    false => format!(
                        "{count} of {} frames {} identical in {}",
                        frames.len(),
                        if count == 1 { "is" } else { "are" },
                        part(measure.part)
                    ),
                }
            };
            Entry::of(measure, value.map(|pooled| pooled.mean), size, infinite)
        });
        let means: Vec<Entry> = means.collect();
        let pooled = pooled
            .into_iter()
            .zip(&means)
            .filter_map(|((measure, values), mean)| {
                (measure.part == Part::Luma || values.is_some()).then(|| PooledEntry {
                    measure,
                    pooled: values.and_then(Pooled::new),
                    reason: mean.reason.clone(),
                })
            });
        Some(Self {
            of_mean_mse,
            pooled: pooled.collect(),
            means,
            frames: frames.len(),
            identical_frames: frames.iter().filter(|frame| frame.same.is_all()).count(),
            identical: differs_in.is_empty(),
            differs_in,
            error,
        })
    }

    /// The first frame that is not shown at the time of its reference.
    #[must_use]
    pub fn first_at_another_time(frames: &[FrameQuality]) -> Option<&FrameQuality> {
        let mut frames = frames.iter();
        frames.find(|frame| frame.time_offset_seconds.abs() > SIMULTANEOUS_SECONDS)
    }

    /// The keys of the measures that the frames are too small for, and why.
    pub fn too_small_for(&self) -> impl Iterator<Item = (&str, &str)> {
        too_small_for(&self.means)
    }

    /// PSNR of mean squared errors, then the means over the frames, in words.
    #[must_use]
    pub fn rows(&self) -> Vec<MeasureRow> {
        let mut means = rows(&self.means);
        for row in &mut means {
            row.name = format!("mean {}", row.name);
        }
        rows(&self.of_mean_mse).into_iter().chain(means).collect()
    }

    /// Over the frames: the name of each measure, and numbers as [`POOLED`] names them.
    #[must_use]
    pub fn pooled_rows(&self) -> Vec<(&'static str, [String; POOLED.len()])> {
        let rows = self.pooled.iter().filter_map(|entry| {
            let pooled = entry.pooled.as_ref()?;
            let [a, b, c, d, e] = pooled.percentiles;
            let harmonic = pooled.harmonic_mean.unwrap_or(f64::NAN);
            let numbers = [harmonic, pooled.least, a, b, c, d, e].map(|number| match number {
                _ if number.is_nan() => "-".to_owned(),
                _ if number.is_infinite() => INFINITE.to_owned(),
                _ => format!("{number:.4}"),
            });
            Some((entry.measure.name, numbers))
        });
        rows.collect()
    }
}

/// What it means that a measure of this part is infinite, where these differ.
fn identity(part: Part, differing: &[&str]) -> String {
    let identical = match part {
        _ if differing.is_empty() => return "nothing differs".to_owned(),
        // Only weighted errors are zero where luma differs.
        Part::Luma if differing.contains(&"luma") => {
            return "luma is identical wherever it counts".to_owned();
        }
        Part::Luma => "luma is identical",
        Part::Plane(name) => return format!("{name} is identical"),
        Part::Planes => return "luma, Cb or Cr is identical".to_owned(),
        Part::All => "all samples of colours are identical",
    };
    let verb = match differing {
        [one] if !one.ends_with('s') => "differs",
        _ => "differ",
    };
    format!("{identical}, {} {verb}", differing.join(" and "))
}

/// A part in words.
fn part(part: Part) -> &'static str {
    match part {
        Part::Luma => "luma",
        Part::Plane(name) => name,
        Part::Planes => "luma, Cb or Cr",
        Part::All => "all samples",
    }
}

/// Measures of luma that frames are too small for.
fn too_small_for(entries: &[Entry]) -> impl Iterator<Item = (&str, &str)> {
    let indices = entries.iter().filter(|entry| entry.scale == Scale::Index);
    indices.filter_map(|entry| Some((entry.key.as_str(), entry.reason.as_deref()?)))
}

/// Entries in words. Those of colour differences that grey frames lack have no rows.
fn rows(entries: &[Entry]) -> Vec<MeasureRow> {
    let is_shown = |entry: &&Entry| entry.value.is_some() || entry.scale != Scale::Decibels;
    entries.iter().filter(is_shown).map(Entry::row).collect()
}
