//! Rows over all frames, against sums written out.

use std::io::Cursor;

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use ga_video::comfort::monitor::{Options, analyse};
use ga_video::comfort::{Dimension, Missing, Record, Row, Scale, Summary, Viewing};
use ga_video::stereo::{Layout, StereoSource};
use ga_video::y4m::Y4mSource;

/// The record of a flat frame.
fn record() -> Record {
    let bytes = y4m::encode([Plane::filled(128, 64, [90; 3])], Film::default()).unwrap();
    let source = Y4mSource::new(Cursor::new(bytes), "film.y4m").unwrap();
    let mut source = StereoSource::halves(Box::new(source), Layout::SideBySide).unwrap();
    let options = Options {
        viewing: Viewing::default(),
        layout: None,
        threads: 1,
    };
    let mut found = Vec::new();
    analyse(&mut source, options, |record| found.push(record)).unwrap();
    found.remove(0)
}

#[test]
fn numbers_of_frames_with_a_score_are_added() {
    let scale = Scale::of(Dimension::Colour, &Viewing::default()).unwrap();
    let usual = record();
    let mut summary = Summary::default();
    assert_eq!(summary.row(Dimension::Colour).mean_score(), None);
    // Scores 0, 7, 15, none, 15 and 10.
    for (frame, raw) in [0.0, 3.0, 40.0, f64::NAN, 20.0, 5.5]
        .into_iter()
        .enumerate()
    {
        let mut record = usual.clone();
        record.frame = frame;
        record.begins_shot = frame.is_multiple_of(3);
        for row in &mut record.rows {
            *row = Row::missing(row.dimension, Missing::NotMeasurable);
        }
        record.rows[Dimension::Colour as usize] = Row::measured(Dimension::Colour, raw, &scale);
        summary.add(&record);
    }
    assert_eq!((summary.frames, summary.shots), (6, 2));
    let row = summary.row(Dimension::Colour);
    assert_eq!((row.scored, row.levels), (5, [2, 1, 2]));
    assert_eq!(row.worst, Some((15, 2)));
    assert_eq!(row.mean_score(), Some(47.0 / 5.0));
    assert_eq!(row.mean_raw(), Some(68.5 / 5.0));
    assert_eq!(summary.row(Dimension::Vertical).scored, 0);
}
