//! `nullcone animate`: a figure and a recorded motion from files.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Result, bail, ensure};
use ga_character::Figure;

use crate::frame::{Command, Context};
use crate::mesh_file;
use crate::motion_file;
use crate::pipeline::{self, OutputArguments, perform};
use crate::reading::reading;
use crate::report::Performed;
use crate::retargeted::{End, FigureFiles, RetargetedArguments};

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
    #[command(flatten)]
    retargeting: RetargetedArguments,
    /// Smooth the skin weights: in each pass, those of every vertex move half the way to the mean
    /// of those of its neighbours. At most 100.
    ///
    /// Painted weights may change from one bone to the next within a single edge, which shows as a
    /// ring about a bent elbow or a crease across the chest. 10 to 20 are usual.
    #[arg(long, value_name = "TIMES", default_value_t = 0)]
    smooth_weights: usize,
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
        files.chain(self.retargeting.inputs())
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
    let progress = context.progress(pipeline::STEPS + 2);
    progress.step("reading the figure");
    let figure = figure(arguments)?.with_smoothed_weights(arguments.smooth_weights)?;
    let mut warnings = pipeline::not_in_obj(&figure, arguments.character.as_deref())?;
    if let Some(mesh) = &arguments.mesh {
        warnings.extend(mesh_file::warnings_of(mesh, figure.warnings.clone()));
    }
    progress.step("transferring the motion");
    let rig = arguments.rig().unwrap_or(Path::new("the figure"));
    let onto = (&figure.character, &*rig.to_string_lossy());
    let end = End::Frame(arguments.to);
    let retargeted = arguments
        .retargeting
        .retarget(&arguments.motion, end, onto, &mut warnings)?;
    let figure_file = |part: &Option<PathBuf>| {
        let path = arguments.character.as_ref().or(part.as_ref());
        path.map(|path| ga_files::name(path)).unwrap_or_default()
    };
    let files = FigureFiles {
        mesh: figure_file(&arguments.mesh),
        rig: figure_file(&arguments.rig),
        weights: figure_file(&arguments.weights),
    };
    let performance = retargeted.performance("animate", files, figure, arguments.fps)?;
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
    motion_file::checked_unit("--metres-per-unit", Some(arguments.metres_per_unit()))?;
    let times = arguments.smooth_weights;
    ensure!(
        times <= 100,
        "--smooth-weights {times}: at most 100 times are possible"
    );
    if let (Some(from), Some(to)) = (arguments.retargeting.from, arguments.to) {
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
