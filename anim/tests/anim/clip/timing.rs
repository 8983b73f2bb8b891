//! Loops, cross-fades, clocks, events and scalar tracks.

use ga_anim::clip::{Clip, ClipError, CrossFade, EventTrack, RootMotion, ScalarTracks, TimeWarp};
use ga_anim::curve::{Curve, CurveError};
use ga_anim::pose::Pose;
use ga_runtime::cga3::{Motor, Rotor, Translator};

use super::{apart, at, x};

#[test]
fn a_walk_in_a_loop_goes_on() {
    // A quarter turn about y and a metre ahead in each cycle.
    let quarter = Rotor::from_axis_angle([0.0, 1.0, 0.0], std::f64::consts::FRAC_PI_2).unwrap();
    let step = Translator::from_displacement([0.0, 0.0, 1.0]) * quarter;
    let way = RootMotion::new(0.5, vec![Motor::default(), step.sqrt(), step]).unwrap();
    assert!(apart(way.at(0.5), step.sqrt()) < 1e-15 && apart(way.at(9.0), step) < 1e-15);
    let around = way.whole() * way.whole() * way.whole() * way.whole();
    assert!(apart(around, Motor::default()) < 1e-14);
}

#[test]
fn a_cross_fade_begins_and_ends_without_a_jump() {
    let from = Clip::new(1.0, vec![at(0.0), at(4.0)]).unwrap();
    let to = Clip::new(1.0, vec![at(10.0), at(10.0), at(12.0)]).unwrap();
    let fade = CrossFade::new(&from, &to, 0.5, 0.5).unwrap();
    assert_eq!([0.25, 0.5].map(|t| x(&fade.sample(t))), [1.0, 2.0]);
    // 3s² − 2s³ of a quarter is 5/32; there are 2.5 and 10.
    assert!((x(&fade.sample(0.625)) - (2.5 + 7.5 * 5.0 / 32.0)).abs() < 1e-14);
    assert_eq!(
        [1.0, 2.0, 2.5, 9.0].map(|t| x(&fade.sample(t))),
        [10.0, 11.0, 12.0, 12.0]
    );
    assert_eq!((fade.end(), fade.weight(f64::NAN)), (2.5, 0.0));
    let cut = CrossFade::new(&from, &to, 0.5, 0.0).unwrap();
    assert_eq!([0.4999, 0.5].map(|t| cut.weight(t)), [0.0, 1.0]);
    assert_eq!(
        CrossFade::new(&from, &to, -1.0, 0.5).unwrap_err(),
        ClipError::Time(-1.0)
    );
    let other = Clip::new(1.0, vec![Pose::rest(2)]).unwrap();
    assert!(CrossFade::new(&from, &other, 0.0, 0.5).is_err());
}

#[test]
fn clips_run_faster_slower_and_backwards() {
    let clip = Clip::new(0.5, vec![at(0.0), at(1.0), at(2.0)]).unwrap();
    assert_eq!(clip.at_speed(2.0).unwrap().duration(), 0.5);
    assert_eq!(
        clip.reversed().frames().iter().map(x).collect::<Vec<_>>(),
        [2.0, 1.0, 0.0]
    );
    for factor in [0.0, -1.0, f64::NAN] {
        assert!(matches!(
            clip.at_speed(factor),
            Err(ClipError::FrameTime(_))
        ));
    }
    let slow = TimeWarp::through(&[0.0, 2.0], &[0.0, 1.0]).unwrap();
    let slow = clip.warped(&slow).unwrap();
    assert_eq!(
        slow.frames().iter().map(x).collect::<Vec<_>>(),
        [0.0, 0.5, 1.0, 1.5, 2.0]
    );
    let endless = TimeWarp::through(&[0.0, 1e300], &[0.0, 1.0]).unwrap();
    assert_eq!(clip.warped(&endless), Err(ClipError::Rate(2.0)));
    let error = TimeWarp::through(&[0.0, 1.0], &[1.0, 1.0]).unwrap_err();
    assert_eq!(
        error,
        CurveError::NotRising {
            key: 1,
            time: 1.0,
            before: 1.0
        }
    );
}

#[test]
fn events_and_scalar_tracks() {
    let events = EventTrack::new(vec![(1.0, 'b'), (0.5, 'a'), (1.0, 'c')]).unwrap();
    let names = |from, to| {
        events
            .between(from, to)
            .iter()
            .map(|event| event.1)
            .collect::<String>()
    };
    assert_eq!(
        [names(0.0, 0.5), names(0.5, 1.0), names(1.0, 9.0)],
        ["a", "bc", ""]
    );
    assert_eq!([names(2.0, 0.0), names(f64::NAN, 1.0)], ["", "abc"]);
    assert_eq!(
        events.in_loop(0.0, 0.0, 1e9).count() + events.in_loop(1.0, 0.0, f64::INFINITY).count(),
        0
    );
    let empty = EventTrack::<()>::new(Vec::new()).unwrap();
    assert_eq!(empty.in_loop(1e-300, 0.0, 1e300).count(), 0);
    let error = EventTrack::new(vec![(0.0, 1), (f64::NAN, 2)]).unwrap_err();
    assert!(matches!(error, ClipError::EventTime { index: 1, .. }));

    let mut tracks = ScalarTracks::default();
    tracks.insert("smile", Curve::step(&[0.0], &[9.0]).unwrap());
    tracks.insert("blink", Curve::step(&[0.0, 1.0], &[0.0, 1.0]).unwrap());
    tracks.insert("smile", Curve::linear(&[0.0, 2.0], &[0.0, 1.0]).unwrap());
    let mut values = [0.0; 2];
    tracks.sample_into(1.0, &mut values).unwrap();
    assert_eq!(values, [0.5, 1.0]);
    assert_eq!(
        tracks.iter().map(|(name, _)| name).collect::<Vec<_>>(),
        ["smile", "blink"]
    );
    assert!(tracks.sample_into(1.0, &mut [0.0; 3]).is_err());
}

#[test]
fn a_clip_does_not_become_a_large_one() {
    let clip = Clip::new(1.0, vec![Pose::rest(5); 2]).unwrap();
    assert_eq!(clip.resampled(1e6).unwrap_err(), ClipError::Rate(1e6));
    assert_eq!(clip.resampled(1e3).unwrap().frames().len(), 1001);
    let slow = TimeWarp::through(&[0.0, 1e6], &[0.0, 1.0]).unwrap();
    assert_eq!(clip.warped(&slow).unwrap_err(), ClipError::Rate(1.0));
}
