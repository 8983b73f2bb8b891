//! Lanes: each holds the result of the operation on a single number.

use ga_runtime::Element;
use ga_runtime::cga3::{Circle, Direction, Line, Motor, Plane, Point, Rotor, Sphere, Translator};
use ga_runtime::scalar::{Field, LaneMask, Lanes, Mask, Prime61, Real, Ring, Select};
use ga_runtime::testing::exact_member;
use ga_runtime::testing::strategy::{nonzero_prime, prime};
use proptest::array::{uniform4, uniform8};
use proptest::collection::vec;
use proptest::prelude::*;

/// Equality of bits, with all NaNs equal.
trait Same: Copy {
    fn same(self, other: Self) -> bool;
}
impl Same for f32 {
    fn same(self, other: Self) -> bool {
        self.to_bits() == other.to_bits() || self.is_nan() && other.is_nan()
    }
}
impl Same for f64 {
    fn same(self, other: Self) -> bool {
        self.to_bits() == other.to_bits() || self.is_nan() && other.is_nan()
    }
}

/// Compares every operation on lanes with the same operation on each number.
fn check<T: Real<Mask = bool> + Same, const N: usize>(
    a: [T; N],
    b: [T; N],
    c: [T; N],
) -> Result<(), TestCaseError> {
    let [x, y, z] = [a, b, c].map(Lanes::from_array);
    let mut added = x;
    added += y;
    let mut taken = x;
    taken -= y;
    let mut scaled = x;
    scaled *= y;
    let mut divided = x;
    divided /= y;
    let ((sine, cosine), mask) = (x.sin_cos(), x.less_than(y));
    prop_assert_eq!(
        [mask.any(), mask.all()],
        [
            (0..N).any(|k| a[k].less_than(b[k])),
            (0..N).all(|k| a[k].less_than(b[k]))
        ]
    );
    prop_assert_eq!(
        x.is_invertible(),
        a.iter().all(|number| *number != T::zero())
    );
    prop_assert_eq!(x == y, a == b);
    for k in 0..N {
        let (p, q, r) = (a[k], b[k], c[k]);
        let results = [
            ("+", x + y, p + q),
            ("-", x - y, p - q),
            ("*", x * y, p * q),
            ("/", x / y, p / q),
            ("+=", added, p + q),
            ("-=", taken, p - q),
            ("*=", scaled, p * q),
            ("/=", divided, p / q),
            ("neg", -x, -p),
            ("mul_add", x.mul_add(y, z), p.mul_add(q, r)),
            ("recip", x.recip(), p.recip()),
            ("sqrt", x.sqrt(), p.sqrt()),
            ("abs", x.abs(), p.abs()),
            ("sin", sine, p.sin()),
            ("cos", cosine, p.cos()),
            ("atan2", x.atan2(y), p.atan2(q)),
            ("exp", x.exp(), p.exp()),
            ("ln", x.ln(), p.ln()),
            ("sinh", x.sinh(), p.sinh()),
            ("cosh", x.cosh(), p.cosh()),
            ("tanh", x.tanh(), p.tanh()),
            ("hypot", x.hypot(y), p.hypot(q)),
            ("max", x.max(y), p.max(q)),
            ("min", x.min(y), p.min(q)),
            (
                "select",
                Select::select(mask, y, z),
                if mask[k] { q } else { r },
            ),
        ];
        for (name, lanes, alone) in results {
            prop_assert!(
                lanes[k].same(alone),
                "{name} in lane {k}: {:?}, alone {alone:?}",
                lanes[k]
            );
        }
        prop_assert_eq!(mask[k], p.less_than(q));
        prop_assert_eq!(x.is_finite()[k], p.is_finite());
        prop_assert_eq!(x.is_zero()[k], p == T::zero());
    }
    Ok(())
}

/// Any bits; special and equal numbers are drawn more often.
fn single() -> impl Strategy<Value = f32> {
    const SPECIAL: [f32; 6] = [0.0, -0.0, 1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
    prop_oneof![
        prop::num::f32::ANY,
        -10.0_f32..10.0,
        prop::sample::select(&SPECIAL[..])
    ]
}

fn double() -> impl Strategy<Value = f64> {
    const SPECIAL: [f64; 6] = [0.0, -0.0, 1.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    prop_oneof![
        prop::num::f64::ANY,
        -10.0_f64..10.0,
        prop::sample::select(&SPECIAL[..])
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn four_singles(a in uniform4(single()), b in uniform4(single()), c in uniform4(single())) {
        check(a, b, c)?;
    }

    #[test]
    fn eight_singles(a in uniform8(single()), b in uniform8(single()), c in uniform8(single())) {
        check(a, b, c)?;
    }

    #[test]
    fn four_doubles(a in uniform4(double()), b in uniform4(double()), c in uniform4(double())) {
        check(a, b, c)?;
    }

    #[test]
    fn eight_doubles(a in uniform8(double()), b in uniform8(double()), c in uniform8(double())) {
        check(a, b, c)?;
    }

    #[test]
    fn exact_lanes(a in uniform4(prime()), b in uniform4(nonzero_prime())) {
        let (x, y) = (Lanes::from_array(a), Lanes::from_array(b));
        prop_assert_eq!((x * y - x) / y, Lanes::from_array([0, 1, 2, 3].map(|k| (a[k] * b[k] - a[k]) / b[k])));
        prop_assert_eq!(y * y.recip(), Lanes::one());
        prop_assert!(y.is_invertible());
        prop_assert_eq!(x + -x, Lanes::zero());
    }

    #[test]
    fn masks_are_boolean_by_lane(a in uniform8(any::<bool>()), b in uniform8(any::<bool>())) {
        let (x, y) = (LaneMask::from_array(a), LaneMask::from_array(b));
        for k in 0..8 {
            prop_assert_eq!([(x & y)[k], (x | y)[k], (!x)[k]], [a[k] && b[k], a[k] || b[k], !a[k]]);
            prop_assert_eq!([x.lane(k), a[k].lane(k)], [a[k]; 2]);
        }
        prop_assert_eq!([x.any(), x.all()], [a.contains(&true), !a.contains(&false)]);
    }

    #[test]
    fn eight_points_at_once(motors in uniform8(motor()), points in uniform8(point()), others in uniform8(point())) {
        let motor: Motor<Eight> = gather(motors);
        let [p, q]: [Point<Eight>; 2] = [gather(points), gather(others)];
        let moved = motor.transform(p);
        let product = motor * motor.reverse() * motor;
        let spanned = p ^ q;
        for k in 0..8 {
            prop_assert_eq!(lane(moved, k), bits(motors[k].transform(points[k])));
            prop_assert_eq!(lane(product, k), bits(motors[k] * motors[k].reverse() * motors[k]));
            prop_assert_eq!(lane(spanned, k), bits(points[k] ^ others[k]));
            prop_assert_eq!(p.distance_squared(q)[k].to_bits(), points[k].distance_squared(others[k]).to_bits());
        }
    }

    #[test]
    fn eight_of_each_object_at_once(
        motors in uniform8(motor()),
        lines in uniform8(free(|c| Line::new(c[0], c[1], c[2], c[3], c[4], c[5]))),
        planes in uniform8(free(|c| Plane::new(c[0], c[1], c[2], c[3]))),
        spheres in uniform8(free(|c| Sphere::new(c[0], Point::new(c[1], c[2], c[3]), c[4]))),
        circles in uniform8(free(|c| Circle::new(Point::new(c[0], c[1], c[2]), Direction::new(c[3], c[4], c[5]), c[6]))),
    ) {
        let motor: Motor<Eight> = gather(motors);
        let line = motor.transform(gather::<_, Line<Eight>, _>(lines));
        let plane = motor.transform(gather::<_, Plane<Eight>, _>(planes));
        let sphere = motor.transform(gather::<_, Sphere<Eight>, _>(spheres));
        let circle = motor.transform(gather::<_, Circle<Eight>, _>(circles));
        for k in 0..8 {
            prop_assert_eq!(lane(line, k), bits(motors[k].transform(lines[k])));
            prop_assert_eq!(lane(plane, k), bits(motors[k].transform(planes[k])));
            prop_assert_eq!(lane(sphere, k), bits(motors[k].transform(spheres[k])));
            prop_assert_eq!(lane(circle, k), bits(motors[k].transform(circles[k])));
        }
    }

    #[test]
    fn exact_sandwiches_in_lanes(motors in uniform4(exact_member::<Motor<Prime61>>()), points in uniform4(exact_member::<Point<Prime61>>())) {
        let motor: Motor<Lanes<Prime61, 4>> = gather(motors);
        let moved = motor.transform(gather::<_, Point<Lanes<Prime61, 4>>, _>(points));
        for k in 0..4 {
            prop_assert_eq!(moved.coordinates().map(|x| x[k]), motors[k].transform(points[k]).coordinates());
        }
    }
}

type Eight = Lanes<f32, 8>;

/// The element over lanes whose lanes are these elements.
fn gather<A, L, const N: usize>(elements: [A; N]) -> L
where
    A: Element,
    L: Element<Scalar = Lanes<A::Scalar, N>>,
{
    L::from_numbers(&mut |place| {
        Lanes::from_array(elements.each_ref().map(|element| element.number(place)))
    })
}

fn lane<L: Element<Scalar = Eight>>(element: L, lane: usize) -> Vec<u32> {
    let bits = |&blade| element.coefficient(blade)[lane].to_bits();
    L::BLADES.iter().map(bits).collect()
}

fn bits<A: Element<Scalar = f32>>(element: A) -> Vec<u32> {
    let bits = |&blade| element.coefficient(blade).to_bits();
    A::BLADES.iter().map(bits).collect()
}

fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![-10.0_f32..10.0, -1e4_f32..1e4]
}

fn point() -> impl Strategy<Value = Point<f32>> {
    [coordinate(), coordinate(), coordinate()].prop_map(Point::from)
}

fn motor() -> impl Strategy<Value = Motor<f32>> {
    let shift = [coordinate(), coordinate(), coordinate()];
    let axis = [-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0];
    (shift, axis, -7.0_f32..7.0).prop_filter_map("an axis of no length", |(shift, axis, angle)| {
        Some(Translator::from_displacement(shift) * Rotor::from_axis_angle(axis, angle)?)
    })
}

fn free<A: core::fmt::Debug>(make: fn(&[f32]) -> A) -> impl Strategy<Value = A> {
    vec(coordinate(), 10).prop_map(move |coefficients| make(&coefficients))
}

#[test]
fn text_and_conversions() {
    let x = Lanes::from([1.5_f32, -2.0]);
    assert_eq!(
        [format!("{x}"), format!("{x:.2}"), format!("{x:?}")],
        ["[1.5, -2]", "[1.50, -2.00]", "Lanes[1.5, -2.0]"]
    );
    assert_eq!(<[f32; 2]>::from(x), *x.as_array());
    assert_eq!(Lanes::<f64, 4>::default(), Lanes::zero());
    assert_eq!(Lanes::<f64, 4>::from_ratio(1, 4).to_array(), [0.25; 4]);
    assert_eq!(Lanes::<f64, 4>::from_integer(-3).to_array(), [-3.0; 4]);
    assert_eq!(Lanes::<f32, 4>::epsilon().to_array(), [f32::EPSILON; 4]);
    let mut y = x;
    y[1] = 7.0;
    assert_eq!(y.to_array(), [1.5, 7.0]);
    assert_eq!(size_of::<Point<Lanes<f32, 8>>>(), 3 * 32);
}

#[test]
fn a_lane_without_inverse_is_found() {
    assert!(!Lanes::from_array([1.0, 0.0, 2.0]).is_invertible());
    assert!(!Lanes::from_array([1.0, -0.0, 2.0]).is_invertible());
    assert!(Lanes::from_array([1.0, -0.5, 2.0]).is_invertible());
}
