//! What is printed.

use std::path::{Path, PathBuf};

use ga_body::character::{BoneReport, CharacterReport, FrameReport, ViewReport};
use ga_body::ground::{Contact, Ground, UpSource};
use ga_draw::document::Page;
use serde::Serialize;

use crate::counted::counted;
use crate::frame::{self, Kept, Verdict, Warning};
use crate::shell::quoted;

/// The names of the files that the command always writes.
pub(super) const CHARACTER: &str = "character.glb";
pub(super) const MOTION: &str = "motion.bvh";
pub(super) const CSV: &str = "joints.csv";
pub(super) const TRC: &str = "joints.trc";
pub(super) const PAGE: &str = "report.html";
pub(super) const JSON: &str = "report.json";

#[derive(Serialize)]
pub(crate) struct Report {
    character: String,
    out: String,
    frames: usize,
    frames_per_second: f64,
    views: Vec<View>,
    bones: Vec<BoneReport>,
    contacts: Vec<Contact>,
    #[serde(flatten)]
    ground: World,
    joints: Vec<String>,
    joints_without_counterpart: Vec<String>,
    reprojection_median_px: f64,
    reprojection_rms_px: f64,
    reprojection_max_px: f64,
    joints_unseen: usize,
    frames_with_unseen_joints: usize,
    /// Left out where measured times are not wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) milliseconds_per_frame: Option<f64>,
    per_frame: Vec<FrameReport>,
    files: Vec<String>,
    #[serde(skip)]
    pub(super) verdict: Verdict,
    #[serde(skip)]
    pub(super) warnings: Vec<Warning>,
    #[serde(skip)]
    pub(super) page: Option<Page>,
    /// Whether one view alone was drawn, so that nothing else is written.
    #[serde(skip)]
    pub(super) is_of_view: bool,
    #[serde(skip)]
    folder: PathBuf,
}

/// What was found in a view, and its film.
#[derive(Serialize)]
struct View {
    #[serde(flatten)]
    found: ViewReport,
    /// The film as it was given, and how many frames it has.
    film: Option<String>,
    film_frames: Option<usize>,
}

/// The ground, in the world of the cameras.
#[derive(Serialize)]
struct World {
    up: Option<[f64; 3]>,
    up_is: Option<UpSource>,
    up_deviation_degrees: Option<f64>,
    floor: Option<f64>,
}

impl Report {
    /// Of a fit, with the films of the first views and the numbers of their frames.
    pub(super) fn new(
        character: &Path,
        out: &Path,
        fit: CharacterReport,
        films: &[(PathBuf, usize)],
        files: &[PathBuf],
    ) -> Self {
        let ground = fit.ground.as_ref();
        let world = World {
            up: ground.map(|ground| ground.up),
            up_is: ground.map(|ground| ground.up_is),
            up_deviation_degrees: ground.map(|ground| ground.up_deviation_degrees),
            floor: ground.and_then(|ground| ground.floor),
        };
        let views = fit.per_view.into_iter().enumerate().map(|(index, found)| {
            let film = films.get(index);
            View {
                found,
                film: film.map(|(path, _)| path.display().to_string()),
                film_frames: film.map(|(_, frames)| *frames),
            }
        });
        Self {
            character: character.display().to_string(),
            out: out.display().to_string(),
            frames: fit.frames,
            frames_per_second: fit.frames_per_second,
            views: views.collect(),
            bones: fit.bones,
            contacts: fit
                .ground
                .map_or(Vec::new(), |Ground { contacts, .. }| contacts),
            ground: world,
            joints: fit.joints,
            joints_without_counterpart: fit.joints_without_counterpart,
            reprojection_median_px: fit.reprojection_median_px,
            reprojection_rms_px: fit.reprojection_rms_px,
            reprojection_max_px: fit.reprojection_max_px,
            joints_unseen: fit.joints_unseen,
            frames_with_unseen_joints: fit.frames_with_unseen_joints,
            milliseconds_per_frame: Some(fit.milliseconds_per_frame),
            per_frame: fit.per_frame,
            files: files
                .iter()
                .map(|path| path.display().to_string())
                .collect(),
            verdict: Verdict::Good,
            warnings: Vec::new(),
            page: None,
            is_of_view: false,
            folder: out.to_owned(),
        }
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(self.verdict)
    }

    fn next(&self) -> Option<String> {
        if self.is_of_view {
            return None;
        }
        let film = quoted(self.folder.join("character.png"));
        let model = quoted(self.folder.join(CHARACTER));
        Some(format!(
            "nullcone render {model} --animation 0 --film {film}"
        ))
    }

    fn page(&self) -> Option<Page> {
        self.page.clone()
    }

    fn kept(&self) -> Option<Kept> {
        (!self.is_of_view).then(|| Kept {
            page: Some(self.folder.join(PAGE)),
            json: Some(self.folder.join(JSON)),
        })
    }

    fn text(&self) -> String {
        let views = &self.views;
        let mut lines = vec![
            format!("the result is {}", self.verdict.with_files().word()),
            format!(
                "motion         {} of {} in {}, {:.2} s",
                counted(self.frames, "frame"),
                counted(self.joints.len(), "joint"),
                counted(views.len(), "view"),
                self.frames as f64 / self.frames_per_second
            ),
            format!(
                "reprojection   {:.2} px median, {:.2} px RMS, {:.2} px at most",
                self.reprojection_median_px, self.reprojection_rms_px, self.reprojection_max_px
            ),
        ];
        lines.extend(views.iter().map(|View { found, .. }| {
            let mut line = format!(
                "  {:12} {:.2} px median, {:.2} px RMS",
                found.name, found.reprojection_median_px, found.reprojection_rms_px
            );
            if let Some(offset) = found.offset_frames.filter(|offset| offset.abs() > 0.05) {
                line += &format!(", {offset:+.1} frames");
            }
            line
        }));
        if self.joints_unseen > 0 {
            lines.push(format!(
                "unseen         {} in {}",
                counted(self.joints_unseen, "joint"),
                counted(self.frames_with_unseen_joints, "frame")
            ));
        }
        if let Some([x, y, z]) = self.ground.up {
            let floor = match self.ground.floor {
                Some(floor) => format!("the floor at {floor:.3} m along it"),
                None => "no floor is known".to_owned(),
            };
            lines.push(format!(
                "up             {x:.3}, {y:.3}, {z:.3} in the world of the cameras; {floor}"
            ));
        }
        if !self.joints_without_counterpart.is_empty() {
            let names = self.joints_without_counterpart.join(", ");
            lines.push(format!("not of the skeleton: {names}"));
        }
        if views.iter().all(|view| view.film.is_none()) {
            lines.push("films          none were given, so that none are drawn over".to_owned());
        }
        for (index, file) in self.files.iter().enumerate() {
            let label = if index == 0 { "wrote" } else { "" };
            lines.push(format!("{label:14} {file}"));
        }
        lines.join("\n") + "\n"
    }
}
