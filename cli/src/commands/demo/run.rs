//! The way from the films to everything that is found in them: each step is a command of the
//! program, which runs in the folder of the results.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::Path;
use std::time::Instant;

use anyhow::{Context as _, Result};
use ga_camera::format::json::encode_views;
use ga_camera::format::{self, NamedCamera};
use ga_camera::rig::{RectifiedRig, StereoRig};
use ga_image::pfm::ByteOrder;
use ga_image::{pfm, png};
use ga_vision::disparity::DisparityMap;
use ga_vision::rectification::{Rectification, RectificationOptions};
use serde_json::Value;

use super::disparity::true_disparities;
use super::inputs::Truth;
use super::steps::{CALIBRATION, CONTOUR, DISPARITIES, DOTS, KEY_FRAMES, PEOPLE, STEPS, Step};
use super::studio::SIZE;
use super::times::Times;
use crate::frame::{Context, Progress, Recorded};

/// What a step said.
pub(super) struct Done {
    pub(super) step: &'static Step,
    line: String,
    pub(super) said: Recorded,
}

impl Done {
    /// The command as a shell reads it.
    pub(super) fn command(&self) -> String {
        format!("nullcone {}", self.line)
    }
}

/// What all steps said.
pub(super) struct Run {
    pub(super) steps: Vec<Done>,
    pub(super) rig: StereoRig,
}

impl Run {
    /// Runs all commands in the current folder. A file with the character is named where it is not
    /// the mannequin.
    pub(super) fn new(
        truth: &Truth,
        character: Option<&str>,
        context: &Context,
        progress: &Progress,
        times: &mut Times,
    ) -> Result<Self> {
        let mut steps = Vec::with_capacity(STEPS.len());
        let mut rig = None;
        for step in &STEPS {
            progress.part(step.title, step.share);
            let begin = Instant::now();
            let line = match character {
                Some(file) if [DOTS, PEOPLE].contains(&step.name) => {
                    format!("{} --character {file}", step.line)
                }
                _ if step.name == CONTOUR => format!("{} {}", step.line, circles(truth)?),
                _ => step.line.to_owned(),
            };
            let said = context.record(&words(&line));
            let said = said.with_context(|| format!("nullcone {line}"))?;
            let seconds = begin.elapsed().as_secs_f64();
            times.steps.push((step.name.to_owned(), seconds));
            steps.push(Done { step, line, said });
            match step.name {
                CALIBRATION => rig = Some(placed(truth)?),
                DISPARITIES => {
                    let rig = rig.as_ref().context("there is no rig")?;
                    write_truth(rig, truth)?;
                }
                _ => {}
            }
        }
        let rig = rig.context("there is no rig")?;
        // Key frames have times in the film.
        let measured = steps.iter_mut().filter(|done| done.step.name != KEY_FRAMES);
        measured.for_each(|done| without_times(&mut done.said.values));
        Ok(Self { steps, rig })
    }

    /// What a step said, by its name.
    pub(super) fn said(&self, name: &str) -> Result<&Recorded> {
        let done = self.steps.iter().find(|done| done.step.name == name);
        Ok(&done
            .with_context(|| format!("there is no step {name}"))?
            .said)
    }

    /// A number that a step said.
    pub(super) fn number(&self, name: &str, pointer: &str) -> Result<f64> {
        let value = self.said(name)?.values.pointer(pointer);
        let number = value.and_then(Value::as_f64);
        number.with_context(|| format!("{name} has no number {pointer}"))
    }

    /// What all steps said, by their names.
    pub(super) fn values(&self) -> BTreeMap<&'static str, Value> {
        let steps = self.steps.iter().map(|done| {
            let values = serde_json::json!({
                "command": done.command(),
                "verdict": done.said.verdict,
                "values": done.said.values,
            });
            (done.step.name, values)
        });
        steps.collect()
    }
}

/// Circles about the disc, somewhat larger, in both pictures: what the contour begins with.
fn circles(truth: &Truth) -> Result<String> {
    const LARGER: f64 = 1.4;
    let StereoRig { left, right } = truth.rig;
    let [left, right] = [left, right].map(|camera| -> Result<String> {
        let [u, v] = camera.project(truth.disc.centre)?;
        let [_, _, depth] = camera
            .world_to_camera
            .transform(truth.disc.centre)
            .coordinates();
        let radius = LARGER * camera.intrinsics.focal()[0] * truth.disc.radius / depth;
        Ok(format!("{u:.0},{v:.0},{radius:.0}"))
    });
    Ok(format!("--circle {} --right-circle {}", left?, right?))
}

/// The words of a line, of which some are in single quotes.
fn words(line: &str) -> Vec<OsString> {
    let mut words = vec![OsString::from("nullcone")];
    for (number, part) in line.split('\'').enumerate() {
        if number % 2 == 1 {
            words.push(part.into());
        } else {
            words.extend(part.split_whitespace().map(OsString::from));
        }
    }
    words
}

/// Removes what was measured by a clock.
fn without_times(value: &mut Value) {
    const TIMES: [&str; 3] = ["seconds", "milliseconds", "milliseconds_per_frame"];
    match value {
        Value::Object(object) => {
            object.retain(|name, _| !TIMES.contains(&name.as_str()));
            object.values_mut().for_each(without_times);
        }
        Value::Array(all) => all.iter_mut().for_each(without_times),
        _ => {}
    }
}

/// The rig that was calibrated, with its left camera where it stands in the room, written for the
/// steps that need a world: that is not found by the pictures of a board alone.
fn placed(truth: &Truth) -> Result<StereoRig> {
    let rig = format::read("rig.yml")?.rig(&[])?;
    let world = rig.left.world_to_camera.reverse() * truth.rig.left.world_to_camera;
    let [left, right] = [rig.left, rig.right].map(|camera| ga_camera::Camera {
        world_to_camera: camera.world_to_camera * world,
        ..camera
    });
    let cameras = [("left", left), ("right", right)].map(|(name, camera)| {
        let named = NamedCamera::new(name, camera.intrinsics);
        let mut named = named.with_size(Some(SIZE));
        named.pose = Some(camera.world_to_camera);
        named.picture = Some(format!("stills/{name}.png").into());
        named
    });
    let views = encode_views(&cameras, Path::new(""))?;
    ga_files::write("views.json", views.as_bytes())?;
    Ok(StereoRig { left, right })
}

/// Writes the disparities that a matcher without errors would find.
fn write_truth(rig: &StereoRig, truth: &Truth) -> Result<()> {
    let (map, visible) = true_disparities(rig, truth)?;
    ga_files::write_together([
        (
            "truth/disparity.pfm",
            pfm::encode(map.plane(), ByteOrder::Little)?.as_slice(),
        ),
        ("truth/visible.png", png::encode(&visible)?.as_slice()),
    ])?;
    Ok(())
}

/// The disparities that were found.
pub(super) fn found_disparities() -> Result<DisparityMap> {
    Ok(ga_vision::disparity::file::read("disparity.pfm", None)?)
}

/// The rig of rectified pictures.
pub(super) fn rectified(rig: &StereoRig) -> Result<RectifiedRig> {
    let options = RectificationOptions::default();
    Ok(Rectification::new(rig, SIZE, options)?.rig)
}
