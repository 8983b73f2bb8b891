//! What happens at a time, and what changes beside the joints.

use crate::clip::ClipError;
use crate::curve::{Curve, CurveError};

/// Things that happen at times of a clip, such as the steps of a walk.
///
/// ```
/// use ga_anim::clip::EventTrack;
/// let steps = EventTrack::new(vec![(0.2, "left"), (0.7, "right")])?;
/// // What happened in the last frame of a clip of one second in a loop.
/// let seen: Vec<_> = steps.in_loop(1.0, 0.6, 1.3).map(|(time, &foot)| (time, foot)).collect();
/// assert_eq!(seen, [(0.7, "right"), (1.2, "left")]);
/// # Ok::<(), ga_anim::clip::ClipError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EventTrack<T> {
    events: Vec<(f64, T)>,
}

impl<T> EventTrack<T> {
    /// The events, each at a time in seconds, in any order. Those at the same time keep theirs.
    ///
    /// # Errors
    ///
    /// [`ClipError::EventTime`].
    pub fn new(mut events: Vec<(f64, T)>) -> Result<Self, ClipError> {
        if let Some(index) = events.iter().position(|(time, _)| !time.is_finite()) {
            return Err(ClipError::EventTime {
                index,
                time: events[index].0,
            });
        }
        events.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        Ok(Self { events })
    }

    /// All events by rising time.
    #[must_use]
    pub fn events(&self) -> &[(f64, T)] {
        &self.events
    }

    /// The events after `from`, up to `to` and at it. Intervals that follow each other therefore
    /// have each event once. Where `to` is earlier, there are none.
    #[must_use]
    pub fn between(&self, from: f64, to: f64) -> &[(f64, T)] {
        let [first, last] =
            [from, to].map(|end| self.events.partition_point(|(time, _)| *time <= end));
        self.events.get(first..last).unwrap_or_default()
    }

    /// The same for a clip that repeats after `period` seconds, by times that go on. Only events
    /// from 0 up to the period, but not at it, belong to the loop. There are none for a period that
    /// is not above 0, times that are not finite, or more repetitions than can be counted.
    pub fn in_loop(&self, period: f64, from: f64, to: f64) -> impl Iterator<Item = (f64, &T)> {
        let first = self.events.partition_point(|(time, _)| *time < 0.0);
        let last = self
            .events
            .partition_point(|(time, _)| *time < period)
            .max(first);
        // Quotients are rounded, and so are the times below: the repetition before the first and
        // the one after the last may have events in the interval, too. The filter decides.
        let (start, end) = ((from / period).floor() - 1.0, (to / period).floor() + 1.0);
        // Beyond this range a repetition and the next are the same number.
        let is_counted = [start, end].iter().all(|n| n.abs() < 2_f64.powi(52));
        let is_usable = period > 0.0 && is_counted;
        let events = if is_usable {
            &self.events[first..last]
        } else {
            &[]
        };
        // No iteration where there is nothing to be found.
        let mut next = if events.is_empty() {
            f64::INFINITY
        } else {
            start
        };
        let end = if is_usable { end } else { f64::NEG_INFINITY };
        std::iter::from_fn(move || {
            let current = next;
            next += 1.0;
            (current <= end).then_some(current)
        })
        .flat_map(move |repetition| {
            events
                .iter()
                .map(move |(time, event)| (repetition * period + time, event))
        })
        .filter(move |(time, _)| from < *time && *time <= to)
    }
}

/// Numbers that change over time beside the joints: weights of morph targets, and values of a
/// user's own.
///
/// ```
/// use ga_anim::clip::ScalarTracks;
/// use ga_anim::curve::Curve;
/// let smile = Curve::linear(&[0.0, 1.0], &[0.0, 1.0])?;
/// let mut tracks = ScalarTracks::default();
/// tracks.insert("smile", smile);
/// assert_eq!(tracks.value("smile", 0.25), Some(0.25));
/// assert_eq!(tracks.value("frown", 0.25), None);
/// # Ok::<(), ga_anim::curve::CurveError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ScalarTracks {
    tracks: Vec<(String, Curve<f64>)>,
}

impl ScalarTracks {
    /// Adds a track, in place of one of the same name.
    pub fn insert(&mut self, name: &str, curve: Curve<f64>) {
        match self.tracks.iter_mut().find(|(other, _)| other == name) {
            Some((_, track)) => *track = curve,
            None => self.tracks.push((name.to_string(), curve)),
        }
    }

    /// The tracks in the order in which they were added.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Curve<f64>)> {
        self.tracks
            .iter()
            .map(|(name, curve)| (name.as_str(), curve))
    }

    /// The value of a track at a time; `None` where there is no track of this name.
    #[must_use]
    pub fn value(&self, name: &str, time: f64) -> Option<f64> {
        self.iter()
            .find(|(other, _)| *other == name)
            .map(|(_, curve)| curve.value(time))
    }

    /// The values of all tracks at a time, in their order.
    ///
    /// # Errors
    ///
    /// [`CurveError::Length`] where there is not one place for each track.
    pub fn sample_into(&self, time: f64, values: &mut [f64]) -> Result<(), CurveError> {
        if values.len() != self.tracks.len() {
            let (times, found) = (self.tracks.len(), values.len());
            return Err(CurveError::Length {
                what: "places",
                times,
                found,
            });
        }
        for (value, (_, curve)) in values.iter_mut().zip(&self.tracks) {
            *value = curve.value(time);
        }
        Ok(())
    }
}
