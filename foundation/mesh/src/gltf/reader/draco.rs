//! Primitives that are compressed by `KHR_draco_mesh_compression`.

use std::collections::HashMap;

use draco_core::{DataType, DecoderBuffer, Mesh, MeshDecoder, PointAttribute, PointIndex};

use super::super::codes::ComponentType;
use super::super::problem::{Element, Problem};
use super::super::{Shape, json};
use super::buffer::Buffers;
use crate::FormatError;

/// The bytes of the accessors that compressed primitives have in place of buffer views, one number
/// behind the other. Primitives whose accessors all have buffer views need not be decompressed.
pub(super) fn decompressed(
    root: &json::Root,
    buffers: &Buffers,
) -> Result<HashMap<usize, Vec<u8>>, FormatError> {
    let mut bytes = HashMap::new();
    for (mesh, json) in root.meshes.iter().enumerate() {
        for (primitive, json) in json.primitives.iter().enumerate() {
            if let Some(draco) = &json.extensions.draco {
                let element = Element::Primitive { mesh, primitive };
                self::primitive(json, draco, root, buffers, &mut bytes)
                    .map_err(|error| error.within(element))?;
            }
        }
    }
    Ok(bytes)
}

fn primitive(
    json: &json::Primitive,
    draco: &json::Draco,
    root: &json::Root,
    buffers: &Buffers,
    bytes: &mut HashMap<usize, Vec<u8>>,
) -> Result<(), FormatError> {
    // An accessor that does not exist is reported when it is read.
    let accessor = |index: usize| root.accessors.get(index);
    let is_open = |index: &usize| {
        !bytes.contains_key(index) && accessor(*index).is_some_and(|it| it.buffer_view.is_none())
    };
    let mut open: Vec<(usize, u32)> = Vec::new();
    for (name, id) in &draco.attributes {
        let index = json.attributes.get(name).copied();
        open.extend(index.filter(is_open).map(|index| (index, *id)));
    }
    let indices = json.indices.filter(is_open);
    if open.is_empty() && indices.is_none() {
        return Ok(());
    }
    if json.mode != json::TRIANGLES {
        let (property, value) = ("mode of compressed geometry", json.mode.to_string());
        return Err(fault(Problem::Value { property, value }));
    }
    let (compressed, _) = buffers.view(root, draco.buffer_view)?;
    let mut mesh = Mesh::new();
    let decoded = MeshDecoder::new().decode(&mut DecoderBuffer::new(compressed), &mut mesh);
    decoded.map_err(|error| fault(Problem::Draco(error.to_string())))?;
    if let (Some(index), Some(json)) = (indices, indices.and_then(accessor)) {
        let corners = mesh.faces().as_flattened();
        count("indices", json.count, corners.len())?;
        let numbers = corners.iter().map(|corner| f64::from(corner.0));
        bytes.insert(index, encoded(json, numbers)?);
    }
    for (index, id) in open {
        let Some(json) = accessor(index) else {
            continue;
        };
        count("vertices", json.count, mesh.num_points())?;
        let Some(attribute) = mesh.attribute_by_unique_id(id) else {
            let message = format!("there is no attribute {id}");
            return Err(fault(Problem::Draco(message)));
        };
        let width = usize::from(attribute.num_components());
        let rows = Shape::from_name(&json.shape).map_or(0, |shape| shape.rows());
        count("numbers of a vertex", rows as u64, width)?;
        bytes.insert(
            index,
            encoded(json, numbers(attribute, mesh.num_points())?.into_iter())?,
        );
    }
    Ok(())
}

/// The numbers of an attribute for each vertex.
fn numbers(attribute: &PointAttribute, vertices: usize) -> Result<Vec<f64>, FormatError> {
    let (kind, data) = (attribute.data_type(), attribute.buffer().data());
    let (width, size) = (usize::from(attribute.num_components()), kind.byte_length());
    let stride = usize::try_from(attribute.byte_stride()).unwrap_or(0);
    let too_short = || fault(Problem::Draco("an attribute has too few values".to_owned()));
    let mut numbers = Vec::with_capacity(vertices * width);
    for vertex in 0..vertices {
        let value = attribute.mapped_index(PointIndex(vertex as u32)).0 as usize;
        let start = value.checked_mul(stride).ok_or_else(too_short)?;
        let end = start.checked_add(width * size).ok_or_else(too_short)?;
        let bytes = data.get(start..end).ok_or_else(too_short)?;
        for component in 0..width {
            let bytes = &bytes[component * size..][..size];
            let number = number(kind, bytes);
            numbers.push(number.ok_or_else(|| {
                fault(Problem::Draco(format!("an attribute is of type {kind:?}")))
            })?);
        }
    }
    Ok(numbers)
}

fn number(kind: DataType, bytes: &[u8]) -> Option<f64> {
    Some(match kind {
        DataType::Int8 => i8::from_le_bytes(*bytes.first_chunk()?).into(),
        DataType::Uint8 => u8::from_le_bytes(*bytes.first_chunk()?).into(),
        DataType::Int16 => i16::from_le_bytes(*bytes.first_chunk()?).into(),
        DataType::Uint16 => u16::from_le_bytes(*bytes.first_chunk()?).into(),
        DataType::Int32 => i32::from_le_bytes(*bytes.first_chunk()?).into(),
        DataType::Uint32 => u32::from_le_bytes(*bytes.first_chunk()?).into(),
        DataType::Float32 => f32::from_le_bytes(*bytes.first_chunk()?).into(),
        _ => return None,
    })
}

/// Numbers as an accessor states their type.
fn encoded(
    accessor: &json::Accessor,
    numbers: impl Iterator<Item = f64>,
) -> Result<Vec<u8>, FormatError> {
    let code = accessor.component_type;
    let component = ComponentType::from_code(code).ok_or_else(|| {
        let (property, value) = ("componentType", code.to_string());
        fault(Problem::Value { property, value })
    })?;
    fn all<const N: usize>(
        numbers: impl Iterator<Item = f64>,
        bytes: impl Fn(f64) -> [u8; N],
    ) -> Vec<u8> {
        numbers.flat_map(bytes).collect()
    }
    Ok(match component {
        ComponentType::I8 => all(numbers, |number| (number as i8).to_le_bytes()),
        ComponentType::U8 => all(numbers, |number| (number as u8).to_le_bytes()),
        ComponentType::I16 => all(numbers, |number| (number as i16).to_le_bytes()),
        ComponentType::U16 => all(numbers, |number| (number as u16).to_le_bytes()),
        ComponentType::U32 => all(numbers, |number| (number as u32).to_le_bytes()),
        ComponentType::F32 => all(numbers, |number| (number as f32).to_le_bytes()),
    })
}

fn count(what: &'static str, expected: u64, found: usize) -> Result<(), FormatError> {
    if expected == found as u64 {
        return Ok(());
    }
    let expected = usize::try_from(expected).unwrap_or(usize::MAX);
    Err(fault(Problem::Count {
        what,
        expected,
        found,
    }))
}

fn fault(problem: Problem) -> FormatError {
    FormatError::gltf(Element::File, problem)
}
