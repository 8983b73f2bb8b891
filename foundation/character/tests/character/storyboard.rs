use ga_anim::pose::Pose;
use ga_character::Storyboard;
use ga_render::sheet::Kind;
use ga_runtime::cga3::Point;

use super::{assert_near, character, journey, moved};

fn place(pose: &Pose) -> [f64; 3] {
    pose.root.transform(Point::default()).coordinates()
}

#[test]
fn a_recording_is_shown_with_its_own_numbers_and_times() {
    // At 40 frames a second four steps from key to key are 5 or 6 frames; the nearest is one each.
    let places: Vec<[f64; 3]> = (0..41).map(|frame| [f64::from(frame), 0.0, 0.0]).collect();
    let board = Storyboard::of_recording(&journey(0.025, &places), 10);
    assert_eq!(board.columns, 5);
    assert_eq!(board.moments.len(), 20);
    for (row, first) in [0, 12, 24, 36].into_iter().enumerate() {
        for step in 0..5 {
            let moment = &board.moments[5 * row + step];
            assert_eq!(moment.number, 10 + first + step);
            assert!((moment.time - 0.025 * (first + step) as f64).abs() < 1e-12);
            assert_near(place(&moment.pose), places[first + step], 1e-12);
            let kind = match step {
                0 | 4 => Kind::Key,
                _ => Kind::InBetween { step, steps: 4 },
            };
            assert_eq!(moment.kind, kind);
        }
    }
}

#[test]
fn rows_between_keys_are_as_many_as_are_asked_for_and_there() {
    let clip = journey(0.2, &[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    for (rows, moments) in [(1, 5), (2, 10), (9, 10)] {
        assert_eq!(Storyboard::of_keys(&clip, rows).moments.len(), moments);
    }
    let board = Storyboard::of_keys(&clip, 2);
    assert_near(place(&board.moments[7].pose), [1.5, 0.0, 0.0], 1e-12);
    let still = Storyboard::of_keys(&journey(0.2, &[[3.0, 0.0, 0.0]]), 4);
    assert_eq!((still.moments.len(), still.columns), (1, 1));
    assert_eq!(still.moments[0].kind, Kind::Key);
}

#[test]
fn the_deviation_is_the_greatest_distance_of_a_joint() {
    let character = character();
    let keys = journey(1.0, &[[0.0; 3], [1.0, 0.0, 0.0]]);
    let board = Storyboard::of_keys(&keys, 1);
    // The recording has a frame in the middle that lies 0.3 m above the straight way, so that a
    // quarter of the way is 0.15 m below.
    let recorded = journey(0.5, &[[0.0; 3], [0.5, 0.3, 0.0], [1.0, 0.0, 0.0]]);
    let deviation = board.deviation(&character, &recorded).unwrap();
    assert!((deviation - 0.3).abs() < 1e-12, "{deviation}");
    assert!(board.deviation(&character, &keys).unwrap() < 1e-12);
    // One joint alone that is elsewhere counts.
    let mut frames = keys.frames().to_vec();
    frames[1].joints[1] = moved([0.0, 0.0, 0.7]);
    let other = ga_anim::clip::Clip::new(1.0, frames).unwrap();
    let deviation = board.deviation(&character, &other).unwrap();
    assert!((deviation - 0.7).abs() < 1e-12, "{deviation}");
    let more = ga_anim::clip::Clip::new(1.0, vec![Pose::rest(3)]).unwrap();
    assert!(board.deviation(&character, &more).is_err());
}
