//! Attributes and visibility of declared items, which a definition holds as tokens.

use proc_macro2::TokenStream;
use syn::parse::Parser;
use syn::{Attribute, Visibility};

/// The attributes that the tokens are; none if they are something else.
pub(super) fn attributes_of(tokens: &TokenStream) -> Vec<Attribute> {
    Attribute::parse_outer
        .parse2(tokens.clone())
        .unwrap_or_default()
}

/// The visibility that the tokens are; private if they are something else.
pub(super) fn visibility_of(tokens: &TokenStream) -> Visibility {
    syn::parse2(tokens.clone()).unwrap_or(Visibility::Inherited)
}
