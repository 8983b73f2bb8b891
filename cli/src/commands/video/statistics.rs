//! How many shots of videos have a background that stands still.

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

use anyhow::{Error, Result};
use ga_video::images::row_of;
use ga_video::keyframe::analyse;
use ga_video::keyframe::statistics::Statistics;
use serde::Serialize;

use super::shots::ShotOptions;
use crate::counted::counted;
use crate::files::expanded;
use crate::frame::{Command, Context, Shown};

/// Count the shots with static and with dynamic background of videos, as in Cui's table 1.
///
/// --json prints {"clips": [{"file", "frames", "shots", "static", "dynamic", "static_proportion"},
/// …], "total": {"frames", "shots", "static", "dynamic", "static_proportion"}}. Where a video
/// cannot be read to its end, the frames and videos before that are counted, and the error follows.
/// A file that is named twice counts once, and so does a row of numbered pictures.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(super) struct Arguments {
    /// The videos: names, or patterns with `*`, `?` or `[abc]`. Numbered pictures are one video.
    #[arg(value_name = "FILE or GLOB", required = true)]
    videos: Vec<PathBuf>,
    #[command(flatten)]
    shots: ShotOptions,
}

#[derive(Serialize)]
pub(super) struct Table {
    clips: Vec<Row>,
    total: Row,
}

#[derive(Default, Serialize)]
struct Row {
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<PathBuf>,
    frames: usize,
    #[serde(flatten)]
    statistics: Statistics,
}

impl Row {
    fn line(&self) -> String {
        let name = match &self.file {
            Some(file) => file.display().to_string(),
            None => "total".into(),
        };
        let found = self.statistics;
        let proportion = found.static_proportion();
        let proportion = proportion.map_or("none".into(), |part| format!("{:.2} %", 100.0 * part));
        format!(
            "{name}: {}, {}, {} static, {} dynamic, static proportion {proportion}\n",
            counted(self.frames, "frame"),
            counted(found.shots(), "shot"),
            found.static_shots,
            found.dynamic_shots
        )
    }
}

/// The videos without those that are parts of others: each file once, and of the numbered pictures
/// of a row the one with the least number, which stands for those after it.
fn once(videos: Vec<PathBuf>) -> Vec<PathBuf> {
    let mut first = HashMap::new();
    for (row, number) in videos.iter().filter_map(|video| row_of(video)) {
        let least = first.entry(row).or_insert(number);
        *least = number.min(*least);
    }
    let mut seen = HashSet::new();
    let mut videos = videos;
    videos.retain(|video| {
        let is_first = row_of(video).is_none_or(|(row, number)| first.get(&row) == Some(&number));
        is_first && seen.insert(video.clone())
    });
    videos
}

impl Command for Arguments {
    type Report = Shown<Table>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        let videos = once(expanded("FILE", &self.videos)?);
        context.files(&videos)?;
        let progress = context.progress(videos.len() as u64);
        let (mut clips, mut total) = (Vec::new(), Row::default());
        let mut failure = None;
        for path in &videos {
            progress.step("analysing");
            let analysed = analyse(path, self.shots.options(), [], None, |done, of| {
                progress.at(done as u64, of as u64);
            });
            let analysed = match analysed {
                Ok(analysed) => analysed,
                Err(error) if clips.is_empty() => return Err(error.into()),
                Err(error) => {
                    failure = Some(error);
                    break;
                }
            };
            let row = Row {
                file: Some(path.clone()),
                frames: analysed.analysis.frames.len(),
                statistics: Statistics::of(&analysed.analysis.shots),
            };
            total.frames += row.frames;
            total.statistics = total.statistics + row.statistics;
            clips.push(row);
            failure = analysed.failure;
            if failure.is_some() {
                break;
            }
        }
        let text = clips.iter().chain([&total]).map(Row::line).collect();
        let mut shown = Shown::new(Table { clips, total }, text);
        shown.failure = failure.map(Error::from);
        Ok(shown)
    }
}
