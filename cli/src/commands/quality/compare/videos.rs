//! The comparison of two videos.

use std::path::Path;

use anyhow::{Context as _, Error, Result, bail, ensure};
use ga_video::quality::{
    self, FRAME_COUNT, FRAME_RATE, Moments, POOLED, Scaled, TimeAlignment, VideoComparison,
    VideoQuality,
};
use ga_video::{Properties, Source, VideoError};
use serde::Serialize;

use super::arguments::{Arguments, COMMAND, line, too_few_pixels};
use super::found::{Found, Scaling};

use crate::frame::{Context, Shown, Warning};
use crate::part::{About, Frames, Part, PartWritten};

/// What was measured of videos, and what was done before.
#[derive(Serialize)]
pub(crate) struct Videos {
    #[serde(flatten)]
    quality: VideoQuality,
    #[serde(skip_serializing_if = "Option::is_none")]
    alignment: Option<TimeAlignment>,
    /// Columns and rows that were scaled to those of the reference.
    #[serde(skip_serializing_if = "Option::is_none")]
    scaled_from: Option<[usize; 2]>,
}

/// Two videos that are compared, without what was measured.
struct Begun {
    comparison: VideoComparison<Box<dyn Source>, Box<dyn Source>>,
    found: Found,
}

impl Arguments {
    /// Compares all frames.
    pub(super) fn videos(&self, context: &Context) -> Result<Shown<Videos>> {
        let progress = context.progress(0);
        let Begun {
            mut comparison,
            mut found,
        } = self.begin(context)?;
        let count = comparison.frame_count();
        progress.step("comparing");
        let frames = &mut found.frames;
        let compared = comparison.try_for_each(|frame| {
            frames.push(frame?);
            // Where no length is stated, the bar is that of the frames so far.
            let done = frames.len();
            progress.at(done as u64, count.unwrap_or(done).max(done) as u64);
            Ok::<(), VideoError>(())
        });
        drop(progress);
        self.report(found, compared.err(), context)
    }

    /// Compares some frames, and writes what was measured.
    pub(super) fn part_of_videos(
        &self,
        asked: Frames,
        path: &Path,
        context: &Context,
    ) -> Result<Shown<PartWritten>> {
        let progress = context.progress(0);
        let Begun {
            comparison,
            mut found,
        } = self.begin(context)?;
        progress.step("reading what is before");
        let comparison = comparison.starting_at(asked.first);
        let mut comparison = comparison.with_context(|| self.names())?;
        progress.step("comparing");
        let is_last = loop {
            // One frame more shows whether it is the last part.
            match comparison
                .next()
                .transpose()
                .with_context(|| self.names())?
            {
                None => break true,
                Some(_) if asked.end_at(asked.first + found.frames.len()) => break false,
                Some(frame) => found.frames.push(frame),
            }
        };
        ensure!(
            !found.frames.is_empty(),
            "--frames {asked}: {} have no such frame",
            self.names()
        );
        drop(progress);
        let frames = asked.first..asked.first + found.frames.len();
        let inputs = [&self.reference, &self.distorted].into_iter();
        let inputs = inputs.chain(&self.attention).map(AsRef::as_ref);
        let about = About::new(COMMAND, self, inputs, frames, is_last)?;
        let written = PartWritten::new(path, &about);
        Part::new(about, found).write(path, context.outputs())?;
        let text = written.text();
        Ok(Shown::new(written, text))
    }

    /// Opens the videos.
    fn begin(&self, context: &Context) -> Result<Begun> {
        let alignment = self.align_times.then(|| {
            let progress = context.progress(0);
            progress.step("reading the times of frames");
            self.align()
        });
        let alignment = alignment.transpose()?;
        let reference: Box<dyn Source> = ga_video::open(&self.reference)?;
        let mut distorted: Box<dyn Source> = ga_video::open(&self.distorted)?;
        let Properties {
            size, pixel_aspect, ..
        } = *reference.properties();
        let map = self.read_map(size)?;
        let own = distorted.properties().size;
        let mut scaling = None;
        if self.scale && own != size {
            let scaled = Scaled::new(distorted, size, pixel_aspect);
            let [width, height] = own;
            let in_words = format!(
                "{} was scaled from {width} × {height} to {} × {} pixels by {}",
                self.distorted.display(),
                size[0],
                size[1],
                scaled.method()
            );
            scaling = Some(Scaling {
                from: own,
                in_words,
            });
            distorted = Box::new(scaled);
        }
        let comparison = VideoComparison::new(reference, distorted, map);
        let mut comparison = comparison.with_context(|| self.names())?;
        if let Some(found) = &alignment {
            comparison = comparison.of_pairs(found.pairs.clone());
        }
        let mut properties = comparison.property_differences();
        properties.extend(alignment.as_ref().and_then(TimeAlignment::frame_difference));
        // The pairs are those of the comparison now.
        let alignment = alignment.map(|found| TimeAlignment {
            pairs: Vec::new(),
            ..found
        });
        let found = Found {
            size,
            properties,
            alignment,
            scaling,
            frames: Vec::new(),
        };
        Ok(Begun { comparison, found })
    }

    /// What is said of the frames, before a failure if there was one.
    pub(super) fn report(
        &self,
        found: Found,
        failure: Option<VideoError>,
        context: &Context,
    ) -> Result<Shown<Videos>> {
        let Found {
            size,
            properties,
            alignment,
            scaling,
            frames,
        } = found;
        let error = failure.as_ref().map(ToString::to_string);
        let Some(quality) = VideoQuality::new(&frames, size, &properties, error) else {
            failure.map_or(Ok(()), Err).with_context(|| self.names())?;
            bail!("{}: the videos have no frames", self.names());
        };
        let mut warnings = too_few_pixels(quality.too_small_for());
        let differ = |found| Warning::new("properties_differ", found);
        // What is said of the alignment covers rates and numbers of frames.
        let is_said = |what| alignment.is_some() && [FRAME_RATE, FRAME_COUNT].contains(&what);
        let unsaid = properties.iter().filter(|found| !is_said(found.what));
        warnings.extend(unsaid.map(differ));
        let other = VideoQuality::first_at_another_time(&frames);
        if let Some(frame) = other.filter(|_| alignment.is_none()) {
            let message = format!(
                "frame {} is shown at {:.3} s in the reference and at {:.3} s in the other video: \
                 frames are compared by their numbers, with --align-times by their times",
                frame.index,
                frame.time_seconds,
                frame.time_seconds + frame.time_offset_seconds
            );
            warnings.push(Warning {
                frame: Some(frame.index),
                ..Warning::new("frame_times_differ", message)
            });
        }
        if let Some(found) = &alignment {
            warnings.push(Warning::new("aligned_times", in_words(found)).into_note());
        }
        if let Some(scaling) = &scaling {
            warnings.push(Warning::new("scaled", &scaling.in_words).into_note());
        }
        let text = text(&quality);
        let messages: Vec<String> = warnings.iter().map(Warning::line_of_text).collect();
        let files = self.files(&messages);
        let videos = Videos {
            quality,
            alignment,
            scaled_from: scaling.map(|scaling| scaling.from),
        };
        let drawn = Shown::new(videos, text).with_plot(
            self.plot.as_ref(),
            context,
            |_| quality::svg(&frames, &files.name()),
            |found, svg| found.quality.page(files, &frames, svg),
        );
        let mut shown = drawn?;
        if let Some(path) = &self.csv {
            context.outputs().write(path, quality::csv(&frames))?;
        }
        shown.warnings = Some(warnings);
        shown.failure = failure.map(|error| {
            let done = frames.len();
            Error::new(error).context(format!("{}: {done} frames are reported", self.names()))
        });
        Ok(shown)
    }

    /// Which frames show the same moments.
    fn align(&self) -> Result<TimeAlignment> {
        let paths = [&self.reference, &self.distorted];
        ensure!(
            paths.iter().all(|path| path.as_os_str() != "-"),
            "--align-times reads the videos twice, and standard input can be read once"
        );
        let [reference, distorted] = paths.map(|path| Moments::of(ga_video::open(path)?));
        let found = TimeAlignment::find(&reference?, &distorted?);
        found.with_context(|| format!("{}: no frames show the same moments", self.names()))
    }
}

fn in_words(found: &TimeAlignment) -> String {
    let unshifted = found.unshifted_mean_square_difference;
    let unshifted = unshifted.map_or_else(String::new, |unshifted| {
        format!(" against {unshifted:.2} without offset")
    });
    format!(
        "frames are compared by their times with an offset of {:+.3} s (mean squared difference of \
         small pictures {:.2}{unshifted}); {} frames of the reference and {} of the other video are \
         left out",
        found.offset_seconds,
        found.mean_square_difference,
        found.unmatched_reference_frames,
        found.unmatched_distorted_frames
    )
}

/// PSNR of mean squared errors and the means, then a table of what else was found over the frames.
fn text(found: &VideoQuality) -> String {
    let mut text = format!(
        "{} frames, {} of them identical\n",
        found.frames, found.identical_frames
    );
    text.extend(found.rows().iter().map(line));
    text.push('\n');
    let names = ("over frames", POOLED.map(String::from));
    for (name, numbers) in std::iter::once(names).chain(found.pooled_rows()) {
        let columns = numbers.map(|number| format!("{number:>10}"));
        text += &format!("{name:20}{}\n", columns.concat());
    }
    text
}
