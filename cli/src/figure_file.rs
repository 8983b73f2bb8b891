//! Figures from files.

use std::path::Path;

use anyhow::{Context, Result, bail};
use ga_anim::gltf::{self, Character};
use ga_anim::rig;
use ga_mesh::{Mesh, obj};

use crate::figure::Figure;

/// The group of the person in MakeHuman's meshes.
const BODY: &str = "body";

/// The figure of a mesh, a rig and weights, in metres, and the group of the mesh that it is.
pub(crate) fn from_obj(
    mesh_path: &Path,
    rig_path: &Path,
    weights_path: &Path,
    group: Option<&str>,
    metres_per_unit: f64,
) -> Result<(Figure, Option<String>)> {
    let mesh = obj::read(mesh_path)?;
    let skeleton = rig::read(rig_path)?;
    let weights = rig::read_weights(weights_path, &skeleton, mesh.vertex_count())?;
    let group = group_of(mesh_path, &mesh, group)?;
    let name = stem(mesh_path);
    let (mesh, weights) = match group.as_deref().and_then(|group| mesh.part(group)) {
        Some(part) => {
            let selected = weights.select(&part.vertices);
            let weights = selected.context("the group has vertices that the mesh does not have")?;
            (part.mesh, weights)
        }
        None => (mesh, weights),
    };
    let body = Character {
        mesh,
        skeleton,
        weights,
    };
    let figure = in_metres(name, body, metres_per_unit);
    Ok((
        figure.with_context(|| unit(mesh_path, metres_per_unit))?,
        group,
    ))
}

/// The figure of the skinned meshes of a glTF file, in metres.
pub(crate) fn from_gltf(path: &Path, metres_per_unit: f64) -> Result<Figure> {
    let document = ga_mesh::gltf::read(path)?;
    let body = gltf::character(&document).with_context(|| path.display().to_string())?;
    in_metres(stem(path), body, metres_per_unit).with_context(|| unit(path, metres_per_unit))
}

/// The name of a file without folders and extension.
pub(crate) fn stem(path: &Path) -> String {
    let name = path.file_stem().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

fn in_metres(name: String, body: Character, metres_per_unit: f64) -> Result<Figure> {
    Ok(Figure {
        name,
        mesh: body.mesh.scaled(metres_per_unit)?,
        skeleton: body.skeleton.scaled(metres_per_unit)?,
        weights: body.weights,
        paint: None,
    })
}

fn unit(path: &Path, metres_per_unit: f64) -> String {
    format!("{} with {metres_per_unit} metres a unit", path.display())
}

fn group_of(path: &Path, mesh: &Mesh, wanted: Option<&str>) -> Result<Option<String>> {
    let Some(group) = wanted else {
        return Ok(mesh.group(BODY).map(|group| group.name.clone()));
    };
    if mesh.group(group).is_none() {
        const SHOWN: usize = 8;
        let groups = mesh.groups();
        let mut names: Vec<&str> = groups.iter().map(|group| group.name.as_str()).collect();
        names.truncate(SHOWN);
        let more = groups.len().saturating_sub(SHOWN);
        bail!(
            "{} has no group {group:?}; its groups are: {}{}",
            path.display(),
            names.join(", "),
            if more > 0 {
                format!(" and {more} more")
            } else {
                String::new()
            }
        );
    }
    Ok(Some(group.to_owned()))
}
