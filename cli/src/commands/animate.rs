//! `nullcone animate`: a figure and a recorded motion from files.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context as _, Result, bail, ensure};
use ga_anim::character::Character;
use ga_anim::gltf::meshes_without_joint;
use ga_anim::motion_file::Options;
use ga_anim::recording::Recording;
use ga_anim::retarget::{Soles, Transfer, begins_with_calibration};
use ga_character::{Animation, Figure, Storyboard};

use crate::frame::{Command, Context, Warning};
use crate::pipeline::{self, OutputArguments, Performance, perform};
use crate::reading::reading;
use crate::report::{Input, MotionInput, Performed};
use crate::transfer::{Body, Motion, TransferArguments};
use crate::{mesh_file, motion_file};

/// Animate your own figure with a recorded motion.
///
/// Writes the same files as `demo`: model.obj (the mesh at rest), model.glb (mesh, skeleton, skin
/// weights and the motion; of a --character all that its file has, with the motion as the first
/// animation and those of the file behind it, unless --replace is given), sheet.png (key frames at
/// four places of the range with three in-betweens after each, shaded and as depth; a --character
/// as its file has it) and report.json. Lengths are metres, y points up. --json prints what
/// report.json holds, with the paths of the files as "written" and the time that it took as
/// "seconds". "checks" are those of `clip retarget`.
///
/// Motion and rig are matched as by `clip retarget`: by the names of their joints, by the shape of
/// the hierarchy, or by a file with --map. They may differ in unit, in proportions, in the
/// vertical, and in the pose in which rotations are zero.
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
    /// The figure is all meshes with a skin, in the pose in which they were bound.
    #[arg(long, value_name = "FILE.glb", conflicts_with_all = ["mesh", "rig", "weights", "group"])]
    character: Option<PathBuf>,
    /// Drop the animations that the file of --character has.
    #[arg(long, requires = "character")]
    replace: bool,
    /// The motion: BVH in any unit, the first animation of a glTF file, or a compressed clip.
    #[arg(long, value_name = "FILE.bvh|FILE.glb|FILE.clip")]
    motion: PathBuf,
    /// The length of one unit of the motion in metres [default: of BVH found from the length of the
    /// legs, of glTF 1]. A compressed clip is in metres.
    #[arg(long, value_name = "METRES")]
    motion_metres_per_unit: Option<f64>,
    #[command(flatten)]
    transfer: TransferArguments,
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
        let files = figure.into_iter().flatten().chain([&self.motion]);
        files.chain(self.transfer.inputs())
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
    let mut warnings = losses(arguments, &figure)?;
    if let Some(mesh) = &arguments.mesh {
        warnings.extend(mesh_file::warnings_of(mesh, figure.warnings.clone()));
    }
    let options = Options {
        metres_per_unit: arguments.motion_metres_per_unit,
        ..Options::default()
    };
    let option = "--motion-metres-per-unit";
    let motion = motion_file::read_any(&arguments.motion, options, option, &mut warnings)?;
    let unit = motion.metres_per_unit();
    let motion = motion
        .recording_in_units()
        .with_context(|| arguments.motion.display().to_string())?;
    progress.step("transferring the motion");
    let range = frames(arguments, &motion)?;
    let transfer = transferred(
        arguments,
        &figure.character,
        (&motion, unit),
        range,
        &mut warnings,
    )?;
    let clip = transfer
        .clip
        .resampled(arguments.fps)
        .with_context(|| format!("--fps {}", arguments.fps))?;

    let storyboard = Storyboard::of_recording(&transfer.clip, range.from);
    let deviation = storyboard.deviation(&figure.character, &transfer.clip)?;
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
            joints_without_counterpart: transfer.joints_without_counterpart,
            metres_per_unit: transfer.target_units_per_unit,
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
        checks: Some(transfer.checks),
    };
    let outputs = context.outputs();
    let mut performed = perform(performance, &arguments.output, outputs, &progress, begin)?;
    performed.warnings.splice(0..0, warnings);
    Ok(performed)
}

fn check_numbers(arguments: &Arguments) -> Result<()> {
    let fps = arguments.fps;
    ensure!(
        fps > 0.0 && fps <= 1000.0,
        "--fps {fps}: the number of frames per second must be greater than 0 and at most 1000"
    );
    let of_motion = arguments.motion_metres_per_unit;
    for (option, unit) in [
        ("--metres-per-unit", Some(arguments.metres_per_unit())),
        ("--motion-metres-per-unit", of_motion),
    ] {
        let unit = unit.unwrap_or(1.0);
        ensure!(
            unit > 0.0 && unit.is_finite(),
            "{option} {unit}: the length of a unit must be greater than 0 and finite"
        );
    }
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
        } => {
            let mut figure = Figure::read_gltf(path, unit)?;
            if let (Some(document), true) = (&mut figure.document, arguments.replace) {
                document.animations.clear();
            }
            figure
        }
        Arguments {
            mesh: Some(mesh),
            rig: Some(rig),
            weights: Some(weights),
            group,
            ..
        } => Figure::read_parts(mesh, rig, weights, group.as_deref(), unit, reading())?,
        _ => bail!("--mesh, --rig and --weights, or --character, are needed"),
    })
}

/// What of a document is not in the mesh of its character, and so not in model.obj.
fn losses(arguments: &Arguments, figure: &Figure) -> Result<Vec<Warning>> {
    let Some(document) = &figure.document else {
        return Ok(Vec::new());
    };
    let still = meshes_without_joint(document)?;
    let targets = document.meshes.iter().flat_map(|mesh| {
        let primitives = mesh.primitives.iter();
        primitives.map(|primitive| primitive.targets.len()).max()
    });
    let losses = [
        ("materials", document.materials.len()),
        ("morph targets", targets.sum()),
        ("meshes that no joint moves", still),
    ];
    let losses = losses.into_iter().filter(|(_, count)| *count > 0);
    let warnings = losses.map(|(what, count)| {
        let message = format!("{what} ({count}) are in model.glb and pictures, not in model.obj");
        let warning = Warning::new("omission", message);
        let warning = match &arguments.character {
            Some(path) => warning.in_file(path),
            None => warning,
        };
        Warning {
            what: Some(what),
            count: Some(count),
            ..warning
        }
    });
    Ok(warnings.collect())
}

/// A range of frames of the motion, both ends included.
#[derive(Clone, Copy)]
struct Range {
    from: usize,
    to: usize,
    calibration_left_out: bool,
}

fn frames(arguments: &Arguments, motion: &Recording) -> Result<Range> {
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
        arguments.from.is_none() && to > 0 && begins_with_calibration(motion);
    Ok(Range {
        from: arguments.from.unwrap_or(calibration_left_out.into()),
        to,
        calibration_left_out,
    })
}

/// The motion on the figure.
fn transferred(
    arguments: &Arguments,
    character: &Character,
    (motion, metres_per_unit): (&Recording, f64),
    range: Range,
    warnings: &mut Vec<Warning>,
) -> Result<Transfer> {
    let path = &arguments.motion;
    let onto = || {
        let rig = arguments.rig().unwrap_or(Path::new("the figure"));
        format!("{} cannot move {}", path.display(), rig.display())
    };
    let soles = Soles::of_mesh(character.mesh.positions(), &character.weights);
    let soles = soles.with_context(onto)?;
    let motion = Motion {
        file: path,
        source: motion,
        metres_per_unit,
        frames: Some([range.from, range.to]),
    };
    let body = Body {
        skeleton: &character.skeleton,
        soles: Some(&soles),
        motion: None,
        metres_per_unit: 1.0,
    };
    let transfer = arguments.transfer.transfer(&motion, &body, warnings);
    transfer.with_context(onto)
}
