//! Two films, frame by frame.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, bail};
use ga_image::plane::Plane;
use ga_video::stereo::StereoSource;
use ga_video::{Frame, Samples};
use ga_vision::diagnosis::of_match::faults_of_match;
use ga_vision::disparity::range::DisparityRange;
use ga_vision::matcher::{MatchSummary, Matcher, MatcherOptions};
use serde::Serialize;

use super::{Arguments, Mode, warnings};
use crate::format::Format;
use crate::frame::{Context, Warning};
use crate::part::Frames;

/// What is printed of two films.
#[derive(Serialize)]
pub(crate) struct FilmReport {
    out: String,
    frames: usize,
    first_frame: usize,
    last_frame: usize,
    min_disparity_px: i32,
    max_disparity_px: i32,
    range_points: Option<usize>,
    mode: Mode,
    per_frame: Vec<FrameReport>,
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
}

#[derive(Serialize)]
struct FrameReport {
    frame: usize,
    #[serde(flatten)]
    found: MatchSummary,
}

/// A name in which the number of a frame takes the place of `%d`, or of `%04d` with as many digits
/// at least; `None` where the name has neither.
pub(super) fn numbered(path: &Path, frame: usize) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let (before, rest) = name.split_once('%')?;
    let (digits, after) = rest.split_once('d')?;
    let width = match digits {
        "" => 0,
        digits => digits
            .strip_prefix('0')?
            .parse()
            .ok()
            .filter(|width| *width < 20)?,
    };
    Some(path.with_file_name(format!("{before}{frame:0width$}{after}")))
}

impl Arguments {
    pub(super) fn films(&self, context: &Context) -> Result<FilmReport> {
        let mut files = context.files(self.views.paths())?;
        let format = files.write("--out", &self.out, &[Format::Pfm, Format::Png])?;
        files.write_if_given("--confidence", self.confidence.as_ref(), &[Format::Png])?;
        files.write_if_given("--picture", self.picture.as_ref(), &[Format::Png])?;
        let others = [
            ("--confidence", &self.confidence),
            ("--picture", &self.picture),
        ];
        for (option, path) in others {
            if let Some(path) = path.as_ref().filter(|path| numbered(path, 0).is_none()) {
                bail!(
                    "{option} {}: the number of the frame needs a place in the name, as %04d",
                    path.display()
                );
            }
        }
        let folder = |path: &Path| {
            let parent = path
                .parent()
                .filter(|parent| !parent.as_os_str().is_empty());
            parent.unwrap_or(Path::new(".")).canonicalize().ok()
        };
        let outputs = [
            Some(&self.out),
            self.confidence.as_ref(),
            self.picture.as_ref(),
        ]
        .into_iter()
        .flatten();
        for input in self.views.paths().into_iter().filter(|path| path.is_dir()) {
            let of_input = input.canonicalize().ok();
            if let Some(out) = outputs.clone().find(|out| folder(out) == of_input) {
                bail!(
                    "{}: the pictures of {} lie in this folder, and some could be overwritten",
                    out.display(),
                    input.display()
                );
            }
        }
        let all = Frames {
            first: 0,
            end: None,
        };
        let asked = self.frames.unwrap_or(all);
        let [left, right] = self.views.paths().map(ga_video::open);
        let named = || self.views.named();
        let mut source = StereoSource::pair(left?, right?).with_context(named)?;
        let [width, height] = source.properties().size;
        let progress = context.progress(1);
        progress.step("matching");
        let threads = rayon::current_num_threads();
        let mut begun: Option<([i32; 2], Option<usize>, Matcher)> = None;
        let mut views: [Frame; 2] = Default::default();
        let (mut per_frame, mut all_warnings) = (Vec::new(), Vec::new());
        let mut frame = 0;
        while !asked.end_at(frame) && source.read(&mut views).with_context(named)? {
            let is_asked = frame >= asked.first;
            if begun.is_none() || is_asked {
                let [left, right] = views.each_ref().map(|view| luma(&view.samples));
                let (range, _, matcher) = match &mut begun {
                    Some(begun) => begun,
                    // The range of the first frame is that of all, in every part.
                    None => {
                        let (range, points) = match self.matching.max_disparity {
                            Some(beyond) => ([self.matching.min_disparity, beyond], None),
                            None => {
                                let found = DisparityRange::of(&left, &right, threads);
                                let found = found.with_context(|| {
                                    format!("{}: --max-disparity gives the range", named())
                                })?;
                                (found.ends, Some(found.points))
                            }
                        };
                        let options = MatcherOptions {
                            range,
                            mode: self.matching.mode.into(),
                            threads,
                        };
                        let matcher = Matcher::new(options, width, height);
                        begun.insert((range, points, matcher.with_context(named)?))
                    }
                };
                if is_asked {
                    let found = matcher.run(&left, &right).with_context(named)?;
                    let faults = faults_of_match([&left, &right], &found, *range);
                    all_warnings.extend(warnings(&faults).into_iter().map(|warning| Warning {
                        frame: Some(frame),
                        ..warning
                    }));
                    let found = found.at_least(self.matching.min_confidence);
                    let name = |path: &Path| numbered(path, frame).unwrap_or_default();
                    let files = self.encoded(&found, format, name)?;
                    context.outputs().write_all(&files)?;
                    per_frame.push(FrameReport {
                        frame,
                        found: found.summary(),
                    });
                    let count = source.properties().frame_count.unwrap_or(2 * frame + 2);
                    progress.at(frame as u64 + 1, count as u64);
                }
            }
            frame += 1;
        }
        let (Some((range, range_points, _)), Some(last)) = (begun, per_frame.last()) else {
            bail!("--frames {asked}: {} have {frame} frames", named());
        };
        let last_frame = last.frame;
        Ok(FilmReport {
            out: self.out.display().to_string(),
            frames: per_frame.len(),
            first_frame: asked.first,
            last_frame,
            min_disparity_px: range[0],
            max_disparity_px: range[1],
            range_points,
            mode: self.matching.mode,
            per_frame,
            warnings: all_warnings,
        })
    }
}

/// Luma in 16 bits, of which all are used.
fn luma(samples: &Samples) -> Plane<u16> {
    match samples {
        Samples::Eight(planes) => planes.luma.map(|level| u16::from(level) * 257),
        Samples::Ten(planes) => planes.luma.map(|level| level << 6 | level >> 4),
    }
}

impl FilmReport {
    pub(super) fn text(&self) -> String {
        let known = self.per_frame.iter().map(|frame| frame.found.density);
        let mean = known.sum::<f64>() / self.frames as f64;
        format!(
            "{}: frames {} to {}, {mean:.2} % known on average\n\
             disparities were looked for from {} up to {} px\n",
            self.out,
            self.first_frame,
            self.last_frame,
            self.min_disparity_px,
            self.max_disparity_px
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_a_place_for_the_number() {
        let named = |name: &str, frame| {
            let path = numbered(Path::new(name), frame)?;
            path.to_str().map(str::to_owned)
        };
        assert_eq!(named("a/d_%04d.pfm", 7).as_deref(), Some("a/d_0007.pfm"));
        assert_eq!(named("d%d.png", 12).as_deref(), Some("d12.png"));
        for without in ["d.pfm", "d%.pfm", "d%4d.pfm", "100%.png", "d%0xd.png"] {
            assert_eq!(named(without, 1), None, "{without}");
        }
    }
}
