//! `nullcone skin`: one moment of an animated glTF model as a mesh.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_anim::gltf::Moment;
use ga_anim::skin;
use ga_mesh::{gltf, obj};
use serde::Serialize;

use crate::format::Format;
use crate::frame::{self, Command, Context};
use crate::output;

/// Pose an animated glTF model at a time and write its vertices in world space.
///
/// The output has the vertices of each node that has a mesh, in rising index of the nodes, each
/// primitive in order and all vertices of its POSITION, so that they are numbered as in the file.
/// Morph targets displace them first; then the joints of the skin move them, or the node where it
/// has no skin. Coordinates are written with as many digits as read back exactly.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The model: glTF 2.0 (.glb or .gltf).
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// The number of the animation, from 0, or `rest` for the pose of the nodes alone. The default
    /// is 0, and `rest` for a model without animations.
    #[arg(long, value_name = "N", value_parser = choice)]
    animation: Option<Choice>,
    /// The time in seconds. Before the first key of a channel the first key counts, after the last
    /// key the last.
    #[arg(long, value_name = "SECONDS")]
    time: f64,
    /// How the joints that move a vertex are combined.
    #[arg(long, value_enum, default_value_t)]
    method: Method,
    /// The mesh to be written.
    #[arg(long, value_name = "FRAME.obj")]
    out: PathBuf,
}

/// The number of an animation, or none for the pose of the nodes.
type Choice = Option<usize>;

fn choice(text: &str) -> Result<Choice, &'static str> {
    match text {
        "rest" => Ok(None),
        number => match number.parse() {
            Ok(animation) => Ok(Some(animation)),
            Err(_) => Err("must be a number from 0, or `rest`"),
        },
    }
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
        let mut files = context.files([&arguments.model])?;
        files.write("--out", &arguments.out, &[Format::Obj])?;
        let document = gltf::read(&arguments.model)?;
        let first = || (!document.animations.is_empty()).then_some(0);
        let animation = arguments.animation.unwrap_or_else(first);
        let moment = Moment::new(
            &document,
            animation,
            arguments.time,
            arguments.method.into(),
        );
        let moment = moment.with_context(|| arguments.model.display().to_string())?;
        output::write(&arguments.out, obj::encode(&moment.mesh).as_bytes())?;
        Ok(Report {
            out: arguments.out.display().to_string(),
            moment,
        })
    }
}

/// What was written.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    out: String,
    #[serde(flatten)]
    moment: Moment,
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let Self { out, moment } = self;
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
}
