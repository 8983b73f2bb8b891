//! What a bake says about itself.

use std::fmt::Write;
use std::path::PathBuf;
use std::time::Instant;

use ga_render::bake::HeightRange;
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
    pub(super) size: u32,
    pub(super) fine_triangles: usize,
    pub(super) coarse_triangles: usize,
    /// Whether a new atlas was made.
    pub(super) unwrapped: bool,
    pub(super) charts: usize,
    pub(super) utilisation: f64,
    /// The area-weighted L2 stretch; 1 for an isometric map.
    pub(super) stretch: f64,
    /// The greatest L2 stretch of a triangle.
    pub(super) stretch_max: f64,
    pub(super) flipped: usize,
    pub(super) overlapping: usize,
    /// Texels that show a point of the surface.
    pub(super) covered_texels: usize,
    /// Those for which the nearest point was taken, as there was none along the normal.
    pub(super) nearest_texels: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) displacement: Option<Range>,
    pub(super) files: Vec<String>,
}

/// What the numbers of the displacement map mean: code 0 is the minimum and code 65535 the maximum,
/// in the unit of the meshes, and codes between are linear.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Range {
    pub(super) minimum: f64,
    pub(super) maximum: f64,
}

impl From<HeightRange> for Range {
    fn from(HeightRange { minimum, maximum }: HeightRange) -> Self {
        Self { minimum, maximum }
    }
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
        let mut text = String::new();
        let mut row = |name: &str, value: String| {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{name:22}  {value}");
        };
        row("charts", self.charts.to_string());
        row("utilisation", format!("{:.3}", self.utilisation));
        row("stretch", format!("{:.4}", self.stretch));
        row("flipped triangles", self.flipped.to_string());
        row("overlapping texels", self.overlapping.to_string());
        if let Some(Range { minimum, maximum }) = self.displacement {
            row("displacement", format!("{minimum:.6} to {maximum:.6}"));
        }
        for (name, seconds) in &self.seconds {
            let seconds = seconds.as_f64().unwrap_or_default();
            row(&format!("{name}, seconds"), format!("{seconds:.3}"));
        }
        row(
            "wrote",
            format!("{}: {}", self.folder.display(), self.files.join(", ")),
        );
        text
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
