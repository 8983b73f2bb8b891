//! Angles and scores against closed forms.

use ga_video::comfort::{Dimension, Level, Scale, Viewing};
use proptest::prelude::*;

/// The angle between the lines of sight of two eyes to their images on the screen.
fn convergence(viewing: &Viewing, parallax_metres: f64) -> f64 {
    let eye = 0.5 * viewing.interocular();
    let image = 0.5 * parallax_metres;
    // To the right and forward.
    let sight = |eye: f64, image: f64| [image - eye, viewing.distance()];
    let [left, right] = [sight(-eye, -image), sight(eye, image)];
    // Positive where they meet in front of the viewer.
    let cross = left[0] * right[1] - left[1] * right[0];
    cross.atan2(left[0] * right[0] + left[1] * right[1])
}

proptest! {
    #[test]
    fn parallax_is_the_angle_between_lines_of_sight(
        width in 0.1..20.0, distance in 0.3..30.0, eyes in 0.05..0.075, percent in -30.0..30.0,
    ) {
        let viewing = Viewing::new(width, distance, eyes).unwrap();
        let parallax = 0.01 * percent * width;
        let expected = convergence(&viewing, 0.0) - convergence(&viewing, parallax);
        let found = viewing.degrees_of_parallax(percent);
        prop_assert!((found - expected.to_degrees()).abs() < 1e-10);
        let back = viewing.parallax_of_degrees(found);
        prop_assert!((back - percent).abs() < 1e-9);
    }

    #[test]
    fn lines_of_sight_are_parallel_at_the_distance_of_the_eyes(
        width in 0.1..20.0, distance in 0.3..30.0, eyes in 0.05..0.075,
    ) {
        let viewing = Viewing::new(width, distance, eyes).unwrap();
        let metres = 0.01 * viewing.parallel_percent() * width;
        prop_assert!(convergence(&viewing, metres).abs() < 1e-12);
        let scale = Scale::of(Dimension::OverDivergence, &viewing).unwrap();
        let parallel = viewing.degrees_of_parallax(viewing.parallel_percent());
        prop_assert!(scale.limit() <= parallel && scale.limit() <= 2.04);
        prop_assert!(scale.comfortable() < scale.limit());
    }

    #[test]
    fn scores_rise_with_the_amount(a in 0.0..100.0, b in 0.0..100.0) {
        for dimension in Dimension::ALL {
            let Some(scale) = Scale::of(dimension, &Viewing::default()) else { continue };
            let is_weak = dimension == Dimension::WeakDepth;
            let [less, more] = if (a < b) != is_weak { [a, b] } else { [b, a] };
            prop_assert!(scale.score(less) <= scale.score(more));
            prop_assert_eq!(scale.score(-more), scale.score(more));
        }
    }
}

#[test]
fn limits_separate_the_levels() {
    for dimension in Dimension::ALL {
        let Some(scale) = Scale::of(dimension, &Viewing::default()) else {
            assert_eq!(dimension, Dimension::Stereoscopy);
            continue;
        };
        // Weak depth is the other way round.
        let worse = if dimension == Dimension::WeakDepth {
            0.999
        } else {
            1.001
        };
        let [comfortable, limit] = [scale.comfortable(), scale.limit()];
        let half_more = if dimension == Dimension::WeakDepth {
            1.0 / 1.5
        } else {
            1.5
        };
        let expected = [
            (comfortable / worse, 7, Level::Green),
            (comfortable * worse, 8, Level::Orange),
            (limit / worse, 13, Level::Orange),
            (limit * worse, 14, Level::Red),
            (limit * half_more / worse, 14, Level::Red),
            (limit * half_more * worse, 15, Level::Red),
        ];
        for (raw, number, level) in expected {
            let score = scale.score(raw);
            assert_eq!(
                (score.number(), score.level()),
                (number, level),
                "{dimension:?} {raw}"
            );
        }
        assert_eq!(scale.score(f64::NAN).number(), 15);
    }
}

#[test]
fn impossible_screens_are_named() {
    for lengths in [
        [0.0, 1.0, 0.06],
        [1.0, f64::NAN, 0.06],
        [1.0, 1.0, f64::INFINITY],
    ] {
        let [width, distance, eyes] = lengths;
        let error = Viewing::new(width, distance, eyes).unwrap_err();
        assert!(
            error.to_string().contains("not positive and finite"),
            "{error}"
        );
    }
}

/// A screen that is twice as wide as far is seen under a right angle.
#[test]
fn lengths_on_the_screen_are_seen_under_their_angle() {
    let viewing = Viewing::new(2.0, 1.0, 0.063).unwrap();
    assert!((viewing.degrees_of_length(100.0) - 90.0).abs() < 1e-9);
    assert!((viewing.degrees_of_length(1.0) - 0.02_f64.to_degrees()).abs() < 1e-4);
}
