//! Diagnoses of pairs of points with known deviations.

use ga_image::plane::Plane;
use ga_vision::ViewGeometryError;
use ga_vision::diagnosis::of_match::{MatchFault, faults_of_match};
use ga_vision::diagnosis::{Diagnosis, DiagnosisFault, DiagnosisOptions, HorizontalDisparity};
use ga_vision::disparity::StereoError;
use ga_vision::disparity::range::DisparityRange;
use ga_vision::feature::PixelPair;
use ga_vision::matcher::{Matcher, MatcherOptions, Mode};
use proptest::prelude::*;

const SIZE: [usize; 2] = [640, 480];

/// Numbers in [0, 1) without a pattern.
fn random(seed: u32) -> impl FnMut() -> f64 {
    let mut state = u64::from(seed) << 1 | 1;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1u32 << 31)
    }
}

/// Points at random disparities, in a right view that is rotated, magnified and displaced.
fn pairs(seed: u32, count: usize, rotation: f64, zoom: f64, offset: f64) -> Vec<PixelPair> {
    let mut next = random(seed);
    let [middle_u, middle_v] = [319.5, 239.5];
    (0..count)
        .map(|_| {
            let (u, v) = (639.0 * next(), 479.0 * next());
            let disparity = 60.0 * next();
            let (x, y) = (u - disparity - middle_u, v - middle_v);
            let (sine, cosine) = rotation.sin_cos();
            let right = [
                zoom * (cosine * x - sine * y) + middle_u,
                zoom * (sine * x + cosine * y) + middle_v + offset,
            ];
            PixelPair {
                left: [u, v],
                right,
            }
        })
        .collect()
}

proptest! {
    #[test]
    fn deviations_are_found_exactly(
        seed in any::<u32>(),
        rotation in -0.1..0.1,
        zoom in 0.8..1.25,
        offset in -30.0..30.0,
    ) {
        let pairs = pairs(seed, 60, rotation, zoom, offset);
        let found = Diagnosis::new(&pairs, SIZE, DiagnosisOptions::default()).unwrap();
        prop_assert!((found.rotation - rotation).abs() < 1e-10, "{found:?}");
        prop_assert!((found.zoom - zoom).abs() < 1e-10, "{found:?}");
        prop_assert!((found.vertical_offset - offset).abs() < 1e-8, "{found:?}");
        prop_assert!(found.residual_rms < 1e-9);
        prop_assert_eq!((found.pairs, found.agreeing), (60, 60));
    }

    #[test]
    fn mismatches_and_noise_do_little(seed in any::<u32>(), rotation in -0.03..0.03) {
        let mut pairs = pairs(seed, 300, rotation, 1.02, 4.0);
        let mut next = random(seed ^ 99);
        for (index, pair) in pairs.iter_mut().enumerate() {
            if index % 3 == 0 {
                pair.right = [640.0 * next(), 480.0 * next()];
            } else {
                pair.right[1] += 0.6 * (next() - 0.5);
            }
        }
        let found = Diagnosis::new(&pairs, SIZE, DiagnosisOptions::default()).unwrap();
        prop_assert!((found.rotation - rotation).abs() < 1e-3, "{found:?}");
        prop_assert!((found.zoom - 1.02).abs() < 2e-3, "{found:?}");
        prop_assert!((found.vertical_offset - 4.0).abs() < 0.2, "{found:?}");
        prop_assert!((200..=215).contains(&found.agreeing), "{found:?}");
        prop_assert!(!found.is_rectified());
        let again = Diagnosis::new(&pairs, SIZE, DiagnosisOptions::default()).unwrap();
        prop_assert_eq!(found, again);
    }
}

#[test]
fn rectified_views_are_recognised() {
    let pairs = pairs(5, 100, 0.0, 1.0, 0.0);
    let found = Diagnosis::new(&pairs, SIZE, DiagnosisOptions::default()).unwrap();
    assert!(found.is_rectified() && !found.is_exchanged());
    assert!(found.vertical.rms < 1e-12 && found.vertical.most < 1e-12);
    let HorizontalDisparity {
        least,
        median,
        greatest,
    } = found.disparity;
    assert!((0.0..5.0).contains(&least) && (50.0..60.0).contains(&greatest));
    assert!((20.0..40.0).contains(&median));
    let exchanged: Vec<PixelPair> = pairs
        .iter()
        .map(|pair| PixelPair {
            left: pair.right,
            right: pair.left,
        })
        .collect();
    let found = Diagnosis::new(&exchanged, SIZE, DiagnosisOptions::default()).unwrap();
    assert!(found.is_rectified() && found.is_exchanged());
}

/// Where rows run backwards for most pairs, least squares over all of them does not replace a model
/// that two views of one scene can have.
#[test]
fn rows_do_not_run_backwards() {
    let mut pairs = pairs(5, 50, 0.0, 1.0, 0.0);
    for (index, pair) in pairs.iter_mut().enumerate() {
        if index % 3 != 0 {
            pair.right[1] = 479.0 - pair.right[1];
        }
    }
    // So great a threshold that all pairs agree.
    let options = DiagnosisOptions {
        threshold: 2000.0,
        ..DiagnosisOptions::default()
    };
    let found = Diagnosis::new(&pairs, SIZE, options).unwrap();
    assert_eq!(found.agreeing, 50);
    assert!(found.rotation.abs() < 1.5, "{found:?}");
}

#[test]
fn pairs_that_cannot_be_diagnosed() {
    let with = |pairs: &[PixelPair]| Diagnosis::new(pairs, SIZE, DiagnosisOptions::default());
    let good = pairs(1, 20, 0.0, 1.0, 0.0);
    assert_eq!(
        with(&good[..2]),
        Err(ViewGeometryError::TooFewMatches {
            found: 2,
            needed: 3
        })
    );
    let mut faulty = good.clone();
    faulty[7].left[1] = f64::NAN;
    assert_eq!(with(&faulty), Err(ViewGeometryError::MatchNotFinite(7)));
    let on_a_line: Vec<PixelPair> = (0..20)
        .map(|k| {
            let x = 10.0 * f64::from(k);
            PixelPair {
                left: [x + 5.0, 0.5 * x],
                right: [x, 0.5 * x],
            }
        })
        .collect();
    assert_eq!(with(&on_a_line), Err(ViewGeometryError::OnOneLine));
    let mut next = random(3);
    let mut anything = || [640.0 * next(), 480.0 * next()];
    let unrelated: Vec<PixelPair> = (0..200)
        .map(|_| PixelPair {
            left: anything(),
            right: anything(),
        })
        .collect();
    assert!(matches!(
        with(&unrelated),
        Err(ViewGeometryError::NoMatchConsensus { pairs: 200, .. })
    ));
    let options = DiagnosisOptions {
        threshold: f64::NAN,
        seed: 1,
    };
    assert!(matches!(
        Diagnosis::new(&good, SIZE, options),
        Err(ViewGeometryError::MatchThreshold(_))
    ));
}

/// Cameras above each other, or views rotated by a quarter turn: columns agree, and rows do not.
#[test]
fn views_on_their_side_are_recognised() {
    let mut next = random(8);
    let pairs: Vec<PixelPair> = (0..100)
        .map(|index| {
            let [u, v, d] = [639.0 * next(), 479.0 * next(), 60.0 * next()];
            let right = match index % 5 {
                0 => [639.0 * next(), 479.0 * next()],
                _ => [u, v - d],
            };
            PixelPair {
                left: [u, v],
                right,
            }
        })
        .collect();
    let found = Diagnosis::new(&pairs, SIZE, DiagnosisOptions::default()).unwrap();
    assert!(found.is_sideways && !found.is_rectified());
    assert_eq!(found.faults(), [DiagnosisFault::Sideways]);
    // Two views of what is far away are rectified, though columns agree as well.
    let far: Vec<PixelPair> = pairs
        .iter()
        .map(|pair| PixelPair {
            left: pair.left,
            right: pair.left,
        })
        .collect();
    let found = Diagnosis::new(&far, SIZE, DiagnosisOptions::default()).unwrap();
    assert!(!found.is_sideways && found.faults().is_empty());
    // Shown lower in the right view, they are not.
    let lower: Vec<PixelPair> = far
        .iter()
        .map(|pair| PixelPair {
            left: pair.left,
            right: [pair.left[0], pair.left[1] + 8.0],
        })
        .collect();
    let found = Diagnosis::new(&lower, SIZE, DiagnosisOptions::default()).unwrap();
    assert!(!found.is_sideways && (found.vertical_offset - 8.0).abs() < 1e-6);
    assert!(matches!(
        found.faults()[..],
        [DiagnosisFault::NotRectified { .. }]
    ));
    // A fifth of what views on their side show is far away.
    let mut partly = pairs.clone();
    for pair in partly.iter_mut().step_by(5) {
        pair.right = pair.left;
    }
    let found = Diagnosis::new(&partly, SIZE, DiagnosisOptions::default()).unwrap();
    assert_eq!(found.faults(), [DiagnosisFault::Sideways]);
}

/// A texture of many waves in all directions, without a period.
fn wavy(x: f64, y: f64) -> u8 {
    let mut sum = 128.0;
    for k in 1..24 {
        let k = f64::from(k);
        let (angle, wave) = (2.4 * k, 0.09 + 0.019 * k);
        sum += 14.0 * (wave * (x * angle.cos() + y * angle.sin()) + 1.7 * k * k).sin();
    }
    sum.round().clamp(0.0, 255.0) as u8
}

/// Shelves at six depths, of disparities from 4 to 19 px, in views of 320 × 240 pixels.
fn shelves(change: impl Fn(f64, f64) -> [f64; 2]) -> Plane<u8> {
    Plane::from_fn(320, 240, |column, row| {
        let [u, v] = change(column as f64, row as f64);
        wavy(u, v)
    })
}

fn of_shelves(u: f64, v: f64) -> [f64; 2] {
    [u + 4.0 + 3.0 * (v / 40.0).floor().clamp(0.0, 5.0), v]
}

/// Left and right view, the range of disparities, and the kinds of the faults.
type Case<'a> = (&'a Plane<u8>, &'a Plane<u8>, [i32; 2], &'a [&'a str]);

#[test]
fn pairs_that_are_matched_badly_say_why() {
    let left = shelves(|u, v| [u, v]);
    let right = shelves(of_shelves);
    let turned = |view: &Plane<u8>| Plane::from_fn(240, 320, |u, v| view.row(239 - u)[v]);
    let rolled = shelves(|u, v| {
        let (sine, cosine) = 3f64.to_radians().sin_cos();
        let (x, y) = (u - 160.0, v - 120.0);
        of_shelves(cosine * x + sine * y + 160.0, cosine * y - sine * x + 120.0)
    });
    let low = shelves(|u, v| of_shelves(u, v - 8.0));
    let other = Plane::from_fn(320, 240, |column, row| {
        let mixed = (column as u32 + 1).wrapping_mul(2_654_435_761) ^ (row as u32 * 40_503);
        ((mixed ^ mixed >> 13).wrapping_mul(2_246_822_519) >> 24) as u8
    });
    let grey = Plane::filled(320, 240, 90u8);
    let cases: [Case<'_>; 10] = [
        (&left, &right, [0, 32], &[]),
        (
            &right,
            &left,
            [0, 32],
            &["views_exchanged", "outside_range"],
        ),
        (&right, &left, [-32, 0], &[]),
        (&left, &rolled, [0, 32], &["not_rectified"]),
        (&left, &low, [0, 32], &["not_rectified"]),
        (&turned(&left), &turned(&right), [0, 32], &["sideways"]),
        (&left, &right, [32, 64], &["outside_range"]),
        (&left, &right, [-32, 0], &["outside_range"]),
        (&left, &other, [0, 32], &["unclear_match"]),
        (&grey, &grey, [0, 32], &["no_texture"]),
    ];
    for (number, (left, right, range, expected)) in cases.into_iter().enumerate() {
        for mode in [Mode::Fast, Mode::Balanced, Mode::Best] {
            let options = MatcherOptions {
                range,
                mode,
                threads: 1,
            };
            let mut matcher = Matcher::new(options, left.width(), left.height()).unwrap();
            let found = matcher.run(left, right).unwrap();
            let faults = faults_of_match([left, right], &found, range);
            let kinds: Vec<_> = faults.iter().map(MatchFault::kind).collect();
            assert_eq!(kinds, expected, "{number} {mode:?}: {faults:?}");
        }
    }
}

/// 99 % of the disparities, whichever sign they have, and not much more.
#[test]
fn ranges_are_found_from_points() {
    let left = shelves(|u, v| [u, v]);
    let right = shelves(of_shelves);
    for (views, [least, beyond]) in [([&left, &right], [4, 20]), ([&right, &left], [-19, -3])] {
        let found = DisparityRange::of(views[0], views[1], 1).unwrap();
        let [first, last] = found.ends;
        assert!((least - 10..least - 2).contains(&first), "{found:?}");
        assert!((beyond + 2..beyond + 26).contains(&last), "{found:?}");
        assert!((last - first) % 16 == 0 && found.points > 50, "{found:?}");
    }
    let grey = Plane::filled(320, 240, 90u8);
    assert!(matches!(
        DisparityRange::of(&grey, &grey, 1),
        Err(StereoError::FewPoints { found: 0, .. })
    ));
}
