//! Motions that cannot be shown.

use super::super::{FilmProblem, Motion, MotionError};
use super::motion;
use crate::document::Page;

/// The error of a motion after a change, which leaves the page as it was.
#[track_caller]
fn error(change: impl FnOnce(&mut Motion)) -> MotionError {
    let mut motion = motion();
    change(&mut motion);
    let mut page = Page::new("");
    let error = page.motion(&motion, "").unwrap_err();
    assert_eq!(page.into_html(), Page::new("").into_html());
    error
}

#[test]
fn numbers_are_numbers() {
    for rate in [0.0, -25.0, f64::INFINITY] {
        let error = error(|motion| motion.frames_per_second = rate);
        assert_eq!(error, MotionError::FramesPerSecond(rate));
    }
    for value in [f64::NEG_INFINITY, 1.1e5] {
        let error = error(|motion| motion.frames[2].as_mut().unwrap()[0][2] = value);
        let element = "the point `foot` of frame 2".to_owned();
        assert_eq!(error, MotionError::Coordinate { element, value });
    }
    let nan = error(|motion| motion.cameras[0].corners[3][0] = f64::NAN);
    assert!(nan.to_string().contains("the camera `</script>"), "{nan}");
    let nan = error(|motion| motion.floor = Some(f64::NAN));
    assert!(
        nan.to_string().contains("the floor has the coordinate NaN"),
        "{nan}"
    );
}

#[test]
fn points_and_bones_belong_together() {
    let points = error(|motion| motion.names.truncate(2));
    let expected = MotionError::Points {
        frame: 0,
        points: 3,
        names: 2,
    };
    assert_eq!(points, expected);
    let bone = error(|motion| motion.bones[1].ends[0] = 3);
    let expected = MotionError::Bone {
        bone: 1,
        point: 3,
        points: 3,
    };
    assert_eq!(bone, expected);
    assert_eq!(
        error(|motion| motion.frames.fill(None)),
        MotionError::NoPose
    );
    let empty = error(|motion| {
        motion.names.clear();
        motion.frames.fill(Some(vec![]));
    });
    assert_eq!(empty, MotionError::NoPose);
}

#[test]
fn pictures_are_in_order() {
    let problem = |change: fn(&mut Motion)| match error(change) {
        MotionError::Film { problem, .. } => problem,
        other => panic!("{other}"),
    };
    let size = problem(|motion| motion.films[1].size = [0, 7]);
    assert_eq!(size, FilmProblem::Size(0, 7));
    let late = problem(|motion| motion.films[1].pictures[0].frames = 0..6);
    let expected = FilmProblem::Frames {
        picture: 0,
        start: 0,
        end: 6,
        from: 0,
        until: 5,
    };
    assert_eq!(late, expected);
    for (start, end) in [(0, 2), (1, 1), (2, 1)] {
        let mut motion = motion();
        motion.films[0].pictures[1].frames = start..end;
        let problem = Page::new("").motion(&motion, "").unwrap_err().to_string();
        let expected = format!("picture 1 is shown from frame {start} until before {end}");
        assert!(problem.contains(&expected), "{problem}");
    }
}
