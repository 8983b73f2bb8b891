//! `nullcone skin`: one moment of an animated glTF model as a mesh.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_anim::gltf::Moment;
use ga_anim::skin;
use ga_mesh::format::{self, Options};
use ga_mesh::gltf;
use serde::Serialize;

use crate::chosen_animation::{ChosenAnimation, warn_of_times};
use crate::format::Format;
use crate::frame::{self, Command, Context, Warning};
use crate::mesh_file;

/// Pose an animated glTF model at a time and write it as a mesh in world space.
///
/// The mesh has the normals, texture coordinates, colours and materials of the model, as far as the
/// format of the output has them: Wavefront OBJ with its materials (.mtl) and pictures, PLY, or
/// glTF. Paths of pictures are written relative to the output. OBJ has the vertices of each node
/// that has a mesh, in rising index of the nodes, each primitive in order and all vertices of its
/// POSITION, so that they are numbered as in the file. Morph targets displace them first; then the
/// joints of the skin move them, or the node where it has no skin. Its coordinates are written with
/// as many digits as read back exactly. In other formats vertices may be numbered otherwise.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The model: glTF 2.0 (.glb or .gltf).
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    #[command(flatten)]
    animation: ChosenAnimation,
    /// The time in seconds. Before the first key of a channel the first key counts, after the last
    /// key the last. A time that the animation does not have is warned of.
    #[arg(long, value_name = "SECONDS")]
    time: f64,
    /// How the joints that move a vertex are combined.
    #[arg(long, value_enum, default_value_t)]
    method: Method,
    /// The mesh to be written, in the format that the ending of its name says.
    #[arg(long, value_name = "FRAME.obj|FRAME.glb|FRAME.ply")]
    out: PathBuf,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Method {
    /// The mean of the places to which the joints would take the vertex. A joint that twists takes
    /// volume away.
    #[default]
    Linear,
    /// The mean of the joints' motors, which keeps the distance to a joint; scale is kept.
    Motor,
    /// The same without scale, as dual quaternion skinning is usually defined.
    DualQuaternion,
}

impl From<Method> for skin::Method {
    fn from(method: Method) -> Self {
        match method {
            Method::Linear => Self::Linear,
            Method::Motor => Self::Motor,
            Method::DualQuaternion => Self::DualQuaternion,
        }
    }
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        ensure!(
            arguments.time.is_finite(),
            "--time {}: the time must be finite",
            arguments.time
        );
        let (model, out) = (&arguments.model, &arguments.out);
        let mut formats = mesh_file::formats(|_| true);
        // Standard output takes the first.
        formats.sort_by_key(|format| *format != Format::Mesh(format::Format::Obj));
        let format = context.files([model])?.write("--out", out, &formats)?;
        let document = gltf::read(model)?;
        let named = || model.display().to_string();
        let animation = arguments.animation.number(&document).with_context(named)?;
        let mut warnings = Vec::new();
        let played = animation.and_then(|number| document.animations.get(number));
        warn_of_times(model, played, [arguments.time; 2], &mut warnings);
        let moment = Moment::new(
            &document,
            animation,
            arguments.time,
            arguments.method.into(),
        );
        let moment = moment.with_context(named)?;
        let mesh = format::relocated(&moment.mesh, model, out)?;
        let files = mesh_file::files(out, format, &mesh, &Options::default())?;
        mesh_file::check_parts("--out", &[model], &files[1..])?;
        let written = mesh_file::write(&mesh, &files, context.outputs())?;
        if let Format::Mesh(format) = format {
            let omissions = format.omissions(&mesh).into_iter();
            warnings.extend(omissions.map(|text| Warning::new("omission", text).in_file(out)));
        }
        Ok(Report {
            out: out.display().to_string(),
            files: written.files,
            moment,
            warnings,
        })
    }
}

/// What was written.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    out: String,
    files: Vec<String>,
    #[serde(flatten)]
    moment: Moment,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let Self { out, moment, .. } = self;
        let shown = match (moment.animation, moment.duration_seconds) {
            (Some(animation), Some(duration)) => {
                let name = moment.animation_name.as_ref();
                let name = name.map_or(String::new(), |name| format!(" ({name})"));
                let time = moment.time_seconds;
                format!("animation {animation}{name} at {time} s of {duration} s")
            }
            _ => "the pose of the nodes".to_owned(),
        };
        let (vertices, faces) = (moment.vertices, moment.faces);
        format!("wrote {out}: {vertices} vertices and {faces} faces, {shown}\n")
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }
}
