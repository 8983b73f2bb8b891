//! Function bodies: a graph as `let` statements and output expressions.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::algebra::Ratio;
use crate::ir::{Arena, Function, Node, NodeId, Value};
use crate::kernel::Kernel;
use crate::passes::Stage;

/// The code of a graph.
pub(super) struct Body {
    /// Values that are read more than once.
    pub(super) statements: TokenStream,
    /// One expression for each output.
    pub(super) outputs: Vec<TokenStream>,
    /// What it requires of the scalar.
    pub(super) needs: Needs,
}

/// What a body requires of the scalar.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Needs {
    /// Sums and products.
    Ring,
    /// Fractions too.
    Field,
    /// Functions too.
    Real,
}

impl Needs {
    /// The name of the trait.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Ring => "Ring",
            Self::Field => "Field",
            Self::Real => "Real",
        }
    }
}

/// Writes the code of a kernel; `inputs` are the expressions of its inputs.
pub(super) fn body(kernel: &Kernel, runtime: &TokenStream, inputs: &[TokenStream]) -> Body {
    let stage = Stage::whole(&kernel.arena, &kernel.outputs);
    let source = Source {
        runtime,
        inputs,
        given: &HashMap::new(),
        prefix: "t",
    };
    stage_body(&kernel.arena, stage, &kernel.outputs, &source)
}

/// Where a body finds what it reads.
pub(super) struct Source<'a> {
    /// The path of ga-runtime.
    pub(super) runtime: &'a TokenStream,
    /// The expressions of the inputs.
    pub(super) inputs: &'a [TokenStream],
    /// Nodes that an earlier stage has computed.
    pub(super) given: &'a HashMap<NodeId, TokenStream>,
    /// How the names of variables begin.
    pub(super) prefix: &'a str,
}

/// Writes the code of one stage of a kernel.
pub(super) fn stage_body(
    arena: &Arena,
    stage: Stage,
    outputs: &[Value],
    source: &Source<'_>,
) -> Body {
    let mut writer = Writer {
        arena,
        stage,
        source,
        needs: Needs::Ring,
        families: Vec::new(),
    };
    let mut statements = TokenStream::new();
    for id in writer.stage.order.clone() {
        if let Node::Function(function, arguments) = arena.node(id)
            && !function.family().is_empty()
        {
            statements.extend(writer.family(*function, arguments));
        } else if writer.stage.uses[id.index()] > 1 {
            let name = writer.variable(id);
            let expression = writer.expression(id);
            statements.extend(quote! { let #name = #expression; });
        }
    }
    let outputs = outputs.iter().map(|&output| writer.value(output)).collect();
    Body {
        statements,
        outputs,
        needs: writer.needs,
    }
}

/// A constant of the scalar type `S`.
pub(super) fn constant(runtime: &TokenStream, value: Ratio) -> TokenStream {
    let ratio = |numerator: i64, denominator: i64| {
        let [numerator, denominator] = [numerator, denominator].map(Literal::i64_suffixed);
        quote! { <S as #runtime::scalar::Field>::from_ratio(#numerator, #denominator) }
    };
    let integer = |value: i64| {
        let value = Literal::i64_suffixed(value);
        quote! { <S as #runtime::scalar::Ring>::from_integer(#value) }
    };
    let parts = [value.numerator(), value.denominator()];
    match parts.map(i64::try_from) {
        [Ok(0), _] => return quote! { <S as #runtime::scalar::Ring>::zero() },
        [Ok(1), Ok(1)] => return quote! { <S as #runtime::scalar::Ring>::one() },
        [Ok(numerator), Ok(1)] => return integer(numerator),
        [Ok(numerator), Ok(denominator)] => return ratio(numerator, denominator),
        _ => {}
    }
    // Other numbers are rounded once, to double precision.
    let (mut mantissa, mut exponent) = value.nearest_double();
    while exponent < 0 && mantissa % 2 == 0 {
        (mantissa, exponent) = (mantissa / 2, exponent + 1);
    }
    let step = MOST_SHIFT.min(exponent.unsigned_abs());
    let mut left = exponent.unsigned_abs() - step;
    let power = |shift: u32| 1_i64 << shift;
    let mut tokens = match exponent < 0 {
        true => ratio(mantissa, power(step)),
        false => integer(mantissa),
    };
    if exponent >= 0 {
        left += step;
    }
    while left > 0 {
        let step = MOST_SHIFT.min(left);
        left -= step;
        let factor = match exponent < 0 {
            true => ratio(1, power(step)),
            false => integer(power(step)),
        };
        tokens = quote! { (#tokens * #factor) };
    }
    tokens
}

/// The largest power of two in one number.
const MOST_SHIFT: u32 = 62;

struct Writer<'a> {
    arena: &'a Arena,
    stage: Stage,
    source: &'a Source<'a>,
    needs: Needs,
    /// Functions of several results that have been called.
    families: Vec<(Function, Box<[Value]>)>,
}

impl Writer<'_> {
    fn variable(&self, id: NodeId) -> Ident {
        format_ident!("{}{}", self.source.prefix, id.index())
    }

    fn constant(&mut self, value: Ratio) -> TokenStream {
        if !value.is_integer() {
            self.needs = self.needs.max(Needs::Field);
        }
        constant(self.source.runtime, value)
    }

    /// The call that gives all results of a family of functions; nothing if it has been made.
    fn family(&mut self, function: Function, arguments: &[Value]) -> TokenStream {
        self.needs = Needs::Real;
        let family = function.family();
        let key = (family[0], arguments.into());
        if self.families.contains(&key) {
            return TokenStream::new();
        }
        self.families.push(key);
        let names: Vec<_> = family
            .iter()
            .map(|&member| {
                let wanted = |id: &NodeId| match self.arena.node(*id) {
                    Node::Function(other, others) => *other == member && **others == *arguments,
                    _ => false,
                };
                match self.stage.order.iter().find(|id| wanted(id)) {
                    Some(&id) => self.variable(id),
                    None => format_ident!("_"),
                }
            })
            .collect();
        let values: Vec<_> = arguments
            .iter()
            .map(|&argument| self.value(argument))
            .collect();
        let call = self.call(function);
        quote! { let (#(#names),*) = #call(#(#values),*); }
    }

    /// A function of one result.
    fn function(&mut self, function: Function, arguments: &[Value]) -> TokenStream {
        let of_field = function.properties().rust.starts_with("Field::");
        let needed = if of_field { Needs::Field } else { Needs::Real };
        self.needs = self.needs.max(needed);
        let values: Vec<_> = arguments
            .iter()
            .map(|&argument| self.value(argument))
            .collect();
        match (function, values.as_slice()) {
            (Function::And, [a, b]) => quote! { (#a & #b) },
            (Function::Or, [a, b]) => quote! { (#a | #b) },
            (Function::Not, [a]) => quote! { !#a },
            _ => {
                let call = self.call(function);
                quote! { #call(#(#values),*) }
            }
        }
    }

    /// The function of ga-runtime that gives a function, or all of its family.
    fn call(&self, function: Function) -> TokenStream {
        let runtime = self.source.runtime;
        let path = function.properties().rust;
        match path.split_once("::") {
            Some((of, method)) => {
                let [of, method] = [of, method].map(|name| format_ident!("{name}"));
                quote! { <S as #runtime::scalar::#of>::#method }
            }
            None => {
                let path = format_ident!("{path}");
                quote! { #runtime::scalar::#path }
            }
        }
    }

    /// A value with its factor.
    fn value(&mut self, value: Value) -> TokenStream {
        if let Some(known) = value.as_constant() {
            return self.constant(known);
        }
        if value.factor == Ratio::ONE {
            return self.read(value.node);
        }
        if value.factor == Ratio::integer(-1) {
            return self.negative(value.node);
        }
        let node = self.operand(value.node);
        let factor = self.constant(value.factor);
        quote! { #factor * #node }
    }

    /// The negative of a node; a difference that is read only here is reversed.
    fn negative(&mut self, id: NodeId) -> TokenStream {
        if let Node::Sum(terms) = self.arena.node(id)
            && self.stage.uses[id.index()] == 1
            && !self.source.given.contains_key(&id)
            && let Some(first) = terms.iter().position(|term| term.factor.is_negative())
        {
            let mut reversed: Vec<_> = terms.iter().map(|&term| -term).collect();
            reversed[..=first].rotate_right(1);
            return self.sum(&reversed);
        }
        let node = self.operand(id);
        quote! { -#node }
    }

    /// A sum whose first term has a positive factor. A product that is read only here is fused with
    /// the addition.
    fn sum(&mut self, terms: &[Value]) -> TokenStream {
        let mut tokens = TokenStream::new();
        for (place, term) in self.ordered(terms).into_iter().enumerate() {
            let is_negative = term.factor.is_negative();
            if place > 0 && self.is_fused(term) {
                let (left, right) = self.factors(term);
                let method = if is_negative {
                    "neg_mul_add"
                } else {
                    "mul_add"
                };
                let method = format_ident!("{method}");
                tokens = quote! { #left.#method(#right, #tokens) };
                continue;
            }
            let size = Value {
                factor: term.factor.abs(),
                ..term
            };
            let text = if size.factor == Ratio::ONE && term.node != Arena::ONE {
                self.operand(term.node)
            } else {
                self.value(size)
            };
            tokens = match (place, is_negative) {
                (0, _) => text,
                (_, false) => quote! { #tokens + #text },
                (_, true) => quote! { #tokens - #text },
            };
        }
        tokens
    }

    /// The terms of a sum in the order in which they are added: a product and a plain term make one
    /// fused operation if the product comes second.
    fn ordered(&self, terms: &[Value]) -> Vec<Value> {
        let mut terms = terms.to_vec();
        if let [first, second, ..] = terms.as_mut_slice()
            && self.is_fused(*first)
            && !self.is_fused(*second)
            && !second.factor.is_negative()
        {
            std::mem::swap(first, second);
        }
        terms
    }

    /// Whether a term is a product that is computed here, so that it can be fused with the
    /// addition.
    fn is_fused(&self, term: Value) -> bool {
        if term.node == Arena::ONE {
            return false;
        }
        let is_product = matches!(self.arena.node(term.node), Node::Product(..));
        term.factor.abs() != Ratio::ONE || (is_product && self.is_here(term.node))
    }

    /// The factors of such a term: the receiver of a method, and its argument.
    fn factors(&mut self, term: Value) -> (TokenStream, TokenStream) {
        let size = term.factor.abs();
        match *self.arena.node(term.node) {
            Node::Product(a, b) if size == Ratio::ONE => (self.receiver(a), self.read(b)),
            _ => {
                let factor = self.constant(size);
                (self.receiver(term.node), factor)
            }
        }
    }

    /// Whether a node is written out where it is read.
    fn is_here(&self, id: NodeId) -> bool {
        self.stage.uses[id.index()] == 1 && !self.source.given.contains_key(&id)
    }

    /// Whether a node is written as an expression that needs parentheses as a factor.
    fn is_loose(&self, id: NodeId) -> bool {
        self.is_here(id)
            && match self.arena.node(id) {
                Node::Sum(terms) => match self.ordered(terms).as_slice() {
                    [_] => true,
                    ordered => !ordered.last().is_some_and(|&last| self.is_fused(last)),
                },
                Node::Quotient(_, divisor) => !self.is_guarded(*divisor),
                Node::One | Node::Input(_) | Node::Product(..) | Node::Function(..) => false,
            }
    }

    /// Whether quotients by a node are 0 where it is.
    fn is_guarded(&self, divisor: NodeId) -> bool {
        matches!(
            self.arena.node(divisor),
            Node::Function(Function::Divisor, _)
        )
    }

    /// A node as the receiver of a method.
    fn receiver(&mut self, id: NodeId) -> TokenStream {
        let read = self.read(id);
        let is_product = matches!(self.arena.node(id), Node::Product(..)) && self.is_here(id);
        if is_product || self.is_loose(id) {
            quote! { (#read) }
        } else {
            read
        }
    }

    /// A node where it is read: its variable, or its expression where this is the only place.
    fn read(&mut self, id: NodeId) -> TokenStream {
        if let Some(given) = self.source.given.get(&id) {
            return given.clone();
        }
        match self.arena.node(id) {
            Node::Input(number) => self.source.inputs[*number].clone(),
            Node::Function(function, _) if !function.family().is_empty() => {
                let name = self.variable(id);
                quote! { #name }
            }
            Node::Sum(_) | Node::Product(..) | Node::Quotient(..) | Node::Function(..)
                if self.stage.uses[id.index()] > 1 =>
            {
                let name = self.variable(id);
                quote! { #name }
            }
            Node::One
            | Node::Sum(_)
            | Node::Product(..)
            | Node::Quotient(..)
            | Node::Function(..) => self.expression(id),
        }
    }

    /// A node as the operand of a multiplication or negation.
    fn operand(&mut self, id: NodeId) -> TokenStream {
        let read = self.read(id);
        if self.is_loose(id) {
            quote! { (#read) }
        } else {
            read
        }
    }

    fn expression(&mut self, id: NodeId) -> TokenStream {
        match self.arena.node(id).clone() {
            Node::One => self.constant(Ratio::ONE),
            Node::Input(number) => self.source.inputs[number].clone(),
            Node::Product(a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                quote! { #a * #b }
            }
            Node::Quotient(a, b) if self.is_guarded(b) => {
                self.needs = self.needs.max(Needs::Field);
                let runtime = self.source.runtime;
                let field = quote! { <S as #runtime::scalar::Field> };
                let divisor = self.read(b);
                if a == Arena::ONE {
                    return quote! { #field::recip_or_zero(#divisor) };
                }
                let dividend = self.read(a);
                quote! { #field::div_or_zero(#dividend, #divisor) }
            }
            // It is known where it divides.
            Node::Function(Function::Divisor, arguments) => self.value(arguments[0]),
            Node::Quotient(a, b) => {
                self.needs = self.needs.max(Needs::Field);
                let (dividend, divisor) = (self.operand(a), self.operand(b));
                let is_input = matches!(self.arena.node(b), Node::Input(_));
                // A product in the divisor needs parentheses.
                let divisor = if is_input {
                    divisor
                } else {
                    quote! { (#divisor) }
                };
                quote! { #dividend / #divisor }
            }
            Node::Sum(terms) => self.sum(&terms),
            Node::Function(function, arguments) => self.function(function, &arguments),
        }
    }
}
