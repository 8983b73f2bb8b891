//! From where the model is seen.

use std::path::Path;

use anyhow::{Context as _, Result, bail, ensure};
use ga_character::animated_scene::camera_of;
use ga_mesh::gltf::{Document, Projection};
use ga_render::{Viewpoint, ViewpointError, view_file};

use super::arguments::Arguments;
use crate::camera_file::LensChoice;
use crate::format::Format;

const DEFAULT_SIZE: [u32; 2] = [1280, 720];

/// From where the model is seen.
pub(super) enum Camera {
    /// A place beside the model, or the camera of a file, with the size of the file's pictures.
    Outside(Viewpoint, Option<[u32; 2]>),
    /// The camera of a node of the model, with the quotient of width and height that it states.
    Node(usize, Option<f64>),
}

impl Camera {
    pub(super) fn new(arguments: &Arguments, document: Option<&Document>) -> Result<Self> {
        let (text, view) = (&arguments.camera, arguments.view.as_deref());
        let Some(name) = &arguments.camera_node else {
            let (viewpoint, size) = viewpoint(text, view, arguments.lens)?;
            return Ok(Self::Outside(viewpoint, size));
        };
        let path = arguments.model.display();
        let lens = arguments.lens;
        lens.refuse(&format!("--camera-node {name} is not a file of cameras"))?;
        let Some(document) = document else {
            bail!("--camera-node {name}: {path} is not a glTF model, which alone has cameras");
        };
        let node = node(document, name).with_context(|| path.to_string())?;
        let projection = camera_of(document, node).map(|camera| camera.projection);
        let aspect = match projection {
            Some(Projection::Perspective { aspect_ratio, .. }) => aspect_ratio.map(f64::from),
            _ => None,
        };
        Ok(Self::Node(node, aspect))
    }

    /// Columns and rows of the pictures.
    pub(super) fn picture_size(&self, arguments: &Arguments) -> Result<[u32; 2]> {
        let text = &arguments.camera;
        let asked = arguments.size.map(|size| size.map(|side| side as u32));
        Ok(match (self, asked) {
            (Self::Outside(_, Some(own)), Some(asked)) if *own != asked => bail!(
                "--size {}x{}: the camera {text} is for {}x{}",
                asked[0],
                asked[1],
                own[0],
                own[1]
            ),
            (Self::Outside(Viewpoint::View(_), None), None) => bail!(
                "{text}: the file does not say how large its pictures are: --size WxH is needed"
            ),
            (Self::Outside(_, Some(own)), _) => *own,
            (Self::Node(_, Some(aspect)), None) => {
                let [_, height] = DEFAULT_SIZE;
                [(f64::from(height) * aspect).round().max(1.0) as u32, height]
            }
            (_, asked) => asked.unwrap_or(DEFAULT_SIZE),
        })
    }
}

/// The path of a file of cameras, where the text is the name of one. Names of viewpoints mean them
/// whatever lies in the folder.
pub(super) fn file(text: &str) -> Option<&Path> {
    let Err(ViewpointError::Unknown(_)) = text.parse::<Viewpoint>() else {
        return None;
    };
    let path = Path::new(text.trim());
    let is_known = Format::of(path, &[Format::Json, Format::Yaml, Format::Text]).is_some();
    (is_known || path.exists()).then_some(path)
}

/// What `--camera` asks for, and columns and rows of the pictures of a camera of a file.
fn viewpoint(
    text: &str,
    name: Option<&str>,
    lens: LensChoice,
) -> Result<(Viewpoint, Option<[u32; 2]>)> {
    if let Some(path) = file(text) {
        let camera = lens.read_one(path, name)?;
        let view = view_file::from_camera(&camera).with_context(|| path.display().to_string())?;
        let size = camera.size.map(|size| size.map(|side| side as u32));
        return Ok((Viewpoint::View(view), size));
    }
    ensure!(
        name.is_none(),
        "--view chooses a camera of a file, and --camera {text} is none"
    );
    lens.refuse(&format!("--camera {text} is not a file of cameras"))?;
    match text.parse() {
        Ok(viewpoint) => Ok((viewpoint, None)),
        Err(ViewpointError::Unknown(_)) => bail!(
            "--camera {text}: not front, side, top, three-quarter, the file of a camera, or of the \
             form \"eye X,Y,Z target X,Y,Z fov DEGREES\""
        ),
        Err(error) => Err(error).context("--camera"),
    }
}

/// The node with a camera that has a name, whose camera has it, or of this number.
fn node(document: &Document, name: &str) -> Result<usize> {
    let nodes = (0..document.nodes.len()).filter_map(|node| {
        let camera = camera_of(document, node)?;
        let names = [&document.nodes[node].name, &camera.name];
        Some((node, names.map(Option::as_deref)))
    });
    let nodes: Vec<(usize, [Option<&str>; 2])> = nodes.collect();
    let mut named = nodes
        .iter()
        .filter(|(_, names)| names.contains(&Some(name)));
    let found = match (named.next(), named.next()) {
        (Some((node, _)), None) => Some(*node),
        (Some(_), Some(_)) => bail!(
            "--camera-node {name}: several nodes have this name or its camera; choose one by its \
             number"
        ),
        (None, _) => {
            let number = name.parse().ok();
            number.filter(|number| nodes.iter().any(|(node, _)| node == number))
        }
    };
    let list = nodes.iter().map(|(node, names)| {
        let name = names.iter().flatten().next();
        name.map_or(format!("{node}"), |name| format!("{node} ({name})"))
    });
    let list: Vec<String> = list.collect();
    match found {
        Some(node) => Ok(node),
        None if list.is_empty() => bail!("--camera-node {name}: the file has no camera"),
        None => bail!(
            "--camera-node {name}: there is no such node with a camera; those with one are {}",
            list.join(", ")
        ),
    }
}
