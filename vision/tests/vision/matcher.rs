//! The dense matcher on scenes of known disparity, and on pairs of known truth.

use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_vision::disparity::evaluation::ErrorMap;
use ga_vision::disparity::{StereoError, file};
use ga_vision::matcher::{Match, Matcher, MatcherOptions, Mode};
use nullcone_shared_data::shared;

const MODES: [Mode; 3] = [Mode::Fast, Mode::Balanced, Mode::Best];

fn options(max_disparity: i32, mode: Mode, threads: usize) -> MatcherOptions {
    MatcherOptions {
        range: [0, max_disparity],
        mode,
        threads,
    }
}

fn matched(views: &[Plane<u8>; 2], options: MatcherOptions) -> Match {
    let [left, right] = views;
    let mut matcher = Matcher::new(options, left.width(), left.height()).expect("options");
    matcher.run(left, right).expect("views")
}

/// A texture without repetition.
fn texture(column: usize, row: usize) -> u8 {
    let mut state =
        (column as u32).wrapping_mul(0x9E37_79B9) ^ (row as u32).wrapping_mul(0x85EB_CA6B);
    state = (state ^ (state >> 15)).wrapping_mul(0x2C1B_3C6D);
    ((state ^ (state >> 13)) >> 8) as u8
}

/// A rectangle at disparity 17 before a background at disparity 6, each with a texture that both
/// views see: views and the true disparities.
fn rectangle(width: usize, height: usize) -> ([Plane<u8>; 2], Plane<f32>) {
    let is_near = |column: usize, row: usize| {
        (width / 3..2 * width / 3).contains(&column) && (height / 4..3 * height / 4).contains(&row)
    };
    let left = Plane::from_fn(width, height, |column, row| {
        if is_near(column, row) {
            texture(column + 5000, row)
        } else {
            texture(column, row)
        }
    });
    let right = Plane::from_fn(width, height, |column, row| {
        if is_near(column + 17, row) {
            texture(column + 17 + 5000, row)
        } else {
            texture(column + 6, row)
        }
    });
    let truth = Plane::from_fn(
        width,
        height,
        |column, row| {
            if is_near(column, row) { 17.0 } else { 6.0 }
        },
    );
    ([left, right], truth)
}

#[test]
fn a_rectangle_and_what_it_hides_are_found() {
    let (views, truth) = rectangle(150, 90);
    for mode in MODES {
        let found = matched(&views, options(32, mode, 1));
        let wrong = |place: &usize| {
            (found.disparity.plane().values()[*place] - truth.values()[*place]).abs() > 1.0
        };
        // Two in a hundred: those at the edges of the rectangle and in the strip it hides.
        let count = (0..150 * 90).filter(wrong).count();
        assert!(count < 270, "{mode:?}: {count} pixels are wrong");
        // In the middle of the hidden strip there is nothing to match.
        let hidden = |row: usize| found.confidence.row(row)[43..47].iter().all(|c| *c == 0.0);
        assert!((30..60).all(hidden), "{mode:?}");
        assert!(found.confidence.get(75, 45) > Some(0.5), "{mode:?}");
        assert_eq!(found.disparity.known(), 150 * 90);
    }
}

#[test]
fn another_exposure_of_one_view_changes_little() {
    let ([left, right], truth) = rectangle(150, 90);
    let darker = right.map(|level| (0.8 * f32::from(level) + 12.0) as u8);
    let found = matched(&[left, darker], options(32, Mode::Balanced, 1));
    let errors = found.disparity.plane().values().iter().zip(truth.values());
    let wrong = errors.filter(|(found, truth)| (*found - *truth).abs() > 1.0);
    assert!(wrong.count() < 200);
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    // Several strips, the last columns in a block that is not full, and flat parts.
    let (views, _) = rectangle(101, 610);
    let views = views.map(|view| {
        Plane::from_fn(101, 610, |column, row| {
            let level = view.row(row)[column];
            if row % 150 < 60 { level / 32 } else { level }
        })
    });
    for mode in MODES {
        let one = matched(&views, options(37, mode, 1));
        for threads in [2, 3, 0] {
            let several = matched(&views, options(37, mode, threads));
            assert_eq!(one.disparity, several.disparity, "{mode:?}, {threads}");
            assert_eq!(one.confidence, several.confidence, "{mode:?}, {threads}");
        }
    }
}

/// Nothing is certain where there is no candidate to compare with but the one beside.
#[test]
fn one_or_two_candidates_have_no_confidence() {
    let view = Plane::from_fn(64, 48, texture);
    for mode in MODES {
        for range in [1, 2] {
            let found = matched(&[view.clone(), view.clone()], options(range, mode, 1));
            let confidence = found.confidence.values();
            assert!(confidence.iter().all(|c| *c == 0.0), "{mode:?}, {range}");
        }
        let found = matched(&[view.clone(), view.clone()], options(4, mode, 1));
        assert!(found.confidence.get(32, 24) > Some(0.5), "{mode:?}");
    }
}

#[test]
fn a_matcher_remembers_nothing_of_the_pair_before() {
    let (views, _) = rectangle(80, 60);
    let other = [Plane::filled(80, 60, 9u8), Plane::from_fn(80, 60, texture)];
    for mode in MODES {
        let options = options(24, mode, 2);
        let mut matcher = Matcher::new(options, 80, 60).unwrap();
        matcher.run(&other[0], &other[1]).unwrap();
        let second = matcher.run(&views[0], &views[1]).unwrap();
        let first = matched(&views, options);
        assert_eq!(first.disparity, second.disparity);
        assert_eq!(first.confidence, second.confidence);
    }
}

/// What the left view shows at a column is in the right one further right by up to 30 columns, as
/// cameras see it that are turned towards each other; or nothing is as near as the range begins.
#[test]
fn ranges_begin_anywhere() {
    let ([left, right], truth) = rectangle(180, 90);
    for (shift, range) in [
        (-30, [-32, -8]),
        (-30, [-32, 0]),
        (0, [4, 28]),
        (0, [-16, 32]),
    ] {
        let moved = |column: usize, row: usize| {
            let from = column.checked_add_signed(shift).filter(|from| *from < 180);
            from.map_or_else(|| texture(column + 9000, row), |from| right.row(row)[from])
        };
        let right = Plane::from_fn(180, 90, moved);
        for mode in MODES {
            let options = MatcherOptions {
                range,
                ..options(0, mode, 1)
            };
            let found = matched(&[left.clone(), right.clone()], options);
            let [least, beyond] = range.map(|end| end as f32);
            let [mut wrong, mut outside, mut sure] = [0; 3];
            for (row, column) in (0..90).flat_map(|row| (0..180).map(move |column| (row, column))) {
                let disparity = found.disparity.get(column, row).unwrap();
                assert!((least..beyond).contains(&disparity), "{mode:?}, {range:?}");
                let expected = truth.row(row)[column] + shift as f32;
                wrong += usize::from((disparity - expected).abs() > 1.0);
                let target = column as f32 - expected;
                if !(-1.0..181.0).contains(&target) {
                    outside += 1;
                    sure += usize::from(found.confidence.get(column, row) > Some(0.3));
                }
            }
            assert!(wrong < 180 * 90 * 4 / 100, "{mode:?}, {range:?}: {wrong}");
            // Nothing is certain of what is outside the right view.
            assert!(
                20 * sure <= outside,
                "{mode:?}, {range:?}: {sure} of {outside}"
            );
        }
    }
}

/// In areas of one level, no disparity fits better than another.
#[test]
fn areas_of_one_level_have_no_confidence() {
    let (views, _) = rectangle(180, 90);
    let is_masked = |column: usize, row: usize| (20..60).contains(&column) && row >= 50;
    let [left, right] = views;
    let masked = |view: &Plane<u8>, shift: usize| {
        Plane::from_fn(180, 90, |column, row| {
            match is_masked(column + shift, row) {
                true => 255,
                false => view.row(row)[column],
            }
        })
    };
    for mode in MODES {
        let grey = Plane::filled(180, 90, 140);
        let found = matched(&[grey.clone(), grey], options(32, mode, 2));
        assert!(found.confidence.values().iter().all(|c| *c == 0.0));
        assert_eq!((found.textured, found.summary().textured), (0, 0.0));
        // Where the census reaches the texture around it, the square has a place.
        let found = matched(&[masked(&left, 0), masked(&right, 6)], options(32, mode, 2));
        for row in 54..90 {
            assert!(found.confidence.row(row)[24..56].iter().all(|c| *c == 0.0));
        }
        assert!((180 * 90 - 40 * 40..=180 * 90 - 32 * 37).contains(&found.textured));
        assert!(found.confidence.get(150, 10) > Some(0.3), "{mode:?}");
        let certain = found.clone().at_least(0.2);
        let known = certain.disparity.plane().values().iter();
        for (disparity, confidence) in known.zip(found.confidence.values()) {
            assert_eq!(disparity.is_finite(), *confidence >= 0.2);
        }
        assert!(certain.summary().density < 100.0);
    }
}

#[test]
fn extreme_views_give_finite_disparities() {
    let black = Plane::filled(33, 9, 0u8);
    let white = Plane::filled(33, 9, 255u8);
    let stripes = Plane::from_fn(33, 9, |column, _| if column % 2 == 0 { 0 } else { 255 });
    let noise = Plane::from_fn(33, 9, texture);
    let views = [black, white, stripes, noise];
    for left in &views {
        for right in &views {
            for (mode, range) in MODES.into_iter().flat_map(|m| [(m, 1), (m, 32), (m, 33)]) {
                let found = matched(&[left.clone(), right.clone()], options(range, mode, 1));
                let highest = (range - 1) as f32;
                let values = found.disparity.plane().values();
                assert!(values.iter().all(|d| (0.0..=highest).contains(d)));
                let confidence = found.confidence.values();
                assert!(confidence.iter().all(|c| (0.0..=1.0).contains(c)));
            }
        }
    }
}

#[test]
fn what_cannot_be_matched_is_named() {
    let build = |range, width, height| Matcher::new(options(range, Mode::Fast, 1), width, height);
    let range = |result: Result<Matcher, StereoError>| match result {
        Err(StereoError::Range {
            range, greatest, ..
        }) => Some((range, greatest)),
        _ => None,
    };
    assert_eq!(range(build(0, 60, 40)), Some((0, 60)));
    assert_eq!(range(build(61, 60, 40)), Some((61, 60)));
    assert_eq!(range(build(3000, 4000, 40)), Some((3000, 2047)));
    let from = |range| {
        Matcher::new(
            MatcherOptions {
                range,
                ..options(0, Mode::Fast, 1)
            },
            60,
            40,
        )
    };
    assert_eq!(range(from([8, 8])), Some((0, 60)));
    assert_eq!(range(from([8, -8])), Some((-16, 60)));
    assert_eq!(
        range(from([i32::MIN, i32::MAX])),
        Some((u32::MAX.into(), 60))
    );
    for ends in [[-60, -20], [30, 61]] {
        let error = from(ends).unwrap_err();
        assert!(matches!(error, StereoError::OutOfView { range, width: 60 } if range == ends));
    }
    assert!(from([-59, 1]).is_ok() && from([59, 60]).is_ok());
    assert!(build(60, 60, 40).is_ok());
    assert!(matches!(
        build(4, 60, 8),
        Err(StereoError::TooSmall { height: 8, .. })
    ));
    assert!(matches!(
        build(4, usize::MAX, 9),
        Err(StereoError::TooLarge { .. })
    ));
    let mut matcher = build(8, 60, 40).unwrap();
    let plane = |width, height| Plane::filled(width, height, 0u8);
    let error = matcher.run(&plane(60, 40), &plane(60, 41)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the left view has 60 × 40 pixels and the right view 60 × 41"
    );
    let error = matcher.run(&plane(61, 40), &plane(61, 40)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the views have 61 × 40 pixels, and the matcher is for 60 × 40"
    );
}

/// The part of the pixels of a view whose disparity is wrong by more than 2 px, in percent. The
/// views and the truth are in a folder of shared data.
fn bad_2(
    folder: &str,
    [left, right, truth]: [&str; 3],
    (scale, range, mode): (f64, i32, Mode),
) -> Option<f64> {
    let path = |name: &str| shared(&format!("data/vision/{folder}/{name}"));
    let grey = |name: &str| {
        let picture = ga_image::file::read(path(name)?).expect("a picture");
        Some(picture.to_grey::<u8>(Luma::Bt601))
    };
    let views = [grey(left)?, grey(right)?];
    let truth = file::read(path(truth)?, Some(scale)).expect("a truth");
    let found = matched(&views, options(range, mode, 2));
    let errors = ErrorMap::new(&found.disparity, &truth).expect("sizes");
    Some(errors.bad(2.0))
}

/// Limits that were set before the matcher was written: OpenCV's semi-global block matching has
/// 9.68 % and 15.97 % here.
#[test]
fn the_pairs_motorcycle_and_aloe_have_few_errors() {
    let motorcycle = [
        "motorcycle_left.png",
        "motorcycle_right.png",
        "motorcycle_disp.pfm",
    ];
    let aloe = ["aloeL.jpg", "aloeR.jpg", "aloeGT.png"];
    for (folder, names, range, limit) in [
        ("middlebury", motorcycle, 64, 6.2),
        ("opencv", aloe, 224, 7.0),
    ] {
        let Some(bad) = bad_2(folder, names, (1.0, range, Mode::Fast)) else {
            return;
        };
        assert!(bad <= limit, "{folder}: {bad}");
    }
}

/// The limits are a little above what is reached, on pairs that were known when the matcher was
/// written: they show changes for the worse, and not how well other pairs are matched. Without
/// averages over neighbourhoods, about 30 % of the last pair are wrong, since it shows bare walls;
/// without planes by region, 0.9, 7.3 and 8.3 %.
#[test]
fn pairs_of_middlebury_are_matched() {
    for (folder, scale, range, mode, limit) in [
        ("mb2001_venus", 8.0, 32, Mode::Fast, 0.8),
        ("mb2003_Teddy", 4.0, 64, Mode::Balanced, 6.7),
        ("mb2006_Midd1", 3.0, 80, Mode::Best, 7.5),
    ] {
        let folder = format!("stereo/{folder}");
        let names = ["left.png", "right.png", "disp_left.png"];
        let Some(bad) = bad_2(&folder, names, (scale, range, mode)) else {
            return;
        };
        assert!(bad <= limit, "{folder}: {bad}");
    }
}
