//! Meshes: attributes, indices and morph targets.

use serde_json::Value;

use super::super::{CustomAttribute, Mesh, MorphTarget, Primitive, json};
use super::buffer::{Buffer, Use};
use super::kept::{Kept, value, with_extensions};
use crate::FormatError;

/// A mesh that has changed since it was read. Its primitives may be as they were.
pub(super) fn mesh(
    index: usize,
    mesh: &Mesh,
    kept: Option<&Kept>,
    buffer: &mut Buffer,
) -> Result<Value, FormatError> {
    let before = kept.and_then(|kept| {
        let mesh = kept.before.meshes.get(index)?;
        Some((kept.file.element("meshes", index)?, mesh))
    });
    let mut primitives = Vec::with_capacity(mesh.primitives.len());
    for (number, data) in mesh.primitives.iter().enumerate() {
        let old = before.and_then(|(json, mesh)| {
            let is_same = mesh.primitives.get(number) == Some(data);
            Some((json.get("primitives")?.get(number)?, is_same))
        });
        primitives.push(match old {
            Some((old, true)) => old.clone(),
            Some((old, false)) => with_extensions(value(&primitive(data, buffer))?, old),
            None => value(&primitive(data, buffer))?,
        });
    }
    let mut written = value(&json::Mesh {
        name: mesh.name.clone(),
        primitives: Vec::new(),
        weights: mesh.weights.clone(),
        extras: mesh.extras.clone(),
    })?;
    written["primitives"] = Value::Array(primitives);
    Ok(written)
}

fn primitive(data: &Primitive, buffer: &mut Buffer) -> json::Primitive {
    let mut attributes = json::Attributes::new();
    add_positions(&data.positions, buffer, &mut attributes);
    add(&data.normals, "NORMAL", buffer, &mut attributes);
    add(&data.tangents, "TANGENT", buffer, &mut attributes);
    add_sets(&data.texcoords, "TEXCOORD", buffer, &mut attributes);
    add_sets(&data.colours, "COLOR", buffer, &mut attributes);
    for (set, joints) in data.joints.iter().enumerate() {
        attributes.insert(format!("JOINTS_{set}"), buffer.joints(joints));
    }
    add_sets(&data.weights, "WEIGHTS", buffer, &mut attributes);
    add_custom(&data.custom, buffer, &mut attributes);
    let vertices = data.vertex_count();
    let indices = data.indices.as_deref();
    let targets = data.targets.iter();
    json::Primitive {
        attributes,
        indices: indices.map(|indices| buffer.indices(indices, vertices)),
        material: data.material,
        mode: data.mode.code(),
        targets: targets.map(|target| morph_target(target, buffer)).collect(),
        extensions: json::PrimitiveExtensions::default(),
        extras: data.extras.clone(),
    }
}

fn morph_target(target: &MorphTarget, buffer: &mut Buffer) -> json::Attributes {
    let mut attributes = json::Attributes::new();
    add_positions(&target.positions, buffer, &mut attributes);
    add(&target.normals, "NORMAL", buffer, &mut attributes);
    add(&target.tangents, "TANGENT", buffer, &mut attributes);
    add_sets(&target.texcoords, "TEXCOORD", buffer, &mut attributes);
    add_sets(&target.colours, "COLOR", buffer, &mut attributes);
    add_custom(&target.custom, buffer, &mut attributes);
    attributes
}

/// Positions must state their bounds.
fn add_positions(items: &[[f32; 3]], buffer: &mut Buffer, attributes: &mut json::Attributes) {
    if !items.is_empty() {
        let accessor = buffer.bounded_floats(items, Use::Vertices);
        attributes.insert("POSITION".to_owned(), accessor);
    }
}

fn add<const N: usize>(
    items: &[[f32; N]],
    name: &str,
    buffer: &mut Buffer,
    attributes: &mut json::Attributes,
) {
    if !items.is_empty() {
        attributes.insert(name.to_owned(), buffer.floats(items, Use::Vertices));
    }
}

fn add_sets<const N: usize>(
    sets: &[Vec<[f32; N]>],
    kind: &str,
    buffer: &mut Buffer,
    attributes: &mut json::Attributes,
) {
    for (set, items) in sets.iter().enumerate() {
        add(items, &format!("{kind}_{set}"), buffer, attributes);
    }
}

fn add_custom(custom: &[CustomAttribute], buffer: &mut Buffer, attributes: &mut json::Attributes) {
    for attribute in custom {
        let CustomAttribute {
            name,
            shape,
            normalized,
            components,
        } = attribute;
        attributes.insert(name.clone(), buffer.custom(*shape, *normalized, components));
    }
}
