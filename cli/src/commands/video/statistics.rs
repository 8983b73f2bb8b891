//! How many shots of videos have a background that stands still.

use std::path::PathBuf;

use anyhow::{Error, Result};
use ga_video::keyframe::Options;
use ga_video::keyframe::statistics::Statistics;
use serde::Serialize;

use super::input::{Blocks, analyse};
use crate::files::expanded;
use crate::frame::{self, Command, Context};

/// Count the shots with static and with dynamic background of videos, as in Cui's table 1.
///
/// --json prints {"clips": [{"file", "frames", "shots", "static", "dynamic", "static_proportion"},
/// …], "total": {"frames", "shots", "static", "dynamic", "static_proportion"}}. Where a video
/// cannot be read to its end, the frames and videos before that are counted, and the error follows.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(super) struct Arguments {
    /// The videos: names, or patterns with `*`, `?` or `[abc]`.
    #[arg(value_name = "FILE or GLOB", required = true)]
    videos: Vec<PathBuf>,
    /// How frames are divided into blocks.
    #[arg(long, value_enum, default_value_t = Blocks::Five)]
    layout: Blocks,
    /// The least number of frames of a shot.
    #[arg(long, value_name = "FRAMES", default_value_t = 1)]
    min_shot: usize,
}

#[derive(Serialize)]
pub(super) struct Table {
    clips: Vec<Row>,
    total: Row,
    /// Why videos are missing.
    #[serde(skip)]
    failure: Option<Error>,
}

#[derive(Serialize)]
struct Row {
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<PathBuf>,
    frames: usize,
    shots: usize,
    #[serde(rename = "static")]
    still: usize,
    dynamic: usize,
    static_proportion: Option<f64>,
}

impl Row {
    fn new(file: Option<PathBuf>, frames: usize, statistics: Statistics) -> Self {
        Self {
            file,
            frames,
            shots: statistics.shots(),
            still: statistics.static_shots,
            dynamic: statistics.dynamic_shots,
            static_proportion: statistics.static_proportion(),
        }
    }

    fn line(&self) -> String {
        let name = match &self.file {
            Some(file) => file.display().to_string(),
            None => "total".into(),
        };
        let proportion = self.static_proportion;
        let proportion = proportion.map_or("none".into(), |part| format!("{:.2} %", 100.0 * part));
        format!(
            "{name}: {} frames, {} shots, {} static, {} dynamic, static proportion {proportion}\n",
            self.frames, self.shots, self.still, self.dynamic
        )
    }
}

impl Command for Arguments {
    type Report = Table;

    fn run(&self, context: &Context) -> Result<Table> {
        let videos = expanded("FILE", &self.videos)?;
        context.files(&videos)?;
        let options = Options {
            layout: self.layout.into(),
            minimum_shot: self.min_shot,
            ..Options::default()
        };
        let progress = context.progress(videos.len() as u64);
        let (mut clips, mut frames, mut total) = (Vec::new(), 0, Statistics::default());
        let mut failure = None;
        for path in &videos {
            progress.step("analysing");
            let analysed = match analyse(path, options, None, &progress) {
                Ok(analysed) => analysed,
                Err(error) if clips.is_empty() => return Err(error),
                Err(error) => {
                    failure = Some(error);
                    break;
                }
            };
            let statistics = Statistics::of(&analysed.analysis.shots);
            let count = analysed.analysis.frames.len();
            clips.push(Row::new(Some(path.clone()), count, statistics));
            frames += count;
            total = total + statistics;
            failure = analysed.failure;
            if failure.is_some() {
                break;
            }
        }
        Ok(Table {
            clips,
            total: Row::new(None, frames, total),
            failure,
        })
    }
}

impl frame::Report for Table {
    fn text(&self) -> String {
        let lines = self.clips.iter().chain([&self.total]).map(Row::line);
        lines.collect()
    }

    fn failure(&mut self) -> Option<Error> {
        self.failure.take()
    }
}
