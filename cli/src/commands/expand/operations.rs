//! The number of operations of functions, as text and as JSON.

use std::fmt::Write;

use anyhow::{Context, Result};
use ga_compiler::emit::count::{self, FunctionCount, Operations};
use ga_compiler::function::CompiledFunction;
use serde::{Serialize, Serializer};

use super::algebra::Algebra;

/// The name and the operations of each function. As JSON it is one object; of several functions an
/// object with one for each name.
pub(super) struct Counts(Vec<(String, FunctionCount)>);

impl Counts {
    pub(super) fn new(algebra: &Algebra, functions: &[CompiledFunction]) -> Result<Self> {
        let counted = |function: &CompiledFunction| {
            let name = function
                .name
                .as_ref()
                .map_or(String::new(), ToString::to_string);
            let count = count::function(&algebra.definition, &algebra.path, function)
                .with_context(|| format!("the code of {name} cannot be counted"))?;
            Ok((name, count))
        };
        functions
            .iter()
            .map(counted)
            .collect::<Result<_>>()
            .map(Self)
    }

    /// Whether the keys of the object are names of functions.
    pub(super) fn has_names(&self) -> bool {
        self.0.len() > 1
    }

    /// A line for each function, and one for the work on its uniform operands where it has any.
    pub(super) fn table(&self) -> String {
        let mut text = String::new();
        for (name, count) in &self.0 {
            let _ = writeln!(text, "{name}: {}", count.call);
            if count.uniform != Operations::default() {
                let _ = writeln!(
                    text,
                    "{name}, once for its uniform operands: {}",
                    count.uniform
                );
            }
        }
        text
    }
}

impl Serialize for Counts {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match &self.0[..] {
            [(_, single)] => Object::from(single).serialize(serializer),
            several => {
                let entries = several.iter();
                serializer.collect_map(entries.map(|(name, count)| (name, Object::from(count))))
            }
        }
    }
}

/// The operations of a function as JSON.
#[derive(Serialize)]
struct Object {
    #[serde(flatten)]
    call: Fields,
    uniform: Fields,
}

#[derive(Serialize)]
struct Fields {
    mul: usize,
    add: usize,
    div: usize,
    sqrt: usize,
    other: usize,
}

impl From<&FunctionCount> for Object {
    fn from(count: &FunctionCount) -> Self {
        Self {
            call: count.call.into(),
            uniform: count.uniform.into(),
        }
    }
}

impl From<Operations> for Fields {
    fn from(count: Operations) -> Self {
        Self {
            mul: count.multiplications,
            add: count.additions,
            div: count.divisions,
            sqrt: count.roots,
            other: count.others,
        }
    }
}
