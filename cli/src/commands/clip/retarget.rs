//! `nullcone clip retarget`: a motion on another skeleton.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_anim::bvh::Bvh;
use ga_anim::clip::Clip;
use ga_anim::clip::compressed::{self, Options};
use ga_anim::gltf::{Rigged, character};
use ga_anim::recording::Recording;
use ga_anim::retarget::{Alignment, Contact, FootLocking, JointMap, Retarget, Soles};
use ga_anim::skeleton::Skeleton;
use ga_anim::unit::likely_unit;
use serde::Serialize;
use serde_json::Value;

use super::input::{Kind, MotionArguments};
use crate::figure_file::stem;
use crate::format::Format;
use crate::frame::{self, Check, Command, Context, Progress, Verdict, Warning};
use crate::motion_file;
use crate::output;
use crate::shell::quoted;

/// Transfer a motion to another skeleton.
///
/// Joints are matched by the usual names (Mixamo, MakeHuman, CMU, 3ds Max Biped, UpperLeg_L), by
/// the shape of the hierarchy where the names say nothing, or by a file given with --map. Matched
/// bones become parallel to those of the motion and keep their lengths; other joints move with the
/// ones above them. The scale is the ratio of the lengths of the legs, and the feet are put on the
/// ground at y = 0. Both bodies stand upright at rest, y up.
///
/// With --foot-locking, a foot whose ankle is slower than 0.05 m/s in the motion stays in one
/// place, and only thighs and shins deviate for that. A leg that is too short is reported. Where
/// the unit of a .bvh is not given, it is guessed for these speeds by the length of the legs.
///
/// For instance
///
///   nullcone clip retarget 01_01.bvh --metres-per-unit 0.056444 --target hero.glb --foot-locking
///   --out hero-jumps.glb --json
///
/// writes hero.glb with the motion as its animation and prints {"frames": 2752, "joints": …,
/// "map_by": "names", "map": {"LeftUpLeg": "thigh_l", …}, "slide_metres": …, "feet": […], …}. A map
/// that is printed is of the form that --map reads: the joint of the motion first, and the joint of
/// the target, or a list of them. slide_metres is how far apart two places of an ankle are at most
/// while it stands, in what is written; slide_free_metres is the same without --foot-locking. The
/// verdict is doubtful where there is a warning, otherwise good.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    /// The skeleton: BVH at rest, or the joints of a glTF file as its nodes stand without an
    /// animation.
    #[arg(long, value_name = "FILE.bvh|FILE.glb")]
    target: PathBuf,
    /// The length of one unit of a target of the kind .bvh in metres [default: 1].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    target_metres_per_unit: Option<f64>,
    /// Which joints belong together: JSON, as in {"LeftUpLeg": "thigh_l", "Spine": ["spine_01",
    /// "spine_02"]}, the joint of the motion first.
    #[arg(long, value_name = "FILE.json")]
    map: Option<PathBuf>,
    /// Keep standing feet in their places.
    #[arg(long)]
    foot_locking: bool,
    /// Which bones become parallel to those of the motion.
    #[arg(long, value_enum, default_value_t = Bones::All)]
    align: Bones,
    /// The greatest error of a joint in a target of the kind .clip.
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 1e-4,
        allow_negative_numbers = true
    )]
    tolerance: f64,
    /// The motion to be written. A .glb keeps the nodes, meshes and skins of a target of that kind,
    /// and a .bvh the channels of a target of that kind.
    #[arg(long, value_name = "OUT.bvh|OUT.glb|OUT.clip")]
    out: PathBuf,
    #[command(flatten)]
    check: Check,
}

/// Which bones become parallel.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Bones {
    /// One bone of every matched joint.
    All,
    /// Those of arms and legs; the trunk keeps its form, which suits a skin.
    Limbs,
}

impl Command for Arguments {
    type Report = Report;

    fn is_check(&self) -> bool {
        self.check.check
    }

    fn run(&self, context: &Context) -> Result<Report> {
        retarget(self, context)
    }
}

fn retarget(arguments: &Arguments, context: &Context) -> Result<Report> {
    let inputs = [arguments.motion.path(), &arguments.target].into_iter();
    let inputs = inputs.chain(arguments.map.as_deref());
    let mut files = context.files(inputs)?;
    let formats = [Format::Bvh, Format::Glb, Format::Gltf, Format::Clip];
    let format = files.write("--out", &arguments.out, &formats)?;
    let progress = context.progress(5);
    let mut warnings = Vec::new();
    progress.step("reading the target");
    let target = Target::read(arguments, &mut warnings)?;
    progress.step("reading the motion");
    let (source, _) = arguments.motion.any_recording(&mut warnings)?;
    let file = arguments.motion.file();
    let (map, map_by) = map(arguments, &source, &target)?;

    progress.step("transferring the motion");
    let onto = || format!("{file} cannot move {}", arguments.target.display());
    let alignment = match arguments.align {
        Bones::All => Alignment::EveryBone,
        Bones::Limbs => Alignment::Limbs,
    };
    let skeleton = &target.skeleton;
    let retarget = Retarget::with_alignment(&source, skeleton, &target.soles, &map, alignment)
        .with_context(onto)?;
    let source_unit = match (arguments.motion.kind()?, arguments.motion.given_unit()) {
        (Kind::Bvh, None) => likely_metres(&source, &file, &mut warnings)?,
        // A recording in metres.
        _ => 1.0,
    };
    let target_unit = match arguments.target_metres_per_unit {
        None => match &target.bvh {
            Some(bvh) => {
                let file = arguments.target.display().to_string();
                likely_metres(&Recording::from_bvh(bvh, 1.0)?, &file, &mut warnings)?
            }
            None => 1.0,
        },
        Some(unit) => unit,
    };
    let locked = retarget
        .with_foot_locking(&FootLocking::new(source_unit))
        .with_context(onto)?;
    let frames = 0..=source.frame_count() - 1;
    let clip = match arguments.foot_locking {
        true => locked.clip(frames),
        false => retarget.clip(frames),
    };
    let clip = clip.with_context(onto)?;

    let report = Report {
        file: file.clone(),
        target: arguments.target.display().to_string(),
        out: arguments.out.display().to_string(),
        frames: clip.frames().len(),
        joints: skeleton.len(),
        frame_time_seconds: clip.frame_time(),
        target_units_per_unit: retarget.scale(),
        motion_metres_per_unit: source_unit,
        target_metres_per_unit: target_unit,
        map_by,
        map: map.to_json(&source, skeleton),
        joints_without_counterpart: retarget.unmatched().map(ToOwned::to_owned).collect(),
        foot_locking: arguments.foot_locking,
        feet: Vec::new(),
        warnings,
        slide_metres: 0.0,
        slide_free_metres: 0.0,
        short_by_metres: 0.0,
    };
    let report = report.with_feet(locked.contacts(), skeleton, target_unit);
    progress.step("writing");
    write(arguments, format, &target, &clip, &progress)?;
    Ok(report)
}

/// The map of joints, and where it comes from.
fn map(
    arguments: &Arguments,
    source: &Recording,
    target: &Target,
) -> Result<(JointMap, &'static str)> {
    let skeleton = &target.skeleton;
    if let Some(path) = &arguments.map {
        let map = ga_files::read(path, |bytes| JointMap::decode(bytes, source, skeleton))?;
        return Ok((map, "file"));
    }
    let map = JointMap::by_names_or_structure(source, skeleton);
    let by = if map == JointMap::by_names(source, skeleton) {
        "names"
    } else {
        "structure"
    };
    Ok((map, by))
}

/// The length of a unit in metres where it is not given.
fn likely_metres(body: &Recording, file: &str, warnings: &mut Vec<Warning>) -> Result<f64> {
    let unit = likely_unit(body).with_context(|| format!("{file}: the body has no bones"))?;
    if !unit.is_clear {
        let message = format!(
            "the length of a unit is not clear: {:.6} m is taken, with which the body is as large \
             as an adult",
            unit.metres
        );
        warnings.push(Warning::new("unclear_unit", message).in_file(Path::new(file)));
    }
    Ok(unit.metres)
}

/// A skeleton from a file, and what is needed to write motions of it.
struct Target {
    skeleton: Skeleton,
    soles: Soles,
    bvh: Option<Bvh>,
    rigged: Option<Rigged>,
}

impl Target {
    fn read(arguments: &Arguments, warnings: &mut Vec<Warning>) -> Result<Self> {
        let path = &arguments.target;
        let shown = || path.display().to_string();
        let unit = arguments.target_metres_per_unit;
        if let Some(unit) = unit {
            ensure!(
                unit > 0.0 && unit.is_finite(),
                "--target-metres-per-unit {unit}: the length of a unit must be greater than 0 and \
                 finite"
            );
        }
        match Kind::of(path).context("--target")? {
            Kind::Bvh => {
                let motion = motion_file::read(path, warnings)?;
                let skeleton = motion.skeleton().with_context(shown)?;
                Ok(Self {
                    soles: Soles::of_skeleton(&skeleton),
                    skeleton,
                    bvh: Some(motion),
                    rigged: None,
                })
            }
            Kind::Gltf => {
                ensure!(
                    unit.is_none(),
                    "--target-metres-per-unit does not apply to {}, which is in metres",
                    path.display()
                );
                let document = ga_mesh::gltf::read(path)?;
                let rigged = Rigged::new(&document).with_context(shown)?;
                let skeleton = rigged.skeleton().clone();
                // The lowest vertices where there is a skin.
                let soles = match character(&document) {
                    Ok(body) if body.skeleton == skeleton => {
                        Soles::of_mesh(body.mesh.positions(), &body.weights).with_context(shown)?
                    }
                    _ => Soles::of_skeleton(&skeleton),
                };
                Ok(Self {
                    skeleton,
                    soles,
                    bvh: None,
                    rigged: Some(rigged),
                })
            }
            Kind::Clip => anyhow::bail!(
                "--target {}: a skeleton is a file of the kind .bvh, .glb or .gltf",
                path.display()
            ),
        }
    }

    /// The motion as BVH, in the unit of the target.
    fn to_bvh(&self, clip: &Clip) -> Result<Bvh> {
        Ok(match &self.bvh {
            Some(bvh) => bvh.with_clip(&self.skeleton, clip)?,
            None => Bvh::from_clip(&self.skeleton, clip)?,
        })
    }

    /// The motion as glTF.
    fn to_gltf(&self, name: &str, unit: f64, clip: &Clip) -> Result<ga_mesh::gltf::Document> {
        if let Some(rigged) = &self.rigged {
            return Ok(rigged.with_clip(name, clip)?);
        }
        let recording = Recording::from_bvh(&self.to_bvh(clip)?, unit)?;
        let rigged = Rigged::of_skeleton(&recording.to_skeleton()?);
        Ok(rigged.with_clip(name, &recording.to_clip()?)?)
    }

    /// The motion with the axes of the target's joints, in metres.
    fn to_recording(&self, name: &str, unit: f64, clip: &Clip) -> Result<Recording> {
        if self.rigged.is_some() {
            let document = self.to_gltf(name, unit, clip)?;
            return Ok(Recording::from_gltf(&document, 0, 1.0, None)?);
        }
        Ok(Recording::from_bvh(&self.to_bvh(clip)?, unit)?)
    }
}

fn write(
    arguments: &Arguments,
    format: Format,
    target: &Target,
    clip: &Clip,
    progress: &Progress,
) -> Result<()> {
    let out = &arguments.out;
    let name = stem(Path::new(&arguments.motion.file()));
    let unit = arguments.target_metres_per_unit.unwrap_or(1.0);
    let shown = || format!("{} cannot be written", out.display());
    match format {
        Format::Glb => {
            let document = target.to_gltf(&name, unit, clip).with_context(shown)?;
            output::write(out, &ga_mesh::gltf::encode(&document).with_context(shown)?)?;
        }
        Format::Gltf => {
            let document = target.to_gltf(&name, unit, clip).with_context(shown)?;
            ga_mesh::gltf::write(out, &document)?;
        }
        Format::Clip => {
            let recording = target.to_recording(&name, unit, clip).with_context(shown)?;
            let options = Options {
                tolerance: arguments.tolerance,
                ..Options::default()
            };
            let clip = compressed::compress(&recording, &options, |done, steps| {
                progress.at(done as u64, steps as u64);
            });
            output::write(out, clip.with_context(shown)?.as_bytes())?;
        }
        _ => {
            let text = target.to_bvh(clip).with_context(shown)?.encode();
            output::write(out, text.as_bytes())?;
        }
    }
    Ok(())
}

/// What was written, with which joints, and how feet stand.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    file: String,
    target: String,
    out: String,
    frames: usize,
    joints: usize,
    frame_time_seconds: f64,
    /// How long one unit of the motion is in units of the target.
    target_units_per_unit: f64,
    motion_metres_per_unit: f64,
    target_metres_per_unit: f64,
    map_by: &'static str,
    map: Value,
    joints_without_counterpart: Vec<String>,
    foot_locking: bool,
    /// The greatest ones of all feet.
    slide_metres: f64,
    slide_free_metres: f64,
    short_by_metres: f64,
    feet: Vec<FootReport>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

/// A foot while it stands.
#[derive(Debug, Serialize)]
struct FootReport {
    /// The joint of the target.
    joint: String,
    /// How many times it stands, and in how many frames.
    contacts: usize,
    standing_frames: usize,
    /// How far apart two places of the ankle are at most during a contact, as it is written and
    /// without foot locking.
    slide_metres: f64,
    slide_free_metres: f64,
    /// How far it is at most from where it should stand, and the first frame of that contact.
    short_by_metres: f64,
    short_in_frame: Option<usize>,
}

impl FootReport {
    /// Where the leg is too short.
    fn warning(&self) -> Option<Warning> {
        const NOTABLE: f64 = 0.005;
        let short = |_: &usize| self.short_by_metres > NOTABLE;
        let frame = self.short_in_frame.filter(short)?;
        let message = format!(
            "the leg above {} is too short: from frame {frame} on, the foot stands {:.1} cm from \
             its place",
            self.joint,
            100.0 * self.short_by_metres
        );
        Some(Warning {
            joint: Some(self.joint.clone()),
            frame: Some(frame),
            ..Warning::new("leg_too_short", message)
        })
    }
}

impl Report {
    fn with_feet(mut self, contacts: &[Contact], skeleton: &Skeleton, unit: f64) -> Self {
        for contact in contacts {
            let joint = &skeleton.joints()[contact.ankle].name;
            if self.feet.last().is_none_or(|foot| foot.joint != *joint) {
                self.feet.push(FootReport {
                    joint: joint.clone(),
                    contacts: 0,
                    standing_frames: 0,
                    slide_metres: 0.0,
                    slide_free_metres: 0.0,
                    short_by_metres: 0.0,
                    short_in_frame: None,
                });
            }
            let Some(foot) = self.feet.last_mut() else {
                continue;
            };
            let (slide, short) = match self.foot_locking {
                true => (contact.slide, contact.short_by),
                false => (contact.slide_before, 0.0),
            };
            foot.contacts += 1;
            foot.standing_frames += contact.frames.end() + 1 - contact.frames.start();
            foot.slide_metres = foot.slide_metres.max(slide * unit);
            foot.slide_free_metres = foot.slide_free_metres.max(contact.slide_before * unit);
            if short * unit > foot.short_by_metres {
                foot.short_by_metres = short * unit;
                foot.short_in_frame = Some(*contact.frames.start());
            }
        }
        let greatest = |of: fn(&FootReport) -> f64| self.feet.iter().map(of).fold(0.0, f64::max);
        self.slide_metres = greatest(|foot| foot.slide_metres);
        self.slide_free_metres = greatest(|foot| foot.slide_free_metres);
        self.short_by_metres = greatest(|foot| foot.short_by_metres);
        self.warnings
            .extend(self.feet.iter().filter_map(FootReport::warning));
        self
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn verdict(&self) -> Option<Verdict> {
        Some(match self.warnings.is_empty() {
            true => Verdict::Good,
            false => Verdict::Doubtful,
        })
    }

    fn next(&self) -> Option<String> {
        let is_clip = Format::Clip.fits(Path::new(&self.out));
        is_clip.then(|| format!("nullcone clip info {}", quoted(&self.out)))
    }

    fn text(&self) -> String {
        let matched = self.joints - self.joints_without_counterpart.len();
        let mut lines = format!(
            "{}: {} frames on {} of {} joints of {}, matched by {}\n",
            self.out,
            self.frames,
            matched,
            self.joints,
            self.target,
            match self.map_by {
                "file" => "the map",
                by => by,
            }
        );
        for foot in &self.feet {
            lines += &format!(
                "{:10} stands {} times, in {} frames; slides {:.2} mm at most{}\n",
                foot.joint,
                foot.contacts,
                foot.standing_frames,
                1e3 * foot.slide_metres,
                match self.foot_locking {
                    true => format!(
                        ", {:.2} mm without foot locking",
                        1e3 * foot.slide_free_metres
                    ),
                    false => String::new(),
                }
            );
        }
        lines
    }
}
