//! Meshes and their primitives, and the influence of joints on them.

use std::collections::HashSet;

use super::super::problem::{Element, Problem};
use super::super::{Components, CustomAttribute, Document, Mesh, Primitive};
use super::check::{Checked, count, exists, fault, finite, targets_of};
use crate::FormatError;

pub(super) fn mesh(index: usize, mesh: &Mesh, document: &Document) -> Checked {
    let within = |error: FormatError| error.within(Element::Mesh(index));
    if mesh.primitives.is_empty() {
        return fault(Element::Mesh(index), Problem::Missing("primitives"));
    }
    let targets = targets_of(document, index);
    if !mesh.weights.is_empty() {
        count("weights of morph targets", targets, mesh.weights.len()).map_err(within)?;
    }
    if let Some(item) = mesh.weights.iter().position(|weight| !weight.is_finite()) {
        return fault(Element::Mesh(index), Problem::NotFinite { item });
    }
    for (number, primitive) in mesh.primitives.iter().enumerate() {
        let element = || Element::Primitive {
            mesh: index,
            primitive: number,
        };
        let within = |error: FormatError| error.within(element());
        count("morph targets", targets, primitive.targets.len()).map_err(within)?;
        if let Some(material) = primitive.material {
            exists("material", material, document.materials.len()).map_err(within)?;
        }
        let vertices = primitive.vertex_count();
        if vertices == 0 {
            return fault(element(), Problem::Missing("attributes"));
        }
        attributes(primitive, vertices, index, number)?;
        indices(primitive, vertices, index, number)?;
        for (target, data) in primitive.targets.iter().enumerate() {
            let check = Attributes {
                mesh: index,
                primitive: number,
                target: Some(target),
                vertices,
            };
            let mut is_empty = true;
            is_empty &= !check.list("POSITION", &data.positions)?;
            is_empty &= !check.list("NORMAL", &data.normals)?;
            is_empty &= !check.list("TANGENT", &data.tangents)?;
            is_empty &= !check.sets("TEXCOORD", &data.texcoords)?;
            is_empty &= !check.sets("COLOR", &data.colours)?;
            is_empty &= !check.custom(&data.custom)?;
            if is_empty {
                return fault(element(), Problem::Missing("attributes of a morph target"));
            }
        }
    }
    Ok(())
}

fn attributes(data: &Primitive, vertices: usize, mesh: usize, primitive: usize) -> Checked {
    let check = Attributes {
        mesh,
        primitive,
        target: None,
        vertices,
    };
    check.list("POSITION", &data.positions)?;
    check.list("NORMAL", &data.normals)?;
    check.list("TANGENT", &data.tangents)?;
    check.sets("TEXCOORD", &data.texcoords)?;
    check.sets("COLOR", &data.colours)?;
    check.sets("WEIGHTS", &data.weights)?;
    for (set, joints) in data.joints.iter().enumerate() {
        check.length(&format!("JOINTS_{set}"), joints.len())?;
    }
    check.custom(&data.custom)?;
    let element = Element::Primitive { mesh, primitive };
    count("sets of weights", data.joints.len(), data.weights.len())
        .map_err(|error| error.within(element))
}

fn indices(data: &Primitive, vertices: usize, mesh: usize, primitive: usize) -> Checked {
    let Some(indices) = &data.indices else {
        return Ok(());
    };
    let element = Element::Indices { mesh, primitive };
    if indices.is_empty() {
        return fault(element, Problem::Missing("indices"));
    }
    match indices.iter().position(|&index| index as usize >= vertices) {
        Some(position) => {
            let vertex = indices[position];
            let problem = Problem::VertexIndex {
                position,
                vertex,
                vertices,
            };
            fault(element, problem)
        }
        None => Ok(()),
    }
}

/// Whether the joints of a primitive exist and every vertex has an influence.
pub(super) fn influences(
    mesh: usize,
    primitive: usize,
    data: &Primitive,
    joints: usize,
) -> Checked {
    let attribute = |name: String| Element::Attribute {
        mesh,
        primitive,
        target: None,
        name,
    };
    for (set, rows) in data.joints.iter().enumerate() {
        for (vertex, row) in rows.iter().enumerate() {
            if let Some(&joint) = row.iter().find(|&&joint| usize::from(joint) >= joints) {
                let problem = Problem::Joint {
                    vertex,
                    joint,
                    joints,
                };
                return fault(attribute(format!("JOINTS_{set}")), problem);
            }
        }
    }
    if data.weights.is_empty() {
        return fault(
            attribute("WEIGHTS_0".to_owned()),
            Problem::Missing("weights"),
        );
    }
    for vertex in 0..data.vertex_count() {
        let weights = || data.weights.iter().flat_map(|set| set[vertex]);
        let sum: f32 = weights().sum();
        if !weights().all(|weight| weight >= 0.0) || sum <= 0.0 {
            let problem = Problem::Weights { vertex, sum };
            return fault(attribute("WEIGHTS_0".to_owned()), problem);
        }
    }
    Ok(())
}

/// Checks the attributes of the vertices or of a morph target.
struct Attributes {
    mesh: usize,
    primitive: usize,
    target: Option<usize>,
    vertices: usize,
}

impl Attributes {
    fn element(&self, name: &str) -> Element {
        Element::Attribute {
            mesh: self.mesh,
            primitive: self.primitive,
            target: self.target,
            name: name.to_owned(),
        }
    }

    fn length(&self, name: &str, found: usize) -> Checked {
        count("items", self.vertices, found).map_err(|error| error.within(self.element(name)))
    }

    /// Whether the list is there; an error if it has another length or a number is not finite.
    fn list<const N: usize>(&self, name: &str, items: &[[f32; N]]) -> Result<bool, FormatError> {
        if items.is_empty() {
            return Ok(false);
        }
        self.length(name, items.len())?;
        finite(items).map_err(|error| error.within(self.element(name)))?;
        Ok(true)
    }

    fn sets<const N: usize>(
        &self,
        kind: &str,
        sets: &[Vec<[f32; N]>],
    ) -> Result<bool, FormatError> {
        for (set, items) in sets.iter().enumerate() {
            let name = format!("{kind}_{set}");
            self.length(&name, items.len())?;
            self.list(&name, items)?;
        }
        Ok(!sets.is_empty())
    }

    fn custom(&self, attributes: &[CustomAttribute]) -> Result<bool, FormatError> {
        let mut seen = HashSet::new();
        for (index, attribute) in attributes.iter().enumerate() {
            let name = &attribute.name;
            let fault = |problem| fault(self.element(name), problem);
            if !name.starts_with('_') {
                let (property, value) = ("the name", name.clone());
                return fault(Problem::Value { property, value });
            }
            if !seen.insert(name) {
                let what = "an attribute of this name, number";
                return fault(Problem::Duplicate { what, index });
            }
            self.length(name, attribute.len())?;
            let width = attribute.shape.components();
            let (expected, found) = (self.vertices * width, attribute.components.len());
            count("numbers", expected, found).map_err(|error| error.within(self.element(name)))?;
            if let Components::F32(numbers) = &attribute.components {
                finite(numbers.as_chunks::<1>().0)
                    .map_err(|error| error.within(self.element(name)))?;
            }
        }
        Ok(!attributes.is_empty())
    }
}
