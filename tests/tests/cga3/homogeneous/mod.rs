//! 4×4 matrices and versors of the same transformations, compared with each other and with plain
//! coordinates: exactly over the prime field, and within a few rounding errors over floating point.

mod refused;

use ga_runtime::cga3::{
    Dilator, Direction, Infinity, Line, Motor, Plane, Point, Rotor, Similarity, Translator,
};
use ga_runtime::geometry::Affine;
use ga_runtime::geometry::homogeneous::{
    Matrix, product, rotation, rotation_about_axis, rotation_about_x, rotation_about_y,
    rotation_about_z, scaling, scaling_about, transform, translation,
};
use ga_runtime::scalar::{Prime61, Ring};
use ga_runtime::testing::{exact_member, for_all, strategy};
use nullcone_tests::plain::{largest, rotated, unit_of};
use proptest::prelude::*;

const EPSILON: f64 = f64::EPSILON;

fn vector() -> impl Strategy<Value = [f64; 3]> {
    [-10.0..10.0_f64, -10.0..10.0, -10.0..10.0]
}

fn axis() -> impl Strategy<Value = [f64; 3]> {
    vector().prop_filter("an axis", |axis| axis.iter().any(|x| x.abs() > 1e-3))
}

fn angle() -> impl Strategy<Value = f64> {
    -7.0..7.0_f64
}

fn primes() -> impl Strategy<Value = [Prime61; 3]> + Clone {
    [strategy::prime(), strategy::prime(), strategy::prime()]
}

/// The largest difference of two matrices.
fn deviation(a: Matrix<f64>, b: Matrix<f64>) -> f64 {
    let (a, b) = (a.into_iter().flatten(), b.into_iter().flatten());
    largest(a.zip(b).map(|(a, b)| a - b))
}

/// The image of a point in homogeneous coordinates.
fn applied<S: Ring>(matrix: Matrix<S>, [x, y, z]: [S; 3]) -> [S; 4] {
    matrix.map(|row| row[0] * x + row[1] * y + row[2] * z + row[3])
}

/// The rotation of p by an angle about an axis of any length.
fn turned(axis: [f64; 3], angle: f64, p: [f64; 3]) -> [f64; 3] {
    rotated(unit_of(axis), angle, p)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    Point::from(a).distance(Point::from(b))
}

#[test]
fn translations_agree_exactly() {
    for_all((primes(), primes()), |(t, x)| {
        let (matrix, versor) = (translation(t), Translator::from_displacement(t));
        let image = versor.transform(Point::from(x)).coordinates();
        assert_eq!(image, [x[0] + t[0], x[1] + t[1], x[2] + t[2]]);
        assert_eq!(
            applied(matrix, x),
            [image[0], image[1], image[2], Prime61::one()]
        );
        assert_eq!(versor.to_homogeneous(), matrix);
    });
    // Exact over floating point too, since halving and doubling are.
    let t = [0.1, 1e-300, -3e200];
    let versor = Translator::from_displacement(t);
    assert_eq!(versor.to_homogeneous(), translation(t));
    assert_eq!(Translator::from_homogeneous(translation(t)), Ok(versor));
}

/// Eq. 9 for a rotor with `cos ½θ = w` and `sin ½θ n = v`: `cos θ = 2w² − 1`, `sin θ n = 2wv`,
/// `(1 − cos θ) n nᵀ = 2 v vᵀ`.
#[test]
fn rotations_agree_exactly() {
    for_all(
        (exact_member::<Rotor<Prime61>>(), primes()),
        |(rotor, x)| {
            let matrix = rotor.to_homogeneous();
            let (two, one, zero) = (Prime61::from_integer(2), Prime61::one(), Prime61::zero());
            let ([a, b, c], w) = rotor.to_quaternion();
            let cosine = two * w * w - one;
            let sine = [a, b, c].map(|v| two * w * v);
            let square = |u: Prime61, v: Prime61| two * u * v;
            let expected = [
                [
                    square(a, a) + cosine,
                    square(a, b) - sine[2],
                    square(a, c) + sine[1],
                    zero,
                ],
                [
                    square(a, b) + sine[2],
                    square(b, b) + cosine,
                    square(b, c) - sine[0],
                    zero,
                ],
                [
                    square(a, c) - sine[1],
                    square(b, c) + sine[0],
                    square(c, c) + cosine,
                    zero,
                ],
                [zero, zero, zero, one],
            ];
            assert_eq!(matrix, expected);
            let image = rotor.transform(Point::from(x)).coordinates();
            assert_eq!(applied(matrix, x), [image[0], image[1], image[2], one]);
        },
    );
}

#[test]
fn motors_agree_exactly_and_compose_as_matrices_do() {
    let motors = exact_member::<Motor<Prime61>>;
    for_all((motors(), motors(), primes()), |(a, b, x)| {
        let image = a.transform(Point::from(x)).coordinates();
        let [p, q, r, w] = applied(a.to_homogeneous(), x);
        assert_eq!((image, w), ([p, q, r], Prime61::one()));
        assert_eq!(
            (a * b).to_homogeneous(),
            product(a.to_homogeneous(), b.to_homogeneous())
        );
        assert_eq!(
            transform(a.to_homogeneous(), Point::from(x)),
            Some(Point::from(image))
        );
    });
}

#[test]
fn uneven_scalings_act_on_each_coordinate() {
    for_all((primes(), primes(), primes()), |(s, c, x)| {
        let [p, q, r, _] = applied(scaling(s), x);
        assert_eq!([p, q, r], [s[0] * x[0], s[1] * x[1], s[2] * x[2]]);
        let [p, q, r, w] = applied(scaling_about(Point::from(c), s), x);
        let expected = [0, 1, 2].map(|k| c[k] + s[k] * (x[k] - c[k]));
        assert_eq!(([p, q, r], w), (expected, Prime61::one()));
        let there_and_back = product(
            translation(c),
            product(scaling(s), translation(c.map(|x| -x))),
        );
        assert_eq!(scaling_about(Point::from(c), s), there_and_back);
    });
}

/// Powers of four have exact square roots, so that nothing is rounded.
#[test]
fn scalings_by_powers_of_four_agree_to_the_bit() {
    for factor in [1.0 / 64.0, 0.25, 1.0, 4.0, 1024.0] {
        let dilator = Dilator::from_factor(factor).unwrap();
        assert_eq!(dilator.to_homogeneous(), scaling([factor; 3]));
        assert_eq!(Dilator::from_homogeneous(scaling([factor; 3])), Ok(dilator));
        let centre = Point::new(1.0, -2.0, 8.0);
        let matrix = scaling_about(centre, [factor; 3]);
        assert_eq!(dilator.about(centre).to_homogeneous(), matrix, "{factor}");
        let image = dilator
            .about(centre)
            .transform(Point::new(2.0, 4.0, -1.0))
            .centre();
        assert_eq!(
            image,
            transform(matrix, Point::new(2.0, 4.0, -1.0)),
            "{factor}"
        );
    }
}

#[test]
fn quarters_about_the_axes_go_the_right_way() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let images = [
        (
            rotation_about_x(quarter),
            Rotor::about_x(quarter),
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        ),
        (
            rotation_about_y(quarter),
            Rotor::about_y(quarter),
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
        ),
        (
            rotation_about_z(quarter),
            Rotor::about_z(quarter),
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
        ),
    ];
    for (matrix, rotor, from, to) in images {
        let image = transform(matrix.unwrap(), Point::from(from)).unwrap();
        assert!(distance(image.coordinates(), to) < EPSILON);
        let image = rotor.unwrap().transform(Point::from(from));
        assert!(distance(image.coordinates(), to) < 2.0 * EPSILON);
    }
}

proptest! {
    #[test]
    fn rotations_about_axes_agree(angle in angle(), p in vector()) {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (matrix, rotor, axis) in [
            (rotation_about_x(angle), Rotor::about_x(angle), x),
            (rotation_about_y(angle), Rotor::about_y(angle), y),
            (rotation_about_z(angle), Rotor::about_z(angle), z),
        ] {
            let (matrix, rotor) = (matrix.unwrap(), rotor.unwrap());
            let [a, b, c, w] = applied(matrix, p);
            prop_assert!(distance([a, b, c], turned(axis, angle, p)) < 4.0 * EPSILON * 20.0);
            prop_assert_eq!(w, 1.0);
            prop_assert!(deviation(rotation(axis, angle).unwrap(), matrix) <= EPSILON);
            prop_assert!(deviation(rotor.to_homogeneous(), matrix) <= 2.0 * EPSILON);
            let found = Rotor::from_homogeneous(matrix).unwrap();
            prop_assert!(deviation(found.to_homogeneous(), matrix) <= 4.0 * EPSILON);
            let same = found.scalar() * rotor.scalar() + found.e12() * rotor.e12() + found.e13() * rotor.e13() + found.e23() * rotor.e23();
            prop_assert!(same.abs() > 1.0 - 4.0 * EPSILON);
        }
    }

    #[test]
    fn rotations_about_any_axis_agree(axis in axis(), angle in angle(), centre in vector(), p in vector()) {
        let rotor = Rotor::from_axis_angle(axis, angle).unwrap();
        let matrix = rotation(axis, angle).unwrap();
        let [a, b, c, _] = applied(matrix, p);
        prop_assert!(distance([a, b, c], turned(axis, angle, p)) < 8.0 * EPSILON * 20.0);
        prop_assert!(deviation(rotor.to_homogeneous(), matrix) <= 6.0 * EPSILON);

        let motor = Motor::about_axis(Point::from(centre), axis, angle).unwrap();
        let matrix = rotation_about_axis(Point::from(centre), axis, angle).unwrap();
        let from_centre = [0, 1, 2].map(|k| p[k] - centre[k]);
        let turned = turned(axis, angle, from_centre);
        let image = [0, 1, 2].map(|k| turned[k] + centre[k]);
        let [a, b, c, _] = applied(matrix, p);
        prop_assert!(distance([a, b, c], image) < 16.0 * EPSILON * 60.0);
        prop_assert!(distance(motor.transform(Point::from(p)).coordinates(), image) < 16.0 * EPSILON * 60.0);
        prop_assert!(deviation(motor.to_homogeneous(), matrix) <= 16.0 * EPSILON * 40.0);
        let found = Motor::from_homogeneous(matrix).unwrap();
        prop_assert!(deviation(found.to_homogeneous(), matrix) <= 16.0 * EPSILON * 40.0);
    }

    #[test]
    fn scalings_agree(exponent in -9.0..9.0_f64, centre in vector(), p in vector()) {
        let factor = 10.0_f64.powf(exponent);
        let dilator = Dilator::from_factor(factor).unwrap();
        prop_assert!(deviation(dilator.to_homogeneous(), scaling([factor; 3])) <= 8.0 * EPSILON * factor);
        let found = Dilator::from_homogeneous(scaling([factor; 3])).unwrap();
        prop_assert!((found.factor() - factor).abs() <= 8.0 * EPSILON * factor);

        let similarity = dilator.about(Point::from(centre));
        let matrix = scaling_about(Point::from(centre), [factor; 3]);
        let expected = [0, 1, 2].map(|k| centre[k] + factor * (p[k] - centre[k]));
        let [a, b, c, _] = applied(matrix, p);
        let size = 40.0 * (factor + 1.0);
        prop_assert!(distance([a, b, c], expected) <= 4.0 * EPSILON * size);
        prop_assert!(deviation(similarity.to_homogeneous(), matrix) <= 8.0 * EPSILON * size);
        let found = Similarity::from_homogeneous(matrix).unwrap();
        prop_assert!(deviation(found.to_homogeneous(), matrix) <= 16.0 * EPSILON * size);
    }

    #[test]
    fn similarities_compose_as_matrices_do(
        turns in [axis(), axis()], angles in [angle(), angle()], shifts in [vector(), vector()], exponents in [-2.0..2.0_f64, -2.0..2.0],
    ) {
        let [a, b] = [0, 1].map(|k| {
            let turn = Rotor::from_axis_angle(turns[k], angles[k]).unwrap();
            let dilator = Dilator::from_factor(10.0_f64.powf(exponents[k])).unwrap();
            Translator::from_displacement(shifts[k]) * turn * dilator
        });
        let matrix = product(a.to_homogeneous(), b.to_homogeneous());
        let composed: Similarity<f64> = a * b;
        let factor = 10.0_f64.powf(exponents[0]);
        // The coefficients of a product of scalings against one another cancel as cosh and sinh do.
        let conditioning = (factor + factor.recip()) * (10.0_f64.powf(exponents[1]) + 10.0_f64.powf(-exponents[1]));
        let size = 20.0 * (1.0 + factor) * conditioning;
        prop_assert!(deviation(composed.to_homogeneous(), matrix) <= 16.0 * EPSILON * size);
    }

    #[test]
    fn affine_maps_undo_themselves(rows in [vector(), vector(), vector()], t in vector(), p in vector()) {
        let map = Affine::new(rows, t);
        prop_assume!(map.determinant().abs() > 1.0);
        let inverse = map.inverse().unwrap();
        let back = inverse.transform(map.transform(Point::from(p)));
        // The condition number is at most the product of both norms.
        let norm = |rows: [[f64; 3]; 3]| rows.into_iter().flatten().fold(0.0, |sum: f64, x| sum + x * x).sqrt();
        let condition = norm(rows) * norm(inverse.linear);
        prop_assert!(distance(back.coordinates(), p) < 1e-14 * condition * (1.0 + condition));
        prop_assert!(deviation((inverse * map).to_homogeneous(), Affine::default().to_homogeneous()) < 1e-14 * condition * (1.0 + condition));
    }
}

/// Maps respect spans: the span of the images is the image of the span.
#[test]
fn affine_maps_respect_spans() {
    type P = Point<Prime61>;
    let maps = ([primes(), primes(), primes()], primes());
    let points = [primes(), primes(), primes()];
    for_all((maps, points, primes()), |((rows, t), points, v)| {
        let map = Affine::new(rows, t);
        let [p, q, r] = points.map(P::from);
        let [p1, q1, r1] = [p, q, r].map(|point| map.transform(point));
        for (point, image) in [(p, p1), (q, q1)] {
            let x = point.coordinates();
            let [a, b, c, w] = applied(map.to_homogeneous(), x);
            assert_eq!((image.coordinates(), w), ([a, b, c], Prime61::one()));
        }
        let direction = Direction::new(v[0], v[1], v[2]);
        let tip = P::new(p.e1() + v[0], p.e2() + v[1], p.e3() + v[2]);
        let moved = map.transform_direction(direction);
        let tip = map.transform(tip).coordinates();
        let expected = [0, 1, 2].map(|k| tip[k] - p1.coordinates()[k]);
        assert_eq!([moved.e1i, moved.e2i, moved.e3i], expected);

        let line: Line<Prime61> = p ^ q ^ Infinity;
        assert_eq!(map.transform_line(line), p1 ^ q1 ^ Infinity);
        let plane: Plane<Prime61> = p ^ q ^ r ^ Infinity;
        assert_eq!(map.transform_plane(plane), p1 ^ q1 ^ r1 ^ Infinity);
    });
}

/// The image of a unit cube has the determinant for its volume, and maps multiply as matrices do.
#[test]
fn affine_maps_compose() {
    let maps =
        || ([primes(), primes(), primes()], primes()).prop_map(|(rows, t)| Affine::new(rows, t));
    for_all((maps(), maps(), primes()), |(a, b, x)| {
        let x = Point::from(x);
        assert_eq!((a * b).transform(x), a.transform(b.transform(x)));
        assert_eq!(
            (a * b).to_homogeneous(),
            product(a.to_homogeneous(), b.to_homogeneous())
        );
        assert_eq!((a * b).determinant(), a.determinant() * b.determinant());
        assert_eq!(a * Affine::default(), a);
        assert_eq!(Affine::default() * a, a);
        assert_eq!(Affine::from_homogeneous(a.to_homogeneous()), Ok(a));
    });
}

#[test]
fn inverses_stay_within_the_range() {
    for size in [1e-200, 1e-100, 1.0, 1e100, 1e200] {
        let map = Affine::scaling([size, 2.0 * size, 4.0 * size]);
        let inverse = map.inverse().expect("a regular map");
        let expected = Affine::scaling([1.0, 0.5, 0.25].map(|x| x / size));
        assert!(
            deviation(inverse.to_homogeneous(), expected.to_homogeneous()) <= 4.0 * EPSILON / size
        );
    }
    let singular: [[[f64; 3]; 3]; 4] = [
        [[0.0; 3]; 3],
        [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.0, 0.0, 1.0]],
        [[f64::NAN, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[f64::INFINITY, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    ];
    for rows in singular {
        assert_eq!(Affine::new(rows, [0.0; 3]).inverse(), None, "{rows:?}");
    }
    assert_eq!(
        Affine::from_translation([f64::NAN, 0.0, 0.0]).inverse(),
        None
    );
    // The inverse of the translation is beyond the range.
    assert_eq!(
        Affine::new(
            [[1e-300, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            [1e300, 0.0, 0.0]
        )
        .inverse(),
        None
    );
}
