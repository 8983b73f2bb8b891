//! `nullcone skin`: one moment of an animated glTF model as a mesh.

use std::path::PathBuf;
use std::str::FromStr;

use anyhow::{Context as _, Result, ensure};
use clap::ValueEnum;
use ga_anim::gltf::{Part, Placement, Player};
use ga_anim::skin;
use ga_mesh::gltf::{self, Animation, Document};
use ga_mesh::{Mesh, obj};
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
    #[arg(long, value_name = "N")]
    animation: Option<Choice>,
    /// The time in seconds. Before the first key of a channel the first key counts, after the last
    /// key the last.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    time: f64,
    /// How the joints that move a vertex are combined.
    #[arg(long, value_enum, default_value_t)]
    method: Method,
    /// The mesh to be written.
    #[arg(long, value_name = "FRAME.obj")]
    out: PathBuf,
}

/// What moves the nodes.
#[derive(Clone, Copy, Debug)]
enum Choice {
    Animation(usize),
    Rest,
}

impl FromStr for Choice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "rest" => Ok(Self::Rest),
            number => match number.parse() {
                Ok(animation) => Ok(Self::Animation(animation)),
                Err(_) => Err("must be a number from 0, or `rest`".to_owned()),
            },
        }
    }
}

#[derive(Clone, Copy, Debug, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
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
        let animation = match arguments.animation {
            Some(Choice::Animation(animation)) => Some(animation),
            Some(Choice::Rest) => None,
            None => (!document.animations.is_empty()).then_some(0),
        };
        let in_model = || arguments.model.display().to_string();
        let player = Player::new(&document).with_context(in_model)?;
        let pose = player
            .pose(animation, arguments.time)
            .with_context(in_model)?;
        let placement = Placement::new(&player).with_context(in_model)?;
        let placed = placement
            .place(&pose, arguments.method.into())
            .with_context(in_model)?;
        ensure!(
            !placement.parts().is_empty(),
            "{}: no node has a mesh",
            arguments.model.display()
        );
        let mesh = placement.mesh(&placed).with_context(in_model)?;
        let text = obj::encode(&mesh);
        output::write(&arguments.out, text.as_bytes())?;
        Ok(Report::new(
            arguments, &document, animation, &placement, &mesh,
        ))
    }
}

/// What was written.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    out: String,
    /// `null` for the pose of the nodes alone.
    animation: Option<usize>,
    animation_name: Option<String>,
    /// How many animations the model has.
    animations: usize,
    /// The time of the animation's last key.
    duration_seconds: Option<f64>,
    time_seconds: f64,
    method: Method,
    vertices: usize,
    faces: usize,
    bounds: Option<Bounds>,
    parts: Vec<PartReport>,
}

/// The least and the greatest coordinates, in the unit of the model.
#[derive(Debug, Serialize)]
struct Bounds {
    min: [f64; 3],
    max: [f64; 3],
}

/// The vertices of a primitive of the mesh of a node.
#[derive(Debug, Serialize)]
struct PartReport {
    node: usize,
    node_name: Option<String>,
    mesh: usize,
    primitive: usize,
    skin: Option<usize>,
    first_vertex: usize,
    vertices: usize,
}

impl Report {
    fn new(
        arguments: &Arguments,
        document: &Document,
        animation: Option<usize>,
        placement: &Placement,
        mesh: &Mesh,
    ) -> Self {
        let played = animation.and_then(|index| document.animations.get(index));
        let part = |part: &Part| {
            let node = &document.nodes[part.node];
            PartReport {
                node: part.node,
                node_name: node.name.clone(),
                mesh: part.mesh,
                primitive: part.primitive,
                skin: node.skin,
                first_vertex: part.vertices.start,
                vertices: part.vertices.len(),
            }
        };
        Self {
            out: arguments.out.display().to_string(),
            animation,
            animation_name: played.and_then(|animation| animation.name.clone()),
            animations: document.animations.len(),
            duration_seconds: played.map(Animation::duration),
            time_seconds: arguments.time,
            method: arguments.method,
            vertices: mesh.vertex_count(),
            faces: mesh.faces().len(),
            bounds: mesh.bounds().map(|[min, max]| Bounds { min, max }),
            parts: placement.parts().iter().map(part).collect(),
        }
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        let moment = match (self.animation, self.duration_seconds) {
            (Some(animation), Some(duration)) => {
                let name = self.animation_name.as_ref();
                let name = name.map_or(String::new(), |name| format!(" ({name})"));
                let time = self.time_seconds;
                format!("animation {animation}{name} at {time} s of {duration} s")
            }
            _ => "the pose of the nodes".to_owned(),
        };
        let (out, vertices, faces) = (&self.out, self.vertices, self.faces);
        format!("wrote {out}: {vertices} vertices and {faces} faces, {moment}\n")
    }
}
