//! The worst moments of a video, with the pictures of their frames.

use std::collections::VecDeque;
use std::rc::Rc;

use ga_vision::comfort::asynchrony::REACH;
use ga_vision::comfort::{Dimension, FrameMeasures, Level, Record, Viewing};
use ga_vision::video::Frame;

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
    /// Frames that wait for their record, and those shortly before them.
    waiting: VecDeque<Rc<Kept>>,
    last: Option<(Rc<Record>, Rc<Kept>)>,
    shot: usize,
    rows: [Vec<Moment>; 11],
}

impl Moments {
    pub(super) fn new(viewing: Viewing) -> Self {
        Self {
            viewing,
            waiting: VecDeque::new(),
            last: None,
            shot: 0,
            rows: Default::default(),
        }
    }

    /// The views of a frame whose record comes later.
    pub(super) fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures) {
        let kept = Kept::new(views, measures, &self.viewing);
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
