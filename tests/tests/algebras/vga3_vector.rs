//! Vectors of vga3 as a vector type: components, lengths, bases and conversions.

use ga_runtime::cga3::{Direction, Point};
use ga_runtime::scalar::{Lanes, Real};
use ga_runtime::vga3::Vector;
use nullcone_tests::plain::{cross, dot, length, minus, near_all, plus, times, unit, vector};
use proptest::prelude::*;

type V = Vector<f64>;

proptest! {
    #[test]
    fn operators_work_by_components(a in vector(5.0), b in vector(5.0), t in 0.1..3.0_f64) {
        let (u, v) = (V::from(a), V::from(b));
        prop_assert_eq!(u.dot(v), dot(a, b));
        prop_assert_eq!(u.length_squared(), dot(a, a));
        prop_assert_eq!((u + v).coordinates(), plus(a, b));
        prop_assert_eq!((u - v).coordinates(), minus(a, b));
        prop_assert_eq!((-u).coordinates(), a.map(|x| -x));
        prop_assert_eq!((u * t).coordinates(), times(a, t));
        prop_assert_eq!((t * u).coordinates(), times(a, t));
        near_all((u / t).coordinates(), a.map(|x| x / t), 1e-14);
        let mut w = u;
        w += v;
        w *= t;
        w -= u;
        w /= 2.0;
        prop_assert_eq!(w.coordinates(), minus(times(plus(a, b), t), a).map(|x| x / 2.0));
        let each = |f: fn(f64, f64) -> f64| [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])];
        prop_assert_eq!(u.component_product(v).coordinates(), each(|x, y| x * y));
        prop_assert_eq!(u.min(v).coordinates(), each(f64::min));
        prop_assert_eq!(u.max(v).coordinates(), each(f64::max));
        prop_assert_eq!(u.abs().coordinates(), a.map(f64::abs));
        prop_assert_eq!([u[0], u[1], u[2]], a);
        prop_assert_eq!([u, v, -u].iter().sum::<V>().coordinates(), minus(plus(a, b), a));
        prop_assert_eq!([u, v].into_iter().sum::<V>(), u + v);
    }

    #[test]
    fn interpolation_starts_and_ends_where_it_is_told(a in vector(5.0), b in vector(5.0), t in 0.0..1.0_f64) {
        let (u, v) = (V::from(a), V::from(b));
        prop_assert_eq!((u.lerp(v, 0.0), u.lerp(v, 1.0)), (u, v));
        near_all(u.lerp(v, t).into(), plus(a, times(minus(b, a), t)), 1e-14);
        near_all([u.lerp(v, t).distance(u)], [t * length(minus(b, a))], 1e-14 * 10.0);
    }

    #[test]
    fn perpendicular_vectors_make_a_right_handed_basis(n in unit(), up in unit(), size in 0.01..100.0_f64) {
        let normal = V::from(n);
        for pair in [normal.orthonormal_pair(), normal.orthonormal_pair_with_up(V::from(up) * size)] {
            let [u, v] = pair.map(V::coordinates);
            let products = [dot(u, u), dot(v, v), dot(u, v), dot(u, n), dot(v, n)];
            near_all(products, [1.0, 1.0, 0.0, 0.0, 0.0], 1e-14);
            near_all(cross(u, v), n, 1e-14);
        }
        let [u, v] = normal.orthonormal_pair_with_up(V::from(up));
        near_all([dot(u.into(), up)], [0.0], 1e-14);
        // v is the direction of `up` without its part along the normal.
        prop_assert!(dot(v.into(), up) > 0.0);
        let across = (normal * size).any_perpendicular().unwrap().coordinates();
        near_all([dot(across, n), dot(across, across)], [0.0, 1.0], 1e-14);
    }

    #[test]
    fn points_and_directions_keep_their_coordinates(a in vector(5.0), b in vector(5.0)) {
        prop_assert_eq!(V::from(Point::from(a)).coordinates(), a);
        prop_assert_eq!(Point::from(V::from(a)).coordinates(), a);
        prop_assert_eq!(V::from(Direction::from_vector(a)).coordinates(), a);
        prop_assert_eq!(Direction::from(V::from(a)).vector(), a);
        prop_assert_eq!(Point::from(a).vector_to(Point::from(b)).coordinates(), minus(b, a));
    }
}

#[test]
fn lengths_neither_overflow_nor_underflow() {
    for scale in [1e-310, 1e-200, 1.0, 1e200, 1e306] {
        let v = V::new(2.0, -3.0, 6.0) * scale;
        assert!((v.length() / scale - 7.0).abs() < 1e-13);
        assert!((v.distance(V::ZERO) / scale - 7.0).abs() < 1e-13);
        let unit = v.normalized().unwrap();
        near_all(unit.into(), [2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0], 1e-13);
    }
}

#[test]
fn vectors_without_a_direction_have_no_unit() {
    for bad in [V::ZERO, V::X * f64::INFINITY, V::new(1.0, f64::NAN, 0.0)] {
        assert_eq!(bad.normalized(), None);
        assert_eq!(bad.any_perpendicular(), None);
    }
    assert!(V::X.is_finite() && !V::new(0.0, f64::INFINITY, 0.0).is_finite());
    assert!(!V::new(0.0, 0.0, f64::NAN).is_finite());
    // A basis exists even if `up` is along the normal or zero.
    for up in [V::Z, -V::Z, V::ZERO, V::new(0.0, 1e-12, 1.0)] {
        let [u, v] = V::Z.orthonormal_pair_with_up(up);
        assert_eq!(u.cross(v), V::Z);
    }
}

#[test]
fn constants_are_the_axes() {
    assert_eq!(V::X.cross(V::Y), V::Z);
    assert_eq!(Vector::<f32>::Y.cross(Vector::<f32>::Z), Vector::<f32>::X);
    assert_eq!(V::Z.cross(V::X), V::Y);
    assert_eq!(V::ZERO, V::default());
}

#[test]
fn components_are_written_by_index() {
    let mut v = Vector::new(1, 2, 3);
    for k in 0..3 {
        v[k] *= 10;
    }
    assert_eq!(v, Vector::new(10, 20, 30));
    assert!(std::panic::catch_unwind(|| v[3]).is_err());
}

#[test]
fn lanes_are_measured_side_by_side() {
    let lanes = |a: f64, b: f64| Lanes::from_array([a, b]);
    let v = Vector::new(lanes(2.0, 0.0), lanes(-3.0, 0.0), lanes(6.0, f64::INFINITY));
    assert_eq!(v.length().to_array(), [7.0, f64::INFINITY]);
    assert_eq!(v.is_finite().to_array(), [true, false]);
    assert_eq!(
        v.max(Vector::new(
            lanes(5.0, 5.0),
            lanes(0.0, 0.0),
            lanes(0.0, 0.0)
        ))
        .e1
        .to_array(),
        [5.0; 2]
    );
    assert_eq!(Real::abs(v.e2).to_array(), [3.0, 0.0]);
}
