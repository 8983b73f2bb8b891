//! The axioms of geometric algebra on the types of cga3, exactly over the prime field.

use ga_runtime::Element;
use ga_runtime::cga3::{
    Bivector, Circle, Dilator, Direction, DualCircle, DualDirection, DualFlatPoint, DualPlane,
    DualPointPair, DualQuaternion, DualSphere, Even, FlatPoint, Infinity, Line, Motor,
    MotorGenerator, Multivector, Plane, Point, PointPair, Pseudoscalar, Quadvector, Quaternion,
    Rotor, RoundVector, Similarity, Sphere, Translator, Trivector,
};
use ga_runtime::scalar::{Field, Prime61, Ring};
use ga_runtime::testing::{exact_member, for_all, strategy};

type X = Multivector<Prime61>;

fn all<T: Into<X>>(element: T) -> X {
    element.into()
}

#[test]
fn versors_form_groups() {
    let motors = || exact_member::<Motor<Prime61>>();
    for_all((motors(), motors(), motors()), |(a, b, c)| {
        assert_eq!((a * b) * c, a * (b * c));
        assert_eq!(a * a.inverse(), Motor::default());
        assert_eq!(a * Motor::default(), a);
        assert_eq!((a * b).reverse(), b.reverse() * a.reverse());
        assert_eq!(all(a * b), all(a) * all(b));
    });
    let similarities = || exact_member::<Similarity<Prime61>>();
    for_all(
        (similarities(), similarities(), similarities()),
        |(a, b, c)| {
            assert_eq!((a * b) * c, a * (b * c));
            assert_eq!(a * a.inverse(), Similarity::default());
        },
    );
    let parts = (
        exact_member::<Translator<Prime61>>(),
        exact_member::<Rotor<Prime61>>(),
        exact_member::<Dilator<Prime61>>(),
    );
    for_all(parts, |(t, r, d)| {
        assert_eq!(all(t * r), all(t) * all(r));
        assert_eq!(all(r * t), all(r) * all(t));
        assert_eq!(all((t * r) * d), all(t) * all(r) * all(d));
        assert_eq!(Motor::from(t) * r, t * r);
    });
}

#[test]
fn geometric_product_is_associative_and_distributes() {
    let any = || exact_member::<X>();
    for_all((any(), any(), any()), |(a, b, c)| {
        assert_eq!((a * b) * c, a * (b * c));
        assert_eq!(a * (b + c), a * b + a * c);
        assert_eq!((a ^ b) ^ c, a ^ (b ^ c));
        assert_eq!((a ^ b) | c, a | (b | c), "contraction by a product");
        assert_eq!((a * b).reverse(), b.reverse() * a.reverse());
        assert_eq!((a & b) & c, a & (b & c));
        assert_eq!(a & b, (a.dual() ^ b.dual()).undual());
        assert_eq!(
            (a | b).dual(),
            a ^ b.dual(),
            "contraction and outer product are dual"
        );
        assert_eq!(a.dual().undual(), a);
        assert_eq!(
            a.right_contraction(b),
            (b.reverse() | a.reverse()).reverse()
        );
        let half = Prime61::from_ratio(1, 2);
        assert_eq!(a.commutator(b), (a * b - b * a) * half);
        assert_eq!(a.scalar_product(b), (a * b).scalar);
        assert_eq!(a.norm_squared(), (a * a.reverse()).scalar);
        let grades = (0..=5).fold(a - a, |sum, grade| sum + a.grade(grade));
        assert_eq!(grades, a);
    });
}

#[test]
fn grades_of_products() {
    let any = || exact_member::<X>();
    for_all((any(), any()), |(a, b)| {
        for r in 0..=5_usize {
            for s in 0..=5_usize {
                let (x, y) = (a.grade(r), b.grade(s));
                let product = x * y;
                assert_eq!(x ^ y, product.grade(r + s), "wedge of {r} and {s}");
                let left = s.checked_sub(r).map_or(x - x, |k| product.grade(k));
                assert_eq!(x | y, left, "left contraction of {r} and {s}");
                let right = r.checked_sub(s).map_or(x - x, |k| product.grade(k));
                assert_eq!(
                    x.right_contraction(y),
                    right,
                    "right contraction of {r} and {s}"
                );
            }
        }
    });
}

#[test]
fn motions_are_automorphisms() {
    let operands = (
        exact_member::<Motor<Prime61>>(),
        exact_member::<Point<Prime61>>(),
        exact_member::<Point<Prime61>>(),
        exact_member::<Point<Prime61>>(),
        exact_member::<Sphere<Prime61>>(),
    );
    for_all(operands, |(m, p, q, r, s)| {
        let [a, b, c] = [p, q, r].map(|x| m.transform(x));
        assert_eq!(m.transform(p ^ q ^ r), a ^ b ^ c);
        assert_eq!(m.transform(p ^ q ^ r ^ Infinity), a ^ b ^ c ^ Infinity);
        assert_eq!(m.transform(p ^ q ^ Infinity), a ^ b ^ Infinity);
        assert_eq!(m.transform(p ^ q), a ^ b);
        assert_eq!(p | q, a | b, "distances are kept");
        assert_eq!(
            m.transform(s) & m.transform(p ^ q ^ r),
            m.transform(s & (p ^ q ^ r))
        );
        assert_eq!(m.inverse().transform(a), p);
        // A moved point is a point: weight 1 and null, although only three numbers are computed.
        assert_eq!(all(a), all(m) * all(p) * all(m.reverse()));
        assert_eq!((-m).transform(p), a, "a motor and its negative move alike");
        let parts = m.translator() * m.rotor();
        assert_eq!(parts, m);
    });
}

#[test]
fn duals_of_types_agree_and_are_undone() {
    macro_rules! check {
        ($($type:ident),*) => {$(
            for_all(exact_member::<$type<Prime61>>(), |x| {
                assert_eq!(all(x.dual()), all(x).dual());
                assert_eq!(all(x.dual()).undual(), all(x));
            });
        )*};
    }
    check!(
        RoundVector,
        PointPair,
        FlatPoint,
        Direction,
        MotorGenerator,
        Circle,
        Line,
        Sphere,
        Plane
    );
    macro_rules! check_from_dual_form {
        ($($type:ident),*) => {$(
            for_all(exact_member::<$type<Prime61>>(), |x| {
                assert_eq!(all(x.undual()), all(x).undual());
                assert_eq!(all(x.undual().dual()), all(x));
            });
        )*};
    }
    check_from_dual_form!(
        DualSphere,
        DualPlane,
        DualCircle,
        DualPointPair,
        DualFlatPoint,
        DualDirection
    );
    for_all(exact_member::<Pseudoscalar<Prime61>>(), |x| {
        assert_eq!(x.dual(), x.e123oi)
    });
}

#[test]
fn conversions_keep_every_coefficient() {
    macro_rules! check {
        ($($from:ident => $to:ident),* $(,)?) => {$(
            for_all(exact_member::<$from<Prime61>>(), |x| {
                let converted = $to::from(x);
                for blade in 0..32 {
                    assert_eq!(converted.coefficient(blade), x.coefficient(blade));
                }
            });
        )*};
    }
    check!(
        Point => RoundVector, Point => Multivector, DualPlane => RoundVector,
        FlatPoint => Bivector, Direction => FlatPoint, Direction => MotorGenerator,
        MotorGenerator => Bivector, Line => Trivector, Plane => Quadvector, Rotor => Motor,
        Translator => Motor, Motor => Similarity, Dilator => Similarity, Rotor => Quaternion,
        Quaternion => DualQuaternion, Motor => DualQuaternion, Similarity => Even, Even => Multivector,
    );
    for_all(exact_member::<X>(), |x| {
        assert_eq!(all(x.extract_line()).extract_line(), x.extract_line());
        assert_eq!(
            x.extract_even().extract_dual_quaternion(),
            x.extract_dual_quaternion()
        );
        assert_eq!(x.extract_quadvector().e123o, x.e123o);
    });
}

#[test]
fn sums_live_in_the_hull() {
    let operands = (
        exact_member::<Point<Prime61>>(),
        exact_member::<Point<Prime61>>(),
        strategy::prime(),
    );
    for_all(operands, |(p, q, factor)| {
        let difference: RoundVector<Prime61> = p - q;
        assert_eq!(difference.eo, Prime61::zero(), "the weights cancel");
        assert_eq!(all(p + q), all(p) + all(q));
        assert_eq!((p * factor).eo, factor);
    });
    for_all(exact_member::<Motor<Prime61>>(), |m| {
        let negative: Motor<Prime61> = -m;
        assert_eq!(negative.scalar(), -m.scalar());
        let twice: DualQuaternion<Prime61> = m + m;
        assert_eq!(twice, m * Prime61::from_integer(2));
    });
}

#[test]
fn defaults_are_the_origin_the_identity_and_zero() {
    assert_eq!(Point::<i64>::default().coordinates(), [0, 0, 0]);
    assert_eq!(
        Motor::<f64>::default().transform(Point::new(1.0, 2.0, 3.0)),
        Point::new(1.0, 2.0, 3.0)
    );
    assert_eq!(Translator::<f64>::default().displacement(), [0.0; 3]);
    assert_eq!(Dilator::<f64>::default().factor(), 1.0);
    assert_eq!(
        Line::<f64>::default(),
        Line::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    );
}

#[test]
fn types_are_as_small_as_what_they_store() {
    assert_eq!(size_of::<Point<f32>>(), 12);
    assert_eq!(size_of::<Motor<f64>>(), 64);
    assert_eq!(size_of::<Translator<f32>>(), 12);
    assert_eq!(size_of::<Infinity>(), 0);
    assert_eq!(size_of::<Multivector<f64>>(), 256);
}

#[test]
fn elements_are_written_in_blades() {
    assert_eq!(
        Point::new(1.0, -2.0, 0.5).to_string(),
        "e1 - 2 e2 + 0.5 e3 + eo + 2.625 ei"
    );
    assert_eq!(Motor::<f64>::default().to_string(), "1");
    assert_eq!(Line::<f64>::default().to_string(), "0");
    let pair = Point::new(1.0, 0.0, 0.0) ^ Point::new(0.0, 1.0, 0.0);
    assert_eq!(
        format!("{pair:.1}"),
        "1.0 e12 + 1.0 e1o - 1.0 e2o + 0.5 e1i - 0.5 e2i"
    );
}

#[test]
fn unit_versors_are_checked_or_repaired() {
    let half = 0.5_f64.sqrt();
    assert!(Rotor::try_new(half, half, 0.0, 0.0, 1e-15).is_some());
    assert!(Rotor::try_new(half, half, 0.1, 0.0, 1e-3).is_none());
    assert!(Rotor::try_new(f64::NAN, 0.0, 0.0, 0.0, 1.0).is_none());
    // The norm is 1, but the Study condition does not hold.
    assert!(Motor::try_new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 1e-9).is_none());
    let repaired = DualQuaternion::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5).normalize();
    assert_eq!(repaired, Some(Motor::default()));
    assert_eq!(DualQuaternion::<f64>::default().normalize(), None);
    assert_eq!(
        (DualQuaternion::<f64>::default() * f64::NAN).normalize(),
        None
    );
}
