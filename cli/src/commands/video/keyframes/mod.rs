//! The cuts, shots and key frames of a video.

mod parts;

use std::fs::File;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Error, Result, bail, ensure};
use ga_image::png;
use ga_render::sheet::{Captioned, captioned_sheet};
use ga_video::keyframe::split::{self, Splitter};
use ga_video::keyframe::timecode::{TimeBase, rate};
use ga_video::keyframe::{Analysed, KeyFrame, Options, Pictures, analyse, scenes};
use serde::{Deserialize, Serialize};

pub(crate) use self::parts::{COMMAND, FORMATS, merged};
use crate::commands::video::shots::ShotOptions;
use crate::counted::counted;
use crate::format::Format;
use crate::frame::{Command, Context, Shown};
use crate::output::Staging;
use crate::part::{PartArguments, PartWritten};

/// Find cuts, dissolves, fades, flashes, shots and key frames of a video.
///
/// Shots are divided at cuts and in the middle of dissolves. A fade has the colour from which or
/// to which it leads: black, white, or #rrggbb. A flash is the same scene in more light, or no
/// picture, for at most three frames, and divides nothing; a stray shot has one frame or two. The
/// background of a shot is static or dynamic. Key frames are chosen in two stages: frames whose
/// background, or whose objects, differ from the last candidate, and of these the ones that have
/// little mutual information with it; the first clear frame of each shot is always one. No key
/// frame is nearly black or blended.
///
/// --json prints {"frames": 720, "cuts": [285, …], "dissolves": [{"start", "end"}, …],
/// "fades": [{"start", "end", "direction", "colour"}, …], "flashes": [{"start", "end", "kind":
/// "flash" or "stray_shot"}, …], "shots": [{"start", "end", "background"}, …], "key_frames":
/// [{"index", "time", "reason", "score"}, …]}. Frames are counted
/// from 0, intervals are half-open, a cut is the first frame of the new shot, times are in seconds.
///
/// For instance
///
///   nullcone video keyframes film.y4m --out keys --contact-sheet sheet.png --plot curves.svg
///   ffmpeg -i film.mp4 -f yuv4mpegpipe -pix_fmt yuv420p - | nullcone video keyframes - --json
#[derive(Clone, Debug, Serialize, Deserialize, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The video; - is Y4M from standard input.
    #[arg(value_name = "FILE")]
    video: PathBuf,
    /// Write the key frames as PNG into this folder.
    #[arg(long, value_name = "DIR", conflicts_with = "part")]
    #[serde(skip)]
    out: Option<PathBuf>,
    /// Choose at most this number of key frames: the first of each shot, then those with most that
    /// is new.
    #[arg(long, value_name = "COUNT")]
    budget: Option<usize>,
    /// The least part that is new in a key frame, from 0 to 1, by mutual information with the
    /// candidate before it.
    #[arg(long, value_name = "PART", default_value_t = Options::default().threshold)]
    threshold: f64,
    #[command(flatten)]
    #[serde(flatten)]
    shots: ShotOptions,
    /// Write the shots as a table (.csv) or as an edit decision list (.edl); may be repeated.
    #[arg(long, value_name = "FILE", conflicts_with = "part")]
    #[serde(skip)]
    scenes: Vec<PathBuf>,
    /// Frames in a second of the timecodes of --scenes, such as 25, 29.97 or 24000/1001; by default
    /// that of the video, or where it varies the usual one at whose frames all times are. The times
    /// of pictures, which state none, follow from it.
    #[arg(long, value_name = "RATE")]
    rate: Option<String>,
    /// The timecode of the first frame: HH:MM:SS:FF, or HH:MM:SS;FF to drop numbers of frames.
    #[arg(long, value_name = "TIMECODE")]
    start_timecode: Option<String>,
    /// Write each shot as a film into this folder, exact to the frame: H.264 with its sound, by
    /// ffmpeg, or Y4M for Y4M and pictures and where ffmpeg is not installed.
    #[arg(long, value_name = "DIR", conflicts_with = "part")]
    #[serde(skip)]
    split: Option<PathBuf>,
    /// Write the differences and the mutual information of all frames as a chart, as Cui's fig. 6.
    #[arg(long, value_name = "FILE.svg", conflicts_with = "part")]
    #[serde(skip)]
    plot: Option<PathBuf>,
    /// Write the key frames side by side as one picture.
    #[arg(long, value_name = "FILE.png", conflicts_with = "part")]
    #[serde(skip)]
    contact_sheet: Option<PathBuf>,
    #[command(flatten)]
    #[serde(skip)]
    part: PartArguments,
}

/// The formats of tables of shots.
const SCENES: [Format; 2] = [Format::Csv, Format::Edl];

/// More key frames would make a contact sheet that viewers refuse.
const MOST_ON_SHEET: usize = 200;

impl Command for Arguments {
    type Report = Shown<Found>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        self.check(context)?;
        match self.part.asked() {
            Some((frames, path)) => Ok(self.measure(frames, path, context)?.map(Found::Part)),
            None => Ok(self
                .analyse(Vec::new(), context)?
                .map(|found| Found::All(Box::new(found)))),
        }
    }
}

/// What was found, or measured of some frames.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Found {
    All(Box<Analysed>),
    Part(PartWritten),
}

impl Arguments {
    /// Analyses the video, of which it may be known how much the first frames say of those before.
    fn analyse(&self, measured: Vec<Option<f64>>, context: &Context) -> Result<Shown<Analysed>> {
        let progress = context.progress(1);
        progress.step("analysing");
        let options = Options {
            threshold: self.threshold,
            budget: self.budget,
            ..self.shots.options()
        };
        let with_sheet = self.contact_sheet.is_some() || context.report().is_some();
        let mut pictures = match self.out.is_some() || with_sheet {
            true => Some(Pictures::new()?),
            false => None,
        };
        let found = analyse(
            &self.video,
            options,
            measured,
            pictures.as_mut(),
            |done, of| {
                progress.at(done as u64, of as u64);
            },
        )?;
        progress.step("writing");
        let title = self.title();
        let sheet = match &mut pictures {
            Some(pictures) if with_sheet => sheet(&title, &found.analysis.key_frames, pictures)?,
            _ => Vec::new(),
        };
        // What was analysed before an error is reported, without files beside the page.
        let is_whole = found.failure.is_none();
        let text = text(&found);
        let mut shown = Shown::new(found, text).with_plot(
            self.plot.as_ref().filter(|_| is_whole),
            context,
            |found| found.analysis.svg(&title),
            |found, svg| found.page(&title, svg, &sheet),
        )?;
        if is_whole {
            let outputs = context.outputs();
            self.write(&shown.values, pictures.as_mut(), &sheet, outputs)?;
        }
        shown.failure = shown.values.failure.take().map(Error::from);
        Ok(shown)
    }
}

impl Arguments {
    fn check(&self, context: &Context) -> Result<()> {
        ensure!(
            (0.0..=1.0).contains(&self.threshold),
            "--threshold {}: it must be from 0 to 1",
            self.threshold
        );
        let mut files = context.files([&self.video])?;
        let folders = [("--out", &self.out), ("--split", &self.split)];
        for (option, folder) in folders {
            if let Some(folder) = folder {
                files.write_folder(option, folder, [""; 0])?;
            }
        }
        ensure!(
            self.split.is_none() || self.video.as_os_str() != "-",
            "--split reads the video twice, which standard input does not allow: write it to a \
             file first"
        );
        if self.rate.is_some() || self.start_timecode.is_some() {
            // What is wrong with them is said before the work.
            let known = self.given_rate()?.map(|rate| self.base_of(rate));
            known.transpose()?;
        }
        for path in &self.scenes {
            files.write("--scenes", path, &SCENES)?;
        }
        files.write_if_given("--plot", self.plot.as_ref(), &[Format::Svg])?;
        let sheet = self.contact_sheet.as_ref();
        files.write_if_given("--contact-sheet", sheet, &[Format::Png])?;
        self.part.check(&mut files)?;
        Ok(())
    }

    /// The name of the video, without folders.
    fn title(&self) -> String {
        let name = self.video.file_name().filter(|name| *name != "-");
        name.map_or("standard input".into(), |name| {
            name.to_string_lossy().into_owned()
        })
    }

    /// Writes the files that were asked for, but for the chart.
    fn write(
        &self,
        found: &Analysed,
        pictures: Option<&mut Pictures>,
        sheet: &[u8],
        outputs: &Staging,
    ) -> Result<()> {
        self.write_scenes(found, outputs)?;
        if let Some(folder) = &self.split {
            self.split(found, folder, outputs)?;
        }
        if let (Some(folder), Some(pictures)) = (&self.out, pictures) {
            for key in &found.analysis.key_frames {
                if let Some(bytes) = pictures.png(key.index)? {
                    let path = folder.join(format!("frame_{:06}.png", key.index));
                    outputs.write(path, bytes)?;
                }
            }
        }
        if let Some(path) = &self.contact_sheet {
            outputs.write(path, sheet)?;
        }
        Ok(())
    }
}

impl Arguments {
    fn given_rate(&self) -> Result<Option<[u32; 2]>> {
        let parsed = |text: &String| {
            let wrong = || format!("--rate {text}: it must be as 25, 29.97 or 24000/1001");
            rate(text).with_context(wrong)
        };
        self.rate.as_ref().map(parsed).transpose()
    }

    fn base_of(&self, rate: [u32; 2]) -> Result<TimeBase> {
        let base = TimeBase::new(rate, self.start_timecode.as_deref());
        base.context(match &self.start_timecode {
            Some(_) => "--start-timecode",
            None => "--rate",
        })
    }

    /// The shots as tables and edit decision lists.
    fn write_scenes(&self, found: &Analysed, outputs: &Staging) -> Result<()> {
        let given = self.given_rate()?;
        let base = given
            .or_else(|| found.rate())
            .map(|rate| self.base_of(rate));
        let base = base.transpose()?;
        let (shots, times) = (&found.analysis.shots, found.times(given));
        for path in &self.scenes {
            let text = match (Format::Edl.fits(path), base) {
                (false, _) => scenes::csv(shots, &times, base),
                (true, Some(base)) => scenes::edl(shots, &times, base, &self.title()),
                (true, None) => bail!(
                    "--scenes {}: the rate of the video varies, and no usual one has all of its \
                     times: say by --rate in what an edit decision list counts",
                    path.display()
                ),
            };
            outputs.write(path, text)?;
        }
        Ok(())
    }

    /// Each shot as a film.
    fn split(&self, found: &Analysed, folder: &Path, outputs: &Staging) -> Result<()> {
        let shots = &found.analysis.shots;
        let name = |number: usize, ending: &str| folder.join(format!("shot_{number:04}.{ending}"));
        if split::is_for_ffmpeg(&self.video) {
            let films = split::by_ffmpeg(&self.video, shots)?;
            for (number, film) in (1..).zip(&films.files) {
                let path = name(number, "mp4");
                outputs.write_with(&path, |file| {
                    let copied =
                        File::open(film).and_then(|mut film| std::io::copy(&mut film, file));
                    copied.with_context(|| format!("cannot write {}", path.display()))?;
                    Ok(())
                })?;
            }
            return Ok(());
        }
        let rate = self.given_rate()?.unwrap_or_else(|| found.mean_rate());
        let mut splitter = Splitter::new(&self.video, rate)?;
        for (number, shot) in (1..).zip(shots) {
            let path = name(number, "y4m");
            outputs.write_with(&path, |file| {
                let written = splitter.write(shot.frames.len(), file);
                written.with_context(|| format!("cannot write {}", path.display()))
            })?;
        }
        Ok(())
    }
}

/// The key frames side by side, each with its number, time, reason and score, as PNG.
fn sheet(title: &str, keys: &[KeyFrame], pictures: &mut Pictures) -> Result<Vec<u8>> {
    let mut captioned = Vec::new();
    for key in keys.iter().take(MOST_ON_SHEET) {
        if let Some(picture) = pictures.picture(key.index)? {
            let place = format!("frame {}, {:.3} s", key.index, key.time_seconds);
            let reason = format!("{}, score {:.3}", key.reason.name(), key.score);
            captioned.push(Captioned::new(&picture, [place, reason])?);
        }
    }
    let heading = format!("{title}: {} key frames", keys.len());
    png::encode(&captioned_sheet(&heading, &captioned)).context("cannot encode the contact sheet")
}

fn text(found: &Analysed) -> String {
    let analysis = &found.analysis;
    let transitions = &analysis.transitions;
    let mut text = format!(
        "{}, {}, {}, {}, {}, {}\n",
        counted(analysis.frames.len(), "frame"),
        counted(analysis.shots.len(), "shot"),
        counted(transitions.cuts.len(), "cut"),
        counted(transitions.dissolves.len(), "dissolve"),
        counted(transitions.fades.len(), "fade"),
        counted(analysis.key_frames.len(), "key frame")
    );
    for line in transitions.blended() {
        text += &(line + "\n");
    }
    for shot in &analysis.shots {
        let (frames, background) = (&shot.frames, shot.background.name());
        text += &format!(
            "shot {} to {}, {background} background\n",
            frames.start, frames.end
        );
    }
    for key in &analysis.key_frames {
        text += &format!(
            "key frame {} at {:.3} s: {}, score {:.3}\n",
            key.index,
            key.time_seconds,
            key.reason.name(),
            key.score
        );
    }
    text
}
