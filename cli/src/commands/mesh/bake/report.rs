//! What a bake says about itself.

use std::path::PathBuf;
use std::time::Instant;

use ga_render::bake::{HeightRange, MapsReport};
use serde::Serialize;
use serde_json::Map as Object;

use crate::frame::{self, Progress, Warning, command_line};

/// The report of a bake.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    pub(super) folder: PathBuf,
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
    /// The time of each step, and of all together.
    pub(super) seconds: Object<String, serde_json::Value>,
    #[serde(flatten)]
    pub(super) maps: MapsReport,
    pub(super) files: Vec<String>,
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn next(&self) -> Option<String> {
        Some(command_line([
            "nullcone render".as_ref(),
            self.folder.join("coarse.glb").as_os_str(),
            "--out".as_ref(),
            self.folder.join("coarse.png").as_os_str(),
        ]))
    }

    fn text(&self) -> String {
        let of = &self.maps;
        let row = |name: &str, value: String| format!("{name:22}  {value}\n");
        let mut text = row("charts", of.charts.to_string())
            + &row("utilisation", format!("{:.3}", of.utilisation))
            + &row("stretch", format!("{:.4}", of.stretch))
            + &row("flipped triangles", of.flipped.to_string())
            + &row("overlapping texels", of.overlapping.to_string());
        if let Some(HeightRange { minimum, maximum }) = of.displacement {
            text += &row("displacement", format!("{minimum:.6} to {maximum:.6}"));
        }
        for (name, seconds) in &self.seconds {
            let seconds = seconds.as_f64().unwrap_or_default();
            text += &row(&format!("{name}, seconds"), format!("{seconds:.3}"));
        }
        let (folder, files) = (self.folder.display(), self.files.join(", "));
        text + &row("wrote", format!("{folder}: {files}"))
    }
}

/// The steps of a bake and their times.
pub(super) struct Steps<'a> {
    progress: &'a Progress,
    times: Vec<(&'static str, Instant)>,
}

impl<'a> Steps<'a> {
    pub(super) fn new(progress: &'a Progress) -> Self {
        let times = Vec::new();
        Self { progress, times }
    }

    pub(super) fn begin(&mut self, name: &'static str) {
        self.progress.step(name);
        self.times.push((name, Instant::now()));
    }

    /// The seconds of each step, and the total since `begin`.
    pub(super) fn finish(self, begin: Instant) -> Object<String, serde_json::Value> {
        let end = Instant::now();
        let ends = self.times.iter().skip(1).map(|(_, time)| *time);
        let mut seconds = Object::new();
        for ((name, from), to) in self.times.iter().zip(ends.chain([end])) {
            seconds.insert((*name).into(), (to - *from).as_secs_f64().into());
        }
        seconds.insert("total".into(), (end - begin).as_secs_f64().into());
        seconds
    }
}
