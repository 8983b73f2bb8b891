//! Checks the products: operand types, and that every result lies in the declared type.

use proc_macro2::Span;
use syn::Ident;

use super::limits;
use crate::algebra::{Algebra, Blade};
use crate::define::{Definition, Operation, ProductDefinition, SCALAR_TYPE, TypeDefinition};
use crate::diag::Diagnostics;
use crate::parse::{OperandTypeSyntax, ProductSyntax};
use crate::resolve::as_blade;
use crate::verify;

pub(super) fn check(
    definition: &Definition,
    sound: &[bool],
    syntax: &[ProductSyntax],
    diagnostics: &mut Diagnostics,
) -> Vec<ProductDefinition> {
    let (algebra, types) = (&definition.algebra, &definition.types[..]);
    let mut products: Vec<ProductDefinition> = Vec::new();
    let mut terms = 0;
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
        let choices = resolve_operands(definition, line, diagnostics);
        let result = resolve_result(types, line.result.as_ref(), diagnostics);
        let (Some(choices), Some(result)) = (choices, result) else {
            continue;
        };
        let (before, mut zeros) = (products.len(), Vec::new());
        let combinations = combinations(&choices);
        for marked in &combinations {
            let operands: &Vec<usize> = &marked.iter().map(|(place, _)| *place).collect();
            let as_blades = marked.iter().map(|(_, kind)| kind.cloned());
            let as_blades: Vec<Option<TypeDefinition>> = as_blades.collect();
            let repeated = products
                .iter()
                .any(|known| known.operation == operation && known.operands == *operands);
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
                operands,
                kinds: (operands.iter().zip(&as_blades))
                    .map(|(place, kind)| kind.as_ref().unwrap_or(&types[*place]))
                    .collect(),
                span: line.operation.span(),
            };
            if terms <= limits::MAX_TERMS {
                let kinds: Vec<_> = operands.iter().map(|&o| &types[o]).collect();
                terms += limits::terms(algebra, operation, &kinds);
                if terms > limits::MAX_TERMS {
                    let message = format!(
                        "{} has too many terms: the products of an algebra have at most {} together",
                        context.title(),
                        limits::MAX_TERMS
                    );
                    diagnostics.error(line.operation.span(), message);
                }
            }
            if terms > limits::MAX_TERMS {
                continue;
            }
            match context.result(&result, diagnostics) {
                Some(Found::Result(result)) => products.push(ProductDefinition {
                    operation,
                    operands: operands.clone(),
                    result,
                    as_blades,
                }),
                Some(Found::Zero) => zeros.push(context.title()),
                None => {}
            }
        }
        // In a list of types some pairs have no product that is not zero.
        if products.len() == before && zeros.len() == combinations.len() && !zeros.is_empty() {
            let (verb, pronoun) = match zeros.len() {
                1 => ("is", "it is"),
                _ => ("are", "they are"),
            };
            let message = format!(
                "{} {verb} always zero, so {pronoun} left out",
                zeros.join(", ")
            );
            diagnostics.warning(line.operation.span(), message);
        }
    }
    products
}

/// A type of an operand, as an index, and with the fact that it is a blade, if it is marked so.
type Marked<'a> = (usize, Option<&'a TypeDefinition>);

fn resolve_operands<'a>(
    definition: &'a Definition,
    line: &ProductSyntax,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<Vec<Marked<'a>>>> {
    let types = &definition.types;
    let mut complete = true;
    let mut choices = Vec::new();
    for names in &line.operands {
        let mut places = Vec::new();
        for OperandTypeSyntax { name, is_blade } in names {
            match types.iter().position(|kind| kind.name == *name) {
                Some(place) if *is_blade => match as_blade(definition, place) {
                    Some(kind) => places.push((place, Some(kind))),
                    None => {
                        complete = false;
                        let message = format!(
                            "`{name}` cannot be marked `blade`: all of its members are blades, or \
                             those that are do not form one family"
                        );
                        diagnostics.error(name.span(), message);
                    }
                },
                Some(place) => places.push((place, None)),
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

fn combinations<T: Copy>(choices: &[Vec<T>]) -> Vec<Vec<T>> {
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

/// What is found for one product.
enum Found {
    /// The type of the result as an index, or none for a scalar.
    Result(Option<usize>),
    /// That it is zero for all operands.
    Zero,
}

/// One operation on given operand types, of which the result is sought.
struct Context<'a> {
    algebra: &'a Algebra,
    types: &'a [TypeDefinition],
    /// For each type, whether it is free of errors.
    sound: &'a [bool],
    operation: Operation,
    operands: &'a [usize],
    /// The types of the operands, with what is known of them beside.
    kinds: Vec<&'a TypeDefinition>,
    span: Span,
}

impl Context<'_> {
    /// The type of the result; `None` if an error was reported.
    fn result(&self, stated: &Stated<'_>, diagnostics: &mut Diagnostics) -> Option<Found> {
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
        Some(Found::Result(place))
    }

    fn fits(&self, place: Option<usize>) -> Result<(), Vec<String>> {
        verify::result_fits(
            self.algebra,
            &self.kinds,
            &self.operation.expression(),
            place.map(|p| &self.types[p]),
        )
    }

    fn infer(&self, diagnostics: &mut Diagnostics) -> Option<Found> {
        if self.sound.contains(&false) {
            return None;
        }
        let expression = self.operation.expression();
        let blades = verify::result_blades(self.algebra, &self.kinds, &expression);
        let names: Vec<_> = blades
            .iter()
            .map(|&blade| self.algebra.names().name(blade))
            .collect();
        if blades.is_empty() {
            return Some(Found::Zero);
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
            [] if blades.iter().all(|blade| blade.grade() == 0) => Some(Found::Result(None)),
            [one] => Some(Found::Result(Some(*one))),
            [] => {
                let message = format!(
                    "{} has the blades {}, and no declared type has exactly these: \
                     declare one, such as `struct {} {{ {} }}`{}",
                    self.title(),
                    names.join(", "),
                    self.free_name(&blades),
                    names.join(", "),
                    self.wider(&blades)
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

    /// A name for a type of some blades that no type has yet.
    fn free_name(&self, blades: &[Blade]) -> String {
        let dimension = self.algebra.dimension();
        let grades = || blades.iter().map(|blade| blade.grade() as usize);
        let is_of_one_grade = grades().min() == grades().max();
        let name = match grades().max() {
            Some(grade) if is_of_one_grade && grade == dimension => "Pseudoscalar",
            Some(1) if is_of_one_grade => "Vector",
            Some(2) if is_of_one_grade => "Bivector",
            Some(3) if is_of_one_grade => "Trivector",
            _ if grades().all(|grade| grade % 2 == 0) => "Even",
            _ if grades().all(|grade| grade % 2 == 1) => "Odd",
            _ => "Multivector",
        };
        let is_taken = |name: &str| self.types.iter().any(|kind| kind.name == name);
        let mut free = name.to_owned();
        let mut number = 1;
        while is_taken(&free) {
            number += 1;
            free = format!("{name}{number}");
        }
        free
    }

    /// The smallest type of more blades, as the end of a message.
    fn wider(&self, blades: &[Blade]) -> String {
        let holds_all = |kind: &&TypeDefinition| {
            let mut blades = blades.iter();
            kind.is_linear() && blades.all(|&blade| kind.coefficient(blade).is_some())
        };
        let wider = self.types.iter().filter(holds_all);
        match wider.min_by_key(|kind| kind.coefficients.len()) {
            Some(kind) => format!(", or state a result with more, `-> {}`", kind.name),
            None => String::new(),
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
