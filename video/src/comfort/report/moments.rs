//! The worst moments of a video, with the pictures of their frames.

use std::collections::VecDeque;
use std::rc::Rc;

use crate::Frame;
use crate::comfort::asynchrony::REACH;
use crate::comfort::{Dimension, FrameMeasures, Level, Record, Viewing};
use crate::stereo::pixel_height;

use super::kept::Kept;

/// The moments of a row that are kept, each of another shot.
const MOST: usize = 2;

/// One of the worst frames of a row.
#[derive(Clone, Debug)]
pub(super) struct Moment {
    pub(super) record: Rc<Record>,
    pub(super) pictures: Rc<Kept>,
    /// The frame before it with its pictures, where the depth changes.
    pub(super) before: Option<(Rc<Record>, Rc<Kept>)>,
    /// The frame whose right view belongs to this left one, where one eye is late.
    pub(super) partner: Option<Rc<Kept>>,
    /// How bad it is: the score, and the amount among equal scores.
    severity: (u8, f64),
    shot: usize,
}

/// Looks for the worst frames of each row while a video is read.
#[derive(Debug)]
pub(super) struct Moments {
    viewing: Viewing,
    pixel_height: f64,
    /// Frames that wait for their record, and those shortly before them.
    waiting: VecDeque<Rc<Kept>>,
    last: Option<(Rc<Record>, Rc<Kept>)>,
    shot: usize,
    rows: [Vec<Moment>; 11],
}

impl Moments {
    /// For pixels of this width and height.
    pub(super) fn new(viewing: Viewing, pixel_aspect: [u32; 2]) -> Self {
        Self {
            viewing,
            pixel_height: pixel_height(pixel_aspect),
            waiting: VecDeque::new(),
            last: None,
            shot: 0,
            rows: Default::default(),
        }
    }

    /// The views of a frame whose record comes later.
    pub(super) fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures) {
        let kept = Kept::new(views, measures, &self.viewing, self.pixel_height);
        self.waiting.push_back(Rc::new(kept));
    }

    pub(super) fn complete(&mut self, record: Record) {
        let oldest = record.frame.saturating_sub(REACH + 1);
        while self.waiting.front().is_some_and(|kept| kept.frame < oldest) {
            self.waiting.pop_front();
        }
        self.shot += usize::from(record.begins_shot);
        let Some(pictures) = self.kept(record.frame) else {
            return;
        };
        let record = Rc::new(record);
        for dimension in Dimension::ALL {
            let row = record.row(dimension);
            let Ok(score) = row.score else { continue };
            if score.level() == Level::Green {
                continue;
            }
            let raw = row.raw.unwrap_or(0.0);
            let severity = match dimension {
                Dimension::WeakDepth => -raw,
                // The first frame of those in which it is wrong.
                Dimension::Stereoscopy => 0.0,
                _ => raw.abs(),
            };
            let severity = (score.number(), severity);
            let rows = &self.rows[dimension as usize];
            let same = rows.iter().position(|moment| moment.shot == self.shot);
            let is_kept = match same {
                Some(place) => severity > rows[place].severity,
                None => rows.len() < MOST || rows.iter().any(|moment| severity > moment.severity),
            };
            if !is_kept {
                continue;
            }
            let delay = record
                .asynchrony
                .delay()
                .filter(|_| dimension == Dimension::Asynchrony);
            let partner = delay.and_then(|delay| {
                let frame = record
                    .frame
                    .checked_add_signed(delay.frames.round() as isize)?;
                self.kept(frame).filter(|_| frame != record.frame)
            });
            let before = self.last.clone();
            let before = before.filter(|_| dimension == Dimension::ParallaxDeviation);
            let moment = Moment {
                record: Rc::clone(&record),
                pictures: Rc::clone(&pictures),
                before,
                partner,
                severity,
                shot: self.shot,
            };
            let rows = &mut self.rows[dimension as usize];
            if let Some(place) = same {
                rows.remove(place);
            }
            let worse = rows.partition_point(|other| other.severity >= moment.severity);
            rows.insert(worse, moment);
            rows.truncate(MOST);
        }
        self.last = Some((record, pictures));
    }

    /// The worst frames of a row, from the worst one; none where all are green.
    pub(super) fn row(&self, dimension: Dimension) -> &[Moment] {
        &self.rows[dimension as usize]
    }

    fn kept(&self, frame: usize) -> Option<Rc<Kept>> {
        let first = self.waiting.front()?.frame;
        self.waiting.get(frame.checked_sub(first)?).map(Rc::clone)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use crate::comfort::asynchrony::{Asynchrony, Delay};
    use crate::comfort::stereoscopy::Stereoscopy;
    use crate::comfort::{Dimension, FrameMeasures, Missing, Record, Row, Score, Viewing};
    use crate::{Frame, Planes, Samples};
    use ga_image::plane::Plane;

    use super::Moments;

    fn views(frame: usize) -> [Frame; 2] {
        let luma = Plane::filled(8, 4, frame as u8);
        let differences = Default::default();
        let view = Frame {
            index: frame,
            samples: Samples::Eight(Planes { luma, differences }),
            ..Frame::default()
        };
        [view.clone(), view]
    }

    /// A record that has these scores and raw numbers; a shot begins at each tenth frame.
    fn record(frame: usize, rows: &[(Dimension, u8, f64)]) -> Record {
        Record {
            frame,
            time_seconds: frame as f64,
            begins_shot: frame.is_multiple_of(10),
            run: 0,
            measures: FrameMeasures::default(),
            asynchrony: Asynchrony::Measured(Delay {
                frames: -3.1,
                uncertainty_frames: 0.0,
            }),
            stereoscopy: Stereoscopy::Unknown,
            rows: Dimension::ALL.map(|dimension| {
                let found = rows.iter().find(|row| row.0 == dimension);
                match found {
                    Some((_, score, raw)) => Row {
                        dimension,
                        score: Ok(Score::new(*score)),
                        raw: Some(*raw),
                    },
                    None => Row::missing(dimension, Missing::Unknown),
                }
            }),
        }
    }

    /// Records come 28 frames after the views.
    fn moments(records: Vec<Record>) -> Moments {
        let mut moments = Moments::new(Viewing::default(), [1, 1]);
        let count = records.len();
        let mut records = records.into_iter();
        for frame in 0..count + 28 {
            if frame < count {
                moments.measured(&views(frame), &FrameMeasures::default());
            }
            if frame >= 28 {
                moments.complete(records.next().unwrap());
            }
        }
        moments
    }

    #[test]
    fn the_worst_frames_of_different_shots_are_kept() {
        let scores = |frame: usize| {
            let vertical = match frame {
                3 => (14, 25.0),
                7 => (14, 27.0),
                12 => (9, 6.0),
                24 => (15, 40.0),
                25 => (15, -41.0),
                _ => (3, 1.0),
            };
            let weak = if frame == 5 { (15, 0.1) } else { (15, 0.2) };
            vec![
                (Dimension::Vertical, vertical.0, vertical.1),
                (Dimension::WeakDepth, weak.0, weak.1),
                (Dimension::Colour, 7, 3.0),
            ]
        };
        let records = (0..30).map(|frame| record(frame, &scores(frame)));
        let moments = moments(records.collect());
        let frames = |dimension| {
            let all = moments.row(dimension).iter();
            all.map(|moment| {
                assert_eq!(moment.pictures.frame, moment.record.frame);
                moment.record.frame
            })
            .collect::<Vec<_>>()
        };
        assert_eq!(frames(Dimension::Vertical), [25, 7]);
        // Less depth is worse; among equal ones the first frame is kept.
        assert_eq!(frames(Dimension::WeakDepth), [5, 10]);
        assert!(frames(Dimension::Colour).is_empty() && frames(Dimension::Brightness).is_empty());
    }

    #[test]
    fn a_delay_has_the_frame_that_belongs_to_it() {
        let late = |frame| record(frame, &[(Dimension::Asynchrony, 15, -3.1)]);
        let jump = |frame| record(frame, &[(Dimension::ParallaxDeviation, 15, 90.0)]);
        let moments = moments(
            (0..40)
                .map(|k| if k < 35 { late(k) } else { jump(k) })
                .collect(),
        );
        // In the first frame there is none three frames before it.
        let rows = moments.row(Dimension::Asynchrony);
        let (first, second) = (&rows[0], &rows[1]);
        assert_eq!((first.record.frame, first.partner.is_none()), (0, true));
        let partner = second.partner.as_ref().map(|kept| kept.frame);
        assert_eq!((second.record.frame, partner), (10, Some(7)));
        let jump = &moments.row(Dimension::ParallaxDeviation)[0];
        let before = jump
            .before
            .as_ref()
            .map(|(record, kept)| [record.frame, kept.frame]);
        assert_eq!((jump.record.frame, before), (35, Some([34, 34])));
    }
}
