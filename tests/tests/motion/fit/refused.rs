//! Points and directions that determine no motion.

use core::f64::consts::FRAC_PI_2;

use ga_runtime::cga3::{Motor, Point, Rotor, Similarity};
use ga_runtime::geometry::FitError;
use ga_runtime::testing::assert_close;
use nullcone_tests::plain::{Vector, plus};

use super::paired;

#[test]
fn points_that_do_not_fix_a_motion_are_refused() {
    let corner = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    let line = [0.1, 0.3, 0.7, 1.3].map(|s| [s, 2.0 * s, 3.0 - s]);
    let heap = [[0.1, 0.2, 0.3]; 4];
    let both = |a: &[Vector], b: &[Vector], expected: FitError<f64>| {
        for pairs in [paired(a, b), paired(b, a)] {
            assert_eq!(Motor::from_point_pairs(&pairs), Err(expected));
            assert_eq!(Similarity::from_point_pairs(&pairs).unwrap_err(), expected);
        }
    };
    both(&line, &corner, FitError::PairsCollinear);
    both(&line, &line, FitError::PairsCollinear);
    both(&heap, &corner, FitError::PairsCoincident);
    both(&heap, &heap, FitError::PairsCoincident);
    // Two distinct points only span a line, however often they are repeated.
    let two = [
        [1e6, 0.3, 0.0],
        [1e6, 0.7, 0.1],
        [1e6, 0.3, 0.0],
        [1e6, 0.7, 0.1],
    ];
    both(&two, &corner, FitError::PairsCollinear);
    let far = line.map(|x| plus(x, [1e8, -1e8, 1e8]));
    both(&far, &corner, FitError::PairsCollinear);
    // Large coordinates whose differences are near the precision.
    both(
        &line.map(|x| x.map(|c| c * 1e200)),
        &corner,
        FitError::PairsCollinear,
    );
    let rounded = [[1e16, 0.0, 0.0], [1e16 + 2.0, 0.0, 0.0], [1e16, 1e-3, 0.0]];
    both(&rounded, &corner[..3], FitError::PairsCoincident);
    // A regular tetrahedron against its mirror image, and a symmetric body against its own.
    let regular = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    both(
        &regular,
        &regular.map(|x| x.map(|c| -c)),
        FitError::RotationNotUnique,
    );
    // Too few pairs.
    for found in 0..3 {
        let pairs = paired(&corner[..found], &corner[..found]);
        assert_eq!(
            Motor::from_point_pairs(&pairs),
            Err(FitError::TooFewPairs { found, needed: 3 })
        );
    }
    let weighted = [1.0, 1.0, 0.0].into_iter().zip(corner);
    let weighted: Vec<_> = weighted
        .map(|(w, x)| (w, Point::from(x), Point::from(x)))
        .collect();
    let too_few = FitError::TooFewPairs {
        found: 2,
        needed: 3,
    };
    assert_eq!(Motor::from_weighted_point_pairs(&weighted), Err(too_few));
    assert_eq!(
        too_few.to_string(),
        "3 pairs with a weight above zero are needed, not 2"
    );
}

#[test]
fn directions_that_do_not_fix_a_rotation_are_refused() {
    let (x, y) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let back = [-2.0, 0.0, 0.0];
    let refused = |pairs: &[(Vector, Vector)]| Rotor::from_direction_pairs(pairs).unwrap_err();
    assert_eq!(refused(&[(x, y), (x, x)]), FitError::PairsCollinear);
    assert_eq!(refused(&[(x, y), (back, x)]), FitError::PairsCollinear);
    assert_eq!(refused(&[(x, x), (y, back)]), FitError::PairsCollinear);
    assert_eq!(
        refused(&[(x, x), (y, [0.0; 3])]),
        FitError::NoDirection { index: 1 }
    );
    assert_eq!(
        refused(&[(x, x)]),
        FitError::TooFewPairs {
            found: 1,
            needed: 2
        }
    );
    assert_eq!(
        refused(&[]),
        FitError::TooFewPairs {
            found: 0,
            needed: 2
        }
    );
    assert_eq!(
        refused(&[(x, x), (y, y), (x, [f64::NAN, 0.0, 0.0])]),
        FitError::PairNotFinite { index: 2 }
    );
    // Inverted in all axes, every rotation by 180° fits equally well.
    let z = [0.0, 0.0, 1.0];
    let inverted = [x, y, z].map(|d| (d, d.map(|c| -c)));
    assert_eq!(refused(&inverted), FitError::RotationNotUnique);
    // The angles between the directions differ: each direction is off by the same angle.
    let fit = Rotor::from_direction_pairs(&[(x, x), (y, [0.6, 0.8, 0.0])]).unwrap();
    let excess = FRAC_PI_2 - (0.6_f64).acos();
    let (axis, angle) = fit.motion.to_axis_angle();
    assert_close!(angle, excess / 2.0, 1e-15);
    assert_close!(axis, [0.0, 0.0, -1.0], 1e-15);
    assert_close!(
        fit.residual(&[(x, x), (y, [0.6, 0.8, 0.0])]),
        2.0 * (excess / 4.0).sin(),
        1e-15
    );
    // The direction with more weight is off by less: w₁ sin δ₁ = w₂ sin δ₂.
    let weighted = [(3.0, x, x), (1.0, y, [0.6, 0.8, 0.0])];
    let (_, angle) = Rotor::from_weighted_direction_pairs(&weighted)
        .unwrap()
        .motion
        .to_axis_angle();
    assert_close!(3.0 * angle.sin(), (excess - angle).sin(), 1e-15);
}

#[test]
fn bad_numbers_are_named() {
    let corner = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for index in 0..4 {
            for place in 0..3 {
                let mut spoilt = corner;
                spoilt[index][place] = bad;
                let named = Err(FitError::PairNotFinite { index });
                assert_eq!(Motor::from_point_pairs(&paired(&spoilt, &corner)), named);
                assert_eq!(Motor::from_point_pairs(&paired(&corner, &spoilt)), named);
            }
        }
    }
    let weighted = |w: f64| corner.map(|x| (w, Point::from(x), Point::from(x)));
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let mut pairs = weighted(1.0);
        pairs[2].0 = bad;
        let Err(FitError::InvalidWeight { index: 2, weight }) =
            Motor::from_weighted_point_pairs(&pairs)
        else {
            panic!("{bad} is a weight");
        };
        assert_eq!(weight.to_bits(), bad.to_bits());
    }
    let none = Motor::from_weighted_point_pairs(&weighted(0.0));
    assert_eq!(none, Err(FitError::ZeroWeights));
    // Differences beyond the range of the scalar.
    let huge = corner.map(|x| x.map(|c| (c - 0.5) * f64::MAX * 2.0));
    let lost = Motor::from_point_pairs(&paired(&huge, &corner));
    assert_eq!(lost, Err(FitError::OutOfRange));
}

#[test]
fn residuals_of_numbers_that_are_not_finite_are_not_zero() {
    let x = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let pairs = paired(&x, &x);
    let fit = Motor::from_point_pairs(&pairs).unwrap();
    let nan = Point::new(f64::NAN, 0.0, 0.0);
    assert_eq!(fit.residual(&[]), 0.0);
    assert_eq!(fit.residual(&pairs), 0.0);
    for place in 0..3 {
        let mut others = pairs.clone();
        others[place].1 = nan;
        assert!(fit.residual(&others).is_nan());
        others[(place + 1) % 3].1 = Point::new(5.0, 0.0, 0.0);
        assert!(fit.residual(&others).is_nan());
        others[(place + 2) % 3].1 = Point::new(f64::INFINITY, 0.0, 0.0);
        assert!(!fit.residual(&others).is_finite());
    }
    let directions: [([f64; 3], [f64; 3]); 2] = [
        ([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]),
    ];
    let fit_of_directions = Rotor::from_direction_pairs(&directions).unwrap();
    // A direction of length zero is not a direction.
    assert!(
        fit_of_directions
            .residual(&[([0.0_f64; 3], [1.0, 0.0, 0.0])])
            .is_nan()
    );
    // Pairs of weight zero are ignored, whatever they are.
    let far = Point::new(4.0, 4.0, 0.0);
    let weighted = [
        (0.0, nan, nan),
        (2.0, Point::new(4.0, 1.0, 0.0), far),
        (0.0, far, nan),
    ];
    assert_close!(fit.weighted_residual(&weighted), 3.0, 1e-14);
    assert_eq!(fit.weighted_residual(&weighted[..1]), 0.0);
}
