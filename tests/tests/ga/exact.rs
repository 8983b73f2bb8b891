//! Every operation that needs no real function, equal to the dense reference over the prime field.

use ga_runtime::scalar::Field;
use ga_runtime::testing::{Prime61, algebra_of, dense, to_dense};
use ga_runtime::{Element, ga};

type Dense = dense::Multivector<Prime61>;

/// The dense form of an element.
fn d<T: Element<Scalar = Prime61>>(element: &T) -> Dense {
    to_dense(&algebra_of(T::METRIC), element)
}

/// A basis blade by the bits of its vectors.
fn blade<T: Element<Scalar = Prime61>>(bits: usize) -> Dense {
    let algebra = algebra_of::<Prime61>(T::METRIC);
    algebra.blade(bits).expect("a blade of the algebra")
}

/// `m x ~m`, for odd m with x̂.
fn action(m: &Dense, x: &Dense) -> Dense {
    if *m == m.involute() {
        m.sandwich(x)
    } else {
        m.sandwich(&x.involute())
    }
}

/// Each function on random members of its operands' types against a formula in dense multivectors.
macro_rules! compare {
    ($($name:ident($($operand:ident: $type:ident),*) = $truth:expr;)*) => { $(
        #[test]
        fn $name() {
            for_all(($(exact_member::<$type<Prime61>>(),)*), |($($operand,)*)| {
                let found = super::d(&compiled::$name($($operand),*));
                $(#[allow(unused_variables)] let $operand = &super::d(&$operand);)*
                let truth: super::Dense = $truth;
                assert_eq!(found, truth);
            });
        }
    )* };
}

mod conformal {
    #[allow(unused_imports)]
    use super::{Field, action, blade};
    use ga_runtime::cga3::{
        Circle, DualPlane, DualQuaternion, Line, Motor, MotorGenerator, Multivector, Plane, Point,
        PointPair, Rotor, RoundVector, Similarity, Sphere, Translator,
    };
    use ga_runtime::testing::{Prime61, exact_member, for_all};

    mod compiled {
        use super::super::ga;
        ga! { ga_runtime::cga3;
            pub fn geometric_operator(a: Point, b: PointPair) -> Multivector { a * b }
            pub fn geometric_name(a: Motor, b: Circle) -> Multivector { geometric(a, b) }
            pub fn wedge_operator(a: Point, b: Circle) -> Sphere { a ^ b }
            pub fn wedge_method(a: Circle, b: RoundVector) -> Quadvector { a.wedge(b) }
            pub fn left_contraction_operator(a: Point, b: Sphere) -> Trivector { a | b }
            pub fn left_contraction_name(a: PointPair, b: Multivector) -> Multivector { left_contraction(a, b) }
            pub fn right_contraction_name(a: Sphere, b: Point) -> Trivector { right_contraction(a, b) }
            pub fn vee_operator(a: Sphere, b: Sphere) -> Circle { a & b }
            pub fn vee_method(a: Line, b: Sphere) -> Bivector { a.vee(b) }
            pub fn scalar_product_name(a: Motor, b: Similarity) -> Even { scalar_product(a, b) + 0 * e12 }
            pub fn commutator_name(a: MotorGenerator, b: Circle) -> Trivector { commutator(a, b) }
            pub fn reverse_name(a: Multivector) -> Multivector { reverse(a) }
            pub fn rev_method(a: Sphere) -> Sphere { a.rev() }
            pub fn involute_name(a: Multivector) -> Multivector { involute(a) }
            pub fn conjugate_name(a: Multivector) -> Multivector { conjugate(a) }
            pub fn dual_name(a: Multivector) -> Multivector { dual(a) }
            pub fn undual_method(a: Multivector) -> Multivector { a.undual() }
            pub fn grade_name(a: Multivector) -> Trivector { grade(a, 3) }
            pub fn grade_method(a: Motor, b: Motor) -> MotorGenerator { (a * b).grade(2) }
            pub fn sandwich_even(m: Motor, x: Circle) -> Circle { sandwich(m, x) }
            pub fn sandwich_odd(m: RoundVector, x: Sphere) -> Quadvector { m.sandwich(x) }
            pub fn sandwich_odd_of_a_vector(m: DualPlane, x: Point) -> RoundVector { transform(m, x) }
            pub fn sandwich_of_a_plane(m: Plane, x: Circle) -> Circle { sandwich(m, x) }
            pub fn sandwich_similarity(m: Similarity, x: Point) -> RoundVector { transform(m, x) }
            pub fn written_out_even(m: Motor, x: Sphere) -> Sphere { m * x * reverse(m) }
            pub fn written_out_odd(m: RoundVector, x: Sphere) -> Quadvector { m * x * m }
            pub fn written_out_backwards(m: Motor, x: Line) -> Line { reverse(m) * x * m }
            pub fn written_out_of_two(m: Motor, n: Rotor, x: Point) -> Point { m * n * x * rev(n) * rev(m) }
            pub fn written_out_of_a_product(m: Motor, n: Translator, x: Line) -> Line { (m * n) * x * rev(m * n) }
            pub fn written_out_free(m: DualQuaternion, x: Point) -> Multivector { m * x * rev(m) }
            pub fn written_out_in_parts(m: Motor, x: Point, y: Point) -> Multivector { m * (x * y) * rev(m) * x }
            pub fn unit_norm_is_one(m: Motor, x: Point) -> Point { m * rev(m) * x }
            pub fn negative_versor(m: Motor, x: Plane) -> Plane { -m * x * rev(-m) }
            pub fn relative_motion(m: Motor, n: Motor) -> Motor { reverse(m) * n }
            pub fn sum_and_difference(a: Circle, b: Line) -> Trivector { a + 2 * b - a / 4 - -b }
            pub fn quotient(a: Sphere, b: Plane) -> Sphere { a / (b.e12oi + 2) }
            pub fn numbers(a: Circle) -> Circle { 0.5 * a * 1.25e2 + a / 3 - 1e-1 * a }
            pub fn blades(a: Multivector) -> Multivector { (e12 ^ a) + (e1 * a) - (a | e21) + e3oi }
            #[allow(deprecated)] // A vector and a 3-vector have no regressive product.
            pub fn constant_types(a: Point, b: Circle) -> Multivector { (Infinity ^ a) + (b & E1) + Origin * E2 }
            pub fn coefficients(a: Multivector) -> RoundVector { a.e12 * e1 + a.e21() * e2 + a.scalar * e3 + a.ei * eo - a.e12oi * ei }
            pub fn norm_squared_name(a: Multivector, b: Point) -> RoundVector { norm_squared(a) * b }
            pub fn norm_squared_difference(a: Point, b: Point) -> RoundVector { norm_squared(a - b) * a }
            pub fn inverse_name(a: Sphere, b: Sphere) -> Multivector { a * inverse(b) }
            pub fn inverse_of_a_motor(a: Motor, b: Motor) -> Motor { a * inv(b) }
            pub fn inverse_of_a_similarity_times_a_number(a: Similarity) -> Even { inverse(2 * a) }
            pub fn recip_name(a: Point, b: Point) -> RoundVector { recip(a | b) * a }
            pub fn three_points(a: Point, b: Point, c: Point) -> Circle { a ^ b ^ c }
            pub fn three_points_and_infinity(a: Point, b: Point, c: Point) -> Plane { a ^ b ^ c ^ ei }
            pub fn four_points(a: Point, b: Point, c: Point, f: Point) -> Sphere { a ^ b ^ c ^ f }
            pub fn line_of_points(a: Point, b: Point) -> Line { a ^ b ^ ei }
            #[allow(deprecated)] // The first join is zero.
            pub fn join_with_itself(a: Point, b: Point) -> Trivector { (a ^ b ^ b) + (a ^ b ^ E1) }
            pub fn dual_of_a_meet(a: Sphere, b: Sphere, c: Sphere) -> PointPair { dual(dual(a) ^ dual(b) ^ dual(c)) }
            pub fn projection(p: Point, s: Circle) -> Multivector { (p | s) * s }
            pub fn scalar_wedge(a: Point, b: Point, c: Line) -> Line { (a | b) ^ c }
        }
    }

    compare! {
        geometric_operator(a: Point, b: PointPair) = a * b;
        geometric_name(a: Motor, b: Circle) = a * b;
        wedge_operator(a: Point, b: Circle) = a ^ b;
        wedge_method(a: Circle, b: RoundVector) = a ^ b;
        left_contraction_operator(a: Point, b: Sphere) = a | b;
        left_contraction_name(a: PointPair, b: Multivector) = a | b;
        right_contraction_name(a: Sphere, b: Point) = a.right_contraction(b);
        vee_operator(a: Sphere, b: Sphere) = a & b;
        vee_method(a: Line, b: Sphere) = a & b;
        scalar_product_name(a: Motor, b: Similarity) = blade::<Motor<Prime61>>(0).scale(a.scalar_product(b));
        commutator_name(a: MotorGenerator, b: Circle) = a.commutator(b);
        reverse_name(a: Multivector) = a.reverse();
        rev_method(a: Sphere) = a.reverse();
        involute_name(a: Multivector) = a.involute();
        conjugate_name(a: Multivector) = a.conjugate();
        dual_name(a: Multivector) = a.dual();
        undual_method(a: Multivector) = a.undual();
        grade_name(a: Multivector) = a.grade(3);
        grade_method(a: Motor, b: Motor) = (a * b).grade(2);
        sandwich_even(m: Motor, x: Circle) = action(m, x);
        sandwich_odd(m: RoundVector, x: Sphere) = action(m, x);
        sandwich_odd_of_a_vector(m: DualPlane, x: Point) = action(m, x);
        sandwich_of_a_plane(m: Plane, x: Circle) = action(m, x);
        sandwich_similarity(m: Similarity, x: Point) = action(m, x);
        written_out_even(m: Motor, x: Sphere) = m.sandwich(x);
        written_out_odd(m: RoundVector, x: Sphere) = &(m * x) * m;
        written_out_backwards(m: Motor, x: Line) = m.reverse().sandwich(x);
        written_out_of_two(m: Motor, n: Rotor, x: Point) = m.sandwich(&n.sandwich(x));
        written_out_of_a_product(m: Motor, n: Translator, x: Line) = (m * n).sandwich(x);
        written_out_free(m: DualQuaternion, x: Point) = m.sandwich(x);
        written_out_in_parts(m: Motor, x: Point, y: Point) = &m.sandwich(&(x * y)) * x;
        unit_norm_is_one(m: Motor, x: Point) = x.clone();
        negative_versor(m: Motor, x: Plane) = m.sandwich(x);
        relative_motion(m: Motor, n: Motor) = &m.reverse() * n;
        sum_and_difference(a: Circle, b: Line) = a + &b.scale(3.into()) - a.scale(Prime61::from_ratio(1, 4));
        quotient(a: Sphere, b: Plane) = a.scale((b.coefficient(0b11011) + 2.into()).recip());
        numbers(a: Circle) = a.scale(Prime61::from_ratio(125, 2) + Prime61::from_ratio(1, 3) - Prime61::from_ratio(1, 10));
        blades(a: Multivector) = (blade::<Point<Prime61>>(0b00011) ^ a) + blade::<Point<Prime61>>(1) * a + (a | blade::<Point<Prime61>>(0b11)) + blade::<Point<Prime61>>(0b11100);
        constant_types(a: Point, b: Circle) = (blade::<Point<Prime61>>(16) ^ a) + (b & &blade::<Point<Prime61>>(1)) + blade::<Point<Prime61>>(8) * blade::<Point<Prime61>>(2);
        coefficients(a: Multivector) = blade::<Point<Prime61>>(1).scale(a.coefficient(3)) - blade::<Point<Prime61>>(2).scale(a.coefficient(3)) + blade::<Point<Prime61>>(4).scale(a.coefficient(0)) + blade::<Point<Prime61>>(8).scale(a.coefficient(16)) - blade::<Point<Prime61>>(16).scale(a.coefficient(0b11011));
        norm_squared_name(a: Multivector, b: Point) = b.scale(a.norm_squared());
        norm_squared_difference(a: Point, b: Point) = a.scale((a - b).norm_squared());
        inverse_name(a: Sphere, b: Sphere) = a * b.inverse().unwrap_or_else(|| b.scale(0.into()));
        inverse_of_a_motor(a: Motor, b: Motor) = a * b.reverse();
        inverse_of_a_similarity_times_a_number(a: Similarity) = a.reverse().scale(Prime61::from_ratio(1, 2));
        recip_name(a: Point, b: Point) = a.scale((a | b).coefficient(0).recip());
        three_points(a: Point, b: Point, c: Point) = a ^ b ^ c;
        three_points_and_infinity(a: Point, b: Point, c: Point) = a ^ b ^ c ^ blade::<Point<Prime61>>(16);
        four_points(a: Point, b: Point, c: Point, f: Point) = a ^ b ^ c ^ f;
        line_of_points(a: Point, b: Point) = a ^ b ^ blade::<Point<Prime61>>(16);
        join_with_itself(a: Point, b: Point) = a ^ b ^ blade::<Point<Prime61>>(1);
        dual_of_a_meet(a: Sphere, b: Sphere, c: Sphere) = (a.dual() ^ b.dual() ^ c.dual()).dual();
        projection(p: Point, s: Circle) = (p | s) * s;
        scalar_wedge(a: Point, b: Point, c: Line) = (a | b) ^ c;
    }
}

mod projective {
    #[allow(unused_imports)]
    use super::{Field, action, blade};
    use ga_runtime::pga3::{Line, Motor, MotorSum, Multivector, Plane, Point, Rotor, Translator};
    use ga_runtime::testing::{Prime61, exact_member, for_all};

    mod compiled {
        use super::super::ga;
        ga! { ga_runtime::pga3;
            pub fn meet_of_planes(a: Plane, b: Plane, c: Plane) -> Point { a ^ b ^ c }
            pub fn join_of_points(a: Point, b: Point, c: Point) -> Plane { a & b & c }
            pub fn join_of_lines(a: Line, b: Point) -> Plane { a.vee(b) }
            pub fn duals(a: Multivector) -> Multivector { dual(a) + undual(involute(a)) }
            pub fn moved_line(m: Motor, x: Line) -> Line { m * x * rev(m) }
            pub fn moved_point(m: Motor, x: Point) -> Point { sandwich(m, x) }
            pub fn moved_plane_back(m: Motor, x: Plane) -> Plane { rev(m) * x * m }
            pub fn moved_motor(m: Motor, x: Motor) -> Motor { transform(m, x) }
            pub fn reflected(m: Plane, x: Point) -> Point { sandwich(m, x) }
            pub fn reflected_twice(a: Plane, b: Plane, x: Line) -> Line { sandwich(a * b, x) }
            pub fn commuted(a: Line, b: Line) -> Line { a.commutator(b) }
            pub fn inverted(a: Plane, m: MotorSum) -> MotorSum { m * inverse(a) * a }
            pub fn inverted_line(a: Rotor, b: Translator, m: Motor) -> Motor { inverse(a * b) * m }
            pub fn projected(p: Point, l: Line) -> Multivector { (l | p) * l + right_contraction(p, l) + conjugate(p) }
            pub fn split(t: Translator, r: Rotor, x: Plane) -> Plane { t * r * x * rev(r) * rev(t) }
        }
    }

    compare! {
        meet_of_planes(a: Plane, b: Plane, c: Plane) = a ^ b ^ c;
        join_of_points(a: Point, b: Point, c: Point) = a & b & c;
        join_of_lines(a: Line, b: Point) = a & b;
        duals(a: Multivector) = a.dual() + a.involute().undual();
        moved_line(m: Motor, x: Line) = m.sandwich(x);
        moved_point(m: Motor, x: Point) = m.sandwich(x);
        moved_plane_back(m: Motor, x: Plane) = m.reverse().sandwich(x);
        moved_motor(m: Motor, x: Motor) = m.sandwich(x);
        reflected(m: Plane, x: Point) = action(m, x);
        reflected_twice(a: Plane, b: Plane, x: Line) = (a * b).sandwich(x);
        commuted(a: Line, b: Line) = a.commutator(b);
        inverted(a: Plane, m: MotorSum) = m.clone();
        inverted_line(a: Rotor, b: Translator, m: Motor) = &(a * b).reverse() * m;
        projected(p: Point, l: Line) = (l | p) * l + p.right_contraction(l) + p.conjugate();
        split(t: Translator, r: Rotor, x: Plane) = t.sandwich(&r.sandwich(x));
    }
}

mod declared {
    ga_runtime::algebra! {
        /// Four vectors, neither diagonal nor whole, one of them null and orthogonal to all.
        pub(super) mod oblique {
            basis a, b, c, n;
            metric a*a = 1, b*b = 1/2, c*c = -2, a*b = 1/3, b*c = -1, a*c = 1/4;

            struct Vector { a, b, c, n }
            struct Bivector { ba, ac, bc, na, bn, nc }
            struct Trivector { abc, nab, acn, cbn }
            struct Volume { cban }
            struct A { a = 2 }
            #[hull(Vector)]
            struct Height { a, c, b = 1/2 }
            struct Multivector { scalar, a, b, c, n, ab, ca, bc, an, nb, nc, abc, abn, anc, bcn, abcn }
            struct Even { scalar, ab, ca, bc, an, nb, nc, abcn }
        }
    }

    #[allow(unused_imports)]
    use super::{Field, action, blade};
    use ga_runtime::testing::{Prime61, exact_member, for_all};
    use oblique::{Bivector, Even, Height, Multivector, Trivector, Vector, Volume};

    mod compiled {
        use super::super::ga;
        ga! { super::oblique;
            pub fn product(x: Multivector, y: Vector) -> Multivector { x * y }
            pub fn wedge(x: Bivector, y: Vector) -> Trivector { x ^ y }
            pub fn four(w: Vector, x: Vector, y: Vector, z: Height) -> Volume { w ^ x ^ y ^ z }
            pub fn contracted(x: Vector, y: Trivector) -> Bivector { x | y }
            pub fn contracted_right(x: Volume, y: Bivector) -> Bivector { x.right_contraction(y) }
            pub fn meet(x: Trivector, y: Trivector) -> Bivector { x & y }
            pub fn duals(x: Multivector) -> Multivector { dual(x) - undual(x) }
            pub fn action_even(x: Vector, y: Vector, z: Trivector) -> Trivector { sandwich(x * y, z) }
            pub fn action_odd(x: Vector, z: Bivector) -> Bivector { sandwich(x, z) }
            pub fn action_of_height(x: Height, z: Volume) -> Volume { sandwich(x, z) }
            pub fn written_out(m: Even, z: Vector) -> Multivector { m * z * rev(m) }
            pub fn inverted(x: Vector, y: Bivector) -> Multivector { inverse(x) * y }
            pub fn negative_blades(x: Multivector) -> Multivector { x.ba * ca + x.cba() * bca - x.nb * a }
            pub fn constant(x: Bivector) -> Multivector { A * x * A + (A | x) }
            pub fn grades(x: Multivector, y: Multivector) -> Even { grade(x * y, 2) + grade(x, 4) }
        }
    }

    compare! {
        product(x: Multivector, y: Vector) = x * y;
        wedge(x: Bivector, y: Vector) = x ^ y;
        four(w: Vector, x: Vector, y: Vector, z: Height) = w ^ x ^ y ^ z;
        contracted(x: Vector, y: Trivector) = x | y;
        contracted_right(x: Volume, y: Bivector) = x.right_contraction(y);
        meet(x: Trivector, y: Trivector) = x & y;
        duals(x: Multivector) = x.dual() - x.undual();
        action_even(x: Vector, y: Vector, z: Trivector) = (x * y).sandwich(z);
        action_odd(x: Vector, z: Bivector) = action(x, z);
        action_of_height(x: Height, z: Volume) = action(x, z);
        written_out(m: Even, z: Vector) = m.sandwich(z);
        inverted(x: Vector, y: Bivector) = x.inverse().expect("not null") * y;
        negative_blades(x: Multivector) = blade::<Vector<Prime61>>(0b101).scale(x.coefficient(3)) - blade::<Vector<Prime61>>(0b111).scale(x.coefficient(7)) + blade::<Vector<Prime61>>(1).scale(x.coefficient(0b1010));
        constant(x: Bivector) = blade::<Vector<Prime61>>(1).sandwich(x).scale(4.into()) + (blade::<Vector<Prime61>>(1) | x).scale(2.into());
        grades(x: Multivector, y: Multivector) = (x * y).grade(2) + x.grade(4);
    }
}
