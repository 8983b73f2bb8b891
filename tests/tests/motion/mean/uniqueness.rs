//! Which motions have a unique mean: those in a ball of less than 90°.

use core::f64::consts::{FRAC_PI_2, PI};

use ga_runtime::cga3::Motor;
use ga_runtime::geometry::FitError;
use ga_runtime::testing::assert_close;
use nullcone_tests::random::SplitMix64;

use super::{Draw, deviation, rotation, translation};

#[test]
fn rotations_all_around_have_no_mean() {
    let z = [0.0, 0.0, 1.0];
    // Opposite rotations, rotations at 120° and at 90°, and rotations by 180° about three axes.
    let all_around: [Vec<Motor<f64>>; 6] = [
        vec![rotation(z, 0.3), rotation(z, 0.3 + PI), -rotation(z, 0.3)],
        [0.0, 2.0, 4.0].map(|k| rotation(z, k * PI / 3.0)).to_vec(),
        [0.0, 1.0, 2.0, 3.0]
            .map(|k| rotation(z, k * FRAC_PI_2))
            .to_vec(),
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], z]
            .map(|axis| rotation(axis, PI))
            .to_vec(),
        vec![rotation(z, 0.0), rotation([0.6, 0.0, 0.8], PI)],
        vec![rotation(z, -1.58), rotation(z, 0.0), rotation(z, 1.58)],
    ];
    for motors in all_around {
        let weighted: Vec<_> = motors.iter().map(|&m| (1.0, m)).collect();
        let Err(FitError::MeanNotUnique { index, angle }) = Motor::mean(&weighted) else {
            panic!("{motors:?} have a mean");
        };
        assert!(index < motors.len() && angle > 1.5 && angle <= PI);
    }
    // With a third beside them, two rotations 180° apart have a mean.
    let beside = [0.0, FRAC_PI_2, PI].map(|angle| (1.0, rotation(z, angle)));
    assert_close!(
        Motor::mean(&beside).unwrap().mean,
        rotation(z, FRAC_PI_2),
        1e-14
    );
    // Slightly less than 180° apart they have one.
    let apart = [-1.0, 1.0].map(|side| (1.0, rotation(z, side * (FRAC_PI_2 - 1e-6))));
    assert_close!(
        Motor::mean(&apart).unwrap().mean,
        translation([0.0; 3]),
        1e-15
    );
}

#[test]
fn fans_over_180_degrees_have_their_middle_as_mean() {
    for seed in 0..400 {
        let mut random = SplitMix64(seed);
        let (axis, turned) = (random.axis(), random.within(PI));
        let start = random.motor(turned, 1.0);
        let count = 3 + 2 * (random.unit() * 5.0) as i32;
        let fan: Vec<_> = (0..count)
            .map(|k| start * rotation(axis, PI * f64::from(k) / f64::from(count - 1)))
            // The ends are 180° apart and have the largest weight.
            .map(|motor| (1.0, random.sign(motor)))
            .enumerate()
            .map(|(k, (w, m))| {
                (
                    if k == 0 || k + 1 == count as usize {
                        2.0
                    } else {
                        w
                    },
                    m,
                )
            })
            .collect();
        let found = Motor::mean(&fan).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        let error = deviation(found.mean, start * rotation(axis, FRAC_PI_2));
        assert!(error < 1e-13, "seed {seed}: {error}");
    }
}

#[test]
fn clouds_that_just_fit_have_a_mean() {
    // All 90° from a centre, two of them almost opposite, with weights from one to a million.
    for seed in 0..4000 {
        let mut random = SplitMix64(seed);
        let centre = random.motor(2.0, 1.0);
        let axis = random.axis();
        let off = 10.0_f64.powf(-1.0 - 8.0 * random.unit());
        let near = random.vector(off);
        let near = std::array::from_fn(|k| near[k] - axis[k]);
        let mut motors = vec![rotation(axis, FRAC_PI_2), rotation(near, FRAC_PI_2)];
        for _ in 0..1 + (random.unit() * 4.0) as usize {
            motors.push(random.motor(FRAC_PI_2, 1.0));
        }
        let cloud: Vec<_> = motors
            .into_iter()
            .map(|motor| {
                (
                    10.0_f64.powf(random.within(3.0)),
                    random.sign(centre * motor),
                )
            })
            .collect();
        let found = Motor::mean(&cloud).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        assert!(found.steps <= 6, "seed {seed}: {found:?}");
        assert!(found.residual.angle < 1e-13 && found.residual.displacement < 1e-12);
    }
}

#[test]
fn a_ball_is_found_wherever_its_centre_is() {
    // Nearly all weight is at one end of the ball, so that the other end is far beyond 90° from the
    // mean.
    let z = [0.0, 0.0, 1.0];
    let found = Motor::mean(&[
        (1e6, rotation(z, 1.5)),
        (1.0, rotation(z, -1.5)),
        (1.0, rotation([1.0, 0.0, 0.0], 1.5)),
    ]);
    assert!((found.unwrap().mean.rotor().to_axis_angle().1 - 1.5).abs() < 1e-5);
    // Random rotations: the best of many centres shows whether they lie in a ball; a refusal is
    // right only if no centre does.
    let mut refused = 0;
    for seed in 0..400 {
        let mut random = SplitMix64(seed);
        let spread = 1.2 + 0.8 * random.unit();
        let motors: Vec<_> = (0..6)
            .map(|_| {
                let angle = spread * random.unit().cbrt();
                random.motor(angle, 1.0)
            })
            .collect();
        let weighted: Vec<_> = motors.iter().map(|&m| (random.unit() + 0.01, m)).collect();
        let nearest = |centre: Motor<f64>| {
            let cosine = |m: &Motor<f64>| (centre.reverse() * *m).scalar().abs();
            motors.iter().map(cosine).fold(1.0, f64::min)
        };
        // A local search by shrinking steps from the identity.
        let (mut centre, mut best) = (Motor::default(), 0.0);
        let mut step = 0.5;
        while step > 1e-6 {
            let mut is_better = false;
            for _ in 0..60 {
                let tried = centre * random.motor(step, 0.0);
                if nearest(tried) > best {
                    (centre, best, is_better) = (tried, nearest(tried), true);
                }
            }
            if !is_better {
                step *= 0.5;
            }
        }
        let edge = (0.5_f64).sqrt();
        match Motor::mean(&weighted) {
            Ok(_) => assert!(best > edge - 1e-4, "seed {seed}: {best}"),
            Err(FitError::MeanNotUnique { .. }) => {
                refused += 1;
                assert!(best < edge, "seed {seed}: {best}");
            }
            Err(error) => panic!("seed {seed}: {error}"),
        }
    }
    assert!((50..350).contains(&refused), "{refused} refused");
}
