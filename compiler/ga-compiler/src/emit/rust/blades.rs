//! The constructor of types of blades, which checks the Plücker relations.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::body::body;
use super::context::{Context, fields};
use crate::define::TypeDefinition;
use crate::ir::{Arena, plucker};
use crate::kernel::Kernel;
use crate::lower;
use crate::passes;

/// `try_new` of a type whose members are blades although not all coefficients make one.
pub(super) fn emit(context: &Context<'_>, kind: &TypeDefinition) -> TokenStream {
    if !kind.facts.blade || kind.facts_are_implied || kind.is_constant() {
        return TokenStream::new();
    }
    let mut arena = Arena::default();
    let operand = lower::operand(&mut arena, kind, false);
    let relations = plucker(&mut arena, &operand);
    let (arena, outputs) = passes::optimise(arena, relations, &[], &[]);
    let kernel = Kernel {
        uniform: vec![false; arena.inputs()],
        arena,
        outputs,
        choices: lower::Choices::default(),
        literals: Vec::new(),
        limits: Vec::new(),
    };
    let inputs = fields(&[(kind, format_ident!("blade"))]);
    let code = body(&kernel, context.runtime, &inputs);
    let (statements, defects) = (code.statements, code.outputs);
    let arguments: Vec<_> = kind.stored().map(|c| &c.name).collect();
    let (path, runtime) = (context.path(kind), context.runtime);
    let real = quote! { #runtime::scalar::Real };
    quote! {
        impl<S: #real<Mask = ::core::primitive::bool>> #path {
            /// The blade with these coefficients, or `None` where one of the Plücker relations is
            /// not satisfied: its value is larger than the tolerance, or not a number.
            #[must_use]
            pub fn try_new(
                #(#arguments: S,)* tolerance: S
            ) -> ::core::option::Option<Self> {
                let blade = Self { #(#arguments),* };
                #statements
                #runtime::__private::are_within(&[#(#defects),*], tolerance).then_some(blade)
            }
        }
    }
}
