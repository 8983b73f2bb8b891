//! `nullcone animate`: a figure and a recorded motion from files.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context as _, Result, bail, ensure};
use ga_anim::bvh::{self, Bvh};
use ga_anim::character::Character;
use ga_anim::clip::Clip;
use ga_anim::retarget::{FootLocking, JointMap, Retarget, Soles};
use ga_character::{Animation, Figure, Storyboard};

use crate::frame::{Command, Context};
use crate::motion_file;
use crate::pipeline::{self, OutputArguments, Performance, perform};
use crate::report::{Input, MotionInput, Performed};

/// Animate your own figure with a recorded motion.
///
/// Writes the same files as `demo`: model.obj (the mesh at rest), model.glb (mesh, skeleton, skin
/// weights and the motion), sheet.png (key frames at four places of the range with three
/// in-betweens after each, shaded and as depth) and report.json. Lengths are metres, y points up.
/// --json prints what report.json holds, with the paths of the files as "written" and the time that
/// it took as "seconds".
///
/// Motion and rig are matched by the names of their joints: equal names, and the usual names of
/// Mixamo, MakeHuman, CMU, 3ds Max Biped, and such as `UpperLeg_L`. With --map, they are matched by
/// a file. They may differ in unit, in proportions and in how the arms and legs stand at rest.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The mesh: Wavefront OBJ, y up, looking along +z, standing upright.
    #[arg(long, value_name = "FILE.obj", required_unless_present = "character")]
    mesh: Option<PathBuf>,
    /// The skeleton: JSON as MakeHuman's rigs for Blender.
    #[arg(long, value_name = "FILE.json", required_unless_present = "character")]
    rig: Option<PathBuf>,
    /// The skin weights: JSON as MakeHuman's, for all vertices of the mesh.
    #[arg(long, value_name = "FILE.json", required_unless_present = "character")]
    weights: Option<PathBuf>,
    /// The figure in one file, in place of mesh, rig and weights: glTF 2.0 (.glb or .gltf), y up.
    ///
    /// The figure is all meshes with a skin, as they stand without an animation.
    #[arg(long, value_name = "FILE.glb", conflicts_with_all = ["mesh", "rig", "weights", "group"])]
    character: Option<PathBuf>,
    /// The motion: BVH, y up, in any unit.
    #[arg(long, value_name = "FILE.bvh")]
    motion: PathBuf,
    /// Which joints belong together, where their names do not say so: JSON, as in {"LeftUpLeg":
    /// "thigh_l", "LeftLeg": "calf_l"}, the joint of the motion first. Other joints of the rig
    /// move with the ones above them. `nullcone clip retarget --json` prints such a map, found by
    /// the shape of the hierarchy.
    #[arg(long, value_name = "FILE.json")]
    map: Option<PathBuf>,
    /// Keep feet in their places that stand in the motion; thighs and shins deviate for that.
    #[arg(long)]
    foot_locking: bool,
    /// Smooth the skin weights: in each pass, those of every vertex move half the way to the mean
    /// of those of its neighbours. At most 100.
    ///
    /// Painted weights may change from one bone to the next within a single edge, which shows as a
    /// ring about a bent elbow or a crease across the chest. 10 to 20 are usual.
    #[arg(long, value_name = "TIMES", default_value_t = 0)]
    smooth_weights: usize,
    /// The first frame of the motion, counted from 0.
    ///
    /// The default is 0, or 1 where frame 0 is a calibration pose (such as a T): a joint then moves
    /// more than three times as far from frame 0 to frame 1 as between any two later frames. The
    /// summary and the report say when that is so.
    #[arg(long, value_name = "F")]
    from: Option<usize>,
    /// The last frame of the motion; by default the last one of the file.
    #[arg(long, value_name = "F")]
    to: Option<usize>,
    /// Frames per second of the animation in model.glb, at most 1000. At 30, 23 seconds of 31
    /// joints add 0.3 MB.
    #[arg(long, value_name = "N", default_value_t = 30.0)]
    fps: f64,
    /// The group of the mesh that is the figure; by default `body` where there is such a group,
    /// otherwise the whole mesh.
    ///
    /// Meshes made for modelling contain more than the body: guides for clothes, cubes that mark
    /// joints.
    #[arg(long, value_name = "NAME")]
    group: Option<String>,
    /// The length of one unit of the mesh in metres; by default 1 for --character, otherwise 0.1,
    /// since MakeHuman's unit is the decimetre.
    #[arg(long, value_name = "N")]
    metres_per_unit: Option<f64>,
    #[command(flatten)]
    output: OutputArguments,
}

impl Arguments {
    fn metres_per_unit(&self) -> f64 {
        let default = if self.character.is_some() { 1.0 } else { 0.1 };
        self.metres_per_unit.unwrap_or(default)
    }

    fn inputs(&self) -> impl Iterator<Item = &PathBuf> {
        let figure = [&self.mesh, &self.rig, &self.weights, &self.character];
        let files = figure.into_iter().chain([&self.map]).flatten();
        files.chain([&self.motion])
    }

    /// The file of the skeleton.
    fn rig(&self) -> Option<&Path> {
        self.character.as_deref().or(self.rig.as_deref())
    }
}

impl Command for Arguments {
    type Report = Performed;

    fn run(&self, context: &Context) -> Result<Performed> {
        animate(self, context)
    }
}

fn animate(arguments: &Arguments, context: &Context) -> Result<Performed> {
    let begin = Instant::now();
    check_numbers(arguments)?;
    arguments.output.check(context.files(arguments.inputs())?)?;
    let progress = context.progress(pipeline::STEPS + 3);
    progress.step("reading the figure");
    let figure = figure(arguments)?.with_smoothed_weights(arguments.smooth_weights)?;
    progress.step("reading the motion");
    let mut warnings = Vec::new();
    let motion = motion_file::read(&arguments.motion, &mut warnings)?;
    progress.step("transferring the motion");
    let range = frames(arguments, &motion)?;
    let retargeted = retarget(arguments, &figure.character, &motion, range)?;
    let clip = retargeted
        .clip
        .resampled(arguments.fps)
        .with_context(|| format!("--fps {}", arguments.fps))?;

    let storyboard = Storyboard::of_recording(&retargeted.clip, range.from);
    let deviation = storyboard.deviation(&figure.character, &retargeted.clip)?;
    let motion_name = ga_files::name(&arguments.motion);
    let figure_file = |part: &Option<PathBuf>| {
        let path = arguments.character.as_ref().or(part.as_ref());
        path.map(|path| ga_files::name(path)).unwrap_or_default()
    };
    let input = Input {
        mesh: figure_file(&arguments.mesh),
        rig: figure_file(&arguments.rig),
        weights: figure_file(&arguments.weights),
        motion: MotionInput {
            name: motion_name.clone(),
            joints: motion.joints().len(),
            frames: motion.frame_count(),
            frames_per_second: 1.0 / motion.frame_time(),
            first_frame: range.from,
            last_frame: range.to,
            calibration_frame_left_out: range.calibration_left_out,
            joints_without_counterpart: retargeted.unmatched,
            metres_per_unit: retargeted.scale,
        },
    };
    let performance = Performance {
        command: "animate",
        input,
        figure,
        animation: Animation {
            name: ga_files::stem(&arguments.motion),
            clip,
            storyboard,
            title: format!(
                "{motion_name}, frames {} to {}: keys and 3 in-betweens after each by screw motion",
                range.from, range.to
            ),
            in_between_deviation: Some(deviation),
        },
    };
    let performed = perform(performance, &arguments.output, &progress, begin)?;
    Ok(Performed {
        warnings,
        ..performed
    })
}

fn check_numbers(arguments: &Arguments) -> Result<()> {
    let fps = arguments.fps;
    ensure!(
        fps > 0.0 && fps <= 1000.0,
        "--fps {fps}: the number of frames per second must be greater than 0 and at most 1000"
    );
    let unit = arguments.metres_per_unit();
    ensure!(
        unit > 0.0 && unit.is_finite(),
        "--metres-per-unit {unit}: the length of a unit must be greater than 0 and finite"
    );
    let times = arguments.smooth_weights;
    ensure!(
        times <= 100,
        "--smooth-weights {times}: at most 100 times are possible"
    );
    if let (Some(from), Some(to)) = (arguments.from, arguments.to) {
        ensure!(from <= to, "--from {from} comes after --to {to}");
    }
    Ok(())
}

/// The figure in metres.
fn figure(arguments: &Arguments) -> Result<Figure> {
    let unit = arguments.metres_per_unit();
    Ok(match arguments {
        Arguments {
            character: Some(path),
            ..
        } => Figure::read_gltf(path, unit)?,
        Arguments {
            mesh: Some(mesh),
            rig: Some(rig),
            weights: Some(weights),
            group,
            ..
        } => Figure::read_parts(mesh, rig, weights, group.as_deref(), unit)?,
        _ => bail!("--mesh, --rig and --weights, or --character, are needed"),
    })
}

/// A range of frames of the motion, both ends included.
#[derive(Clone, Copy)]
struct Range {
    from: usize,
    to: usize,
    calibration_left_out: bool,
}

fn frames(arguments: &Arguments, motion: &Bvh) -> Result<Range> {
    let count = motion.frame_count();
    let path = arguments.motion.display();
    ensure!(count > 0, "{path}: the motion has no frames");
    for (option, frame) in [("--from", arguments.from), ("--to", arguments.to)] {
        if let Some(frame) = frame.filter(|&frame| frame >= count) {
            let last = count - 1;
            bail!("{option} {frame}: the frames of {path} are 0 to {last}");
        }
    }
    let to = arguments.to.unwrap_or(count - 1);
    let calibration_left_out =
        arguments.from.is_none() && to > 0 && bvh::begins_with_calibration(motion);
    Ok(Range {
        from: arguments.from.unwrap_or(calibration_left_out.into()),
        to,
        calibration_left_out,
    })
}

/// The motion on the figure.
struct Retargeted {
    clip: Clip,
    unmatched: Vec<String>,
    scale: f64,
}

fn retarget(
    arguments: &Arguments,
    character: &Character,
    motion: &Bvh,
    range: Range,
) -> Result<Retargeted> {
    let onto = || {
        format!(
            "{} cannot move {}",
            arguments.motion.display(),
            arguments.rig().unwrap_or(Path::new("the figure")).display()
        )
    };
    let Character {
        mesh,
        skeleton,
        weights,
    } = character;
    let soles = Soles::of_mesh(mesh.positions(), weights).with_context(onto)?;
    let map = match &arguments.map {
        Some(path) => ga_files::read(path, |bytes| JointMap::decode(bytes, motion, skeleton))?,
        None => JointMap::by_names(motion, skeleton),
    };
    let retarget = Retarget::with_map(motion, skeleton, &soles, &map).with_context(onto)?;
    let frames = range.from..=range.to;
    let clip = if arguments.foot_locking {
        // The person of the motion is as large as the figure, which is in metres.
        let locked = retarget.with_foot_locking(&FootLocking::new(retarget.scale()));
        locked.and_then(|locked| locked.clip(frames))
    } else {
        retarget.clip(frames)
    };
    Ok(Retargeted {
        clip: clip.with_context(onto)?,
        unmatched: retarget.unmatched().map(ToOwned::to_owned).collect(),
        scale: retarget.scale(),
    })
}
