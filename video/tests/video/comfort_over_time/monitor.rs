//! All rows of videos.

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film, Sampling};
use ga_image::ycbcr::YCbCr;
use ga_video::comfort::monitor::{Monitor, Options, analyse};
use ga_video::comfort::stereoscopy::Stereoscopy;
use ga_video::comfort::{ComfortError, Dimension, Level, Record, Summary, Viewing};
use ga_video::stereo::{Layout, StereoSource};
use ga_video::y4m::Y4mSource;
use ga_video::{Frame, Planes, Properties, Samples};

use super::scene::{Random, texture};

fn options(threads: usize) -> Options {
    Options {
        viewing: Viewing::default(),
        layout: Some(Layout::SideBySide),
        threads,
    }
}

fn records(bytes: Vec<u8>, threads: usize) -> (Vec<Record>, Result<(), ComfortError>) {
    let source = Y4mSource::new(std::io::Cursor::new(bytes), "clip.y4m").unwrap();
    let mut source = StereoSource::halves(Box::new(source), Layout::SideBySide).unwrap();
    let mut records = Vec::new();
    let result = analyse(&mut source, options(threads), |record| records.push(record));
    (records, result)
}

/// The records of views that lie in two videos.
pub(super) fn of_frames(frames: &[[Frame; 2]]) -> Vec<Record> {
    let properties = Properties {
        size: frames[0][0].samples.size(),
        sampling: Sampling::default(),
        bit_depth: 8,
        colours: YCbCr::default(),
        pixel_aspect: [1, 1],
        frames_per_second: Some([24, 1]),
        frame_count: None,
    };
    let options = Options {
        layout: None,
        ..options(2)
    };
    let mut monitor = Monitor::new(&properties, options).unwrap();
    let mut records = Vec::new();
    let mut each = |record| records.push(record);
    monitor.push(frames, &mut each).unwrap();
    monitor.finish(&mut each);
    assert_eq!(records.len(), frames.len());
    records
}

/// Frames side by side of a texture that moves; a near square hides a part of it.
fn clip(frames: usize) -> Vec<u8> {
    let pictures = (0..frames).map(|frame| {
        let moved = 5.0 * (0.4 * frame as f64).sin();
        Plane::from_fn(480, 136, |column, row| {
            let (eye, column) = (column / 240, (column % 240) as f64);
            let near = 90.0 - if eye == 1 { 10.0 } else { 0.0 } + moved;
            let inside = (near..near + 70.0).contains(&column) && (30..100).contains(&row);
            let level = match inside {
                true => 0.5 * texture(7, column - near, row as f64) + 90.0,
                false => 0.6 * texture(9, column + 3.0 * eye as f64, row as f64 + moved),
            };
            [level as u8; 3]
        })
    });
    let pictures: Vec<_> = pictures.collect();
    y4m::encode(&pictures, Film::default()).unwrap()
}

#[test]
fn records_are_the_same_for_any_number_of_threads() {
    let bytes = clip(11);
    let (one, result) = records(bytes.clone(), 1);
    result.unwrap();
    let (two, result) = records(bytes, 2);
    result.unwrap();
    assert_eq!(one.len(), 11);
    assert_eq!(one, two);
    assert!(one.iter().enumerate().all(|(index, r)| r.frame == index));
    assert!(one[0].begins_shot && !one[1].begins_shot);
    assert_eq!(one[5].stereoscopy, Stereoscopy::InOrder);
    for dimension in [
        Dimension::Brightness,
        Dimension::Colour,
        Dimension::Vertical,
    ] {
        let score = one[5].row(dimension).score.unwrap();
        assert_eq!(score.level(), Level::Green, "{dimension:?}");
    }
    let mut summary = Summary::default();
    one.iter().for_each(|record| summary.add(record));
    assert_eq!((summary.frames, summary.shots), (11, 1));
    let vertical = summary.row(Dimension::Vertical);
    let mean: f64 = one
        .iter()
        .map(|r| f64::from(r.row(Dimension::Vertical).score.unwrap().number()))
        .sum::<f64>()
        / 11.0;
    assert_eq!(vertical.mean_score(), Some(mean));
    assert_eq!(vertical.levels, [11, 0, 0]);
}

#[test]
fn a_clip_cut_short_keeps_the_frames_before() {
    let mut bytes = clip(6);
    bytes.truncate(bytes.len() - 1000);
    let (records, result) = records(bytes, 2);
    assert_eq!(records.len(), 5);
    let error = result.unwrap_err();
    assert_eq!(error.frame(), Some(5), "{error}");
}

#[test]
fn a_video_of_one_view_is_named() {
    let picture = Plane::from_fn(640, 180, |column, row| {
        [texture(3, column as f64, row as f64) as u8; 3]
    });
    let bytes = y4m::encode([&picture; 3], Film::default()).unwrap();
    let (records, result) = records(bytes, 2);
    assert!(
        matches!(result, Err(ComfortError::Mono { frame: 0 })),
        "{result:?}"
    );
    assert!(records.is_empty());
}

/// Views of any size, of 8 and of 10 bits, that show little or nothing.
#[test]
fn every_row_is_a_number_or_says_why_not() {
    let mut random = Random(12);
    for size in [
        [1, 1],
        [2, 1],
        [1, 16],
        [5, 3],
        [16, 16],
        [49, 48],
        [101, 67],
    ] {
        for kind in 0..6 {
            let level = |frame: usize, eye: usize, column: usize, row: usize, noise: u8| match kind
            {
                0 => 16,
                1 => 255,
                2 => noise,
                // One view is black.
                3 => noise * eye as u8,
                4 => 255 * ((column + row + frame) % 2) as u8,
                _ => texture(5, (column + 3 * frame + 2 * eye) as f64, row as f64) as u8,
            };
            let mut frame = |index: usize, eye: usize| {
                let luma = Plane::from_fn(size[0], size[1], |column, row| {
                    level(index, eye, column, row, random.bits() as u8)
                });
                let samples = match kind % 2 {
                    0 => Samples::Eight(Planes {
                        luma,
                        ..Planes::default()
                    }),
                    _ => Samples::Ten(Planes {
                        luma: luma.map(|code| 4 * u16::from(code)),
                        ..Planes::default()
                    }),
                };
                Frame {
                    index,
                    time_seconds: index as f64 / 24.0,
                    samples,
                }
            };
            // A single frame, and a few of them.
            for count in [1, 9] {
                let frames: Vec<_> = (0..count).map(|i| [frame(i, 0), frame(i, 1)]).collect();
                for record in of_frames(&frames) {
                    for row in &record.rows {
                        let finite = row.raw.is_none_or(f64::is_finite);
                        assert!(finite, "{size:?} {kind} {row:?}");
                        assert!(
                            row.raw.is_some() || row.score.is_err(),
                            "{size:?} {kind} {row:?}"
                        );
                    }
                    assert!(record.asynchrony.delay().is_none(), "{size:?} {kind}");
                }
            }
        }
    }
}

/// Each defect of the clip shows in its own row, against the frames without defects.
#[test]
fn defects_of_a_real_clip() {
    let path = "data/vision/clips/motorcycle_sbs_960x324_defects.y4m";
    let Some(path) = nullcone_shared_data::shared(path) else {
        return;
    };
    let source = ga_video::open(path).unwrap();
    let mut source = StereoSource::halves(source, Layout::SideBySide).unwrap();
    let mut found = Vec::new();
    analyse(&mut source, options(2), |record| found.push(record)).unwrap();
    assert_eq!(found.len(), 48);
    let number = |record: &Record, dimension| {
        record
            .row(dimension)
            .score
            .map(|score| i32::from(score.number()))
    };
    for (frames, injected) in [
        (8..14, Dimension::Vertical),
        (14..20, Dimension::Brightness),
        (20..26, Dimension::Colour),
        (26..32, Dimension::Stereoscopy),
        (32..38, Dimension::FocalGap),
    ] {
        for record in &found[frames] {
            for dimension in [
                Dimension::Brightness,
                Dimension::Colour,
                Dimension::Vertical,
                Dimension::Asynchrony,
                Dimension::Stereoscopy,
                Dimension::FocalGap,
            ] {
                let (now, clean) = (number(record, dimension), number(&found[3], dimension));
                match (now, clean) {
                    (Ok(now), Ok(clean)) if dimension == injected => {
                        assert!(now >= clean + 5, "{dimension:?} {record:?}");
                    }
                    (Ok(now), Ok(clean)) => {
                        assert!((now - clean).abs() <= 2, "{dimension:?} {record:?}");
                    }
                    _ => assert_eq!(now, clean, "{dimension:?} {}", record.frame),
                }
            }
        }
    }
}
