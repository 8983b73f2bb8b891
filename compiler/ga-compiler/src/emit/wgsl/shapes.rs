//! The types of WGSL: a structure for each type of the algebra, `f32`, arrays, and structures for
//! tuples.

use std::collections::{BTreeMap, HashMap};

use quote::ToTokens;
use syn::Attribute;
use syn::ext::IdentExt;

use super::super::item;
use super::names::Names;
use crate::define::{Definition, Parameter, SCALAR_TYPE};
use crate::signature::Shape;

/// The structures of a module.
pub(super) struct Shapes<'a> {
    definition: &'a Definition,
    /// The declared structures in the order of their first use.
    structures: Vec<Structure>,
    /// The structure of a type of the algebra, by its place in the declaration.
    of_type: BTreeMap<usize, usize>,
    /// The structure of a tuple, by its name before it was made safe.
    of_tuple: HashMap<String, usize>,
}

/// A structure.
struct Structure {
    docs: String,
    name: String,
    /// Names and types of its members.
    members: Vec<(String, String)>,
}

impl<'a> Shapes<'a> {
    pub(super) fn new(definition: &'a Definition) -> Self {
        Self {
            definition,
            structures: Vec::new(),
            of_type: BTreeMap::new(),
            of_tuple: HashMap::new(),
        }
    }

    /// The name of a shape as a type. Structures that it needs are declared, if they are not yet.
    pub(super) fn name(&mut self, shape: &Shape, names: &mut Names) -> String {
        match shape {
            Shape::Scalar => "f32".to_owned(),
            Shape::Type(index) => {
                let structure = self.structure_of_type(*index, names);
                self.structures[structure].name.clone()
            }
            Shape::Array(element, count) if *count > 0 => {
                let element = self.name(element, names);
                format!("array<{element}, {count}>")
            }
            Shape::Array(..) | Shape::Tuple(_) => {
                let structure = self.structure_of_parts(parts(shape), names);
                self.structures[structure].name.clone()
            }
        }
    }

    /// The declarations of all structures.
    pub(super) fn declarations(&self) -> String {
        let declaration = |structure: &Structure| {
            let members: Vec<_> = structure
                .members
                .iter()
                .map(|(name, kind)| format!("    {name}: {kind},\n"))
                .collect();
            let (docs, name) = (&structure.docs, &structure.name);
            format!("{docs}struct {name} {{\n{}}}\n\n", members.concat())
        };
        self.structures.iter().map(declaration).collect()
    }

    /// Expressions for the numbers stored in a shape, given one for the whole.
    pub(super) fn read(&mut self, shape: &Shape, whole: &str, names: &mut Names) -> Vec<String> {
        match shape {
            Shape::Scalar => vec![whole.to_owned()],
            Shape::Type(index) => {
                let structure = self.structure_of_type(*index, names);
                let members = self.structures[structure].members.clone().into_iter();
                let parts = self.parts(*index).into_iter().zip(members);
                let read = |(part, (member, _)): (Shape, (String, String))| {
                    self.read(&part, &format!("{whole}.{member}"), names)
                };
                parts.flat_map(read).collect()
            }
            Shape::Array(element, count) => (0..*count)
                .flat_map(|place| self.read(element, &format!("{whole}[{place}]"), names))
                .collect(),
            Shape::Tuple(parts) => parts
                .iter()
                .enumerate()
                .flat_map(|(place, part)| {
                    self.read(part, &format!("{whole}.{}", member(place)), names)
                })
                .collect(),
        }
    }

    /// The expression that builds a shape of the numbers stored in it, which are taken from the
    /// front.
    pub(super) fn build(
        &mut self,
        shape: &Shape,
        numbers: &mut dyn Iterator<Item = String>,
        names: &mut Names,
    ) -> String {
        let name = self.name(shape, names);
        let mut values: Vec<String> = match shape {
            Shape::Scalar => return numbers.next().unwrap_or_default(),
            Shape::Type(index) => {
                let parts = self.parts(*index).into_iter();
                parts
                    .map(|part| self.build(&part, numbers, names))
                    .collect()
            }
            Shape::Array(element, count) => (0..*count)
                .map(|_| self.build(element, numbers, names))
                .collect(),
            Shape::Tuple(parts) => parts
                .iter()
                .map(|part| self.build(part, numbers, names))
                .collect(),
        };
        if values.is_empty() {
            values.push("0.0".to_owned());
        }
        call(&name, &values)
    }

    /// The shapes of the members of a type's structure.
    fn parts(&self, index: usize) -> Vec<Shape> {
        let kind = &self.definition.types[index];
        match &kind.parameters {
            None => kind.stored().map(|_| Shape::Scalar).collect(),
            Some(parameters) => parameters.list.iter().map(Parameter::shape).collect(),
        }
    }

    fn structure_of_type(&mut self, index: usize, names: &mut Names) -> usize {
        if let Some(&known) = self.of_type.get(&index) {
            return known;
        }
        let kind = &self.definition.types[index];
        let mut taken = Names::default();
        let fields: Vec<String> = match &kind.parameters {
            None => kind.stored().map(|c| c.name.to_string()).collect(),
            Some(parameters) => parameters.list.iter().map(|p| p.name.to_string()).collect(),
        };
        let fields = fields.into_iter().zip(self.parts(index));
        let mut members: Vec<_> = fields
            .map(|(field, part)| (taken.give(&field), self.name(&part, names)))
            .collect();
        if members.is_empty() {
            members.push(nothing());
        }
        self.structures.push(Structure {
            docs: comment(&item::attributes_of(&kind.docs)),
            name: names.give(&kind.name.unraw().to_string()),
            members,
        });
        self.of_type.insert(index, self.structures.len() - 1);
        self.structures.len() - 1
    }

    fn structure_of_parts(&mut self, parts: &[Shape], names: &mut Names) -> usize {
        let wished = if parts.is_empty() {
            "Nothing".to_owned()
        } else {
            let parts: Vec<_> = parts.iter().map(|part| self.word(part)).collect();
            parts.join("And")
        };
        if let Some(&known) = self.of_tuple.get(&wished) {
            return known;
        }
        let mut members: Vec<_> = parts
            .iter()
            .enumerate()
            .map(|(place, part)| (member(place), self.name(part, names)))
            .collect();
        if members.is_empty() {
            members.push(nothing());
        }
        self.structures.push(Structure {
            docs: String::new(),
            name: names.give(&wished),
            members,
        });
        self.of_tuple.insert(wished, self.structures.len() - 1);
        self.structures.len() - 1
    }

    /// A shape as a part of a name.
    fn word(&self, shape: &Shape) -> String {
        match shape {
            Shape::Scalar => SCALAR_TYPE.to_owned(),
            Shape::Type(index) => self.definition.types[*index].name.unraw().to_string(),
            Shape::Array(element, count) => format!("{}{count}", self.word(element)),
            Shape::Tuple(parts) => {
                let parts: Vec<_> = parts.iter().map(|part| self.word(part)).collect();
                format!("{}End", parts.join("And"))
            }
        }
    }
}

/// `name(value, …)`, over several lines where it is long.
pub(super) fn call(name: &str, values: &[String]) -> String {
    const WIDTH: usize = 100;
    let length: usize = values.iter().map(|value| value.len() + 2).sum();
    if name.len() + length <= WIDTH {
        return format!("{name}({})", values.join(", "));
    }
    let lines: Vec<_> = values
        .iter()
        .map(|value| format!("    {},\n", value.replace('\n', "\n    ")))
        .collect();
    format!("{name}(\n{})", lines.concat())
}

/// Doc comments as comments, without the examples in Rust that they hold.
pub(super) fn comment(attributes: &[Attribute]) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut is_code = false;
    for attribute in attributes.iter().filter(|a| a.path().is_ident("doc")) {
        if let Ok(meta) = attribute.meta.require_name_value()
            && let Ok(text) = syn::parse2::<syn::LitStr>(meta.value.to_token_stream())
        {
            for line in text.value().trim_end_matches('\n').split('\n') {
                let is_fence = line.trim_start().starts_with("```");
                is_code ^= is_fence;
                if !is_code && !is_fence {
                    lines.push(line.trim_end().to_owned());
                }
            }
        }
    }
    // The heading of an example, and what is empty without it.
    let is_left_over = |line: &String| line.is_empty() || line.trim_start().starts_with('#');
    while lines.last().is_some_and(is_left_over) {
        lines.pop();
    }
    lines.dedup_by(|next, line| next.is_empty() && line.is_empty());
    lines.iter().map(|line| format!("//{line}\n")).collect()
}

/// The member of a tuple at a place.
fn member(place: usize) -> String {
    format!("value{place}")
}

/// The member of a structure that stores nothing, since it must have one.
fn nothing() -> (String, String) {
    ("nothing".to_owned(), "f32".to_owned())
}

fn parts(shape: &Shape) -> &[Shape] {
    match shape {
        Shape::Tuple(parts) => parts,
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_hold_no_rust() {
        let attributes: Vec<Attribute> = vec![
            syn::parse_quote!(#[doc = " A point."]),
            syn::parse_quote!(#[doc = ""]),
            syn::parse_quote!(#[doc = " ```\n let p = 1;\n ```\n"]),
            syn::parse_quote!(#[doc = ""]),
            syn::parse_quote!(#[doc = " Of weight 1."]),
            syn::parse_quote!(#[doc = ""]),
            syn::parse_quote!(#[doc = " # Example"]),
            syn::parse_quote!(#[doc = " ```rust"]),
            syn::parse_quote!(#[doc = " let q = 2;"]),
            syn::parse_quote!(#[doc = " ```"]),
        ];
        assert_eq!(comment(&attributes), "// A point.\n//\n// Of weight 1.\n");
    }
}
