//! Comparisons and choices: over f64 and in lanes against plain `if`, and with NaN and infinities.

use ga_runtime::cga3::{Point, RoundVector};
use ga_runtime::interop::num_traits::FromFloat;
use ga_runtime::scalar::{Dual, Lanes, Mask, Real};

mod compiled {
    #![deny(warnings)]
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        pub fn compared(x: Scalar, y: Scalar) -> [Scalar; 6] {
            [
                select(x < y, 1, 0), select(x <= y, 1, 0), select(x > y, 1, 0),
                select(x >= y, 1, 0), select(x == y, 1, 0), select(x != y, 1, 0),
            ]
        }
        pub fn joined(x: Scalar, y: Scalar, z: Scalar) -> [Scalar; 5] {
            let (a, b) = (x < y, y < z);
            let c = !a || b;
            [
                select(a && b, 1, 0), select(a || b, 1, 0), select(!a, 1, 0), select(c, 1, 0),
                select(!(a && !b) && x < z || !!a, 1, 0),
            ]
        }
        pub fn ranged(x: Scalar, y: Scalar) -> [Scalar; 4] {
            [min(x, y), x.max(y), clamp(x, -1, 1), sign(x)]
        }
        /// Not in the same blades, and only one of both is scaled.
        pub fn chosen(x: Scalar, p: Point, v: RoundVector) -> RoundVector {
            select(x < 0, 2 * p, v - eo)
        }
        /// A point whichever it is.
        pub fn nearer(o: Point, p: Point, q: Point) -> Point {
            select((o | p) >= (o | q), p, q)
        }
        pub fn nearer_moved(m: Motor, o: Point, p: Point, q: Point) -> Point {
            sandwich(m, nearer(o, p, q))
        }
        pub fn sorted(x: Scalar, y: Scalar, p: Point, q: Point) -> ([Scalar; 2], (Point, Point)) {
            (select(x <= y, [x, y], [y, x]), select(x <= y, (p, q), (q, p)))
        }
        /// The root that is not chosen does not exist.
        pub fn root_or_zero(x: Scalar) -> Scalar { select(x < 0, 0, sqrt(x)) }
        pub fn ramp(x: Scalar) -> Scalar { select(x > 0, x * x, -x) + max(x, 2 * x) }
        /// A conjunction of six comparisons.
        pub fn boxed(x: Scalar, y: Scalar, z: Scalar, a: Scalar, b: Scalar) -> Scalar {
            select(x > a && x < b && y > a && y < b && z > a && z < b, x * 2, y)
        }
        /// Two conjunctions of which one holds without the other.
        pub fn two_ranges(x: Scalar, y: Scalar, z: Scalar, w: Scalar) -> [Scalar; 2] {
            [
                select(x < y && y < z && z < w && x < 0, x, w),
                select(x < y && y < z && z < w && w < 0, x, w),
            ]
        }
        pub fn nested(x: Scalar, y: Scalar, z: Scalar, a: Scalar) -> Scalar {
            select(x > a, select(y > a, select(z > a, x * y, 0), 0), 0)
        }
        /// Zero at each point where x has a root, and not zero where y is zero.
        pub fn limited(x: Scalar, y: Scalar) -> [Scalar; 3] { [sqrt(x), abs(x) - x, x / y * y - x] }
        pub fn absolute(x: Scalar) -> [Scalar; 3] { [sqrt(x), abs(x), 2 * abs(x) - x] }
        pub fn staged(uniform a: Scalar, uniform b: Scalar, x: Scalar, y: Scalar) -> [Scalar; 3] {
            let is_less = a < b && !(a == 0);
            [select(is_less, a, b) * x, select(is_less || x < a, x, y), select(a < b, a * a, b)]
        }
        pub fn unstaged(a: Scalar, b: Scalar, x: Scalar, y: Scalar) -> [Scalar; 3] {
            let is_less = a < b && !(a == 0);
            [select(is_less, a, b) * x, select(is_less || x < a, x, y), select(a < b, a * a, b)]
        }
    }
}

const NUMBERS: [f64; 9] = [
    -2.5,
    -1.0,
    -0.0,
    0.0,
    0.5,
    1.0,
    3.0,
    f64::INFINITY,
    f64::NAN,
];

fn bit(condition: bool) -> f64 {
    f64::from(u8::from(condition))
}

#[test]
fn comparisons_are_those_of_rust() {
    for x in NUMBERS {
        for y in NUMBERS {
            let truth = [x < y, x <= y, x > y, x >= y, x == y, x != y];
            assert_eq!(compiled::compared(x, y), truth.map(bit), "{x} {y}");
            for z in NUMBERS {
                let (a, b) = (x < y, y < z);
                let implied = !a || b;
                let last = (implied && x < z) || a;
                let truth = [a && b, a || b, !a, implied, last].map(bit);
                assert_eq!(compiled::joined(x, y, z), truth, "{x} {y} {z}");
            }
        }
    }
}

#[test]
fn lanes_choose_one_by_one() {
    for x in NUMBERS {
        let lanes = [x; 8];
        let others: [f64; 8] = std::array::from_fn(|lane| NUMBERS[lane]);
        let found = compiled::compared(Lanes::from_array(lanes), Lanes::from_array(others));
        let single = others.map(|y| compiled::compared(x, y));
        for (comparison, found) in found.into_iter().enumerate() {
            assert_eq!(found.to_array(), single.map(|all| all[comparison]), "{x}");
        }
    }
    let points: [[f64; 3]; 4] = [[1.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0], [2.0; 3]];
    let lanes = |shift: usize| {
        Point::from(std::array::from_fn(|axis| {
            Lanes::from_array(std::array::from_fn(|lane| points[(lane + shift) % 4][axis]))
        }))
    };
    let origin = Point::from([Lanes::splat(0.0); 3]);
    let found = compiled::nearer(origin, lanes(0), lanes(1));
    let nearest = [points[0], points[2], points[2], points[0]];
    for axis in 0..3 {
        let found = found.coordinates()[axis].to_array();
        assert_eq!(found, nearest.map(|point| point[axis]));
    }
}

#[test]
fn ranges_and_signs() {
    assert_eq!(compiled::ranged(2.0, 3.0), [2.0, 3.0, 1.0, 1.0]);
    assert_eq!(compiled::ranged(-2.0, -3.0), [-3.0, -2.0, -1.0, -1.0]);
    assert_eq!(compiled::ranged(0.5, 0.5), [0.5, 0.5, 0.5, 1.0]);
    assert_eq!(compiled::ranged(0.0, 1.0)[3], 0.0);
    assert!(compiled::ranged(f64::NAN, 1.0)[3].is_nan());
}

#[test]
fn multivectors_are_chosen_whole() {
    let (p, v) = (
        Point::new(1.0, 2.0, 3.0),
        RoundVector::new(5.0, 6.0, 7.0, 8.0, 9.0),
    );
    let twice = RoundVector::new(2.0, 4.0, 6.0, 2.0, 14.0);
    assert_eq!(compiled::chosen(-1.0, p, v), twice);
    let other = RoundVector::new(5.0, 6.0, 7.0, 7.0, 9.0);
    assert_eq!(compiled::chosen(0.0, p, v), other);

    let (near, far) = (Point::new(1.0, 0.0, 0.0), Point::new(0.0, 3.0, 0.0));
    let origin = Point::new(0.0, 0.0, 0.0);
    assert_eq!(compiled::nearer(origin, near, far), near);
    assert_eq!(compiled::nearer(origin, far, near), near);
    let up = ga_runtime::cga3::Translator::from_displacement([0.0, 0.0, 2.0]);
    let moved = compiled::nearer_moved(up.into(), origin, far, near);
    assert_eq!(moved.coordinates(), [1.0, 0.0, 2.0]);

    let (numbers, points) = compiled::sorted(2.0, 1.0, near, far);
    assert_eq!((numbers, points), ([1.0, 2.0], (far, near)));
    let (numbers, points) = compiled::sorted(1.0, 1.5, near, far);
    assert_eq!((numbers, points), ([1.0, 1.5], (near, far)));
}

#[test]
fn what_is_not_chosen_does_no_harm() {
    assert_eq!(compiled::root_or_zero(-4.0), 0.0);
    assert_eq!(compiled::root_or_zero(4.0), 2.0);
    let lanes = compiled::root_or_zero(Lanes::from_array([9.0, -1.0]));
    assert_eq!(lanes.to_array(), [3.0, 0.0]);
}

#[test]
fn long_conjunctions_are_those_of_rust() {
    let inside = [0.25_f64, 0.5, 0.75];
    for x in inside.into_iter().chain([-1.0, 2.0]) {
        for y in inside.into_iter().chain([-1.0, 2.0]) {
            for z in inside.into_iter().chain([-1.0, 2.0]) {
                let is_inside = [x, y, z].iter().all(|c| (0.0..1.0).contains(c));
                let truth = if is_inside { x * 2.0 } else { y };
                assert_eq!(compiled::boxed(x, y, z, 0.0, 1.0), truth, "{x} {y} {z}");
                let truth = if x > 0.0 && y > 0.0 && z > 0.0 {
                    x * y
                } else {
                    0.0
                };
                assert_eq!(compiled::nested(x, y, z, 0.0), truth, "{x} {y} {z}");
            }
        }
    }
    assert_eq!(compiled::two_ranges(-1.0, 1.0, 2.0, 3.0), [-1.0, 3.0]);
    assert_eq!(compiled::two_ranges(-4.0, -3.0, -2.0, -1.0), [-4.0, -4.0]);
    assert_eq!(compiled::two_ranges(1.0, 2.0, 3.0, 4.0), [4.0, 4.0]);
}

#[test]
fn what_is_zero_at_most_points_is_computed() {
    let [root, twice, quotient]: [f64; 3] = compiled::limited(-2.0, 0.0);
    assert!(root.is_nan() && twice == 4.0 && quotient.is_nan());
    let [_, size, other] = compiled::absolute(-2.0);
    assert_eq!((size, other), (2.0, 6.0));
}

#[test]
fn derivatives_are_those_of_the_branch() {
    let at = |x: f64| compiled::ramp(Dual::<f64>::variable(x));
    // x² + 2 x, and −x + x.
    assert_eq!((at(3.0).value, at(3.0).derivatives), (15.0, [8.0]));
    assert_eq!((at(-3.0).value, at(-3.0).derivatives), (0.0, [0.0]));
}

#[test]
fn uniform_conditions_hold_in_both_stages() {
    for a in NUMBERS {
        for b in NUMBERS {
            let staged = compiled::staged(a, b);
            for (x, y) in [(0.25, 2.0), (-4.0, -1.0)] {
                let (found, truth) = (staged.apply(x, y), compiled::unstaged(a, b, x, y));
                for (found, truth) in found.into_iter().zip(truth) {
                    assert!(
                        found == truth || found.is_nan() && truth.is_nan(),
                        "{a} {b}"
                    );
                }
                if !(a.is_nan() || b.is_nan()) {
                    assert_eq!(found_choice(a, b, x, y), truth[1]);
                }
            }
        }
    }
}

/// The second number of `staged` as Rust writes it.
fn found_choice(a: f64, b: f64, x: f64, y: f64) -> f64 {
    if (a < b && a != 0.0) || x < a { x } else { y }
}

/// A scalar that defines no more than it must compares in the same way, and so do registers.
#[test]
fn other_scalars_compare_in_the_same_way() {
    for x in NUMBERS {
        for y in NUMBERS {
            let (a, b) = (FromFloat(x), FromFloat(y));
            assert_eq!(
                (a.less_or_equal(b), a.equals(b)),
                (x <= y, x == y),
                "{x} {y}"
            );
            let (a, b) = (wide::f64x2::splat(x), wide::f64x2::splat(y));
            assert_eq!(a.less_or_equal(b).all(), x <= y);
            assert_eq!(a.equals(b).all(), x == y);
        }
    }
}
