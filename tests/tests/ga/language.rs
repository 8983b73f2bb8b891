//! The language of `ga!`: bindings, patterns, arrays, tuples, calls and closures, on integers small
//! enough to check by hand.

use ga_runtime::cga3::{Infinity, Line, Plane, Point, RoundVector};
use ga_runtime::ga;

fn point(x: i64, y: i64, z: i64) -> RoundVector<i64> {
    RoundVector::new(x, y, z, 1, 0)
}

mod compiled {
    use ga_runtime::ga;

    ga! { ga_runtime::cga3;
        // The callee is defined later and calls a third function.
        pub fn outer(a: RoundVector, b: RoundVector) -> Scalar { 2 * middle(a, b) + inner(b, a) }
        fn middle(p: RoundVector, q: RoundVector) -> Scalar { inner(q, p - q) }
        fn inner(a: RoundVector, b: RoundVector) -> Scalar {
            let b = a.e1 * b;
            b.e2
        }

        pub fn shadowed(a: Scalar) -> Scalar {
            let a = a + 1;
            let b = a * a;
            let a = b - a;
            a
        }

        pub fn patterns(a: [Scalar; 2], b: (Scalar,), c: ([Scalar; 2], Scalar)) -> (Scalar, [Scalar; 2]) {
            let [x, y] = a;
            let ([z, _], w) = c;
            let (t, u, _) = (x + z, [y, w], b);
            (t * b.0, u)
        }

        pub fn elements(a: [RoundVector; 3], t: (Scalar, [[Scalar; 2]; 2])) -> RoundVector {
            a[0] * t.0 + a[1] * t.1[0][1] - a[2] * t.1[1].0
        }

        pub fn several(p: RoundVector, n: Scalar) -> ([RoundVector; 2], (Scalar, Origin), Scalar) {
            let twice = 2 * p;
            ([twice, n * p], (n - 1, eo), p.e3)
        }

        pub fn through_a_tuple(n: Scalar) -> Scalar {
            let (a, b) = pair(n);
            let both = pair(a - b);
            both.1 + pair(7)[0]
        }
        fn pair(n: Scalar) -> (Scalar, Scalar) { (n * n, n + 3) }

        pub fn arrays_handed_on(a: [Scalar; 3]) -> Scalar { sum([a[2], a[0], 1]) + sum(a) }
        fn sum(a: [Scalar; 3]) -> Scalar { a[0] + 10 * a[1] + 100 * a[2] }

        #[allow(non_snake_case)]
        /// Operands may have the names of blades, and of variables and items in emitted code.
        pub fn collisions(
            t0: Scalar, t5: Scalar, e1: Scalar, S: Scalar, closure: Scalar, result: Scalar, node0: Scalar,
            c0: Scalar, core: Scalar, function: Scalar, r#type: Scalar, sin: Scalar,
        ) -> [Scalar; 3] {
            let node1 = t0 * t5;
            let t1 = e1 * S + closure * result;
            let sum = node0 * c0 + core * function;
            [node1 - t1, sum * r#type, sin]
        }

        pub fn method_calls(a: Scalar, b: Scalar) -> Scalar { a.difference(b).difference(1) }
        fn difference(a: Scalar, b: Scalar) -> Scalar { a - b }

        pub fn precedence(a: Scalar, b: Scalar, c: Scalar) -> Scalar { -a * b - c - -b * 2 }

        pub fn checked(p: Point, q: Point) -> Line {
            let line: Line = p ^ q ^ ei;
            let _: Scalar = line | line;
            let (a, b): (Scalar, Scalar) = (2, 1);
            (a - b) * line
        }

        pub fn trailing(a: [Scalar; 1], ) -> (Scalar,) { (a[0],) }

        pub fn unused(a: Point, b: Scalar, c: [Line; 2]) -> Scalar {
            let unread = (a, c);
            b
        }

        pub fn constants() -> (Scalar, Infinity) { (6 / 3, ei) }

        pub fn copies(p: Point) -> [Point; 2] { [p, p] }
    }
}

#[test]
fn calls_are_copied_in_whatever_their_order() {
    let (a, b) = (point(2, 3, 5), point(7, 11, 13));
    // inner(x, y) = x.e1 · y.e2.
    let inner = |x: [i64; 2], y: [i64; 2]| x[0] * y[1];
    let truth = 2 * inner([7, 11], [2 - 7, 3 - 11]) + inner([7, 11], [2, 3]);
    assert_eq!(compiled::outer(a, b), truth);
    assert_eq!(compiled::method_calls(10, 4), 5);
    let pair = |n: i64| (n * n, n + 3);
    let (x, y) = pair(4);
    assert_eq!(compiled::through_a_tuple(4), pair(x - y).1 + 49);
    assert_eq!(compiled::arrays_handed_on([1, 2, 3]), 3 + 10 + 100 + 321);
}

#[test]
fn names_mean_the_last_binding() {
    assert_eq!(compiled::shadowed(4), 20);
    let numbers = compiled::collisions(2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37);
    assert_eq!(numbers, [6 - (35 + 143), (17 * 19 + 23 * 29) * 31, 37]);
}

#[test]
fn patterns_and_elements() {
    assert_eq!(compiled::patterns([1, 2], (3,), ([4, 5], 6)), (15, [2, 6]));
    let a = [point(1, 0, 0), point(0, 1, 0), point(0, 0, 1)];
    assert_eq!(
        compiled::elements(a, (2, [[3, 5], [7, 11]])),
        RoundVector::new(2, 5, -7, 2 + 5 - 7, 0)
    );
    let ([twice, scaled], (number, origin), z) = compiled::several(point(1, 2, 3), 4);
    assert_eq!(twice, RoundVector::new(2, 4, 6, 2, 0));
    assert_eq!(scaled, RoundVector::new(4, 8, 12, 4, 0));
    assert_eq!((number, origin, z), (3, ga_runtime::cga3::Origin, 3));
    assert_eq!(compiled::trailing([5]), (5,));
    assert_eq!(compiled::precedence(2, 3, 5), -6 - 5 + 6);
}

#[test]
fn operands_may_be_left_unread() {
    let line = Line::new(0, 0, 0, 0, 0, 0);
    assert_eq!(compiled::unused(Point::new(1, 2, 3), 8, [line; 2]), 8);
    let (two, infinity): (f64, Infinity) = compiled::constants();
    assert_eq!((two, infinity), (2.0, Infinity));
    let p = Point::new(1, 2, 3);
    assert_eq!(compiled::copies(p), [p, p]);
}

#[test]
fn annotations_do_not_change_values() {
    let (p, q) = (Point::new(1, 2, 3), Point::new(4, 6, 8));
    let direction = Line::through(p, q).direction();
    assert_eq!(compiled::checked(p, q).direction(), direction);
    assert_eq!(direction, [3, 4, 5]);
}

#[test]
fn closures_are_expressions() {
    let inner = ga! { ga_runtime::cga3; |p: Point, q: Point| -> Scalar { p | q } };
    assert_eq!(
        inner(Point::new(0.0, 0.0, 0.0), Point::new(3.0, 0.0, 4.0)),
        -12.5
    );
    let swapped =
        ga! { ga_runtime::cga3; |pair: (Scalar, Scalar)| -> (Scalar, Scalar) { (pair.1, pair.0) } };
    assert_eq!(swapped((1, 2)), (2, 1));
    let plane =
        ga! { ga_runtime::cga3; (a: Point, b: Point, c: Point) -> Plane { a ^ b ^ c ^ ei } };
    let [a, b, c] = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|[x, y, z]| Point::new(x, y, z));
    let found: Plane<i64> = plane(a, b, c);
    assert_eq!(found.e123i, 0);
    let applied = [1, 2, 3].map(ga! { ga_runtime::cga3; |n: Scalar| -> Scalar { n * n } });
    assert_eq!(applied, [1, 4, 9]);
    let nested: fn() -> f64 = ga! { ga_runtime::cga3; || -> Scalar { 3 } };
    assert_eq!(nested(), 3.0);
}
