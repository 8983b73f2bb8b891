//! Vertices and triangles.

use serde_json::{Value, json};

use super::buffer::{Buffer, Elements, Target, single, unit};
use super::{GltfError, Model, skin};

/// The mesh with its only primitive.
pub(super) fn mesh(model: &Model, buffer: &mut Buffer) -> Result<Value, GltfError> {
    let vertices = model.positions.len();
    if model.normals.len() != vertices {
        return Err(GltfError::Count {
            what: "normals",
            expected: vertices,
            found: model.normals.len(),
        });
    }
    let triangles = triangles(model)?;
    let mut attributes = json!({
        "POSITION": buffer.add(Some(Target::Array), Elements::bounded_floats(&positions(model)?)),
        "NORMAL": buffer.add(Some(Target::Array), Elements::floats(&normals(model)?)),
    });
    if let Some(skin) = &model.skin {
        skin::add_attributes(skin, vertices, buffer, &mut attributes)?;
    }
    let indices = Elements::indices(triangles.iter().flatten().copied(), vertices);
    Ok(json!({
        "name": model.name,
        "primitives": [{
            "attributes": attributes,
            "indices": buffer.add(Some(Target::ElementArray), indices),
            "material": 0,
        }],
    }))
}

fn positions(model: &Model) -> Result<Vec<[f32; 3]>, GltfError> {
    let numbered = model.positions.iter().enumerate();
    numbered
        .map(|(vertex, &position)| single(position, "position", vertex))
        .collect()
}

fn normals(model: &Model) -> Result<Vec<[f32; 3]>, GltfError> {
    let numbered = model.normals.iter().enumerate();
    numbered
        .map(|(index, &normal)| {
            if normal == [0.0; 3] {
                return Ok([0.0, 1.0, 0.0]);
            }
            let direction = unit(normal).ok_or(GltfError::NotFinite {
                what: "normal",
                index,
            })?;
            single(direction, "normal", index)
        })
        .collect()
}

fn triangles(model: &Model) -> Result<Vec<[u32; 3]>, GltfError> {
    let vertices = model.positions.len();
    for (triangle, corners) in model.triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Err(GltfError::Triangle {
                triangle,
                vertex,
                vertices,
            });
        }
    }
    let differ = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    let triangles: Vec<_> = model.triangles.iter().copied().filter(differ).collect();
    if triangles.is_empty() {
        return Err(GltfError::Empty);
    }
    Ok(triangles)
}
