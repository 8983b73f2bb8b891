//! Points that are not seen although the table has numbers for them, and points never seen.

use ga_runtime::cga3::Point;

use super::note::PointTableNote;
use super::points::PointTable;

/// What 0,0,0 means in a table of points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Zeros {
    /// That a marker is lost, as many programs write it: a point that is exactly 0,0,0 in some
    /// frames and elsewhere in others is not seen in the former. A point that is 0,0,0 in all
    /// frames that have it stays there if it is the only one, since coordinates may be relative to
    /// it; several such points cannot be in one place, and are not seen.
    #[default]
    Lost,
    /// A point at the origin.
    Kept,
}

impl PointTable {
    /// Takes points that are 0,0,0 as not seen; see [`Zeros::Lost`].
    pub(super) fn lose_zeros(&mut self) {
        let mut always = Vec::new();
        for point in 0..self.names.len() {
            let places = self.frames.iter().enumerate();
            let places = places.filter_map(|(frame, row)| Some((frame, row.points[point]?)));
            let (zeros, others): (Vec<_>, Vec<_>) = places.partition(|(_, place)| is_zero(*place));
            match (zeros.is_empty(), others.is_empty()) {
                (true, _) => {}
                (false, true) => always.push(point),
                (false, false) => {
                    let label = |(frame, _): &(usize, _)| self.frames[*frame].label.clone();
                    self.notes.push(PointTableNote::LostAtOrigin {
                        point: self.names[point].clone(),
                        frames: zeros.iter().map(label).collect(),
                    });
                    for (frame, _) in zeros {
                        self.lose(frame, point);
                    }
                }
            }
        }
        let names = always.iter().map(|&point| self.names[point].clone());
        let names: Vec<_> = names.collect();
        match names.len() {
            0 => {}
            1 => self
                .notes
                .extend(names.into_iter().map(PointTableNote::AlwaysAtOrigin)),
            _ => {
                self.notes.push(PointTableNote::NeverFound(names));
                for point in always {
                    (0..self.frames.len()).for_each(|frame| self.lose(frame, point));
                }
            }
        }
    }

    /// Leaves out points that are seen in no frame.
    pub(super) fn leave_out_never_seen(&mut self) {
        let is_seen = |point: usize| self.frames.iter().any(|row| row.points[point].is_some());
        let seen: Vec<bool> = (0..self.names.len()).map(is_seen).collect();
        if seen.iter().all(|&seen| seen) {
            return;
        }
        let names = self.names.iter().zip(&seen);
        let never = names.filter(|(_, seen)| !**seen);
        let never = never.map(|(name, _)| name.clone()).collect();
        self.notes.push(PointTableNote::NeverSeen(never));
        keep(&mut self.names, &seen);
        keep(&mut self.numbers, &seen);
        for row in &mut self.frames {
            keep(&mut row.points, &seen);
        }
    }

    fn lose(&mut self, frame: usize, point: usize) {
        self.frames[frame].points[point] = None;
    }
}

fn is_zero(place: Point<f64>) -> bool {
    place.coordinates() == [0.0; 3]
}

/// Keeps those items of a list that are marked.
fn keep<T>(items: &mut Vec<T>, marks: &[bool]) {
    let mut marks = marks.iter();
    items.retain(|_| marks.next().copied().unwrap_or_default());
}
