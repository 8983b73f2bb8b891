//! Checks the products: operand types, and that every result lies in the declared type.

use proc_macro2::Span;
use syn::Ident;

use crate::algebra::Algebra;
use crate::define::{Operation, ProductDefinition, SCALAR_TYPE, TypeDefinition};
use crate::diag::Diagnostics;
use crate::parse::ProductSyntax;
use crate::verify;

pub(super) fn check(
    algebra: &Algebra,
    types: &[TypeDefinition],
    sound: &[bool],
    syntax: &[ProductSyntax],
    diagnostics: &mut Diagnostics,
) -> Vec<ProductDefinition> {
    let mut products: Vec<ProductDefinition> = Vec::new();
    for line in syntax {
        let Some(operation) = Operation::from_name(&line.operation.to_string()) else {
            let message = format!("unknown operation `{}`", line.operation);
            diagnostics.error(line.operation.span(), message);
            continue;
        };
        if line.operands.len() != operation.arity() {
            let (wanted, found) = (operation.arity(), line.operands.len());
            let plural = if wanted == 1 { "" } else { "s" };
            let message = format!(
                "`{}` takes {wanted} operand{plural}, not {found}",
                line.operation
            );
            diagnostics.error(line.operation.span(), message);
            continue;
        }
        let choices = resolve_operands(types, line, diagnostics);
        let result = resolve_result(types, line.result.as_ref(), diagnostics);
        let (Some(choices), Some(result)) = (choices, result) else {
            continue;
        };
        for operands in combinations(&choices) {
            let repeated = products
                .iter()
                .any(|known| known.operation == operation && known.operands == operands);
            if repeated {
                let names: Vec<_> = operands
                    .iter()
                    .map(|&o| types[o].name.to_string())
                    .collect();
                let message = format!(
                    "`{}({})` is declared twice",
                    line.operation,
                    names.join(", ")
                );
                diagnostics.error(line.operation.span(), message);
                continue;
            }
            let context = Context {
                algebra,
                types,
                sound,
                operation,
                operands: &operands,
                span: line.operation.span(),
            };
            if let Some(result) = context.result(&result, diagnostics) {
                products.push(ProductDefinition {
                    operation,
                    operands,
                    result,
                });
            }
        }
    }
    products
}

fn resolve_operands(
    types: &[TypeDefinition],
    line: &ProductSyntax,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Vec<usize>>> {
    let mut complete = true;
    let mut choices = Vec::new();
    for names in &line.operands {
        let mut places = Vec::new();
        for name in names {
            match types.iter().position(|kind| kind.name == *name) {
                Some(place) => places.push(place),
                None => {
                    complete = false;
                    diagnostics.error(name.span(), format!("unknown type `{name}`"));
                }
            }
        }
        choices.push(places);
    }
    complete.then_some(choices)
}

/// What a declaration says about a result.
enum Stated<'a> {
    /// Nothing: it is to be found.
    Nothing,
    /// The type of the last operand.
    LastOperand(&'a Ident),
    /// A type, or a scalar.
    Type(&'a Ident, Option<usize>),
}

fn resolve_result<'a>(
    types: &[TypeDefinition],
    stated: Option<&'a Ident>,
    diagnostics: &mut Diagnostics,
) -> Option<Stated<'a>> {
    let Some(name) = stated else {
        return Some(Stated::Nothing);
    };
    if name == SCALAR_TYPE {
        return Some(Stated::Type(name, None));
    }
    if name == "Self" {
        return Some(Stated::LastOperand(name));
    }
    let place = types.iter().position(|kind| kind.name == *name);
    if place.is_none() {
        diagnostics.error(name.span(), format!("unknown type `{name}`"));
    }
    place.map(|place| Stated::Type(name, Some(place)))
}

fn combinations(choices: &[Vec<usize>]) -> Vec<Vec<usize>> {
    choices.iter().fold(vec![vec![]], |all, next| {
        all.iter()
            .flat_map(|start| {
                next.iter().map(move |&place| {
                    let mut extended = start.clone();
                    extended.push(place);
                    extended
                })
            })
            .collect()
    })
}

/// One operation on given operand types, of which the result is sought.
struct Context<'a> {
    algebra: &'a Algebra,
    types: &'a [TypeDefinition],
    /// For each type, whether it is free of errors.
    sound: &'a [bool],
    operation: Operation,
    operands: &'a [usize],
    span: Span,
}

impl Context<'_> {
    /// The type of the result as an index, or none for a scalar; `None` if an error was reported.
    fn result(&self, stated: &Stated<'_>, diagnostics: &mut Diagnostics) -> Option<Option<usize>> {
        if !self.operands.iter().all(|&o| self.sound[o]) {
            return None;
        }
        if self.operands.iter().all(|&o| self.types[o].is_constant()) {
            let message = "a product of constants alone has no scalar type: one operand must store a coefficient";
            diagnostics.error(self.span, message);
            return None;
        }
        let (name, place) = match *stated {
            Stated::Nothing => return self.infer(diagnostics),
            Stated::LastOperand(name) => (name, self.operands.last().copied()),
            Stated::Type(name, place) => (name, place),
        };
        if place.is_some_and(|place| !self.sound[place]) {
            return None;
        }
        if let Err(reasons) = self.fits(place) {
            let message = format!(
                "{} does not lie in `{}`: {}",
                self.title(),
                place.map_or(SCALAR_TYPE.to_owned(), |p| self.types[p].name.to_string()),
                reasons.join("; ")
            );
            diagnostics.error(name.span(), message);
            return None;
        }
        Some(place)
    }

    fn fits(&self, place: Option<usize>) -> Result<(), Vec<String>> {
        let operands: Vec<_> = self.operands.iter().map(|&o| &self.types[o]).collect();
        verify::result_fits(
            self.algebra,
            &operands,
            &self.operation.expression(),
            place.map(|p| &self.types[p]),
        )
    }

    fn infer(&self, diagnostics: &mut Diagnostics) -> Option<Option<usize>> {
        if self.sound.contains(&false) {
            return None;
        }
        let operands: Vec<_> = self.operands.iter().map(|&o| &self.types[o]).collect();
        let blades = verify::result_blades(self.algebra, &operands, &self.operation.expression());
        let names: Vec<_> = blades
            .iter()
            .map(|&blade| self.algebra.names().name(blade))
            .collect();
        if blades.is_empty() {
            diagnostics.error(self.span, format!("{} is always zero", self.title()));
            return None;
        }
        let candidates: Vec<usize> = (0..self.types.len())
            .filter(|&place| {
                let kind = &self.types[place];
                kind.is_linear()
                    && kind.coefficients.len() == blades.len()
                    && blades
                        .iter()
                        .all(|&blade| kind.coefficient(blade).is_some())
            })
            .collect();
        match candidates.as_slice() {
            [] if blades.iter().all(|blade| blade.grade() == 0) => Some(None),
            [one] => Some(Some(*one)),
            [] => {
                let message = format!(
                    "{} has the blades {}, and no declared type has exactly these",
                    self.title(),
                    names.join(", ")
                );
                diagnostics.error(self.span, message);
                None
            }
            several => {
                let fitting: Vec<_> = several
                    .iter()
                    .map(|&place| format!("`{}`", self.types[place].name))
                    .collect();
                let message = format!(
                    "{} fits {}: state the result with `->`",
                    self.title(),
                    fitting.join(" and ")
                );
                diagnostics.error(self.span, message);
                None
            }
        }
    }

    fn title(&self) -> String {
        let names: Vec<_> = self
            .operands
            .iter()
            .map(|&o| self.types[o].name.to_string())
            .collect();
        format!("`{}({})`", self.operation.name(), names.join(", "))
    }
}
