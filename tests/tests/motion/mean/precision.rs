//! Means of far motions, in single precision and of long sums.

use core::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::cga3::Motor;
use ga_runtime::testing::assert_close;
use nullcone_tests::plain::motor_coefficients;
use nullcone_tests::random::SplitMix64;

use super::{Draw, deviation, matrix_exponential, of_matrix, planted, rotation, translation};

#[test]
fn far_displacements_keep_their_figures() {
    for size in [1e-12, 1e6, 1e12, 1e100] {
        let motors = [[1.0, 0.5, 0.0], [-0.5, 2.0, 1.0], [0.25, 0.0, -3.0]]
            .map(|t| t.map(|x| x * size))
            .into_iter()
            .zip([0.1, -0.7, 0.9]);
        let weighted: Vec<_> = motors
            .map(|(t, angle)| (1.0, translation(t) * rotation([0.0, 0.6, 0.8], angle)))
            .collect();
        let found = Motor::mean(&weighted).unwrap();
        assert!(
            found.residual.displacement <= 1e-14 * size,
            "{size}: {found:?}"
        );
        let scaled: Vec<_> = weighted
            .iter()
            .map(|(w, m)| {
                (
                    *w,
                    translation(m.translator().displacement().map(|x| x / size)) * m.rotor(),
                )
            })
            .collect();
        let plain = Motor::mean(&scaled)
            .unwrap()
            .mean
            .translator()
            .displacement();
        let found = found.mean.translator().displacement().map(|x| x / size);
        assert_close!(found.to_vec(), plain.to_vec(), 1e-13);
    }
}

#[test]
fn single_precision_comes_to_rest_too() {
    for seed in 0..1000 {
        let mut random = SplitMix64(seed);
        let turned = random.within(PI);
        let centre = random.motor(turned, 10.0);
        let narrow = |m: Motor<f64>| {
            let [a, b, c, d, e, f, g, h] = motor_coefficients(m).map(|x| x as f32);
            Motor::new_unchecked(a, b, c, d, e, f, g, h)
        };
        let cloud: Vec<_> = planted(&mut random, centre, FRAC_PI_2 - 0.01)
            .into_iter()
            .map(|(w, m)| (w as f32, narrow(m)))
            .collect();
        let found = Motor::mean(&cloud).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        assert!(found.steps <= 25);
        let mean = found.mean;
        let wide = Motor::new_unchecked(
            f64::from(mean.scalar()),
            f64::from(mean.e12()),
            f64::from(mean.e13()),
            f64::from(mean.e23()),
            f64::from(mean.e1i()),
            f64::from(mean.e2i()),
            f64::from(mean.e3i()),
            f64::from(mean.e123i()),
        );
        assert!(
            deviation(wide, centre) < 2e-5,
            "seed {seed}: {}",
            deviation(wide, centre)
        );
    }
}

#[test]
fn long_sums_keep_their_figures() {
    // First all motors of one side, then all of the other, so that partial sums are large before
    // they cancel.
    let mut random = SplitMix64(1);
    let centre = random.motor(1.0, 1.0);
    let sides: Vec<_> = (0..20_000)
        .map(|_| (random.axis().map(|x| x.abs()), 0.5 + 0.2 * random.unit()))
        .collect();
    let narrow = |m: Motor<f64>| {
        let [a, b, c, d, e, f, g, h] = motor_coefficients(m).map(|x| x as f32);
        (1.0_f32, Motor::new_unchecked(a, b, c, d, e, f, g, h))
    };
    let moved = |sign: f64| {
        let moved = move |&(axis, angle): &([f64; 3], f64)| {
            let step = axis.map(|x| x * sign);
            centre * of_matrix(matrix_exponential(step.map(|x| x * angle), step))
        };
        sides.iter().map(moved).map(narrow).collect::<Vec<_>>()
    };
    let cloud = [moved(1.0), moved(-1.0)].concat();
    let found = Motor::mean(&cloud).unwrap();
    let (_, expected) = narrow(centre);
    assert_close!(found.mean, expected, 3e-7);
    assert!(found.steps <= 4);
}
