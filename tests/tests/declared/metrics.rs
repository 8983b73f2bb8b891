//! Other metrics: none, one, six dimensions; definite, indefinite, degenerate, oblique.

use ga_runtime::testing::{assert_close, for_all, strategy};
use proptest::prelude::*;

ga_runtime::algebra! {
    /// The complex numbers as the even part of the plane's algebra.
    mod complex {
        basis x, y;
        signature 2;

        /// A vector of the plane.
        struct Vector { x, y }
        /// A complex number, `i = x∧y`.
        struct Complex { scalar, xy }
        /// A complex number of modulus 1.
        #[hull(Complex)]
        #[facts(unit_versor)]
        struct Phase { scalar, xy }

        products {
            geometric({Complex, Phase}, {Complex, Phase}) -> Complex;
            geometric(Vector, Vector);
            geometric(Vector, {Complex, Phase}) -> Vector;
            sandwich(Phase, Vector) -> Self;
            dual(Vector);
            undual(Vector);
        }
    }
}

ga_runtime::algebra! {
    /// The complex numbers again: the algebra of one vector of square −1.
    mod imaginary {
        basis i;
        metric i*i = -1;

        /// A complex number.
        struct Complex { scalar, i }
        /// The imaginary unit.
        struct I { i = 1 }

        products {
            geometric({Complex, I}, Complex) -> Complex;
            dual(Complex);
        }
    }
}

ga_runtime::algebra! {
    /// Spacetime with the signature +−−−.
    mod spacetime {
        basis t, x, y, z;
        signature 1, 3;

        /// An event.
        struct Event { t, x, y, z }
        /// The electromagnetic field, `E` in tx, ty, tz and `B` in the others.
        struct Field { tx, ty, tz, yz, zx, xy }
        /// A Lorentz transformation.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Lorentz { scalar, tx, ty, tz, yz, zx, xy, txyz }
        /// Sums of Lorentz transformations.
        struct Even { scalar, tx, ty, tz, yz, zx, xy, txyz }
        /// A three-dimensional volume.
        struct Trivector { xyz, tyz, tzx, txy }

        products {
            geometric(Lorentz, Lorentz) -> Lorentz;
            geometric({Event, Trivector}, {Event, Trivector}) -> Even;
            geometric({Field, Even}, {Field, Even}) -> Even;
            sandwich(Lorentz, {Event, Field, Trivector, Lorentz}) -> Self;
            wedge(Event, Event);
            left_contraction(Event, {Event, Field, Trivector}) -> Everything;
            right_contraction({Field, Trivector}, Event) -> Everything;
            commutator(Field, Field);
            vee(Trivector, Trivector);
            dual({Event, Trivector}) -> Everything;
            undual(Field);
        }
        /// A general multivector, of all sixteen blades.
        struct Everything { scalar, t, x, y, z, tx, ty, tz, xy, xz, yz, txy, txz, tyz, xyz, txyz }
    }
}

ga_runtime::algebra! {
    /// An oblique basis of space whose vectors have fractions for inner products, one of them a
    /// negative square.
    mod oblique {
        basis a, b, c;
        metric a*a = 3/2, b*b = 2, c*c = -1/3, a*b = 1/2, c*b = -1/4, b*c = -1/4;

        /// A vector.
        struct Vector { a, b, c }
        /// A bivector.
        struct Bivector { bc, ca, ab }
        /// A vector in the plane c = 2.
        #[hull(Vector)]
        #[facts(weight(c))]
        struct Affine { a, b, c = 1 }
        /// A vector on a parabola.
        #[hull(Vector)]
        struct Parabola { a, b = (1 - a*a)/3, c = -1/2 }
        /// A rotation.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Rotor { scalar, ab, ac, bc }
        /// Sums of rotations.
        struct Even { scalar, ab, ac, bc }
        /// A general multivector, of all eight blades.
        struct Multivector { scalar, a, b, c, ab, ac, bc, abc }
        /// The vector b.
        struct B { b = 1 }

        products {
            geometric({Vector, Affine, Parabola, B, Bivector}, {Vector, Parabola}) -> Multivector;
            geometric(Rotor, Rotor) -> Rotor;
            geometric(Multivector, Multivector) -> Multivector;
            wedge({Parabola, B}, {Affine, Parabola}) -> Bivector;
            wedge(Multivector, Multivector) -> Multivector;
            vee(Bivector, Bivector);
            vee(Multivector, Multivector) -> Multivector;
            left_contraction({Vector, B}, {Vector, Affine}) -> Scalar;
            left_contraction(Multivector, Multivector) -> Multivector;
            right_contraction(Multivector, Multivector) -> Multivector;
            scalar_product(Multivector, Multivector) -> Scalar;
            commutator(Multivector, Multivector) -> Multivector;
            sandwich(Rotor, {Vector, Bivector, Rotor}) -> Self;
            sandwich(Rotor, {Affine, Parabola}) -> Vector;
            sandwich({Vector, Multivector}, Multivector) -> Multivector;
            dual({Vector, Affine});
            dual(Multivector);
            undual(Multivector);
        }
    }
}

ga_runtime::algebra! {
    /// The projective plane, degenerate and oblique: lines as vectors, points as bivectors.
    mod projective {
        basis e0, e1, e2;
        metric e1*e1 = 1, e2*e2 = 1, e1*e2 = 1/2;

        /// A line.
        struct Line { e0, e1, e2 }
        /// A point.
        struct Point { e12, e01, e20 }
        /// A motion of the plane.
        #[hull(Even)]
        #[facts(unit_versor)]
        struct Motion { scalar, e12, e01, e20 }
        /// Sums of motions.
        struct Even { scalar, e12, e01, e20 }
        /// A general multivector of the plane.
        struct Plane { e012 }

        products {
            wedge(Line, Line);
            wedge(Line, Point);
            vee(Point, Point);
            vee(Line, Point) -> Scalar;
            dual(Line);
            undual(Line);
            dual(Point);
            undual(Point);
            geometric(Motion, Motion) -> Motion;
            geometric(Line, Line) -> Even;
            sandwich(Motion, {Line, Point}) -> Self;
            sandwich(Line, {Line, Point}) -> Self;
        }
    }
}

ga_runtime::algebra! {
    /// Squares beside the vectors, and a null pair: e0² = 0, e1² = 1, ep · em = −1.
    mod beside {
        basis e0 = 0, e1 = 1, en = -1/2, ep = 0, em = 0;
        metric ep*em = -1;

        struct Vector { e0, e1, en, ep, em }

        products {
            left_contraction(Vector, Vector) -> Scalar;
        }
    }
}

ga_runtime::algebra! {
    /// The exterior algebra of four dimensions: every inner product is zero.
    mod exterior {
        basis dx, dy, dz, dw;
        metric;

        /// A form of degree 1.
        struct Form1 { dx, dy, dz, dw }
        /// A form of degree 2.
        struct Form2 { dxy, dxz, dxw, dyz, dyw, dzw }
        /// A form of degree 3.
        struct Form3 { dxyz, dxyw, dxzw, dyzw }
        /// A form of degree 4.
        struct Form4 { dxyzw }

        products {
            wedge(Form1, {Form1, Form2, Form3});
            wedge(Form2, Form2);
            geometric(Form1, Form1) -> Form2;
            vee(Form3, {Form3, Form2, Form1});
            dual({Form1, Form2, Form3, Form4});
            undual({Form1, Form2, Form3});
        }
    }
}

ga_runtime::algebra! {
    /// Six dimensions with the signature of the conformal algebra of spacetime.
    mod six {
        basis e1, e2, e3, e4, e5, e6;
        signature 4, 2;

        /// A vector.
        struct Vector { e1, e2, e3, e4, e5, e6 }
        /// A bivector.
        struct Bivector { e12, e13, e14, e15, e16, e23, e24, e25, e26, e34, e35, e36, e45, e46, e56 }
        /// A trivector.
        struct Trivector {
            e123, e124, e125, e126, e134, e135, e136, e145, e146, e156,
            e234, e235, e236, e245, e246, e256, e345, e346, e356, e456
        }
        /// The span of four vectors.
        struct Quadrivector {
            e1234, e1235, e1236, e1245, e1246, e1256, e1345, e1346, e1356, e1456, e2345, e2346, e2356, e2456, e3456
        }
        /// The span of five vectors.
        struct Hyperplane { e12345, e12346, e12356, e12456, e13456, e23456 }
        /// An element of even grade.
        struct Even {
            scalar,
            e12, e13, e14, e15, e16, e23, e24, e25, e26, e34, e35, e36, e45, e46, e56,
            e1234, e1235, e1236, e1245, e1246, e1256, e1345, e1346, e1356, e1456, e2345, e2346, e2356, e2456, e3456,
            e123456
        }
        /// A vector of square 1.
        #[hull(Vector)]
        #[facts(unit_versor)]
        struct Mirror { e1, e2, e3, e4, e5, e6 }

        products {
            wedge(Vector, {Vector, Bivector, Trivector, Quadrivector});
            wedge(Bivector, Bivector);
            left_contraction(Vector, {Bivector, Trivector, Quadrivector, Hyperplane});
            vee(Hyperplane, {Hyperplane, Quadrivector, Trivector});
            vee(Quadrivector, Quadrivector);
            dual({Vector, Bivector, Trivector, Quadrivector, Hyperplane});
            commutator(Bivector, {Vector, Bivector, Trivector});
            geometric(Mirror, Mirror) -> Even;
            sandwich(Mirror, {Vector, Bivector, Mirror}) -> Self;
        }
    }
}

mod products {
    mod complex {
        ga_runtime::testing::product_tests!(super::super::complex);
    }
    mod imaginary {
        ga_runtime::testing::product_tests!(super::super::imaginary);
    }
    mod spacetime {
        ga_runtime::testing::product_tests!(super::super::spacetime);
    }
    mod oblique {
        ga_runtime::testing::product_tests!(super::super::oblique);
    }
    mod projective {
        ga_runtime::testing::product_tests!(super::super::projective);
    }
    mod exterior {
        ga_runtime::testing::product_tests!(super::super::exterior);
    }
    mod six {
        ga_runtime::testing::product_tests!(super::super::six);
    }
}

/// Squares are those that stand beside the vectors, whatever their order.
#[test]
fn squares_stand_beside_vectors() {
    use beside::Vector;
    let basis = [Vector::E0, Vector::E1, Vector::EN, Vector::EP, Vector::EM];
    let inner = basis.map(|a| basis.map(|b: Vector<f64>| a | b));
    let expected = [
        [0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -0.5, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -1.0],
        [0.0, 0.0, 0.0, -1.0, 0.0],
    ];
    assert_eq!(inner, expected);
}

/// `(a + bi)(c + di) = (ac − bd) + (ad + bc)i`, whether i is a bivector or a vector.
#[test]
fn complex_numbers_multiply() {
    let number = || strategy::prime();
    for_all((number(), number(), number(), number()), |(a, b, c, d)| {
        let expected = (a * c - b * d, a * d + b * c);
        let product = complex::Complex::new(a, b) * complex::Complex::new(c, d);
        assert_eq!((product.scalar, product.xy), expected);
        let product = imaginary::Complex::new(a, b) * imaginary::Complex::new(c, d);
        assert_eq!((product.scalar, product.i), expected);
        let turned = imaginary::I * imaginary::Complex::new(a, b);
        assert_eq!((turned.scalar, turned.i), (-b, a));
    });
}

/// A boost along x with velocity v takes (t, x) to γ(t + vx, x + vt), and velocities add as (u +
/// v)/(1 + uv).
#[test]
fn boosts_follow_lorentz() {
    let boost = |velocity: f64| {
        let half = velocity.atanh() / 2.0;
        let (cosh, sinh) = (half.cosh(), half.sinh());
        // x t = −t x, so exp(−½φ tx) t exp(½φ tx) = t cosh φ + x sinh φ.
        spacetime::Lorentz::try_new(cosh, -sinh, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-12)
    };
    proptest!(|(u in -0.9..0.9_f64, v in -0.9..0.9_f64, t in -5.0..5.0_f64, x in -5.0..5.0_f64)| {
        let (first, second) = (boost(u).expect("unit"), boost(v).expect("unit"));
        let gamma = (1.0 - u * u).sqrt().recip();
        let event = first.transform(spacetime::Event::new(t, x, 1.0, -2.0));
        let expected = [gamma * (t + u * x), gamma * (x + u * t), 1.0, -2.0];
        assert_close!([event.t, event.x, event.y, event.z], expected, 1e-12);
        let both = boost((u + v) / (1.0 + u * v)).expect("unit");
        let product = second * first;
        assert_close!([product.scalar(), product.tx()], [both.scalar(), both.tx()], 1e-12);
    });
}

/// F² = E² − B² + 2 (E·B) I, both parts of which are Lorentz invariants.
#[test]
fn invariants_of_the_electromagnetic_field() {
    let number = || strategy::prime();
    for_all([(); 6].map(|()| number()), |[a, b, c, d, e, f]| {
        let (electric, magnetic) = ([a, b, c], [d, e, f]);
        let field = spacetime::Field::new(a, b, c, d, e, f);
        let square = field * field;
        let dot = |p: [_; 3], q: [_; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        assert_eq!(
            square.scalar,
            dot(electric, electric) - dot(magnetic, magnetic)
        );
        assert_eq!(square.txyz, (dot(electric, magnetic)) * 2.into());
        assert_eq!([square.tx, square.ty, square.tz], [0.into(); 3]);
    });
}
