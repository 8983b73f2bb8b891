//! Declarations and their tests do not depend on the names at the call site, on the names of types
//! and blades, or on the prelude.

#![allow(
    dead_code,
    non_camel_case_types,
    non_upper_case_globals,
    unused_imports,
    unused_macros,
    clippy::wrong_self_convention
)]

/// A call site where every name that emitted code might use means something else.
mod shadowed_call_site {
    struct Box;
    struct Err;
    struct None;
    struct Ok;
    struct Option;
    struct Result;
    struct Some;
    struct String;
    struct Vec;

    trait AsRef {}
    trait Clone {}
    trait Copy {}
    trait Debug {}
    trait Default {}
    trait Display {}
    trait Drop {}
    trait Eq {}
    trait Fn {}
    trait FnMut {}
    trait FnOnce {}
    trait From {}
    trait Into {}
    trait IntoIterator {}
    trait Iterator {}
    trait Ord {}
    trait PartialEq {}
    trait PartialOrd {}
    trait Send {}
    trait Sized {}
    trait Sync {}
    trait ToOwned {}
    trait ToString {}
    trait TryFrom {}
    trait TryInto {}

    struct bool;
    struct f32;
    struct f64;
    struct i64;
    struct str;
    struct usize;

    mod alloc {}
    mod core {}
    mod ga_compiler {}
    mod ga_macros {}
    mod ga_runtime {}
    mod proptest {}
    mod std {}

    const BASIS: () = ();
    const METRIC: () = ();
    const drop: () = ();
    const size_of: () = ();

    macro_rules! shadow_all {
        ($d:tt $($name:ident)*) => { $(
            macro_rules! $name {
                ($d($d tokens:tt)*) => { ::core::compile_error!("the macro of the call site was used") };
            }
        )* };
    }
    shadow_all! {
        $ algebra assert assert_eq assert_ne cfg compile_error concat debug_assert derive env format format_args include
        inline line macro_rules_like matches module_path must_use panic print println product_tests stringify test todo
        unimplemented unreachable vec write writeln
    }

    /// Methods on every type with the names of those that the emitted tests call.
    trait Everywhere: ::core::marker::Sized {
        fn commutator(self) {}
        fn conjugate(self) {}
        fn dual(self) {}
        fn geometric(self) {}
        fn grade(self) {}
        fn involute(self) {}
        fn is_finite(self) {}
        fn len(self) {}
        fn norm_squared(self) {}
        fn reverse(self) {}
        fn sandwich(self) {}
        fn scalar(self) {}
        fn scale(self) {}
        fn undual(self) {}
        fn wedge(self) {}
    }
    impl<T> Everywhere for T {}

    ::ga_runtime::algebra! {
        mod vga3 {
            basis e1, e2, e3;
            metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1/2;

            struct E3 { e3 = 1 }
            struct Vector { e1, e2, e3 }
            struct Bivector { e12, e13, e23 }
            #[hull(Even)]
            #[facts(unit_versor)]
            struct Rotor { scalar, e12, e13, e23 }
            #[hull(Vector)]
            struct Affine { e1, e2 = (e1*e1 - 1)/2, e3 = 1/3 }
            struct Even { scalar, e12, e13, e23 }
            struct Multivector { scalar, e1, e2, e3, e12, e13, e23, e123 }

            products {
                geometric(Vector, Vector);
                geometric(Rotor, Rotor) -> Rotor;
                wedge({Vector, Affine, E3}, {Vector, Affine}) -> Bivector;
                left_contraction(Vector, {Vector, Bivector}) -> Multivector;
                right_contraction(Bivector, Vector);
                scalar_product(Vector, Vector) -> Scalar;
                commutator(Bivector, Bivector);
                vee(Bivector, Bivector);
                dual(Vector);
                undual(Bivector);
                sandwich({Rotor, Vector}, Vector) -> Self;
                sandwich(Rotor, Affine) -> Vector;
            }
        }
    }

    ::ga_runtime::testing::product_tests!(self::vga3);

    ::ga_runtime::ga! { self::vga3;
        fn functions(m: Rotor, v: Vector, uniform_: Scalar) -> (Vector, [Scalar; 2]) {
            let moved = m * v * reverse(m);
            (moved + v / 3, [sqrt(v | moved) + exp(uniform_), abs(uniform_) * atan2(uniform_, 2)])
        }
        fn staged(uniform m: Rotor, v: Vector) -> Vector { m * v * reverse(m) }
        fn turned(b: Bivector, v: Vector) -> Vector { grade(sandwich(reverse(b), v), 1) / norm_squared(b) }
    }

    #[::core::prelude::v1::test]
    fn functions_mean_what_they_say() {
        let rotor = vga3::Rotor::new_unchecked(1.0, 0.0, 0.0, 0.0);
        let v = vga3::Vector::new(3.0, 6.0, 9.0);
        let (moved, [root, product]) = functions(rotor, v, 0.0);
        ::core::assert_eq!(moved, vga3::Vector::new(4.0, 8.0, 12.0));
        // 9 + 36 + 81/2.
        ::core::assert_eq!((root, product), (85.5_f64.sqrt() + 1.0, 0.0));
        ::core::assert_eq!(staged(rotor).apply(v), v);
        ::core::assert_eq!(staged(rotor).map(|x| x + 0.0).apply(v), v);
        let turned = turned(vga3::Bivector::new(2.0, 0.0, 0.0), v);
        ::core::assert_eq!(turned, vga3::Vector::new(-3.0, -6.0, 9.0));
        let closure = ::ga_runtime::ga! { vga3; |v: Vector| -> Scalar { v | v } };
        ::core::assert_eq!(closure(v), 85.5);
    }
}

/// Types with the names of items that emitted code uses.
mod types_named_like_the_prelude {
    ga_runtime::algebra! {
        mod names {
            basis e1, e2, e3;
            signature 2, 1;

            struct Option { e1, e2, e3 }
            struct Result { e12, e13, e23 }
            struct Some { e1 = 1 }
            struct None { e2 = 1 }
            struct Ok { e3 = -1/2 }
            struct Err { e1, e2 }
            struct Vec { e12, e13 }
            struct String { e123 }
            struct Box { scalar, e123 }
            #[hull(From)]
            #[facts(unit_versor)]
            struct Default { scalar, e12, e13, e23 }
            struct From { scalar, e12, e13, e23 }
            #[hull(Into)]
            struct Clone { e1, e2, e3 = 1 }
            struct Into { e1, e2, e3 }
            #[hull(Err)]
            #[facts(unit_versor)]
            struct Copy { e1, e2 }
            struct Debug { e13 }
            struct Display { e23 }
            struct PartialEq { e12 }
            struct Formatter { e3 }
            struct Element { scalar }
            struct Ring { scalar, e1 }
            struct Field { scalar, e2 }
            struct Real { scalar, e3 }
            struct Sandwich { scalar, e12 }
            struct Commutator { scalar, e13 }
            struct Add { e1, e12 }
            struct Mul { e1, e13 }
            struct Neg { e1, e23 }
            struct Fn { e2, e12 }
            struct Iterator { e2, e13 }
            struct Output { e2, e23 }
            struct B { e3, e12 }
            struct T { e3, e13 }
            struct Prime61 { e3, e23 }
            struct Ratio { e1, e123 }
            struct bool { e2, e123 }
            struct f32 { e3, e123 }
            struct f64 { e12, e123 }
            struct i64 { e13, e123 }
            struct str { e23, e123 }
            struct usize { e1, e2, e12 }
            struct core { e1, e3, e13 }
            struct std { e2, e3, e23 }
            struct alloc { e1, e2, e13 }
            struct names { e1, e2, e3, e123 }
            struct ga_runtime { e1, e2, e3, e12 }

            products {
                geometric(Option, Option) -> From;
                geometric(Default, Default) -> Default;
                wedge({Some, None, Ok, Clone, Into}, {Option, Clone}) -> Result;
                wedge(Option, Result) -> String;
                left_contraction(Option, Option) -> Scalar;
                vee(Result, Result) -> Option;
                commutator(Result, Result) -> Result;
                scalar_product(f64, f64) -> Scalar;
                right_contraction(String, Option) -> Result;
                dual(bool) -> Commutator;
                sandwich(Default, {Option, Result, Default}) -> Self;
                geometric(B, bool) -> names_of_all;
                sandwich(Copy, {Option, Result}) -> Self;
            }
            struct names_of_all { scalar, e1, e2, e3, e12, e13, e23, e123 }
        }
    }

    ga_runtime::testing::product_tests!(self::names);
}

/// Blades with the names of variables in emitted code.
mod blades_named_like_variables {
    ga_runtime::algebra! {
        mod numbered {
            basis t0, t1, t2, t3, t4;
            metric t0*t0 = -1, t1*t1 = 1, t2*t2 = 2, t3*t3 = 1, t4*t4 = 1;

            struct Vector { t0, t1, t2, t3, t4 }
            #[hull(Even)]
            #[facts(unit_versor)]
            struct Versor {
                scalar, t01, t02, t03, t04, t12, t13, t14, t23, t24, t34, t0123, t0124, t0134, t0234, t1234
            }
            struct Even {
                scalar, t01, t02, t03, t04, t12, t13, t14, t23, t24, t34, t0123, t0124, t0134, t0234, t1234
            }

            products {
                geometric({Vector, Even}, {Vector, Even}) -> Multivector;
                sandwich(Versor, Vector) -> Self;
            }
            struct Multivector {
                scalar, t0, t1, t2, t3, t4,
                t01, t02, t03, t04, t12, t13, t14, t23, t24, t34,
                t012, t013, t014, t023, t024, t034, t123, t124, t134, t234,
                t0123, t0124, t0134, t0234, t1234, t01234
            }
        }
    }

    mod numbered_tests {
        ga_runtime::testing::product_tests!(super::numbered);
    }

    ga_runtime::algebra! {
        mod words {
            basis versor, defects, value, norm, half;
            signature 5;

            #[hull(Vector)]
            #[facts(unit_versor)]
            struct Unit { versor, defects, value, norm, half }
            struct Vector { versor, defects, value, norm, half }
            struct Area { defectsversor, valuehalf, halfnorm }

            products {
                sandwich(Unit, {Vector, Unit}) -> Self;
                left_contraction(Vector, {Vector, Unit}) -> Scalar;
                left_contraction(Vector, Area) -> Vector;
            }
        }
    }

    mod words_tests {
        ga_runtime::testing::product_tests!(super::words);
    }

    ga_runtime::algebra! {
        mod more_words {
            basis scale, within, defect, coefficient, blade;
            signature 5;

            #[hull(Vector)]
            #[facts(unit_versor)]
            struct Unit { scale, within, defect, coefficient, blade }
            struct Vector { scale, within, defect, coefficient, blade }

            products { left_contraction(Vector, {Vector, Unit}) -> Scalar; }
        }
    }

    mod more_words_tests {
        ga_runtime::testing::product_tests!(super::more_words);
    }

    /// The check of a unit versor reads its operand, not a variable of the same name.
    #[test]
    fn unit_versors_are_checked() {
        let (cosh, sinh) = (0.5_f64.cosh(), 0.5_f64.sinh());
        let boost = |scalar, t01| {
            numbered::Versor::try_new(
                scalar, t01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
                1e-12,
            )
        };
        let versor = boost(cosh, sinh).expect("(t0 t1)² = 1, cosh² − sinh² = 1");
        assert_eq!(
            (versor.scalar(), versor.t01(), versor.t12()),
            (cosh, sinh, 0.0)
        );
        assert!(boost(cosh, sinh + 1e-6).is_none());

        let unit = words::Unit::try_new(0.0, 0.6, 0.0, 0.0, 0.8, 1e-12).expect("0.36 + 0.64 = 1");
        assert_eq!((unit.defects(), unit.half(), unit.norm()), (0.6, 0.8, 0.0));
        assert!(words::Unit::try_new(1.0, 0.0, 0.0, 0.0, 1e-3, 1e-9).is_none());
        let nearest = words::Unit::normalize(words::Vector::new(2.0, 2.0, 0.0, -2.0, 2.0));
        assert_eq!(
            nearest.map(|unit| (unit.defects(), unit.norm())),
            Some((0.5, -0.5))
        );
    }
}

/// Keywords as names, written as raw identifiers.
mod raw_names {
    ga_runtime::algebra! {
        mod r#match {
            basis r#in, r#as;
            signature 2;

            struct r#type { r#in, r#as }
            struct r#struct { inas }

            products { wedge(r#type, r#type); geometric(r#struct, r#type) -> r#type; }
        }
    }

    ga_runtime::testing::product_tests!(self::r#match);
}

/// A module without a prelude.
#[no_implicit_prelude]
mod without_prelude {
    ::ga_runtime::algebra! {
        pub(super) mod plane {
            basis e1, e2;
            signature 1, 1;

            struct E1 { e1 = 1 }
            struct Vector { e1, e2 }
            #[hull(Sums)]
            #[facts(unit_versor)]
            struct Boost { scalar, e12 }
            struct Sums { scalar, e12 }

            products {
                geometric(Vector, Vector);
                geometric(E1, Vector) -> Sums;
                geometric(Boost, Boost) -> Boost;
                sandwich(Boost, {Vector, Boost}) -> Self;
                right_contraction(Vector, Vector) -> Scalar;
                dual(Vector);
            }
        }
    }

    ::ga_runtime::testing::product_tests!(self::plane);

    ::ga_runtime::ga! { self::plane;
        fn boosted(b: Boost, v: Vector) -> (Vector, Scalar) { (sandwich(b, v), sqrt(abs(v | v)) / 2) }
        fn staged(uniform b: Boost, v: [Vector; 2]) -> [Vector; 2] { [sandwich(b, v[0]), b * v[1] * rev(b)] }
        fn generated(x: Scalar) -> Boost { exp(log(exp(x * e12))) }
    }
}
