//! Algebras in which several tests compile.

use ga_compiler::check_types;
use ga_compiler::define::Definition;
use proc_macro2::TokenStream;
use quote::quote;

/// The declaration of cga3 as it ships.
pub(crate) fn cga3_tokens() -> TokenStream {
    let source = include_str!("../../../ga-runtime/src/algebras/cga3.rs");
    let start = source.find("algebra! {").expect("the macro") + "algebra! {".len();
    let end = source.rfind('}').expect("the macro");
    source[start..end].parse().expect("tokens")
}

/// The types of cga3.
pub(crate) fn cga3() -> Definition {
    check(cga3_tokens())
}

/// An algebra of signature (1, 2, 1) that is not conformal.
pub(crate) fn minkowski() -> Definition {
    check(quote! {
        pub mod minkowski {
            basis t, x, y, w;
            signature 1, 2, 1;
            struct Vector { t, x, y, w }
            /// Vectors of constant weight, as points are.
            #[hull(Vector)]
            struct Event { t, x, y, w = 2 }
            struct Bivector { tx, ty, xy, tw, xw, yw }
            struct Even { scalar, tx, ty, xy, tw, xw, yw, txyw }
            #[hull(Even)] #[facts(unit_versor)]
            struct Boost { scalar, tx, ty, xy, tw, xw, yw, txyw }
        }
    })
}

fn check(declaration: TokenStream) -> Definition {
    match check_types(declaration, quote! { ga_runtime }) {
        Ok(definition) => definition,
        Err(error) => panic!("{error}"),
    }
}
