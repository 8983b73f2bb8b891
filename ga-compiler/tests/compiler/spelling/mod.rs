//! Spelling does not matter: formulas with the same meaning cost the same.

mod random;

use ga_compiler::count;
use ga_compiler::define::Definition;
use quote::quote;

use crate::algebras::compile;

/// Multiplications, additions, divisions and roots: of each call, and those done once.
type Cost = [(usize, usize, usize, usize); 2];

/// The cost of a function, of which the operands and the result are `types`.
#[track_caller]
fn count(definition: &Definition, types: &str, formula: &str) -> Cost {
    let (operands, result) = types.rsplit_once(" -> ").expect("a signature");
    let text = format!("fn kernel({operands}) -> {result} {{ {formula} }}");
    let function = compile(definition, &text);
    let counted = count::function(definition, &quote!(algebra), &function);
    let counted = counted.expect("operations that are known");
    [counted.call, counted.uniform].map(|found| {
        let count::Operations {
            multiplications,
            additions,
            divisions,
            roots,
            ..
        } = found;
        (multiplications, additions, divisions, roots)
    })
}
