//! How many shots of videos have a background that stands still.

use std::path::PathBuf;

use anyhow::Result;
use ga_video::keyframe::Options;
use ga_video::keyframe::statistics::Statistics;
use serde::Serialize;

use super::input::{Blocks, analyse};
use crate::frame::Progress;
use crate::output;

/// Count the shots with static and with dynamic background of videos, as in Cui's table 1.
///
/// --json prints {"clips": [{"file", "frames", "shots", "static", "dynamic", "static_proportion"},
/// …], "total": {"frames", "shots", "static", "dynamic", "static_proportion"}}. Where a video
/// cannot be read to its end, the frames and videos before that are counted, and the error follows.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(super) struct Arguments {
    /// The videos.
    #[arg(value_name = "FILE", required = true)]
    videos: Vec<PathBuf>,
    /// Print one JSON object instead of a table.
    #[arg(long)]
    json: bool,
    /// How frames are divided into blocks.
    #[arg(long, value_enum, default_value_t = Blocks::Five)]
    layout: Blocks,
    /// The least number of frames of a shot.
    #[arg(long, value_name = "FRAMES", default_value_t = 1)]
    min_shot: usize,
}

#[derive(Serialize)]
struct Table {
    clips: Vec<Row>,
    total: Row,
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

pub(super) fn run(arguments: &Arguments, quiet: bool) -> Result<()> {
    let options = Options {
        layout: arguments.layout.into(),
        minimum_shot: arguments.min_shot,
        ..Options::default()
    };
    let progress = Progress::new(arguments.videos.len() as u64, quiet);
    let (mut clips, mut frames, mut total) = (Vec::new(), 0, Statistics::default());
    let mut failure = None;
    for path in &arguments.videos {
        progress.step("analysing");
        let analysed = match analyse(path, options, None, &progress) {
            Ok(analysed) => analysed,
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
    drop(progress);
    let table = Table {
        clips,
        total: Row::new(None, frames, total),
    };
    if !table.clips.is_empty() && arguments.json {
        output::print_json(&table)?;
    } else if !table.clips.is_empty() && !quiet {
        let lines = table.clips.iter().chain([&table.total]).map(Row::line);
        output::print(&lines.collect::<String>())?;
    }
    // What was analysed before an error is reported.
    failure.map_or(Ok(()), Err)
}
