//! Steps, and motions in step, on gaits whose footfalls are known.

use ga_anim::bvh;
use ga_anim::gait::{Aligned, Foot, Footfall, GaitProblem, footfalls};
use ga_anim::recording::{Cycle, Played, Recording, blend_played};
use ga_anim::retarget::Source;
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;

use crate::walker::{ANKLES, Gait, RUN, WALK};

const UP: Vector<f64> = Vector::new(0.0, 1.0, 0.0);

/// Where a joint is in every frame.
fn path(recording: &Recording, joint: usize) -> Vec<Vector<f64>> {
    let frames = 0..recording.frame_count();
    frames
        .map(|frame| {
            let frames = recording.frames_of_joints(frame).unwrap();
            Vector::from(frames[joint].transform(Point::default()))
        })
        .collect()
}

/// The frames in which an ankle that moved begins to stand still, by its speed alone.
fn begins_to_stand(recording: &Recording, ankle: usize) -> Vec<usize> {
    let path = path(recording, ankle);
    let speed = |frame: usize| path[frame].distance(path[frame + 1]) / recording.frame_time();
    let stands: Vec<bool> = (0..path.len() - 1)
        .map(|frame| speed(frame) < 0.05)
        .collect();
    (1..stands.len())
        .filter(|&frame| stands[frame] && !stands[frame - 1])
        .collect()
}

#[test]
fn footfalls_are_found_when_feet_come_down() {
    for gait in [
        WALK,
        RUN,
        Gait {
            rate: 120.0,
            ..WALK
        },
        Gait { rate: 30.0, ..RUN },
    ] {
        let found = footfalls(&gait.recording()).unwrap();
        for (side, foot) in [Foot::Left, Foot::Right].into_iter().enumerate() {
            let found: Vec<f64> = found
                .iter()
                .filter(|footfall| footfall.foot == foot)
                .map(|footfall| footfall.time_seconds)
                .collect();
            let truth = gait.down(side);
            assert_eq!(found.len(), truth.len(), "{found:?} {truth:?}");
            for (found, truth) in found.iter().zip(&truth) {
                // The ankle is near the ground a little before it stands there.
                assert!(
                    (truth - 0.06..truth + 0.02).contains(found),
                    "{found} {truth}"
                );
            }
        }
    }
}

#[test]
fn steps_coincide_and_standing_feet_stay_in_their_places() {
    let (walk, run) = (WALK.recording(), RUN.recording());
    for is_looped in [true, false] {
        let aligned = Aligned::new(&[(&walk, 0.5), (&run, 0.5)], is_looped).unwrap();
        // Each of them on its clock, nearly alone.
        let only = |kept: usize| {
            let played = aligned.played.iter().enumerate();
            let played = played
                .map(|(k, (played, _))| (played.clone(), if k == kept { 1.0 } else { 1e-12 }));
            blend_played(&played.collect::<Vec<_>>(), aligned.duration_seconds).unwrap()
        };
        let [walks, runs] = [0, 1].map(only);
        let mean = blend_played(&aligned.played, aligned.duration_seconds).unwrap();
        let mut steps = 0;
        for ankle in ANKLES {
            let [a, b] = [&walks, &runs].map(|motion| begins_to_stand(motion, ankle));
            assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
            for (a, b) in a.iter().zip(&b) {
                assert!(a.abs_diff(*b) <= 1, "{a} {b}");
            }
            steps += a.len();
            // Both stand from the later footfall on, for the stance of the run at least.
            let path = path(&mean, ankle);
            for (&a, &b) in a.iter().zip(&b) {
                let begin = a.max(b) + 1;
                let end = (begin + 12).min(path.len() - 1);
                let slide = path[begin].distance(path[end]);
                assert!(slide < 0.02, "{slide} m from frame {begin}");
            }
        }
        let least = if is_looped { 12 } else { 4 };
        assert!(steps >= least, "{steps} steps");
    }
}

#[test]
fn a_motion_without_steps_is_an_error_that_names_it() {
    let walk = WALK.recording();
    let stands = Gait {
        speed: 0.0,
        lift: 0.0,
        ..WALK
    }
    .recording();
    let error = Aligned::new(&[(&walk, 1.0), (&stands, 1.0)], false).unwrap_err();
    assert_eq!(error.motion, 1);
    assert_eq!(
        error.problem,
        GaitProblem::TooFewSteps {
            found: 0,
            needed: 2
        }
    );
    // What counts for nothing needs no steps.
    assert!(Aligned::new(&[(&walk, 1.0), (&stands, 0.0)], false).is_ok());
}

/// A third of a recording does not have the steps of the whole, however often it is repeated; the
/// footfall that is named is one that it has.
#[test]
fn feet_in_another_order_are_named_by_a_time_of_the_motion() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let whole = Recording::from_bvh(&bvh::read(path).unwrap(), 0.0254 / 0.45).unwrap();
    let count = whole.joints().len();
    let locals = whole.locals()[..917 * count].to_vec();
    let third = Recording::new(whole.joints().to_vec(), whole.frame_time(), locals, vec![]);
    let third = third.unwrap();
    let error = Aligned::new(&[(&whole, 0.5), (&third, 0.5)], true).unwrap_err();
    assert_eq!(error.motion, 1);
    let message = error.problem.to_string();
    let GaitProblem::Order {
        seconds: time_seconds,
        is_repeated: true,
        found: foot,
        expected,
    } = error.problem
    else {
        panic!("{message}");
    };
    let footfall = Footfall { foot, time_seconds };
    assert!(footfalls(&third).unwrap().contains(&footfall), "{message}");
    assert!(foot != expected && time_seconds <= third.duration());
    let [found, expected] = [foot, expected].map(|foot| match foot {
        Foot::Left => "the left foot",
        Foot::Right => "the right foot",
        Foot::Both => "both feet",
    });
    let end = format!(
        "at {time_seconds:.3} s, when its strides are repeated, {found} in place of {expected}"
    );
    assert!(message.ends_with(&end), "{message}");
}

#[test]
fn a_cycle_goes_on_without_a_jump() {
    // One stride exactly, and one without its last frame.
    for missing in [0.0, 1.0] {
        let gait = Gait {
            stride: 1.2,
            seconds: 1.2 - missing / 60.0 + 1e-9,
            heading: 0.7,
            ..WALK
        };
        let short = gait.recording();
        let long = Gait {
            seconds: 5.0,
            ..gait
        }
        .recording();
        let cycle = Cycle::of_whole(&short, UP).unwrap();
        assert!(
            (cycle.duration() - 1.2).abs() < 1e-9,
            "{}",
            cycle.duration()
        );
        assert!(cycle.seam().is_cyclic());
        let played = [(Played::new(&short).in_cycles(cycle), 1.0)];
        let repeated = blend_played(&played, 5.0).unwrap();
        for joint in 0..long.joints().len() {
            let [found, truth] = [&repeated, &long].map(|motion| path(motion, joint));
            for (frame, (found, truth)) in found.iter().zip(&truth).enumerate() {
                let error = found.distance(*truth);
                // Between the last frame and the first it is interpolated.
                assert!(error < 1e-9 + 2e-3 * missing, "{joint} {frame}: {error}");
            }
        }
    }
}

#[test]
fn a_motion_that_does_not_end_as_it_begins_is_said() {
    let half = Gait {
        seconds: 0.6,
        ..WALK
    }
    .recording();
    let cycle = Cycle::of_whole(&half, UP).unwrap();
    assert!(!cycle.seam().is_cyclic());
    let played = [(Played::new(&half).in_cycles(cycle), 1.0)];
    let repeated = blend_played(&played, 1.5).unwrap();
    // The first time it is as it was.
    for frame in 0..36 {
        assert_eq!(
            repeated.frame(frame).unwrap().len(),
            half.frame(frame).unwrap().len()
        );
        let [a, b] = [&repeated, &half].map(|motion| motion.frame(frame).unwrap()[3].motor);
        assert!((a.reverse() * b).rotor().scalar() > 1.0 - 1e-15);
    }
}

#[test]
fn the_direction_and_the_place_are_those_of_the_first_motion() {
    let (walk, run) = (WALK.recording(), RUN.recording());
    let aligned = Aligned::new(&[(&walk, 1.0), (&run, 1.0)], false).unwrap();
    let mean = blend_played(&aligned.played, aligned.duration_seconds).unwrap();
    let hips = path(&mean, 0);
    let way = hips[hips.len() - 1] - hips[0];
    // The walk goes along z.
    assert!(way.e1.abs() < 0.02 * way.e3, "{way:?}");
    let rotor: Rotor<f64> = mean.frame(10).unwrap()[0].rotor();
    assert!(Motor::from(rotor).scalar().abs() > 1.0 - 1e-9);
}
