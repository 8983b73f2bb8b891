//! Vertices and triangles.

use ga_runtime::vga3::Vector;
use gltf_json as json;
use gltf_json::Index;
use gltf_json::buffer::Target;
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::validation::Checked;

use super::document::{Attributes, Document, Elements, single};
use super::{GltfError, Model, skin};

/// Appends the mesh with its only primitive.
pub(super) fn add(
    model: &Model,
    material: Index<json::Material>,
    document: &mut Document,
) -> Result<Index<json::Mesh>, GltfError> {
    let vertices = model.positions.len();
    if model.normals.len() != vertices {
        return Err(GltfError::Count {
            what: "normals",
            expected: vertices,
            found: model.normals.len(),
        });
    }
    let triangles = triangles(model)?;
    let mut attributes = Attributes::new();
    let vertex_data = Some(Target::ArrayBuffer);
    attributes.insert(
        Checked::Valid(Semantic::Positions),
        document.add(vertex_data, Elements::bounded_floats(&positions(model)?)),
    );
    attributes.insert(
        Checked::Valid(Semantic::Normals),
        document.add(vertex_data, Elements::floats(&normals(model)?)),
    );
    if let Some(skin) = &model.skin {
        skin::add_attributes(skin, vertices, document, &mut attributes)?;
    }
    let indices = Elements::indices(triangles.iter().flatten().copied(), vertices);
    let primitive = Primitive {
        attributes,
        indices: Some(document.add(Some(Target::ElementArrayBuffer), indices)),
        material: Some(material),
        mode: Checked::Valid(Mode::Triangles),
        targets: None,
        extensions: None,
        extras: Default::default(),
    };
    Ok(document.root.push(json::Mesh {
        name: Some(model.name.to_owned()),
        primitives: vec![primitive],
        weights: None,
        extensions: None,
        extras: Default::default(),
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
            let direction = Vector::from(normal)
                .normalized()
                .ok_or(GltfError::NotFinite {
                    what: "normal",
                    index,
                })?;
            single(direction.coordinates(), "normal", index)
        })
        .collect()
}

/// The triangles with three different corners.
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
