//! Lorentz transformations of sta as matrices, and interpolation between them.

use std::f64::consts::PI;

use ga_runtime::geometry::NotLorentz;
use ga_runtime::sta::{Bivector, Rotor, Vector as Event};
use nullcone_tests::plain::{near, near_all, unit, vector};
use proptest::prelude::*;

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

fn size(r: Rotor<f64>) -> f64 {
    coefficients(r)
        .iter()
        .fold(1.0_f64, |most, x| most.max(x.abs()))
}

/// The sign for which the first large coefficient is positive.
fn apart(a: Rotor<f64>, b: Rotor<f64>) -> f64 {
    let off = |sign: f64| {
        let pairs = coefficients(a).into_iter().zip(coefficients(b));
        pairs.fold(0.0_f64, |most, (x, y)| most.max((x - sign * y).abs()))
    };
    off(1.0).min(off(-1.0))
}

fn rotors(rapidity: f64) -> impl Strategy<Value = Rotor<f64>> {
    (unit(), -rapidity..rapidity, unit(), -PI..PI).prop_map(|(v, rapidity, axis, angle)| {
        let boost = Rotor::from_rapidity(v, rapidity).expect("a boost");
        boost * Rotor::from_axis_angle(axis, angle).expect("an axis")
    })
}

type Complex = [f64; 2];
type Spinor = [[Complex; 2]; 2];

fn times(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn product(a: Spinor, b: Spinor) -> Spinor {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (x, y) = (times(a[i][0], b[0][j]), times(a[i][1], b[1][j]));
            [x[0] + y[0], x[1] + y[1]]
        })
    })
}

fn adjoint(a: Spinor) -> Spinor {
    std::array::from_fn(|i| std::array::from_fn(|j| [a[j][i][0], -a[j][i][1]]))
}

/// `[t + z, x − i y; x + i y, t − z]`.
fn hermitian([t, x, y, z]: [f64; 4]) -> Spinor {
    [[[t + z, 0.0], [x, -y]], [[x, y], [t - z, 0.0]]]
}

fn entries(a: Spinor) -> [f64; 8] {
    std::array::from_fn(|k| a[k / 4][k / 2 % 2][k % 2])
}

proptest! {
    #[test]
    fn matrices_determine_rotors_up_to_sign(rotor in rotors(12.0)) {
        let again = Rotor::from_matrix(rotor.to_matrix()).unwrap();
        // The matrix has entries of the size of the Lorentz factor, so it knows no more.
        let gamma = rotor.to_matrix()[0][0];
        prop_assert!(apart(again, rotor) < 4e-15 * gamma * size(rotor), "{again} {rotor}");
        // The rotation of the one that is chosen is by at most π.
        let (_, rotation) = again.boost_and_rotation();
        prop_assert!(rotation.scalar() > -1e-12);
    }

    #[test]
    fn other_matrices_are_refused(rotor in rotors(3.0), off in 1e-3..1.0_f64, place in 0..16_usize) {
        let matrix = rotor.to_matrix();
        let mut mirrored = matrix;
        mirrored[3] = mirrored[3].map(|x| -x);
        prop_assert_eq!(Rotor::from_matrix(mirrored), Err(NotLorentz::ReversesSpace));
        let mut back = matrix;
        back[0] = back[0].map(|x| -x);
        prop_assert_eq!(Rotor::from_matrix(back), Err(NotLorentz::ReversesTime));
        let all = matrix.map(|row| row.map(|x| -x));
        prop_assert_eq!(Rotor::from_matrix(all), Err(NotLorentz::ReversesTime));
        let scaled = matrix.map(|row| row.map(|x| x * (1.0 + off)));
        prop_assert_eq!(Rotor::from_matrix(scaled), Err(NotLorentz::ChangesIntervals));
        let mut bad = matrix;
        bad[place / 4][place % 4] += off;
        prop_assert!(Rotor::from_matrix(bad).is_err());
        bad[place / 4][place % 4] = f64::NAN;
        prop_assert_eq!(Rotor::from_matrix(bad), Err(NotLorentz::NotFinite));
    }

    /// Products, action and determinant of spinor matrices.
    #[test]
    fn spinor_matrices_multiply_and_act_as_rotors_do(a in rotors(2.0), b in rotors(2.0), t in -3.0..3.0_f64, x in vector(3.0)) {
        let (m, n) = (a.to_sl2c(), b.to_sl2c());
        near_all(entries((a * b).to_sl2c()), entries(product(m, n)), 1e-12 * size(a) * size(b));
        let image = a.transform(Event::from_time_place(t, x));
        let [x, y, z] = x;
        let acted = product(product(m, hermitian([t, x, y, z])), adjoint(m));
        let expected = hermitian([image.g0, image.g1, image.g2, image.g3]);
        near_all(entries(acted), entries(expected), 1e-11 * size(a).powi(2));
        let (ad, bc) = (times(m[0][0], m[1][1]), times(m[0][1], m[1][0]));
        near_all([ad[0] - bc[0], ad[1] - bc[1]], [1.0, 0.0], 1e-12 * size(a).powi(2));
        near_all(coefficients(Rotor::from_sl2c(m).unwrap()), coefficients(a), 1e-15 * size(a));
        let doubled = m.map(|row| row.map(|x| x.map(|x| 2.0 * x)));
        prop_assert_eq!(Rotor::from_sl2c(doubled), Err(NotLorentz::Determinant));
    }

    #[test]
    fn interpolation_is_even(a in rotors(2.0), b in rotors(2.0), t in -0.5..1.5_f64) {
        let bound = 1e-10 * (size(a) * size(b)).powi(2);
        let at = |t: f64| a.interpolate(b, t).unwrap();
        prop_assert!(apart(at(0.0), a) < bound && apart(at(1.0), b) < bound);
        // Steps of equal length are the same transformation, seen from the first frame.
        let step = |from: f64, to: f64| at(from).reverse() * at(to);
        prop_assert!(apart(step(0.0, t), step(0.3, 0.3 + t)) < bound);
        let half = at(0.5).reverse() * b;
        prop_assert!(apart(a.reverse() * b, half * half) < bound);
        let root = (a.reverse() * b).sqrt().unwrap();
        prop_assert!(apart(root * root, a.reverse() * b) < bound);
    }

    /// Null rotations, whose generator has square zero: x ↦ exp(F) x with F² = 0.
    #[test]
    fn null_rotations_are_interpolated(size in 0.01..3.0_f64, t in 0.0..1.0_f64, flip in prop::bool::ANY) {
        let wave = Bivector::from_fields([size, 0.0, 0.0], [0.0, size, 0.0]);
        let end = wave.exp().unwrap();
        near_all(coefficients(end), [1.0, size, 0.0, 0.0, 0.0, size, 0.0, 0.0], 1e-14);
        let end = if flip { -end } else { end };
        let found = Rotor::default().interpolate(end, t).unwrap();
        near_all(coefficients(found), [1.0, t * size, 0.0, 0.0, 0.0, t * size, 0.0, 0.0], 1e-13);
    }
}

#[test]
fn half_turns_and_equal_rotors() {
    let half_turn = Rotor::from_axis_angle([0.0, 0.0, 1.0], PI).unwrap();
    let identity = Rotor::<f64>::default();
    let quarter = identity.interpolate(half_turn, 0.5).unwrap();
    let image = quarter.transform(Event::from_time_place(0.0, [1.0, 0.0, 0.0]));
    near(image.g2.abs(), 1.0, 1e-15);
    for end in [identity, -identity] {
        let same = identity.interpolate(end, 0.7).unwrap();
        near_all(coefficients(same), coefficients(identity), 1e-15);
    }
    // Half a turn and a boost along its axis: the scalar is zero.
    let both = half_turn * Rotor::from_rapidity([0.0, 0.0, 1.0], 1.0).unwrap();
    let middle = identity.interpolate(both, 0.5).unwrap();
    assert!(apart(middle * middle, both) < 1e-14);
    assert_eq!((-identity).powf(f64::NAN), None);
    // The matrix of a half turn, for which the trace does not determine the rotor.
    let again = Rotor::from_matrix(both.to_matrix()).unwrap();
    assert!(apart(again, both) < 1e-14);
    // A boost to nearly the speed of light, of whose matrix rounding leaves no rotation.
    let fast = Rotor::from_rapidity([1.0, 2.0, 3.0], 30.0).unwrap();
    assert_eq!(
        Rotor::from_matrix(fast.to_matrix()),
        Err(NotLorentz::ChangesIntervals)
    );
}

#[test]
#[allow(deprecated)]
fn the_former_names_are_still_there() {
    let rotor = Rotor::<f64>::from_velocity([0.1, 0.2, 0.3]).unwrap();
    assert_eq!(rotor.boost_and_turn(), rotor.boost_and_rotation());
    use ga_runtime::geometry::NotConformal;
    assert_eq!(NotConformal::Turns, NotConformal::Rotates);
    assert_eq!(NotConformal::Shifts, NotConformal::Translates);
}

proptest! {
    /// A multiple of a spinor matrix by a complex number near 1 is the same transformation.
    #[test]
    fn determinants_near_one_are_divided_out(a in rotors(2.0), re in -1e-9..1e-9_f64, im in -1e-9..1e-9_f64) {
        let multiple = a.to_sl2c().map(|row| row.map(|entry| times(entry, [1.0 + re, im])));
        let found = Rotor::from_sl2c(multiple).unwrap();
        near_all(coefficients(found), coefficients(a), 1e-13 * size(a).powi(3));
    }
}

#[test]
fn spinor_matrices_without_a_rotor_are_errors() {
    let (zero, one) = ([0.0; 2], [1.0, 0.0]);
    let of = |a: [f64; 2], d: [f64; 2]| Rotor::from_sl2c([[a, zero], [zero, d]]);
    assert_eq!(of(one, [-1.0, 0.0]), Err(NotLorentz::Determinant));
    assert_eq!(of(zero, zero), Err(NotLorentz::Determinant));
    assert_eq!(of(one, [1.0, 1e-6]), Err(NotLorentz::Determinant));
    assert_eq!(of(one, [f64::NAN, 0.0]), Err(NotLorentz::NotFinite));
    assert_eq!(of([1e200, 0.0], [1e200, 0.0]), Err(NotLorentz::NotFinite));
    // The determinant of the matrix of a large boost is 1 only up to the rounding of its entries.
    let boost = Rotor::from_rapidity([0.0, 0.0, 1.0], 15.0).unwrap();
    let again = Rotor::from_sl2c(boost.to_sl2c()).unwrap();
    near_all(
        coefficients(again),
        coefficients(boost),
        1e-15 * size(boost),
    );
    // A singular matrix of large entries is not within rounding of a rotor.
    assert_eq!(
        Rotor::from_sl2c([[[1e5, 0.0], [1e5, 0.0]], [[1e5, 0.0], [1e5, 0.0]]]),
        Err(NotLorentz::Determinant)
    );
}
