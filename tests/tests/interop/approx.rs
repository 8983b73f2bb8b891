//! approx: elements compare by coefficient, as their scalars do.

use crate::every_type::every_type;

use approx_05::{
    AbsDiffEq, RelativeEq, UlpsEq, assert_abs_diff_eq, assert_relative_eq, assert_ulps_eq,
};
use ga_runtime::Element;
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::{cga2, cga3, pga2, pga3, sta, vga2, vga3};
use nullcone_embedder::sta as spacetime;

/// An element with one coefficient replaced.
fn changed<T: Element<Scalar = f64>>(stored: &[usize], values: &[f64]) -> T {
    T::from_numbers(&mut |number| {
        let place = stored.iter().position(|other| *other == number);
        values[place.expect("a stored number")]
    })
}

/// Each trait sees a change of any single coefficient, and measures it as the scalar does.
fn each_coefficient_counts<T>()
where
    T: Element<Scalar = f64> + AbsDiffEq<Epsilon = f64> + RelativeEq + UlpsEq,
{
    let mut stored = Vec::new();
    let _ = T::from_numbers(&mut |number| {
        stored.push(number);
        0.0
    });
    let values: Vec<f64> = (1..=stored.len()).map(|k| k as f64).collect();
    let value: T = changed(&stored, &values);
    assert!(value.abs_diff_eq(&value, 0.0) && value.relative_eq(&value, 0.0, 0.0));
    assert!(value.ulps_eq(&value, 0.0, 0));
    for place in 0..stored.len() {
        let with = |x: f64| -> T {
            let mut values = values.clone();
            values[place] = x;
            changed(&stored, &values)
        };
        let x = values[place];
        let other = with(x + 0.25);
        assert!(value.abs_diff_eq(&other, 0.25) && !value.abs_diff_eq(&other, 0.249));
        let relative = 0.25 / (x + 0.25);
        assert!(value.relative_eq(&other, 0.0, relative * 1.001));
        assert!(!value.relative_eq(&other, 0.0, relative * 0.999));
        let next = with(f64::from_bits(x.to_bits() + 3));
        assert!(value.ulps_eq(&next, 0.0, 3) && !value.ulps_eq(&next, 0.0, 2));
        let nan = with(f64::NAN);
        assert!(!nan.abs_diff_eq(&nan, f64::INFINITY) && !nan.relative_eq(&nan, 1.0, 1.0));
        assert!(!nan.ulps_eq(&nan, 0.0, u32::MAX));
        let infinite = with(f64::INFINITY);
        assert!(!infinite.abs_diff_eq(&value, 1e300) && !infinite.relative_eq(&value, 0.0, 0.5));
    }
}

macro_rules! all_count {
    ($($module:ident { $($name:ident),* }),*) => { $( $(
        each_coefficient_counts::<$module::$name<f64>>();
    )* )* };
}

#[test]
fn each_coefficient_of_each_type_counts() {
    every_type!(all_count);
    all_count! { spacetime { Vector, Bivector, Even, Rotor } }
}

#[test]
fn defaults_are_those_of_the_scalar() {
    assert_eq!(Point::<f32>::default_epsilon(), f32::EPSILON);
    assert_eq!(Motor::<f64>::default_epsilon(), f64::EPSILON);
    assert_eq!(
        Motor::<f64>::default_max_relative(),
        f64::default_max_relative()
    );
    assert_eq!(Motor::<f64>::default_max_ulps(), 4);
}

#[test]
fn the_macros_of_approx_work() {
    let p = Point::new(0.1_f64 + 0.2, 1.0, 1e6);
    assert_abs_diff_eq!(p, Point::new(0.3, 1.0, 1e6));
    assert_relative_eq!(p, Point::new(0.3, 1.0, 1e6 + 1e-6), max_relative = 1e-11);
    assert_ulps_eq!(p, Point::new(0.3, 1.0, 1e6), max_ulps = 1);
    let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], 1.0).unwrap();
    // A rotor and its negative are the same rotation but different elements.
    assert!(!rotor.abs_diff_eq(&-rotor, 0.1));
}
