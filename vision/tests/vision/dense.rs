//! The dense matcher on synthetic scenes, whose disparities are known exactly.

use ga_vision::disparity::DisparityMap;
use ga_vision::disparity::evaluation::ErrorMap;
use ga_vision::matcher::{Match, Matcher, MatcherOptions, Mode};
use proptest::prelude::*;

use crate::synthetic_scene::{Panel, Scene, Seen, Views};

const MODES: [Mode; 3] = [Mode::Fast, Mode::Balanced, Mode::Best];

const FOCAL: f64 = 200.0;
const BASELINE: f64 = 0.1;

/// A wall at a depth, and a board that hides the pixels from `board[0]` to `board[1]`.
fn board_before_wall(wall: f64, board: f64, corners: [[f64; 2]; 2], seed: u64) -> Scene {
    let mut scene = Scene::new(FOCAL, BASELINE, [150, 100]);
    let camera = scene.rig.left.intrinsics;
    let all = [[-100.0, -100.0], [300.0, 300.0]];
    scene.panels = vec![
        Panel::facing(camera, wall, all, 4.0, seed),
        Panel::facing(camera, board, corners, 4.0, seed + 1),
    ];
    scene
}

fn matched(views: &Views, mode: Mode) -> Match {
    let options = MatcherOptions {
        range: [0, 32],
        mode,
        threads: 1,
    };
    let (width, height) = (views.left.width(), views.left.height());
    let mut matcher = Matcher::new(options, width, height).unwrap();
    matcher.run(&views.left, &views.right).unwrap()
}

/// The truth where it is seen as told, and unknown elsewhere.
fn where_seen(views: &Views, wanted: impl Fn(usize, usize) -> bool) -> DisparityMap {
    let (width, height) = (views.truth.width(), views.truth.height());
    DisparityMap::new(ga_image::plane::Plane::from_fn(
        width,
        height,
        |column, row| match wanted(column, row) {
            true => views.truth.row(row)[column],
            false => f32::NAN,
        },
    ))
}

/// The largest and the least true disparity within `reach` pixels differ by more than 1 px.
fn near_an_edge(views: &Views, column: usize, row: usize, reach: usize) -> bool {
    let columns = column.saturating_sub(reach)..(column + reach + 1).min(views.truth.width());
    let rows = row.saturating_sub(reach)..(row + reach + 1).min(views.truth.height());
    let around = rows.flat_map(|row| views.truth.row(row)[columns.clone()].iter().copied());
    let (low, high) = around.fold((f32::MAX, f32::MIN), |(low, high), d| {
        (low.min(d), high.max(d))
    });
    high - low > 1.0
}

/// The board is from u = 60 to 90 and the wall behind is hidden from the right camera from
/// 60 − (25 − 10) on.
#[test]
fn the_truth_of_a_board_before_a_wall() {
    let [wall, board] = [10.0, 25.0].map(|disparity| FOCAL * BASELINE / disparity);
    let corners = [[59.5, 29.5], [89.5, 69.5]];
    let views = board_before_wall(wall, board, corners, 3).views();
    for row in 0..100 {
        for column in 0..150 {
            let inside = (60..90).contains(&column) && (30..70).contains(&row);
            let disparity = if inside { 25.0 } else { 10.0 };
            let found = views.truth.get(column, row).unwrap();
            assert!(
                (found - disparity).abs() < 1e-5,
                "{found} at {column}, {row}"
            );
            let seen = match (column, row) {
                (0..10, _) => Seen::OutOfView,
                (45..60, 30..70) => Seen::Occluded,
                _ => Seen::ByBoth,
            };
            assert_eq!(views.seen.get(column, row), Some(seen), "{column}, {row}");
        }
    }
}

/// A plane with the normal n at the distance c from the left camera, `n·X = c`, has the disparity
/// `f B (n·r)/c` at the pixel whose ray is r, of depth 1.
#[test]
fn the_truth_of_a_slanted_plane() {
    let mut scene = Scene::new(FOCAL, BASELINE, [60, 40]);
    let (sides, corner) = ([[4.0, 0.0, 2.0], [-0.5, 4.0, 1.0]], [-2.0, -2.0, 1.0]);
    scene.panels = vec![Panel::new(corner, sides, 0.05, 1)];
    let [[a, b, c], [d, e, f]] = sides;
    let normal = [b * f - c * e, c * d - a * f, a * e - b * d];
    let dot = |p: [f64; 3]| (0..3).map(|k| normal[k] * p[k]).sum::<f64>();
    for (u, v) in [(0.0, 0.0), (59.0, 0.0), (17.0, 39.0), (30.25, 20.5)] {
        let ray = [(u - 29.5) / FOCAL, (v - 19.5) / FOCAL, 1.0];
        let expected = FOCAL * BASELINE * dot(ray) / dot(corner);
        let found = scene.truth([u, v]).0;
        assert!((found - expected).abs() < 1e-11, "{found} {expected}");
    }
}

/// Textured planes are found to a fraction of a pixel, away from their edges.
#[test]
fn a_floor_is_found_to_a_fraction_of_a_pixel() {
    let mut scene = Scene::new(FOCAL, BASELINE, [150, 100]);
    // From a disparity of 8 px at the top to 25 px at the bottom.
    let sides = [[6.0, 0.0, 0.0], [0.0, 1.2, -1.9]];
    scene.panels = vec![Panel::new([-3.0, -0.68, 2.65], sides, 0.03, 5)];
    let views = scene.views();
    for mode in MODES {
        let found = matched(&views, mode);
        let truth = where_seen(&views, |column, row| {
            views.seen.get(column, row) == Some(Seen::ByBoth)
        });
        let errors = ErrorMap::new(&found.disparity, &truth).unwrap();
        assert!(errors.bad(1.0) < 0.5, "{mode:?}: bad 1 {}", errors.bad(1.0));
        let average = errors.average_px().unwrap();
        let limit = if mode == Mode::Fast { 0.12 } else { 0.09 };
        assert!(average < limit, "{mode:?}: average {average}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// A board before a wall, at any disparities: both are found, the wall also where only the left
    /// camera sees it, and what cannot be matched is less certain. Half-way between whole pixels,
    /// whole disparities would be wrong by 0.5 px.
    #[test]
    fn a_board_and_the_wall_behind_it_are_found(
        behind in 3.0..12.0,
        ahead in 5.0..16.0,
        left in 45.0..65.0,
        top in 20.0..40.0,
        size in (25.0..50.0, 25.0..45.0),
        seed in any::<u32>(),
    ) {
        let depth = |disparity: f64| FOCAL * BASELINE / disparity;
        let corners = [[left, top], [left + size.0, top + size.1]];
        let scene =
            board_before_wall(depth(behind), depth(behind + ahead), corners, u64::from(seed));
        let views = scene.views();
        for mode in MODES {
            let found = matched(&views, mode);
            let state = |column, row| views.seen.get(column, row);
            let clear = where_seen(&views, |column, row| {
                state(column, row) == Some(Seen::ByBoth) && !near_an_edge(&views, column, row, 4)
            });
            let errors = ErrorMap::new(&found.disparity, &clear).unwrap();
            prop_assert!(errors.bad(1.0) < 1.0, "{mode:?}: bad 1 {}", errors.bad(1.0));
            let average = errors.average_px().unwrap();
            let limit = if mode == Mode::Fast { 0.25 } else { 0.2 };
            prop_assert!(average < limit, "{mode:?}: average {average}");

            let hidden = where_seen(&views, |column, row| {
                state(column, row) == Some(Seen::Occluded) && !near_an_edge(&views, column, row, 2)
            });
            let errors = ErrorMap::new(&found.disparity, &hidden).unwrap();
            prop_assert!(errors.bad(1.0) < 30.0, "{mode:?}: hidden {}", errors.bad(1.0));

            let confidence = |wanted: Seen| {
                let values = found.confidence.values().iter().zip(views.seen.values());
                let wanted = values.filter(|(_, seen)| **seen == wanted).map(|(c, _)| c);
                wanted.clone().sum::<f32>() / wanted.count() as f32
            };
            let [clear, hidden] = [Seen::ByBoth, Seen::Occluded].map(confidence);
            prop_assert!(hidden < 0.5 * clear, "{mode:?}: {hidden} {clear}");
        }
    }
}
