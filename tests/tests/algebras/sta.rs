//! Events, velocities, fields and Lorentz transformations of sta, compared with matrices and
//! textbook formulas.

use std::f64::consts::PI;

use ga_runtime::geometry::{relative_velocity, velocity_sum};
use ga_runtime::sta::{Bivector, Rotor, Vector as Event};
use nullcone_tests::plain::{
    Vector, cross, dot, length, minus, near_all, plus, rotated, times, unit, vector,
};
use proptest::prelude::*;

type Matrix = [[f64; 4]; 4];

const ONE: Matrix = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

fn product(a: Matrix, b: Matrix) -> Matrix {
    a.map(|row| [0, 1, 2, 3].map(|column| (0..4).map(|k| row[k] * b[k][column]).sum()))
}

fn flat(a: Matrix) -> [f64; 16] {
    let mut all = [0.0; 16];
    for (to, from) in all.iter_mut().zip(a.iter().flatten()) {
        *to = *from;
    }
    all
}

fn largest(a: Matrix) -> f64 {
    a.iter().flatten().fold(0.0, |most, x| most.max(x.abs()))
}

/// The matrix exponential by the Taylor series of a / 2¹⁰, squared ten times.
fn exponential(a: Matrix) -> Matrix {
    let small = a.map(|row| row.map(|x| x / 1024.0));
    let (mut sum, mut term) = (ONE, ONE);
    for k in 1..=16 {
        term = product(term, small).map(|row| row.map(|x| x / f64::from(k)));
        for (to, from) in sum.iter_mut().flatten().zip(term.iter().flatten()) {
            *to += from;
        }
    }
    for _ in 0..10 {
        sum = product(sum, sum);
    }
    sum
}

/// The boost that takes a clock at rest to the velocity v.
fn boost_matrix(v: Vector) -> Matrix {
    let square = dot(v, v);
    let gamma = 1.0 / (1.0 - square).sqrt();
    let mut matrix = ONE;
    matrix[0][0] = gamma;
    for i in 0..3 {
        matrix[0][i + 1] = gamma * v[i];
        matrix[i + 1][0] = gamma * v[i];
        for j in 0..3 {
            if square > 0.0 {
                matrix[i + 1][j + 1] += (gamma - 1.0) * v[i] * v[j] / square;
            }
        }
    }
    matrix
}

/// The matrix of `x ↦ F x − x F`: twice the Lorentz force of the fields E and B.
fn generator_matrix(e: Vector, b: Vector) -> Matrix {
    let [ex, ey, ez] = e.map(|x| 2.0 * x);
    let [bx, by, bz] = b.map(|x| 2.0 * x);
    [
        [0.0, ex, ey, ez],
        [ex, 0.0, bz, -by],
        [ey, -bz, 0.0, bx],
        [ez, by, -bx, 0.0],
    ]
}

fn coefficients(r: Rotor<f64>) -> [f64; 8] {
    [
        r.scalar(),
        r.g10(),
        r.g20(),
        r.g30(),
        r.g32(),
        r.g13(),
        r.g21(),
        r.g0123(),
    ]
}

fn components(x: Event<f64>) -> [f64; 4] {
    [x.g0, x.g1, x.g2, x.g3]
}

fn velocity() -> impl Strategy<Value = Vector> + Clone {
    (unit(), 0.0..0.99_f64).prop_map(|(direction, speed)| times(direction, speed))
}

proptest! {
    #[test]
    fn boosts_are_those_of_textbooks(v in velocity(), t in -5.0..5.0_f64, x in vector(5.0)) {
        let boost = Rotor::from_velocity(v).unwrap();
        near_all(flat(boost.to_matrix()), flat(boost_matrix(v)), 1e-12);
        near_all(boost.velocity(), v, 1e-14);
        let event = Event::from_time_place(t, x);
        let image = boost.transform(event);
        let gamma = boost_matrix(v)[0][0];
        near_all([image.time()], [gamma * (t + dot(v, x))], 1e-12);
        near_all([image.interval_squared()], [t * t - dot(x, x)], 1e-10);
        near_all(components(Event::from_velocity(v).unwrap()), boost_matrix(v).map(|row| row[0]), 1e-12);
        // By rapidity.
        prop_assume!(length(v) > 0.01);
        let again = Rotor::from_rapidity(times(v, 3.0), length(v).atanh()).unwrap();
        near_all(coefficients(again), coefficients(boost), 1e-13);
        let rapidity = Event::from_velocity(v).unwrap().rapidity().unwrap();
        near_all([rapidity], [length(v).atanh()], 1e-13);
        near_all(Event::from_velocity(v).unwrap().velocity().unwrap(), v, 1e-15);
    }

    #[test]
    fn rotations_do_not_change_time(axis in unit(), angle in -7.0..7.0_f64, t in -5.0..5.0_f64, x in vector(5.0)) {
        let turn = Rotor::from_axis_angle(times(axis, 2.0), angle).unwrap();
        let image = turn.transform(Event::from_time_place(t, x));
        near_all([image.time()], [t], 1e-14);
        near_all(image.place(), rotated(axis, angle, x), 1e-13);
    }

    #[test]
    fn velocities_add_as_boosts_do(u in velocity(), v in velocity()) {
        let both = product(boost_matrix(u), boost_matrix(v));
        let expected = [1, 2, 3].map(|k| both[k][0] / both[0][0]);
        near_all(velocity_sum(u, v).unwrap(), expected, 1e-12);
        let rotor = Rotor::from_velocity(u).unwrap() * Rotor::from_velocity(v).unwrap();
        near_all(rotor.velocity(), expected, 1e-12);
        prop_assert!(length(velocity_sum(u, v).unwrap()) <= 1.0);
        // The relative velocity undoes the sum.
        let again = velocity_sum(u, relative_velocity(u, v).unwrap()).unwrap();
        near_all(again, v, 1e-9);
    }

    #[test]
    fn every_rotor_is_a_rotation_and_then_a_boost(u in velocity(), v in velocity(), axis in unit(), angle in -3.0..3.0_f64) {
        let rotor = Rotor::from_velocity(u).unwrap()
            * Rotor::from_axis_angle(axis, angle).unwrap()
            * Rotor::from_velocity(v).unwrap();
        let (boost, turn) = rotor.boost_and_rotation();
        let size = largest(rotor.to_matrix());
        near_all(coefficients(boost * turn), coefficients(rotor), 1e-13 * size);
        let rest = turn.transform(Event::from_time_place(1.0, [0.0; 3]));
        near_all(components(rest), [1.0, 0.0, 0.0, 0.0], 1e-14);
        near_all(boost.velocity(), rotor.velocity(), 1e-12 * size);
        // A boost has a symmetric matrix.
        let matrix = boost.to_matrix();
        near_all([matrix[0][1], matrix[1][2]], [matrix[1][0], matrix[2][1]], 1e-13 * size);
    }

    #[test]
    fn fields_change_as_maxwell_and_lorentz_say(e in vector(3.0), b in vector(3.0), v in velocity()) {
        let field = Bivector::from_fields(e, b);
        let seen = field.seen_from(v).unwrap();
        let gamma = 1.0 / (1.0 - dot(v, v)).sqrt();
        let along = |x: Vector| times(v, gamma * gamma / (gamma + 1.0) * dot(v, x));
        let electric = minus(times(plus(e, cross(v, b)), gamma), along(e));
        let magnetic = minus(times(minus(b, cross(v, e)), gamma), along(b));
        near_all(seen.electric(), electric, 1e-12 * gamma);
        near_all(seen.magnetic(), magnetic, 1e-12 * gamma);
        let (first, second) = field.invariants();
        near_all([first, second], [dot(e, e) - dot(b, b), dot(e, b)], 1e-13);
        let (third, fourth) = seen.invariants();
        near_all([third, fourth], [first, second], 1e-11 * gamma * gamma);
        // The force on a moving charge, γ (E·v, E + v × B).
        let force = field.commutator(Event::from_velocity(v).unwrap());
        near_all([force.time() / gamma], [dot(e, v)], 1e-13);
        near_all(times(force.place(), 1.0 / gamma), plus(e, cross(v, b)), 1e-13);
    }

    #[test]
    fn exponentials_are_those_of_matrices(e in vector(1.5), b in vector(1.5), scale in prop::sample::select(&[1.0, 1e-3, 1e-9])) {
        let (e, b) = (times(e, scale), times(b, scale));
        let rotor = Bivector::from_fields(e, b).exp().unwrap();
        let expected = exponential(generator_matrix(e, b));
        near_all(flat(rotor.to_matrix()), flat(expected), 1e-12 * largest(expected));
        let half = Bivector::from_fields(times(e, 0.5), times(b, 0.5)).exp().unwrap();
        near_all(coefficients(half * half), coefficients(rotor), 1e-13 * largest(expected));
    }

    #[test]
    fn logarithms_survive_a_round_trip(e in vector(2.0), b in vector(2.0), sign in prop::sample::select(&[1.0, -1.0])) {
        let plus = Bivector::from_fields(e, b).exp().unwrap();
        let rotor = if sign < 0.0 { -plus } else { plus };
        let log = rotor.log().unwrap();
        let again = log.exp().unwrap();
        // Near −1 and near null bivectors F is determined by small numbers.
        let sine = (rotor.scalar() + 1.0).hypot(rotor.g0123());
        let size = largest(rotor.to_matrix());
        near_all(coefficients(again), coefficients(rotor), 1e-12 * size * (1.0 + 1.0 / sine));
    }

    #[test]
    fn proper_times_are_those_at_rest(v in velocity(), tau in 0.001..1e3_f64) {
        let gamma = 1.0 / (1.0 - dot(v, v)).sqrt();
        let path = Event::from_time_place(gamma * tau, times(v, gamma * tau));
        near_all([path.proper_time().unwrap() / tau], [1.0], 1e-12);
        near_all([(-path).proper_time().unwrap() / tau], [-1.0], 1e-12);
        prop_assert_eq!(path.proper_distance().is_none(), true);
        let across = Event::from_time_place(times(v, gamma)[0].abs(), [gamma * 1.0, 0.0, 0.0]);
        let expected = (gamma * gamma - across.time() * across.time()).sqrt();
        near_all([across.proper_distance().unwrap()], [expected], 1e-12 * gamma);
    }
}

#[test]
fn small_and_null_generators_keep_their_digits() {
    for size in [1e-300, 1e-160, 1e-20, 1e-9, 1e-4, 0.3] {
        for (e, b) in [
            ([size, 0.0, 0.0], [0.0; 3]),
            ([0.0; 3], [0.0, size, 0.0]),
            // A plane wave: null.
            ([size, 0.0, 0.0], [0.0, size, 0.0]),
            ([size, 0.0, 0.0], [2.0 * size, size, 0.0]),
        ] {
            let field = Bivector::from_fields(e, b);
            let log = field.exp().unwrap().log().unwrap();
            near_all(log.electric(), e, 2e-15 * size);
            near_all(log.magnetic(), b, 2e-15 * size);
        }
    }
    let wave = Bivector::from_fields([2.0, 0.0, 0.0], [0.0, 2.0, 0.0]);
    near_all(
        coefficients(wave.exp().unwrap()),
        [1.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0],
        0.0,
    );
}

#[test]
fn minus_one_has_a_logarithm_and_minus_a_null_rotor_has_none() {
    let one = Rotor::<f64>::default();
    assert_eq!(one.log(), Some(Bivector::default()));
    let turn = (-one).log().unwrap();
    assert_eq!(turn.magnetic(), [0.0, 0.0, PI]);
    near_all(coefficients(turn.exp().unwrap()), coefficients(-one), 1e-15);
    let wave = Bivector::from_fields([2.0, 0.0, 0.0], [0.0, 2.0, 0.0])
        .exp()
        .unwrap();
    assert_eq!((-wave).log(), None);
    // The negative of a boost includes a full rotation.
    let boost = Rotor::from_rapidity([1.0, 0.0, 0.0], 1.0).unwrap();
    let log = (-boost).log().unwrap();
    near_all(
        coefficients(log.exp().unwrap()),
        coefficients(-boost),
        1e-15,
    );
}

#[test]
fn nothing_reaches_the_speed_of_light() {
    for bad in [
        [1.0, 0.0, 0.0],
        [0.8, 0.8, 0.0],
        [f64::NAN, 0.0, 0.0],
        [0.0, f64::INFINITY, 0.0],
    ] {
        assert!(Rotor::from_velocity(bad).is_err());
        assert!(Event::from_velocity(bad).is_err());
        assert!(
            Bivector::from_fields([1.0; 3], [0.0; 3])
                .seen_from(bad)
                .is_err()
        );
        assert!(velocity_sum(bad, [0.5, 0.0, 0.0]).is_err());
        assert!(velocity_sum([0.5, 0.0, 0.0], bad).is_err());
        assert!(relative_velocity(bad, [0.5, 0.0, 0.0]).is_err());
        assert!(relative_velocity([0.5, 0.0, 0.0], bad).is_err());
    }
    // The error names the velocity as it was given.
    let error = relative_velocity([2.0, 0.0, 0.0], [0.5, 0.0, 0.0]).unwrap_err();
    assert_eq!(error.velocity, [2.0, 0.0, 0.0]);
    assert_eq!(
        error.to_string(),
        "the velocity [2, 0, 0] is not slower than light, which has velocity 1"
    );
    let fast = 1.0 - f64::EPSILON;
    assert!(
        Rotor::from_velocity([fast, 0.0, 0.0])
            .unwrap()
            .scalar()
            .is_finite()
    );
}

#[test]
fn numbers_that_are_not_finite_give_none() {
    let light = Event::from_time_place(2.0, [2.0, 0.0, 0.0]);
    assert_eq!(light.proper_time(), Some(0.0));
    assert_eq!(light.proper_distance(), Some(0.0));
    assert_eq!(light.rapidity(), None);
    assert_eq!(light.velocity(), Some([1.0, 0.0, 0.0]));
    assert_eq!(light.interval_squared(), 0.0);
    assert_eq!(
        Event::from_time_place(0.0, [0.0; 3]).velocity(),
        None::<[f64; 3]>
    );
    assert_eq!(
        Event::from_time_place(1.0, [2.0, 0.0, 0.0]).velocity(),
        None
    );
    assert_eq!(
        Event::from_time_place(3e200, [0.0; 3]).proper_time(),
        Some(3e200)
    );
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for event in [
            Event::from_time_place(bad, [0.0; 3]),
            Event::from_time_place(1.0, [0.0, bad, 0.0]),
        ] {
            assert_eq!(event.proper_time(), None);
            assert_eq!(event.proper_distance(), None);
            assert_eq!(event.velocity(), None);
            assert_eq!(event.rapidity(), None);
        }
        assert_eq!(Rotor::from_rapidity([1.0, 0.0, 0.0], bad), None);
        assert_eq!(Rotor::from_rapidity([bad, 0.0, 0.0], 1.0), None);
        assert_eq!(Rotor::from_axis_angle([1.0, 0.0, 0.0], bad), None);
        assert_eq!(Rotor::from_axis_angle([0.0, bad, 0.0], 1.0), None);
        for place in 0..6 {
            let mut numbers = [0.25; 6];
            numbers[place] = bad;
            let [a, b, c, d, e, f] = numbers;
            assert_eq!(Bivector::new(a, b, c, d, e, f).exp(), None);
            assert_eq!(Rotor::new_unchecked(1.0, a, b, c, d, e, f, 0.0).log(), None);
        }
        assert_eq!(
            Rotor::new_unchecked(bad, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0).log(),
            None
        );
        assert_eq!(
            Rotor::new_unchecked(1.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, bad).log(),
            None
        );
    }
    assert_eq!(Rotor::<f64>::from_rapidity([0.0; 3], 1.0), None);
    assert_eq!(Rotor::from_rapidity([1.0, 0.0, 0.0], 2000.0), None);
    assert_eq!(
        Bivector::from_fields([1000.0, 0.0, 0.0], [0.0; 3]).exp(),
        None
    );
}
