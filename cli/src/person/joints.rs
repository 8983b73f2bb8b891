//! The joints of the person in the views.

use std::path::PathBuf;

use anyhow::{Result, ensure};
use ga_body::format::{DetectorOptions, JointViews, Model};

use crate::files::expanded;

/// The files with the joints, and what they do not say.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct JointFiles {
    /// The joints in the views: one file, or a file or folder for each view. Names, or patterns
    /// with `*`, `?` or `[abc]`, whose files are sorted by the numbers in their names.
    #[arg(long = "joints", value_name = "J.json or GLOB", required = true, num_args = 1..)]
    paths: Vec<PathBuf>,
    /// Frames a second, where the joints do not state it; 30 where nothing does.
    #[arg(long, value_name = "RATE")]
    fps: Option<f64>,
    /// The model of the detector, whatever its files say: coco17, coco18, body25, body25b, body135,
    /// halpe26, halpe136, coco133, mediapipe, mpii16 or lsp14. Its joints are those of the files in
    /// their order. By default the files or the number of joints say it.
    #[arg(long, value_name = "NAME")]
    model: Option<Model>,
    /// The standard deviation of a detector's joints of confidence 1.
    #[arg(long, value_name = "PX", default_value_t = DetectorOptions::default().deviation_px)]
    deviation: f64,
    /// Which of the people whom a detector found in each picture, from 0 in the order of the file;
    /// by default the one with the greatest sum of confidences.
    #[arg(long, value_name = "N")]
    person: Option<usize>,
}

const DEFAULT_RATE: f64 = 30.0;

impl JointFiles {
    /// The same with the files of patterns.
    pub(crate) fn expanded(&self) -> Result<Self> {
        Ok(Self {
            paths: expanded("--joints", &self.paths)?,
            ..self.clone()
        })
    }

    /// The files and folders.
    pub(crate) fn paths(&self) -> &[PathBuf] {
        &self.paths
    }

    /// The files as messages name them.
    pub(crate) fn names(&self) -> String {
        let names = self.paths.iter().map(|path| path.display().to_string());
        names.collect::<Vec<_>>().join(", ")
    }

    pub(crate) fn read(&self) -> Result<JointViews> {
        let deviation = self.deviation;
        ensure!(
            deviation > 0.0 && deviation.is_finite(),
            "--deviation {deviation}: a standard deviation in pixels is greater than 0 and finite"
        );
        let options = DetectorOptions {
            deviation_px: deviation,
            person: self.person,
            model: self.model,
            ..DetectorOptions::default()
        };
        Ok(JointViews::read(&self.paths, &options)?)
    }

    /// Frames a second: as the option says, or the joints, or a film of the person, in this order.
    pub(crate) fn rate(&self, joints: &JointViews, of_film: Option<f64>) -> Result<f64> {
        let rate = self.fps.or(joints.frames_per_second()).or(of_film);
        let rate = rate.unwrap_or(DEFAULT_RATE);
        ensure!(
            rate > 0.0 && rate.is_finite(),
            "--fps {rate}: the number of frames per second must be greater than 0 and finite"
        );
        Ok(rate)
    }

    /// Whether the option says how many frames there are in a second.
    pub(crate) fn has_rate(&self) -> bool {
        self.fps.is_some()
    }
}
