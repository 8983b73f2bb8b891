//! Algebras in which several tests compile, and functions in them.

use ga_compiler::check_types;
use ga_compiler::define::Definition;
use ga_compiler::function::CompiledFunction;
use proc_macro2::TokenStream;
use quote::quote;

/// The declaration of cga3 in ga-runtime.
pub(crate) fn cga3_tokens() -> TokenStream {
    let source = include_str!("../../../../ga-runtime/src/algebras/cga3.rs");
    let start = source.find("algebra! {").expect("the macro") + "algebra! {".len();
    let end = source.rfind('}').expect("the macro");
    source[start..end].parse().expect("tokens")
}

/// The types of pga3.
pub(crate) fn pga3() -> Definition {
    let source = include_str!("../../../../ga-runtime/src/algebras/pga3.rs");
    let start = source.find("algebra! {").expect("the macro") + "algebra! {".len();
    let end = source.rfind('}').expect("the macro");
    check(source[start..end].parse().expect("tokens"))
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

/// Types of cga3 under other names and in another order of the basis.
pub(crate) fn renamed() -> Definition {
    check(quote! {
        pub mod conformal {
            basis infinity, x, y, z, origin;
            metric x*x = 1, y*y = 1, z*z = 1, infinity*origin = -1;
            #[hull(Weighted)] #[facts(null)]
            struct Place { x, y, z, origin = 1, infinity = (x*x + y*y + z*z)/2 }
            struct Weighted { infinity, z, origin, x, y }
            struct Flat { infinityxyz, infinityyxorigin, infinityxzorigin, infinityyzorigin }
            struct Ball { xyzorigin, infinityxyz, infinityxyorigin, infinityxzorigin, infinityyzorigin }
            struct Axis { infinityxy, infinityxz, infinityyz, infinityxorigin, infinityyorigin, infinityzorigin }
            struct Ring {
                xyz, xyorigin, xzorigin, yzorigin, infinityxy, infinityxz, infinityyz,
                infinityxorigin, infinityyorigin, infinityzorigin
            }
            struct Pair {
                xy, xz, yz, xorigin, yorigin, zorigin, infinityx, infinityy, infinityz, infinityorigin
            }
            struct Sum { zx, scalar, xy, yz, infinityxyz, infinityx, infinityy, infinityz }
            #[hull(Sum)] #[facts(unit_versor)]
            struct Motion { scalar, yx, xz, yz, infinityx, infinityy, infinityz, infinityxyz }
            #[hull(Sum)] #[facts(unit_versor)]
            struct Rotation { xz, yz, scalar, yx }
            #[hull(Sum)] #[facts(unit_versor)]
            struct Translation { infinityz, scalar = 1, infinityx, infinityy }
            struct FlatPlace { infinityz, infinityx, infinityy, infinityorigin }
            struct Normal { z, x, y, infinity }
            struct AnyEven {
                scalar, xy, xz, yz, xorigin, yorigin, zorigin, infinityx, infinityy, infinityz,
                infinityorigin, xyzorigin, infinityxyz, infinityxyorigin, infinityxzorigin,
                infinityyzorigin
            }
            #[hull(AnyEven)] #[facts(unit_versor)]
            struct Conformal {
                xy, xz, yz, scalar, xorigin, yorigin, zorigin, infinityx, infinityy, infinityz,
                infinityorigin, xyzorigin, infinityxyz, infinityxyorigin, infinityxzorigin,
                infinityyzorigin
            }
            struct AnyOdd {
                x, y, z, origin, infinity, xyz, xyorigin, xzorigin, yzorigin, infinityxy,
                infinityxz, infinityyz, infinityxorigin, infinityyorigin, infinityzorigin,
                infinityxyzorigin
            }
            #[hull(AnyOdd)] #[facts(unit_versor)]
            struct Reversing {
                xyz, xyorigin, xzorigin, yzorigin, infinityxy, x, y, z, origin, infinity,
                infinityxz, infinityyz, infinityxorigin, infinityyorigin, infinityzorigin,
                infinityxyzorigin
            }
            #[hull(AnyEven)] #[facts(unit_versor)]
            struct Similar {
                scalar, yx, xz, yz, infinityx, infinityy, infinityz, infinityxyz, infinityorigin,
                infinityxyorigin, infinityxzorigin, infinityyzorigin
            }
            #[hull(AnyEven)] #[facts(unit_versor)]
            struct Scaling { infinityorigin, scalar }
            struct Volume { infinityxyzorigin }
        }
    })
}

/// One function from its text.
#[track_caller]
pub(crate) fn compile(definition: &Definition, text: &str) -> CompiledFunction {
    match ga_compiler::compile(definition, text.parse().expect("tokens")) {
        Ok(mut functions) => functions.remove(0),
        Err(error) => panic!("{text}: {error}"),
    }
}

fn check(declaration: TokenStream) -> Definition {
    match check_types(declaration, quote! { ga_runtime }) {
        Ok(definition) => definition,
        Err(error) => panic!("{error}"),
    }
}
