//! cga3 declared again under other names and in another order of the basis, on neither of which the
//! geometry depends.

use ga_runtime::Element;
use ga_runtime::cga3;
use ga_runtime::scalar::Prime61;
use ga_runtime::testing::{exact_member, for_all};

ga_runtime::algebra! {
    /// Conformal geometry with the point at infinity first.
    mod conformal {
        basis nf, nz, nx, ny, nh;
        metric nh*nf = -1, nz*nz = 1, ny*ny = 1, nx*nx = 1;

        struct Across { nx = 1 }
        struct Along { ny = 1 }
        struct Up { nz = 1 }
        struct Here { nh = 1 }
        struct Far { nf = 1 }

        #[hull(Ball)]
        #[facts(null, weight(nh))]
        struct Place { nx, ny, nz, nh = 1, nf = (nx*nx + ny*ny + nz*nz)/2 }

        struct Ball { nx, ny, nz, nh, nf }

        struct Mirror { nx, ny, nz, nf }

        struct Pair { nxy, nxz, nyz, nxh, nyh, nzh, nxf, nyf, nzf, nhf }

        struct Flat { nxf, nyf, nzf, nhf }

        struct Arrow { nxf, nyf, nzf }

        struct Twist { nxy, nxz, nyz, nxf, nyf, nzf }

        struct Hoop { nxyz, nxyh, nxzh, nyzh, nxyf, nxzf, nyzf, nxhf, nyhf, nzhf }

        struct Axis { nxyf, nxzf, nyzf, nxhf, nyhf, nzhf }

        struct Globe { nxyzh, nxyzf, nxyhf, nxzhf, nyzhf }

        struct Sheet { nxyzf, nxyhf, nxzhf, nyzhf }

        struct Space { nxyzhf }

        #[hull(TurnSum)]
        #[facts(unit_versor)]
        struct Turn { scalar, nxy, nxz, nyz }

        #[hull(MotionSum)]
        #[facts(unit_versor)]
        struct Shift { scalar = 1, nxf, nyf, nzf }

        #[hull(MotionSum)]
        #[facts(unit_versor)]
        struct Motion { scalar, nxy, nxz, nyz, nxf, nyf, nzf, nxyzf }

        #[hull(EvenPart)]
        #[facts(unit_versor)]
        struct Zoom { scalar, nhf }

        #[hull(EvenPart)]
        #[facts(unit_versor)]
        struct Shape {
            scalar, nxy, nxz, nyz, nxf, nyf, nzf, nxyzf, nhf, nxyhf, nxzhf, nyzhf
        }

        struct TurnSum { scalar, nxy, nxz, nyz }

        struct MotionSum { scalar, nxy, nxz, nyz, nxf, nyf, nzf, nxyzf }

        struct EvenPart {
            scalar,
            nxy, nxz, nyz, nxh, nyh, nzh, nxf, nyf, nzf, nhf,
            nxyzh, nxyzf, nxyhf, nxzhf, nyzhf
        }

        struct Whole {
            scalar,
            nx, ny, nz, nh, nf,
            nxy, nxz, nyz, nxh, nyh, nzh, nxf, nyf, nzf, nhf,
            nxyz, nxyh, nxzh, nyzh, nxyf, nxzf, nyzf, nxhf, nyhf, nzhf,
            nxyzh, nxyzf, nxyhf, nxzhf, nyzhf,
            nxyzhf
        }

        products {
            wedge({Place, Ball}, {Place, Ball}) -> Pair;
            wedge(Pair, {Place, Ball}) -> Hoop;
            wedge({Place, Ball}, Pair) -> Hoop;
            wedge(Hoop, {Place, Ball}) -> Globe;
            wedge({Place, Ball}, Hoop) -> Globe;
            wedge({Globe, Sheet}, {Place, Ball}) -> Space;
            wedge({Place, Ball}, {Globe, Sheet}) -> Space;
            wedge(Pair, Pair) -> Globe;
            wedge(Pair, {Hoop, Axis}) -> Space;
            wedge({Hoop, Axis}, Pair) -> Space;
            wedge(Flat, {Place, Ball}) -> Axis;
            wedge({Place, Ball}, Flat) -> Axis;
            wedge({Place, Ball}, Arrow) -> Axis;
            wedge(Arrow, {Place, Ball}) -> Axis;
            wedge({Axis, Pair}, Flat) -> Sheet;
            wedge(Axis, {Place, Ball}) -> Sheet;
            wedge({Place, Ball}, Axis) -> Sheet;
            wedge(Mirror, Mirror) -> Twist;
            wedge({Place, Ball}, Far) -> Flat;
            wedge(Pair, Far) -> Axis;
            wedge(Hoop, Far) -> Sheet;
            wedge(Globe, Far) -> Space;

            wedge({Across, Along, Up, Here}, {Place, Ball}) -> Pair;
            wedge({Place, Ball}, {Across, Along, Up, Here}) -> Pair;
            wedge(Pair, {Across, Along, Up, Here}) -> Hoop;
            wedge(Hoop, {Across, Along, Up, Here}) -> Globe;
            wedge(Flat, {Across, Along, Up, Here}) -> Axis;
            wedge(Axis, {Across, Along, Up, Here}) -> Sheet;
            wedge(Far, {Place, Ball}) -> Flat;
            wedge(Far, Pair) -> Axis;
            wedge(Far, Hoop) -> Sheet;
            left_contraction({Across, Along, Up, Here}, {Place, Ball}) -> Scalar;
            left_contraction({Place, Ball}, {Across, Along, Up, Here, Far}) -> Scalar;

            vee({Globe, Sheet}, Globe) -> Hoop;
            vee(Globe, Sheet) -> Hoop;
            vee(Sheet, Sheet) -> Axis;
            vee({Globe, Sheet}, Hoop) -> Pair;
            vee(Hoop, {Globe, Sheet}) -> Pair;
            vee(Globe, Axis) -> Pair;
            vee(Axis, Globe) -> Pair;
            vee(Sheet, Axis) -> Flat;
            vee(Axis, Sheet) -> Flat;
            vee({Hoop, Axis}, {Hoop, Axis}) -> Ball;
            vee({Globe, Sheet}, {Place, Ball}) -> Scalar;
            vee({Place, Ball}, {Globe, Sheet}) -> Scalar;

            left_contraction({Place, Ball, Mirror}, {Place, Ball, Mirror}) -> Scalar;
            left_contraction({Place, Ball, Mirror}, Pair) -> Ball;
            left_contraction({Place, Ball, Mirror}, {Hoop, Axis}) -> Pair;
            left_contraction({Place, Ball, Mirror}, {Globe, Sheet}) -> Hoop;
            left_contraction({Place, Ball}, Space) -> Globe;
            left_contraction(Mirror, Space) -> Sheet;
            left_contraction(Pair, Pair) -> Scalar;
            left_contraction(Pair, {Hoop, Axis, Globe, Sheet}) -> Whole;
            left_contraction(Twist, Twist) -> Scalar;
            left_contraction({Hoop, Axis}, {Hoop, Axis}) -> Scalar;
            left_contraction({Hoop, Axis}, {Globe, Sheet}) -> Ball;
            left_contraction({Globe, Sheet}, {Globe, Sheet}) -> Scalar;
            left_contraction(Far, {Place, Ball}) -> Scalar;
            left_contraction(Far, Pair) -> Ball;
            left_contraction(Far, Hoop) -> Pair;
            left_contraction(Far, Axis) -> Arrow;
            left_contraction(Far, Globe) -> Hoop;
            right_contraction(Pair, {Place, Ball}) -> Ball;
            right_contraction({Hoop, Axis}, {Place, Ball}) -> Pair;
            right_contraction({Globe, Sheet}, {Place, Ball}) -> Hoop;
            scalar_product({Place, Ball, Mirror}, {Place, Ball, Mirror}) -> Scalar;
            scalar_product(Pair, Pair) -> Scalar;
            scalar_product(Flat, Flat) -> Scalar;
            scalar_product(Twist, Twist) -> Scalar;
            scalar_product(Hoop, {Hoop, Axis}) -> Scalar;
            scalar_product(Axis, {Hoop, Axis}) -> Scalar;
            scalar_product(Globe, {Globe, Sheet}) -> Scalar;
            scalar_product(Sheet, {Globe, Sheet}) -> Scalar;
            scalar_product(Whole, Whole) -> Scalar;

            dual({Place, Ball}) -> Globe;
            undual({Place, Ball}) -> Globe;
            dual(Mirror) -> Sheet;
            undual(Mirror) -> Sheet;
            dual({Pair, Flat}) -> Hoop;
            undual({Pair, Flat}) -> Hoop;
            dual(Twist) -> Axis;
            undual(Twist) -> Axis;
            dual(Hoop) -> Pair;
            undual(Hoop) -> Pair;
            dual(Axis) -> Twist;
            undual(Axis) -> Twist;
            dual(Globe) -> Ball;
            undual(Globe) -> Ball;
            dual(Sheet) -> Mirror;
            undual(Sheet) -> Mirror;
            dual(Space) -> Scalar;
            undual(Space) -> Scalar;
            dual(Whole) -> Whole;
            undual(Whole) -> Whole;

            geometric(Turn, Turn) -> Turn;
            geometric(Shift, Shift) -> Shift;
            geometric(Shift, Turn) -> Motion;
            geometric(Turn, Shift) -> Motion;
            geometric(Motion, {Turn, Shift, Motion}) -> Motion;
            geometric({Turn, Shift}, Motion) -> Motion;
            geometric(Zoom, Zoom) -> Zoom;
            geometric({Turn, Shift, Motion}, Zoom) -> Shape;
            geometric(Zoom, {Turn, Shift, Motion}) -> Shape;
            geometric(Shape, {Turn, Shift, Motion, Zoom, Shape}) -> Shape;
            geometric({Turn, Shift, Motion, Zoom}, Shape) -> Shape;
            geometric(TurnSum, TurnSum) -> TurnSum;
            geometric(MotionSum, MotionSum) -> MotionSum;
            geometric(Mirror, Mirror) -> MotionSum;
            geometric(Ball, Ball) -> EvenPart;
            geometric(Axis, Axis) -> MotionSum;
            geometric(Twist, Twist) -> MotionSum;
            geometric(EvenPart, EvenPart) -> EvenPart;
            geometric(Whole, Whole) -> Whole;

            commutator(Twist, Twist) -> Twist;
            commutator(Twist, Axis) -> Axis;
            commutator(Axis, Axis) -> Twist;
            commutator(Pair, Pair) -> Pair;
            commutator(Whole, Whole) -> Whole;

            wedge(Whole, Whole) -> Whole;
            left_contraction(Whole, Whole) -> Whole;
            right_contraction(Whole, Whole) -> Whole;
            vee(Whole, Whole) -> Whole;
            sandwich(Whole, Whole) -> Whole;

            sandwich(
                {Turn, Shift, Motion},
                {
                    Place, Ball, Mirror, Pair, Flat, Arrow, Twist, Hoop, Axis,
                    Globe, Sheet, Motion
                }
            ) -> Self;
            sandwich(
                {Zoom, Shape},
                {
                    Ball, Mirror, Pair, Flat, Arrow, Twist, Hoop, Axis, Globe, Sheet
                }
            ) -> Self;
            sandwich({Zoom, Shape}, Place) -> Ball;
            sandwich(EvenPart, Ball) -> Whole;
            sandwich(Mirror, {Ball, Mirror, Pair, Flat, Hoop, Axis, Globe, Sheet}) -> Self;
            sandwich(Ball, {Ball, Pair, Hoop, Globe}) -> Self;
            sandwich({Mirror, Ball}, Place) -> Ball;
        }
    }
}

mod products {
    ga_runtime::testing::product_tests!(super::conformal);
}

/// The vector of cga3 that corresponds to each vector here: f is ei, z is e3, x is e1, y is e2, h
/// is eo.
const VECTORS: [usize; 5] = [4, 2, 0, 1, 3];

/// An element of cga3 as the corresponding type here: blades go to blades, with a sign for the
/// order of their vectors.
fn translated<T: Element<Scalar = Prime61>, U: Element<Scalar = Prime61>>(element: T) -> U {
    U::from_coefficients_unchecked(&mut |blade| {
        let vectors: Vec<_> = (0..5)
            .filter(|bit| blade >> bit & 1 == 1)
            .map(|bit| VECTORS[bit])
            .collect();
        let there = vectors.iter().map(|vector| 1 << vector).sum();
        let swaps = (0..vectors.len())
            .map(|k| {
                vectors[k..]
                    .iter()
                    .filter(|later| **later < vectors[k])
                    .count()
            })
            .sum::<usize>();
        let value = element.coefficient(there);
        if swaps % 2 == 1 { -value } else { value }
    })
}

macro_rules! agrees {
    ($($test:ident: |$a:ident: $A:ident as $AA:ident, $b:ident: $B:ident as $BB:ident| $product:expr => $R:ident as $RR:ident;)*) => { $(
        #[test]
        fn $test() {
            for_all((exact_member::<cga3::$A<_>>(), exact_member::<cga3::$B<_>>()), |($a, $b)| {
                let expected: cga3::$R<Prime61> = $product;
                let ($a, $b): (conformal::$AA<Prime61>, conformal::$BB<Prime61>) =
                    (translated($a), translated($b));
                let result: conformal::$RR<Prime61> = $product;
                assert_eq!(result, translated(expected));
            });
        }
    )* };
}

agrees! {
    points_move: |m: Motor as Motion, x: Point as Place| m.transform(x) => Point as Place;
    circles_move: |m: Motor as Motion, x: Circle as Hoop| m.transform(x) => Circle as Hoop;
    planes_scale: |m: Similarity as Shape, x: Plane as Sheet| m.transform(x) => Plane as Sheet;
    mirrors_reflect: |m: DualPlane as Mirror, x: Sphere as Globe| m.sandwich(x) => Sphere as Globe;
    motions_compose: |a: Motor as Motion, b: Motor as Motion| a * b => Motor as Motion;
    points_join: |p: Point as Place, q: Point as Place| p ^ q => PointPair as Pair;
    spheres_meet: |a: Sphere as Globe, b: Sphere as Globe| a & b => Circle as Hoop;
    planes_and_lines_meet: |a: Plane as Sheet, b: Line as Axis| a & b => FlatPoint as Flat;
    lines_commute: |a: Line as Axis, b: Line as Axis| a.commutator(b) => MotorGenerator as Twist;
    duals_agree: |a: Line as Axis, _b: Circle as Hoop| a.dual() => MotorGenerator as Twist;
    motions_add: |a: Motor as Motion, b: Motor as Motion| a + b => DualQuaternion as MotionSum;
    points_subtract: |p: Point as Place, q: Point as Place| p - q => RoundVector as Ball;
    everything_multiplies: |a: Multivector as Whole, b: Multivector as Whole| a * b => Multivector as Whole;
}
