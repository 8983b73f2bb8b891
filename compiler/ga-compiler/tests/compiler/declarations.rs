//! Declarations through the compiler, with no macro involved: what is accepted, what is refused,
//! and what is emitted.

use ga_compiler::define::Definition;
use ga_compiler::{check, expand_algebra, parse};
use proc_macro2::TokenStream;
use quote::quote;

fn check(declaration: TokenStream) -> Result<Definition, Vec<String>> {
    let messages = |errors: syn::Error| errors.into_iter().map(|e| e.to_string()).collect();
    parse::parse_declaration(declaration)
        .and_then(|syntax| check::check(syntax, quote!(::ga_runtime)))
        .map_err(messages)
}

/// The emitted code of a declaration, formatted.
fn emitted(declaration: &TokenStream) -> String {
    let code = expand_algebra(quote!([::ga_runtime] #declaration));
    let file = syn::parse2(code).expect("items");
    prettyplease::unparse(&file)
}

#[test]
fn signatures_may_stop_early() {
    for (signature, squares) in [
        (quote!(3), ["1", "1", "1"]),
        (quote!(2, 1), ["1", "1", "-1"]),
        (quote!(1, 1, 1), ["1", "-1", "0"]),
        (quote!(0, 0, 3), ["0", "0", "0"]),
    ] {
        let definition = check(quote! {
            mod some { basis x, y, z; signature #signature; struct Vector { x, y, z } }
        });
        let metric = definition.expect("sound").algebra.metric().clone();
        let found = [0, 1, 2].map(|k| metric.get(k, k).to_string());
        assert_eq!(found, squares);
    }
}

#[test]
fn a_full_metric_of_many_dimensions_is_accepted() {
    // There are 10¹⁴ ways to contract the pseudoscalar of these twelve vectors with itself.
    let names: Vec<_> = (b'a'..=b'l')
        .map(|letter| quote::format_ident!("{}", letter as char))
        .collect();
    let entries = names.iter().enumerate().flat_map(|(row, a)| {
        names[row..].iter().map(move |b| {
            if a == b {
                quote!(#a * #b = 2)
            } else {
                quote!(#a * #b = 1)
            }
        })
    });
    let definition = check(quote! {
        mod many {
            basis #(#names),*;
            metric #(#entries),*;
            struct Vector { #(#names),* }
            products { left_contraction(Vector, Vector) -> Scalar; }
        }
    });
    let algebra = definition.expect("sound").algebra;
    // The determinant of a matrix of ones plus the identity is n + 1.
    assert!(!algebra.is_degenerate());
    assert_eq!(algebra.metric().pseudoscalar_square().to_string(), "13");
}

#[test]
fn every_fault_is_found_and_none_twice() {
    let found = check(quote! {
        mod some {
            basis e1, e2, e2;
            signature 3;
            struct Vector { e1, e2, e3 }
            struct Rotor { scalar, e12, e21 }
            #[hull(Rotor)] #[facts(unit)] struct Unit { scalar, e12 }
            products {
                wedge({Vector, Unit}, {Vector, Unit}) -> Area;
                geometric(Rotor, Rotor) -> Rotor;
                join(Vector);
            }
        }
    });
    let expected = [
        "basis vector `e2` is listed twice",
        "unknown basis vector in `e3`; a blade is named by basis vectors joined after their common prefix",
        "blade `e21` is listed twice, first as `e12`",
        "unknown fact; known are `unit_versor`, `null`, `blade` and `weight(…)`",
        "unknown type `Area`",
        "unknown operation `join`",
    ];
    assert_eq!(found.err().expect("faulty"), expected);
}

/// What a message proposes can be written as it stands: a name that no type has, and the blades.
#[test]
fn names_of_missing_types_are_free_and_say_the_grades() {
    for (products, proposed) in [
        (quote!(wedge(Whole, Whole)), "struct Bivector2 { e12, "),
        (quote!(wedge(Vector, Plane)), "struct Trivector { e123 }"),
        (quote!(geometric(Vector, Vector)), "struct Even { scalar, "),
        (quote!(geometric(Vector, Plane)), "struct Odd { e1, "),
        (
            quote!(geometric(Mixed, Mixed)),
            "struct Multivector { scalar, ",
        ),
    ] {
        let found = check(quote! {
            mod some {
                basis e1, e2, e3, e4;
                signature 4;
                struct Whole { e1, e2, e3, e4 }
                struct Vector { e1, e2, e3 }
                struct Plane { e12, e13, e23 }
                struct Bivector { e34 }
                struct Mixed { scalar, e1, e2 }
                products { #products; }
            }
        });
        let messages = found.err().expect("no type has the result");
        assert_eq!(messages.len(), 1, "{messages:?}");
        assert!(messages[0].contains(proposed), "{proposed}: {messages:?}");
    }
}

/// Methods have the names of types in lower case with underscores, so these must differ too.
#[test]
fn types_that_methods_would_name_alike() {
    let found = check(quote! {
        mod some {
            basis e1, e2;
            signature 2;
            struct AB { e1, e2 }
            struct Ab { e12 }
        }
    });
    let expected = ["methods name the types `AB` and `Ab` alike, `ab`: choose another name"];
    assert_eq!(found.err().expect("faulty"), expected);
}

#[test]
fn faulty_declarations_leave_their_names() {
    let code = emitted(&quote! {
        pub(crate) mod some {
            basis e1, e2;
            signature 3;
            struct Vector { e1, e2 }
            struct Area { e12 }
        }
    });
    assert_eq!(code.matches("compile_error!").count(), 1);
    assert!(code.contains("pub(crate) mod some"), "{code}");
    assert!(
        code.contains("pub use self::__errors::{Area, BASIS, METRIC, Vector};"),
        "{code}"
    );
    assert!(code.contains("pub(crate) use __nullcone_some_"), "{code}");
}

#[test]
fn emitted_code_reads_like_written_code() {
    let code = emitted(&quote! {
        mod plane {
            basis e1, e2, e0;
            metric e1*e1 = 1, e2*e2 = 1;
            struct Line { e1, e2, e0 }
            #[hull(Sums)]
            struct Point { e20, e01, e12 = 1 }
            struct Sums { e20, e01, e12 }
            products {
                wedge(Line, Line) -> Sums;
                vee(Point, Point) -> Line;
            }
        }
    });
    for body in [
        "
    fn bitxor(self, other: Line<S>) -> Sums<S> {
        Sums {
            e20: self.e0.neg_mul_add(other.e2, self.e2 * other.e0),
            e01: self.e1.neg_mul_add(other.e0, self.e0 * other.e1),
            e12: self.e2.neg_mul_add(other.e1, self.e1 * other.e2),
        }
    }",
        "
    fn bitand(self, other: Point<S>) -> Line<S> {
        Line {
            e1: self.e01 - other.e01,
            e2: other.e20 - self.e20,
            e0: self.e01.neg_mul_add(other.e20, self.e20 * other.e01),
        }
    }",
    ] {
        let body = body.replace("\n", "\n    ");
        assert!(code.contains(&body), "{body}\nis not in\n{code}");
    }
}

/// Traits of other crates learn the fields in their order, and an operator that no declaration
/// provides has a message of its own.
#[test]
fn what_other_crates_and_messages_need_is_emitted() {
    let code = emitted(&quote! {
        mod plane {
            basis e1, e2;
            signature 2;
            struct Vector { e1, e2 }
            struct Area { e12 }
            products { wedge(Vector, Vector); }
        }
    });
    let words = code.split_whitespace().collect::<Vec<_>>().join(" ");
    let fields = [
        r#"{ linear Vector "Vector" { e1 0 "e1", e2 1 "e2" } [] }"#,
        r#"{ linear Area "Area" { e12 0 "e12" } [] }"#,
    ];
    let fields = fields.join(" ");
    assert!(
        words.contains(&format!("interoperate! {{ {fields} }}")),
        "{code}"
    );
    // The products of two vectors that are missing, with the right operand first in the bound.
    let is_missing = |operator: &str| {
        let start = format!("::core::ops::{operator}<Vector<S>> for Vector<S> where Vector<S>: ");
        words.contains(&format!("{start}::ga_runtime::products::"))
    };
    let missing = ["Mul", "BitXor", "BitOr", "BitAnd"].map(is_missing);
    assert_eq!(missing, [true, false, true, true], "{code}");
}

/// Declarations that would take very long are refused, each with the bound.
#[test]
fn sizes_are_bounded() {
    let names: Vec<_> = "abcdefghi"
        .chars()
        .map(|c| quote::format_ident!("x{c}"))
        .collect();
    let blades = |dimension: usize| {
        let blade = |bits: usize| {
            let letters = names[..dimension].iter().enumerate();
            let letters = letters.filter(|(place, _)| bits >> place & 1 == 1);
            let joined: String = letters
                .map(|(_, name)| name.to_string().split_off(1))
                .collect();
            quote::format_ident!("x{joined}")
        };
        let rest: Vec<_> = (1..1 << dimension).map(blade).collect();
        quote! { scalar, #(#rest),* }
    };
    let refused = |declaration: TokenStream| match check(declaration) {
        Ok(_) => panic!("accepted"),
        Err(messages) => messages.join("; "),
    };
    let (nine, seven) = (blades(9), blades(7));
    let (all, first) = (&names, &names[..7]);
    let large = quote! { mod a { basis #(#all),*; signature 9; struct M { #nine } } };
    assert!(refused(large).contains("that of two types of 256 blades"));
    let pairs = first.iter().flat_map(|a| first.iter().map(move |b| (a, b)));
    let entries = pairs.filter(|(a, b)| a <= b).map(|(a, b)| {
        let value = if a == b { 2 } else { 1 };
        quote! { #a*#b = #value }
    });
    let many = quote! { mod a {
        basis #(#first),*; metric #(#entries),*;
        struct M { #seven }
        products { geometric(M, M); }
    } };
    assert!(refused(many).contains("at most 131072 together"));
    let types: Vec<_> = (0..=128).map(|k| quote::format_ident!("T{k}")).collect();
    let many = quote! { mod a { basis xa; signature 1; #(struct #types { xa })* } };
    assert!(refused(many).contains("at most 128 types"));
    let line = quote! { wedge({#(#types),*}, {#(#types),*}); };
    let many = quote! { mod a { basis xa; signature 1; struct T0 { xa } products { #line } } };
    assert!(refused(many).contains("at most 8192 products"));
}
