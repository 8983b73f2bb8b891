//! Primitives: attributes, indices and morph targets.

use std::collections::BTreeMap;

use super::super::problem::{Element, Problem};
use super::super::{CustomAttribute, Mode, MorphTarget, Primitive, Shape, json};
use super::accessor::{Accessors, Format};
use crate::FormatError;

/// Reads one primitive.
pub(super) struct Reader<'a> {
    pub(super) accessors: &'a Accessors<'a>,
    /// Whether the file uses `KHR_mesh_quantization`.
    pub(super) is_quantized: bool,
    pub(super) mesh: usize,
    pub(super) primitive: usize,
}

/// The accessors of attributes, by what they are.
#[derive(Default)]
struct Sorted<'a> {
    positions: Option<usize>,
    normals: Option<usize>,
    tangents: Option<usize>,
    texcoords: Vec<usize>,
    colours: Vec<usize>,
    joints: Vec<usize>,
    weights: Vec<usize>,
    custom: Vec<(&'a str, usize)>,
}

/// The attributes of the vertices, or of a morph target.
struct Attributes<'a> {
    reader: &'a Reader<'a>,
    target: Option<usize>,
}

impl Reader<'_> {
    pub(super) fn primitive(&self, json: &json::Primitive) -> Result<Primitive, FormatError> {
        let (mesh, primitive) = (self.mesh, self.primitive);
        let mode = Mode::from_code(json.mode).ok_or_else(|| {
            let (property, value) = ("mode", json.mode.to_string());
            let element = Element::Primitive { mesh, primitive };
            FormatError::gltf(element, Problem::Value { property, value })
        })?;
        let attributes = Attributes {
            reader: self,
            target: None,
        };
        let sorted = attributes.sort(&json.attributes)?;
        let indices = json.indices.map(|accessor| {
            let indices = self.accessors.indices(accessor);
            indices.map_err(|error| error.within(Element::Indices { mesh, primitive }))
        });
        let targets = json.targets.iter().enumerate();
        let targets = targets.map(|(target, json)| self.target(target, json));
        Ok(Primitive {
            mode,
            positions: attributes.vectors("POSITION", sorted.positions, self.vertices())?,
            normals: attributes.vectors("NORMAL", sorted.normals, self.directions())?,
            tangents: match sorted.tangents {
                Some(accessor) => {
                    attributes.floats("TANGENT", accessor, Shape::Vec4, self.directions())?
                }
                None => Vec::new(),
            },
            texcoords: attributes.texcoords(&sorted, self.texcoords())?,
            colours: attributes.colours(&sorted, Format::Unsigned, 1.0)?,
            joints: attributes.sets("JOINTS", &sorted.joints, |accessor| {
                self.accessors.joints(accessor)
            })?,
            weights: attributes.sets("WEIGHTS", &sorted.weights, |accessor| {
                self.accessors
                    .floats(accessor, Shape::Vec4, Format::Unsigned)
            })?,
            custom: attributes.custom(&sorted)?,
            indices: indices.transpose()?,
            material: json.material,
            targets: targets.collect::<Result<_, _>>()?,
            extras: json.extras.clone(),
        })
    }

    fn target(&self, target: usize, json: &json::Attributes) -> Result<MorphTarget, FormatError> {
        let attributes = Attributes {
            reader: self,
            target: Some(target),
        };
        let sorted = attributes.sort(json)?;
        Ok(MorphTarget {
            positions: attributes.vectors("POSITION", sorted.positions, self.vertices())?,
            normals: attributes.vectors("NORMAL", sorted.normals, self.directions())?,
            tangents: attributes.vectors("TANGENT", sorted.tangents, self.directions())?,
            texcoords: attributes.texcoords(&sorted, self.morph_texcoords())?,
            colours: attributes.colours(&sorted, Format::Normalized, 0.0)?,
            custom: attributes.custom(&sorted)?,
        })
    }

    fn vertices(&self) -> Format {
        if self.is_quantized {
            Format::Quantized
        } else {
            Format::Float
        }
    }

    fn directions(&self) -> Format {
        if self.is_quantized {
            Format::Normalized
        } else {
            Format::Float
        }
    }

    fn morph_texcoords(&self) -> Format {
        match self.texcoords() {
            Format::Quantized => Format::Quantized,
            _ => Format::Normalized,
        }
    }

    fn texcoords(&self) -> Format {
        if self.is_quantized {
            Format::Quantized
        } else {
            Format::Unsigned
        }
    }
}

impl Attributes<'_> {
    fn element(&self, name: &str) -> Element {
        Element::Attribute {
            mesh: self.reader.mesh,
            primitive: self.reader.primitive,
            target: self.target,
            name: name.to_owned(),
        }
    }

    /// Sorts attributes by their names.
    fn sort<'b>(&self, json: &'b json::Attributes) -> Result<Sorted<'b>, FormatError> {
        let mut sorted = Sorted::default();
        let mut sets: BTreeMap<(&str, u32), usize> = BTreeMap::new();
        for (name, &accessor) in json {
            match name.as_str() {
                "POSITION" => sorted.positions = Some(accessor),
                "NORMAL" => sorted.normals = Some(accessor),
                "TANGENT" => sorted.tangents = Some(accessor),
                _ if name.starts_with('_') => sorted.custom.push((name, accessor)),
                _ => {
                    let set = name
                        .rsplit_once('_')
                        .and_then(|(kind, set)| Some((kind, set.parse().ok()?)))
                        .filter(|(kind, _)| self.has_sets(kind));
                    let set = set.ok_or_else(|| {
                        let (property, value) = ("the name", name.clone());
                        FormatError::gltf(self.element(name), Problem::Value { property, value })
                    })?;
                    sets.insert(set, accessor);
                }
            }
        }
        for ((kind, set), accessor) in sets {
            let list = match kind {
                "TEXCOORD" => &mut sorted.texcoords,
                "COLOR" => &mut sorted.colours,
                "JOINTS" => &mut sorted.joints,
                _ => &mut sorted.weights,
            };
            if list.len() != set as usize {
                let problem = Problem::Missing("the set with the number before it");
                return Err(FormatError::gltf(
                    self.element(&format!("{kind}_{set}")),
                    problem,
                ));
            }
            list.push(accessor);
        }
        Ok(sorted)
    }

    /// Whether attributes of this kind are numbered.
    fn has_sets(&self, kind: &str) -> bool {
        let is_of_vertices = self.target.is_none();
        matches!(kind, "TEXCOORD" | "COLOR")
            || is_of_vertices && matches!(kind, "JOINTS" | "WEIGHTS")
    }

    fn floats<const N: usize>(
        &self,
        name: &str,
        accessor: usize,
        shape: Shape,
        format: Format,
    ) -> Result<Vec<[f32; N]>, FormatError> {
        let floats = self.reader.accessors.floats(accessor, shape, format);
        floats.map_err(|error| error.within(self.element(name)))
    }

    /// Three numbers for each vertex, or none.
    fn vectors(
        &self,
        name: &str,
        accessor: Option<usize>,
        format: Format,
    ) -> Result<Vec<[f32; 3]>, FormatError> {
        match accessor {
            Some(accessor) => self.floats(name, accessor, Shape::Vec3, format),
            None => Ok(Vec::new()),
        }
    }

    /// The sets of one kind.
    fn sets<T>(
        &self,
        kind: &str,
        accessors: &[usize],
        read: impl Fn(usize) -> Result<T, FormatError>,
    ) -> Result<Vec<T>, FormatError> {
        let numbered = accessors.iter().enumerate();
        numbered
            .map(|(set, &accessor)| {
                let element = || self.element(&format!("{kind}_{set}"));
                read(accessor).map_err(|error| error.within(element()))
            })
            .collect()
    }

    fn texcoords(
        &self,
        sorted: &Sorted,
        format: Format,
    ) -> Result<Vec<Vec<[f32; 2]>>, FormatError> {
        self.sets("TEXCOORD", &sorted.texcoords, |accessor| {
            self.reader.accessors.floats(accessor, Shape::Vec2, format)
        })
    }

    fn colours(
        &self,
        sorted: &Sorted,
        format: Format,
        alpha: f32,
    ) -> Result<Vec<Vec<[f32; 4]>>, FormatError> {
        self.sets("COLOR", &sorted.colours, |accessor| {
            self.reader.accessors.colours(accessor, format, alpha)
        })
    }

    fn custom(&self, sorted: &Sorted) -> Result<Vec<CustomAttribute>, FormatError> {
        let read = |&(name, accessor): &(&str, usize)| {
            let numbers = self.reader.accessors.read(accessor);
            let numbers = numbers.map_err(|error| error.within(self.element(name)))?;
            Ok(CustomAttribute {
                name: name.to_owned(),
                shape: numbers.shape,
                normalized: numbers.normalized,
                components: numbers.components,
            })
        };
        sorted.custom.iter().map(read).collect()
    }
}
