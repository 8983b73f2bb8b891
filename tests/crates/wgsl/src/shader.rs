//! Compute shaders around single functions, and their validation.

use std::fmt::Write;

use ga_compiler::define::Definition;
use ga_compiler::emit::wgsl;
use ga_compiler::function::CompiledFunction;

/// A compute shader that calls one function for each element of a buffer.
pub struct Shader {
    /// The whole module.
    pub text: String,
    /// How many numbers one element of the input buffer has.
    pub inputs: usize,
    /// How many numbers one element of the output buffer has.
    pub outputs: usize,
}

/// The number of calls in a workgroup.
pub(crate) const WORKGROUP: u32 = 64;

impl Shader {
    /// The shader of the function with a given name. Its input elements consist of the operands in
    /// order, its output elements of the result.
    ///
    /// # Panics
    /// If the text does not contain the function in the expected form.
    #[must_use]
    pub fn new(definition: &Definition, function: &CompiledFunction) -> Self {
        let mut text = wgsl::module(definition, std::slice::from_ref(function));
        // The function comes last, under a name that WGSL accepts.
        let last = text.lines().rfind(|line| line.starts_with("fn "));
        let name = last
            .and_then(|line| line[3..].split('(').next())
            .expect("the function")
            .to_owned();
        let prepare = signature(&text, &format!("{name}_prepare"));
        let (parameters, result) = signature(&text, &name).expect("the function");
        let uniform = prepare.map_or(Vec::new(), |(parameters, _)| parameters);
        let varying = parameters.iter().filter(|(name, _)| name != "prepared");
        let members: Vec<_> = function
            .operands
            .iter()
            .map(|operand| {
                let mut all = uniform.iter().chain(varying.clone());
                all.find(|(name, _)| operand.name == name)
                    .expect("a parameter")
            })
            .collect();
        let members: String = members
            .iter()
            .map(|(name, kind)| format!("    {name}: {kind},\n"))
            .collect();
        let argument = |(name, _): &(String, String)| format!("elements[id.x].{name}");
        let mut arguments: Vec<_> = varying.map(argument).collect();
        if !uniform.is_empty() {
            let uniform: Vec<_> = uniform.iter().map(argument).collect();
            arguments.insert(0, format!("{name}_prepare({})", uniform.join(", ")));
        }
        let _ = write!(
            text,
            "
struct Element {{
{members}}}

@group(0) @binding(0) var<storage, read> elements: array<Element>;
@group(0) @binding(1) var<storage, read_write> results: array<{result}>;

@compute @workgroup_size({WORKGROUP})
fn compute_all(@builtin(global_invocation_id) id: vec3<u32>) {{
    if id.x < arrayLength(&elements) {{
        results[id.x] = {name}({});
    }}
}}
",
            arguments.join(", ")
        );
        let stored = |shape: &ga_compiler::function::Shape| shape.stored(definition);
        Self {
            text,
            inputs: function
                .operands
                .iter()
                .map(|operand| stored(&operand.shape))
                .sum(),
            outputs: stored(&function.result),
        }
    }
}

/// The parameters, names with types, and the result of a function in a module.
fn signature(text: &str, name: &str) -> Option<(Vec<(String, String)>, String)> {
    let start = format!("fn {name}(");
    let line = text.lines().find(|line| line.starts_with(&start))?;
    let (parameters, result) = line[start.len()..].split_once(") -> ")?;
    let pair = |text: &str| {
        text.split_once(": ")
            .map(|(a, b)| (a.to_owned(), b.to_owned()))
    };
    // Commas inside a type do not separate parameters.
    let parameters = parameters.replace(", ", "\n").replace("\n2>", ", 2>");
    let parameters = parameters.lines().filter_map(pair).collect();
    Some((parameters, result.trim_end_matches(" {").to_owned()))
}

/// Checks a module as an implementation of WGSL does.
///
/// # Errors
/// The error in the module, with its line.
pub fn validate(text: &str) -> Result<(), String> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
    let mut validator = naga::valid::Validator::new(
        naga::valid::ValidationFlags::all(),
        naga::valid::Capabilities::empty(),
    );
    match validator.validate(&module) {
        Ok(_) => Ok(()),
        Err(error) => Err(error.emit_to_string(text)),
    }
}
