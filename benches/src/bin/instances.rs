//! Prints a crate that calls every declared product of cga3 at `f32` and `f64`, for measuring how
//! long it takes to build all of them.

use anyhow::{Context, Result, anyhow};
use ga_compiler::define::{Operation, TypeDefinition};
use nullcone_benches::declaration;
use quote::quote;

fn main() -> Result<()> {
    let declaration = declaration::cga3().context("cga3 is declared by the macro")?;
    let syntax =
        ga_compiler::parse::parse_declaration(declaration).map_err(|error| anyhow!("{error}"))?;
    let definition = ga_compiler::check::check(syntax, quote! { ga_runtime })
        .map_err(|error| anyhow!("{error}"))?;
    let path = |kind: &TypeDefinition, scalar: &str| match kind.is_constant() {
        true => format!("ga_runtime::cga3::{}", kind.name),
        false => format!("ga_runtime::cga3::{}<{scalar}>", kind.name),
    };
    for (number, product) in definition.products.iter().enumerate() {
        let first = &definition.types[product.operands[0]];
        for scalar in ["f32", "f64"] {
            let result = product.result.map_or(scalar.to_owned(), |index| {
                path(&definition.types[index], scalar)
            });
            let (name, a) = (product.operation.name(), path(first, scalar));
            match product.operation {
                Operation::Unary(_) => {
                    println!("pub fn p{number}_{scalar}(a: {a}) -> {result} {{ a.{name}() }}");
                }
                _ => {
                    let b = path(&definition.types[product.operands[1]], scalar);
                    println!(
                        "pub fn p{number}_{scalar}(a: {a}, b: {b}) -> {result} {{ a.{name}(b) }}"
                    );
                }
            }
        }
    }
    Ok(())
}
