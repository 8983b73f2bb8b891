//! Delays that are removed from videos.

use std::io::Cursor;

use ga_image::plane::Plane;
use ga_image::y4m::{Film, Sampling, Writer};
use ga_video::Samples;
use ga_video::comfort::ComfortError;
use ga_video::comfort::align::{CommonDelay, Plan};
use ga_video::comfort::asynchrony::AsynchronyMeter;
use ga_video::stereo::{Layout, StereoSource};
use ga_video::y4m::Y4mSource;

use super::scene::texture;

const SIZE: [usize; 2] = [240, 136];

/// The frame at a time of a clip in which a near square moves before a background that moves too.
fn codes(eye: usize, time: f64) -> impl Fn(usize, usize) -> u8 {
    // Frequencies that do not repeat within a film.
    let sum = |phase: f64| -> f64 {
        let waves = [(4.0, 0.173), (3.0, 0.291), (2.0, 0.437), (1.2, 0.611)];
        let terms = waves.into_iter().enumerate();
        terms
            .map(|(k, (size, f))| size * (f * time + phase * (k + 1) as f64).sin())
            .sum()
    };
    let [x, y] = [sum(0.4), sum(2.9)];
    let near = 80.0 - 12.0 * eye as f64 + sum(4.1);
    move |column, row| {
        let (column, row) = (column as f64, row as f64);
        let inside = (near..near + 80.0).contains(&column) && (30.0..106.0).contains(&row);
        let level = match inside {
            true => 0.4 * texture(7, column - near, row) + 110.0,
            false => 0.6 * texture(9, column + x + 3.0 * eye as f64, row + y),
        };
        level.clamp(0.0, 255.0) as u8
    }
}

/// A grey film side by side whose right eye is late, by the time of a frame, and whose views are
/// exchanged.
fn film(frames: i32, delay: impl Fn(i32) -> f64, is_exchanged: bool) -> Vec<u8> {
    let film = Film {
        sampling: Sampling::Grey,
        ..Film::default()
    };
    let mut bytes = Vec::new();
    let mut writer = Writer::new(&mut bytes, [2 * SIZE[0], SIZE[1]], 8, film).unwrap();
    for frame in 0..frames {
        let time = f64::from(frame);
        let [mut left, mut right] = [(0, 0.0), (1, delay(frame))]
            .map(|(eye, delay)| Plane::from_fn(SIZE[0], SIZE[1], codes(eye, time - delay)));
        if is_exchanged {
            std::mem::swap(&mut left, &mut right);
        }
        let whole = Plane::from_fn(2 * SIZE[0], SIZE[1], |column, row| {
            let view = if column < SIZE[0] { &left } else { &right };
            view.row(row)[column % SIZE[0]]
        });
        writer
            .write([&whole, &Plane::default(), &Plane::default()])
            .unwrap();
    }
    bytes
}

fn open(bytes: &[u8]) -> StereoSource {
    let source = Y4mSource::new(Cursor::new(bytes.to_vec()), "film.y4m").unwrap();
    StereoSource::halves(Box::new(source), Layout::SideBySide).unwrap()
}

fn plan(bytes: &[u8]) -> Result<Plan, ComfortError> {
    Plan::of(|| Ok(open(bytes)), Some(Layout::SideBySide), 2, |_, _| {})
}

fn applied(plan: &Plan, bytes: &[u8]) -> Vec<[Samples; 2]> {
    let mut views = Vec::new();
    plan.apply(&mut open(bytes), |pair| {
        views.push(pair.map(|frame| frame.samples.clone()));
        Ok::<(), ComfortError>(())
    })
    .unwrap();
    views
}

#[test]
fn delays_are_removed_exactly() {
    let truth = film(50, |_| 0.0, false);
    let truth = applied(&plan(&truth).unwrap(), &truth);
    for delay in -3..=3_i64 {
        let is_exchanged = delay % 2 == 0;
        let bytes = film(50, |_| delay as f64, is_exchanged);
        let plan = plan(&bytes).unwrap();
        let found = plan.delay();
        // Which of the stored views is late.
        let expected = if is_exchanged { -delay } else { delay };
        assert_eq!(
            (found.frames, found.agreeing),
            (expected, found.measured),
            "{delay}"
        );
        assert!(
            found.rest_frames.abs() < 0.2 && found.measured >= 5,
            "{found:?}"
        );
        assert_eq!(plan.frames(), 50 - delay.unsigned_abs() as usize);
        assert_eq!(
            plan.exchanged_frames(),
            if is_exchanged { plan.frames() } else { 0 }
        );
        let views = applied(&plan, &bytes);
        let mut meter = AsynchronyMeter::default();
        let mut after = Vec::new();
        for [left, right] in &views {
            after.extend(meter.push(left, right));
        }
        after.extend(meter.finish());
        let measured: Vec<f64> = after
            .iter()
            .filter_map(|a| Some(a.delay()?.frames))
            .collect();
        assert!(measured.len() >= 5, "{delay}: {after:?}");
        assert!(
            measured.iter().all(|frames| frames.abs() < 0.25),
            "{delay}: {measured:?}"
        );
        // The left view of the first pair is that of the frame at which both eyes are there.
        let first = delay.min(0).unsigned_abs() as usize;
        assert_eq!(views[0][0], truth[first][0], "{delay}");
    }
}

#[test]
fn a_delay_that_is_not_constant_is_stated() {
    // Each shot alone is long enough to be measured.
    let changing = film(130, |frame| if frame < 95 { 2.0 } else { -1.0 }, false);
    let found = *plan(&changing).unwrap().delay();
    assert_eq!(found.frames, 2, "{found:?}");
    assert!(found.agreeing < found.measured, "{found:?}");
    let half = CommonDelay::of([0.45, 0.5, 0.55, 0.5]);
    assert_eq!((half.measured, half.agreeing), (4, 4));
    assert!((half.frames as f64 + half.rest_frames - 0.5).abs() < 1e-9);
}

#[test]
fn a_film_without_motion_shows_no_delay() {
    let bytes = film(12, |_| 0.0, false);
    let frozen = {
        let start = bytes.iter().position(|byte| *byte == b'\n').unwrap() + 1;
        let frame = &bytes[start..start + (bytes.len() - start) / 12];
        let mut frozen = bytes[..start].to_vec();
        (0..12).for_each(|_| frozen.extend_from_slice(frame));
        frozen
    };
    let found = plan(&frozen).unwrap();
    assert_eq!((found.delay().frames, found.delay().measured), (0, 0));
    assert_eq!(found.frames(), 12);
}
