//! Vertices and triangles.

use ga_runtime::vga3::Vector;

use super::super::Primitive;
use super::precision::single;
use super::{Model, ModelProblem, skin};

/// The primitive of the model, with the first material.
pub(super) fn primitive(model: &Model) -> Result<Primitive, ModelProblem> {
    let vertices = model.positions.len();
    if model.normals.len() != vertices {
        return Err(ModelProblem::Count {
            what: "normals",
            expected: vertices,
            found: model.normals.len(),
        });
    }
    let indices = triangles(model)?.into_flattened();
    let mut primitive = Primitive {
        positions: positions(model)?,
        normals: normals(model)?,
        indices: Some(indices),
        material: Some(0),
        ..Primitive::default()
    };
    if let Some(skin) = &model.skin {
        skin::add_influences(skin, vertices, &mut primitive)?;
    }
    Ok(primitive)
}

fn positions(model: &Model) -> Result<Vec<[f32; 3]>, ModelProblem> {
    let numbered = model.positions.iter().enumerate();
    numbered
        .map(|(vertex, &position)| single(position, "position", vertex))
        .collect()
}

fn normals(model: &Model) -> Result<Vec<[f32; 3]>, ModelProblem> {
    let numbered = model.normals.iter().enumerate();
    numbered
        .map(|(index, &normal)| {
            if normal == [0.0; 3] {
                return Ok([0.0, 1.0, 0.0]);
            }
            let direction = Vector::from(normal)
                .normalized()
                .ok_or(ModelProblem::NotFinite {
                    what: "normal",
                    index,
                })?;
            single(direction.coordinates(), "normal", index)
        })
        .collect()
}

/// The triangles with three different corners.
fn triangles(model: &Model) -> Result<Vec<[u32; 3]>, ModelProblem> {
    let vertices = model.positions.len();
    for (triangle, corners) in model.triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Err(ModelProblem::Triangle {
                triangle,
                vertex,
                vertices,
            });
        }
    }
    let differ = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    let triangles: Vec<_> = model.triangles.iter().copied().filter(differ).collect();
    if triangles.is_empty() {
        return Err(ModelProblem::Empty);
    }
    Ok(triangles)
}
