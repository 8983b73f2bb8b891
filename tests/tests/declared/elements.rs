//! Methods and traits that every declared type has, on every type of ga-runtime: coefficients by
//! name, text, conversions that check, normalization.

#![allow(
    clippy::float_cmp,
    reason = "coefficients are copied, and other values are exact"
)]

use std::fmt::{Debug, Display};
use std::str::FromStr;

use ga_runtime::dense::Algebra;
use ga_runtime::testing::{for_all, member, strategy};
use ga_runtime::{Element, NotMember, ParseElementError};

use super::every_type::every_type;

/// The coefficient of the outer product of basis vectors that a name like `e31` means.
fn by_name<T: Element<Scalar = f64>>(algebra: &Algebra<f64>, element: &T, name: &str) -> f64 {
    let dense = algebra.element(element);
    let place = |digit: char| {
        let mut names = T::BASIS.iter();
        names.position(|vector| vector.ends_with(digit))
    };
    let vectors = name[1..].chars().filter_map(place);
    let blade = match name {
        "scalar" => algebra.one(),
        _ => vectors.fold(algebra.one(), |blade, vector| {
            blade.wedge(&algebra.blade(1 << vector).expect("a basis vector"))
        }),
    };
    let terms = blade.terms().collect::<Vec<_>>();
    let [(mask, sign)] = terms[..] else {
        panic!("{name} is not a blade")
    };
    dense.coefficient(mask) * sign
}

/// Checks names, text and conversions of random members.
fn check<T, M>(name: &str)
where
    T: Element<Scalar = f64> + PartialEq + Debug + Display + FromStr<Err = ParseElementError>,
    M: Element<Scalar = f64> + From<T>,
{
    let algebra = Algebra::of::<T>().expect("a declared algebra");
    assert_eq!(T::NAME, name);
    for_all(member::<T>(strategy::float(0.75)), |element| {
        for (name, value) in element.coefficients() {
            assert_eq!(
                value,
                by_name(&algebra, &element, name),
                "{name} of {element:?}"
            );
            assert_eq!(element.coefficient_of(name), Some(value));
        }
        assert!(element.is_finite());

        let text = element.to_string();
        let read: T = text.parse().expect("what was written is read");
        assert_same(&read, &element);

        let all = M::from(element);
        assert_same(
            &T::try_from_element(all, 1e-12).expect("a member"),
            &element,
        );
        // A blade that the type does not have.
        let foreign = (0..algebra.size()).find(|blade| !T::BLADES.contains(blade));
        if let Some(foreign) = foreign {
            let with = |value: f64| {
                M::from_coefficients_unchecked(&mut |blade| {
                    if blade == foreign {
                        value
                    } else {
                        all.coefficient(blade)
                    }
                })
            };
            let largest = element
                .coefficients()
                .map(|(_, x)| x.abs())
                .fold(0.0, f64::max);
            let small = T::try_from_element(with(largest * 1e-7), 1e-6);
            assert_same(&small.expect("a member"), &element);
            let large = T::try_from_element(with(largest * 1e-5 + 1e-300), 1e-6);
            assert!(
                matches!(large, Err(NotMember::Coefficient { .. })),
                "{large:?}"
            );
            let infinite = T::try_from_element(with(f64::INFINITY), 1e-6);
            assert!(
                matches!(infinite, Err(NotMember::NotFinite { .. })),
                "{infinite:?}"
            );
        }
    });
}

/// Types that are stored as coefficients are read as they were written, parameters are rounded.
fn assert_same<T: Element<Scalar = f64> + PartialEq + Debug>(read: &T, element: &T) {
    const BY_PARAMETERS: [&str; 6] = [
        "DualSphere",
        "Sphere",
        "PointPair",
        "DualPointPair",
        "Circle",
        "DualCircle",
    ];
    let is_of_cga3 = T::BASIS.len() == 5;
    if !is_of_cga3 || !BY_PARAMETERS.contains(&T::NAME) {
        assert_eq!(read, element);
        return;
    }
    let size = element.coefficients().map(|(_, x)| x.abs());
    let size = size.fold(0.0, f64::max);
    for ((_, a), (_, b)) in read.coefficients().zip(element.coefficients()) {
        assert!((a - b).abs() <= 1e-12 * size, "{read:?} for {element:?}");
    }
}

#[test]
fn names_texts_and_conversions_of_every_type() {
    macro_rules! check_all {
        ($($algebra:ident { $($type:ident),* }),*) => { $( $(
            check::<ga_runtime::$algebra::$type<f64>, ga_runtime::$algebra::Multivector<f64>>(
                stringify!($type),
            );
        )* )* };
    }
    every_type!(check_all);
}

/// Checks that normalized elements have norm 1 or −1 and are positive multiples, also where squares
/// leave the range of the numbers.
macro_rules! check_normalized {
    ($($algebra:ident { $($type:ident),* })*) => { $( $( {
        use ga_runtime::$algebra::$type;
        for_all(member::<$type<f64>>(strategy::float(0.75)), |element| {
            let size = element.norm_squared().abs().sqrt();
            for scale in [1.0, 1e-200, 1e200] {
                let scaled = element * scale;
                let Some(unit) = scaled.normalized() else {
                    // Null up to rounding.
                    assert!(size < 1e-7, "{element:?}");
                    continue;
                };
                if size > 1e-3 {
                    let norm = unit.norm_squared();
                    assert!((norm.abs() - 1.0).abs() < 1e-9, "{element:?} to {norm}");
                    assert_eq!(norm < 0.0, element.norm_squared() < 0.0);
                    let back = unit * size - element;
                    assert!(back.coefficients().all(|(_, x)| x.abs() < 1e-9 * size.max(1.0)));
                }
            }
        });
        assert_eq!(($type::<f64>::default() * 0.0).normalized(), None);
        assert_eq!(($type::<f64>::default() * f64::NAN).normalized(), None);
    } )* )* };
}

#[test]
fn elements_are_normalized() {
    check_normalized! {
        cga3 {
            RoundVector, DualSphere, DualPlane, PointPair, DualCircle, FlatPoint, MotorGenerator, Circle,
            DualPointPair, DualFlatPoint, Line, Sphere, Plane, Pseudoscalar, Quaternion, DualQuaternion
        }
        cga2 { RoundVector, DualLine, PointPair, FlatPoint, MotorGenerator, Circle, Line }
        pga3 { Plane, Line, Point }
        pga2 { Line, Point }
        vga3 { Vector, Bivector, Trivector, Quaternion, Multivector }
        vga2 { Vector, Bivector, Complex }
        sta { Vector, Bivector, Trivector, Even }
    }
}

/// Rounding errors are removed from versors.
#[test]
fn versors_are_normalized() {
    macro_rules! check {
        ($($algebra:ident { $($type:ident),* })*) => { $( $( {
            use ga_runtime::$algebra::$type;
            for_all(member::<$type<f64>>(strategy::float(0.5)), |versor| {
                let unit = versor.normalized().expect("a finite versor");
                let difference = unit - versor;
                let largest = versor.coefficients().map(|(_, x)| x.abs()).fold(1.0, f64::max);
                assert!(
                    difference.coefficients().all(|(_, x)| x.abs() < 1e-11 * largest * largest),
                    "{versor:?} to {unit:?}"
                );
            });
        } )* )* };
    }
    check! {
        cga3 { Rotor, Translator, Motor, Dilator, Similarity, Transversor, EvenVersor, OddVersor }
        cga2 { Rotor, Translator, Motor, Dilator, Similarity }
        pga3 { Rotor, Translator, Motor }
        pga2 { Rotor, Translator, Motor }
        vga3 { Rotor }
        vga2 { Rotor }
        sta { Rotor }
    }
    let drifted = ga_runtime::cga3::Rotor::new_unchecked(0.8_f64, 0.6, 0.0, 1e-3);
    assert!((drifted.norm_squared() - 1.0).abs() > 1e-7);
    let unit = drifted.normalized().expect("a rotor");
    assert!((unit.norm_squared() - 1.0).abs() < 1e-15);
}

/// Elements near no versor become versors too, in every grade of `M ~M`.
#[test]
fn sums_are_normalized() {
    macro_rules! check {
        ($($algebra:ident $hull:ident $type:ident),*) => { $( {
            use ga_runtime::$algebra::{$hull, $type};
            let algebra = Algebra::of::<$type<f64>>().expect("a declared algebra");
            for_all(member::<$hull<f64>>(strategy::float(3.0)), |sum| {
                for scale in [1.0, 1e-200, 1e200] {
                    let Some(unit) = $type::normalize(sum * scale) else {
                        continue;
                    };
                    let dense = algebra.element(&unit);
                    let defect = dense.geometric(&dense.reverse()) - algebra.one();
                    let size: f64 = dense.coefficients().iter().map(|x| x * x).sum();
                    assert!(
                        defect.coefficients().iter().all(|x| x.abs() < 1e-12 * size.max(1.0)),
                        "{sum:?} to {unit:?}"
                    );
                }
            });
            for_all(member::<$type<f64>>(strategy::float(0.5)), |versor| {
                let unit = $type::normalize(versor * 3.0).expect("a multiple of a versor");
                let largest = versor.coefficients().map(|(_, x)| x.abs()).fold(1.0, f64::max);
                let difference = unit - versor;
                assert!(difference.coefficients().all(|(_, x)| x.abs() < 1e-11 * largest * largest));
            });
        } )* };
    }
    check!(sta Even Rotor, cga2 Even Similarity, cga3 DualQuaternion Motor, vga3 Quaternion Rotor);
    // For most elements there is a versor.
    let counted = std::cell::Cell::new(0);
    for_all(
        member::<ga_runtime::sta::Even<f64>>(strategy::float(3.0)),
        |sum| {
            counted
                .set(counted.get() + u32::from(ga_runtime::sta::Rotor::normalize(sum).is_some()));
        },
    );
    assert!(counted.get() > 200, "{} of 256", counted.get());
}

mod conversions {
    use ga_runtime::cga3::{
        Infinity, Line, Motor, Multivector, Point, Rotor, RoundVector, Sphere, Translator,
    };
    use ga_runtime::{NotMember, pga3};

    #[test]
    fn the_standard_traits_say_what_is_wrong() {
        let p = Point::new(1.0_f64, 2.0, 3.0);
        assert_eq!(Point::try_from(RoundVector::from(p)), Ok(p));
        assert_eq!(Point::try_from(Multivector::from(p)), Ok(p));
        let error = Point::try_from(RoundVector::from(p) * 2.0).expect_err("a weight of 2");
        assert_eq!(
            error,
            NotMember::Coefficient {
                type_name: "Point",
                blade: "eo".to_owned(),
                found: "2.0".to_owned(),
                expected: "1.0".to_owned(),
            }
        );
        let line: Line<f64> = p ^ Point::ORIGIN ^ Infinity;
        let error = Sphere::try_from(Multivector::from(line)).expect_err("a line");
        assert_eq!(
            error.to_string(),
            "not a Sphere: the coefficient of e1oi is 1.0 instead of 0.0"
        );
    }

    #[test]
    fn versors_of_a_narrower_kind() {
        let rotor = Rotor::from_axis_angle([1.0, 2.0, 2.0], 0.7_f64).expect("an axis");
        let shift = Translator::from_displacement([1e-3, 0.0, 0.0]);
        assert_eq!(Rotor::try_from(Motor::from(rotor)), Ok(rotor));
        assert_eq!(Translator::try_from(Motor::from(shift)), Ok(shift));
        assert!(Rotor::try_from(Motor::from(shift)).is_err());
        assert!(Rotor::try_from_element(Motor::from(shift), 1e-2).is_ok());
        assert!(Translator::try_from(Motor::from(rotor)).is_err());
        // The facts are checked relative to the terms that cancel in them.
        let far = Translator::from_displacement([1e9, 2e9, 3e9]) * rotor;
        let sum = ga_runtime::cga3::DualQuaternion::from(far);
        assert_eq!(Motor::try_from(sum), Ok(far));
        assert_eq!(
            Motor::try_from(sum * 2.0),
            Err(NotMember::NotUnitVersor { type_name: "Motor" })
        );
        let ideal = pga3::Multivector::from(pga3::Direction::new(1.0, 0.0, 0.0));
        assert!(pga3::Plane::try_from(ideal).is_err());
    }
}

mod text {
    use ga_runtime::cga3::{Line, Motor, Point, Rotor};
    use ga_runtime::pga3;

    fn message<T: std::str::FromStr<Err: ToString> + std::fmt::Debug>(text: &str) -> String {
        text.parse::<T>().expect_err("a faulty text").to_string()
    }

    #[test]
    fn terms_may_be_spaced_and_ordered_freely() {
        assert_eq!("  ei  +  eo+0 ".parse::<Point<f64>>().ok(), None);
        assert_eq!("0.5 ei + e1 + eo".parse(), Ok(Point::new(1.0, 0.0, 0.0)));
        assert_eq!(
            "-2 e12i\n\t- -3 e1oi".parse(),
            Ok(Line::new(-2.0, 0.0, 0.0, 3.0, 0.0, 0.0))
        );
        assert_eq!("0".parse(), Ok(Line::<f64>::ZERO));
        assert_eq!("1".parse(), Ok(Rotor::<f32>::IDENTITY));
        assert_eq!("1 scalar".parse(), Ok(Motor::<f32>::IDENTITY));
        assert_eq!(
            "2 e30".parse(),
            Ok(pga3::Line::new(0.0, 0.0, 0.0, 0.0, 0.0, 2.0))
        );
    }

    #[test]
    fn errors_name_the_term_and_its_place() {
        assert_eq!(
            message::<Rotor<f64>>("x"),
            "`x` at column 1 is not a term of a Rotor, whose blades are scalar, e12, e13, e23"
        );
        assert_eq!(
            message::<Rotor<f64>>("1 + 2 e14"),
            "`e14` at column 7 is not a term of a Rotor, whose blades are scalar, e12, e13, e23"
        );
        assert_eq!(
            message::<Rotor<f64>>("1 2"),
            "there is no ` + ` or ` - ` before `2` at column 3"
        );
        assert_eq!(
            message::<Rotor<f64>>("1 -"),
            "there is no term behind the sign at column 3"
        );
        assert_eq!(
            message::<Rotor<f64>>("e12 + 1 + 3 e12"),
            "the blade `e12` at column 13 occurs before"
        );
        assert_eq!(
            message::<Rotor<f64>>(" "),
            "an empty text is not an element; zero is `0`"
        );
        assert_eq!(
            message::<Rotor<f64>>("1 + e12"),
            "not a Rotor: M ~M is not 1 up to the tolerance"
        );
        assert_eq!(
            message::<Point<f64>>("e1 + eo"),
            "not a Point: the coefficient of ei is 0.0 instead of 0.5"
        );
        assert_eq!(
            message::<Line<f64>>("inf e1oi"),
            "not a Line: the coefficient of e1oi is not finite"
        );
        assert_eq!(
            message::<Line<f64>>("1"),
            "`1` at column 1 is not a term of a Line, whose blades are e12i, e13i, e23i, e1oi, \
             e2oi, e3oi"
        );
    }
}

mod scalars {
    use ga_runtime::cga3::{Dilator, Even, Motor, Multivector, Quaternion, Rotor};
    use ga_runtime::vga3::Vector;

    #[test]
    fn numbers_are_added_to_elements_with_a_scalar() {
        let q = Quaternion::new(1.0, 2.0, 3.0, 4.0);
        assert_eq!(q + 2.0, Quaternion::new(3.0, 2.0, 3.0, 4.0));
        assert_eq!(2.0 + q, q + 2.0);
        assert_eq!(q - 2.0, Quaternion::new(-1.0, 2.0, 3.0, 4.0));
        assert_eq!(2.0 - q, -(q - 2.0));
        let all = Multivector::from(q);
        assert_eq!(1.5 - all, Multivector::from(1.5 - q));
        let mut sum = all;
        sum += 1.0;
        sum -= all;
        assert_eq!(sum, Multivector::ONE);
        // The rotor halfway to another, R = (1 + b a)/|1 + b a|.
        let (a, b) = (Vector::X, Vector::Y);
        let half = (1.0_f64 + b * a).normalize().expect("not opposite");
        let moved = half.transform(a);
        assert!((moved - b).length() < 1e-15);
        assert_eq!(Rotor::<i64>::IDENTITY + 2, Quaternion::new(3, 0, 0, 0));
        assert_eq!(
            Even::from(Dilator::<f64>::IDENTITY) + 1.0,
            Dilator::IDENTITY + 1.0
        );
        let mut motor = Motor::<f64>::IDENTITY;
        motor *= Rotor::IDENTITY;
        motor *= &Motor::IDENTITY;
        assert_eq!(motor, Motor::default());
    }
}

mod norms {
    use ga_runtime::cga3::{Circle, DualSphere, Point, PointPair, RoundVector, Sphere};

    /// The signs that the pages of the types state.
    #[test]
    fn real_and_imaginary_rounds_differ_in_sign() {
        let at = |x: f64, y: f64, z: f64| Point::new(x, y, z);
        let pair = PointPair::through(at(1.0, 0.0, 0.0), at(3.0, 0.0, 0.0));
        let circle = Circle::through(at(1.0, 0.0, 0.0), at(3.0, 0.0, 0.0), at(0.0, 2.0, 1.0));
        let sphere = Sphere::from_centre_radius(at(1.0, 2.0, 3.0), 2.0);
        assert!(pair.norm_squared() < 0.0);
        assert!(circle.norm_squared() < 0.0);
        assert!(sphere.norm_squared() < 0.0);
        let dual: DualSphere<f64> = sphere.dual();
        assert!(dual.norm_squared() > 0.0);
        let imaginary = Sphere::from_centre_radius_squared(at(1.0, 2.0, 3.0), -4.0);
        assert!(imaginary.norm_squared() > 0.0);
        assert_eq!(RoundVector::from(at(1.0, 2.0, 3.0)).norm_squared(), 0.0);
    }
}
