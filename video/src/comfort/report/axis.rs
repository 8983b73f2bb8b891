//! Time to the right, as all charts of the report have it.

use crate::comfort::Timeline;

use ga_draw::document::{Anchor, Svg, ticks};

/// How wide a chart is, and where its time begins and ends.
pub(super) const WIDTH: f64 = 980.0;
pub(super) const LEFT: f64 = 185.0;
pub(super) const RIGHT: f64 = 830.0;

pub(super) const INK: &str = "#2c3440";
pub(super) const FAINT: &str = "#8a93a0";

/// Numbers along time at most.
const LABELS: usize = 10;

/// The intervals of a video, each as wide as the others.
#[derive(Clone, Copy)]
pub(super) struct TimeAxis<'a> {
    timeline: &'a Timeline,
}

impl<'a> TimeAxis<'a> {
    pub(super) fn new(timeline: &'a Timeline) -> Self {
        Self { timeline }
    }

    /// The width of an interval.
    pub(super) fn step(&self) -> f64 {
        (RIGHT - LEFT) / self.timeline.intervals().len().max(1) as f64
    }

    /// Where an interval begins.
    pub(super) fn start(&self, index: usize) -> f64 {
        LEFT + self.step() * index as f64
    }

    /// Its middle.
    pub(super) fn middle(&self, index: usize) -> f64 {
        LEFT + self.step() * (index as f64 + 0.5)
    }

    /// What an interval is, in words.
    pub(super) fn unit(&self) -> String {
        match self.timeline.seconds() {
            None => "one frame".into(),
            Some(seconds) if seconds < 1.0 => format!("{seconds} seconds"),
            Some(1.0) => "one second".into(),
            Some(seconds) => format!("{seconds:.0} seconds"),
        }
    }

    /// Where shots begin, except for the first one; none if they would hide the chart.
    pub(super) fn cuts(&self) -> Vec<f64> {
        let intervals = self.timeline.intervals().iter().enumerate();
        let begin =
            intervals.filter(|(index, interval)| interval.summary.shots > usize::from(*index == 0));
        let cuts: Vec<f64> = begin.map(|(index, _)| self.start(index)).collect();
        match cuts.len() * 4 > self.timeline.intervals().len() && cuts.len() > 12 {
            true => Vec::new(),
            false => cuts,
        }
    }

    /// Lines where shots begin.
    pub(super) fn draw_cuts(&self, svg: &mut Svg, [top, bottom]: [f64; 2]) {
        for x in self.cuts() {
            svg.line(
                [x, top],
                [x, bottom],
                "stroke=\"#000\" stroke-width=\"1.2\" stroke-dasharray=\"4 3\"",
            );
        }
    }

    /// The numbers below a chart, in 34 units of height.
    pub(super) fn draw(&self, svg: &mut Svg, y: f64) {
        let intervals = self.timeline.intervals();
        let [Some(first), Some(last)] = [intervals.first(), intervals.last()] else {
            return;
        };
        svg.line(
            [LEFT, y],
            [RIGHT, y],
            &format!("stroke=\"{INK}\" stroke-width=\"1\""),
        );
        let (marks, name): (Vec<(f64, String)>, _) = match self.timeline.seconds() {
            None => {
                let range = [first.first_frame as f64, last.first_frame as f64];
                let frames = ticks(range, LABELS)
                    .into_iter()
                    .filter(|frame| frame.fract() == 0.0);
                let mark = |frame: f64| (frame, format!("{frame:.0}"));
                (frames.map(mark).collect(), "frame")
            }
            Some(_) => {
                let times = times([first.start_seconds, last.start_seconds]);
                let mark = |seconds: f64| (seconds, clock(seconds));
                let name = "time (hours:)minutes:seconds";
                (times.into_iter().map(mark).collect(), name)
            }
        };
        let is_frames = self.timeline.seconds().is_none();
        for (value, text) in marks {
            let place = intervals.partition_point(|interval| match is_frames {
                true => (interval.first_frame as f64) < value,
                false => interval.start_seconds < value - 1e-6,
            });
            let x = match is_frames {
                true => self.middle(place),
                false => self.start(place),
            };
            svg.line([x, y], [x, y + 5.0], &format!("stroke=\"{INK}\""));
            let attributes = format!("fill=\"{INK}\"");
            svg.text([x, y + 18.0], 12.0, Anchor::Middle, &attributes, &text);
        }
        let attributes = format!("fill=\"{FAINT}\"");
        svg.text([RIGHT, y + 33.0], 12.0, Anchor::End, &attributes, name);
    }
}

/// Round times: whole seconds, parts of a minute or of an hour.
fn times([first, last]: [f64; 2]) -> Vec<f64> {
    const STEPS: [f64; 14] = [
        1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0, 7200.0,
    ];
    let least = (last - first) / LABELS as f64;
    match STEPS.into_iter().find(|step| *step >= least) {
        Some(step) => {
            let from = (first / step).ceil() as u64;
            let to = (last / step).floor() as u64;
            (from..=to).map(|k| k as f64 * step).collect()
        }
        None => ticks([first, last], LABELS),
    }
}

/// A time as minutes and seconds, with hours where there are some.
pub(super) fn clock(seconds: f64) -> String {
    let whole = seconds.round().max(0.0) as u64;
    let (hours, minutes, seconds) = (whole / 3600, whole / 60 % 60, whole % 60);
    match hours {
        0 => format!("{minutes}:{seconds:02}"),
        _ => format!("{hours}:{minutes:02}:{seconds:02}"),
    }
}

/// Names beside the right end of lines, moved apart where they would touch.
pub(super) fn draw_labels(svg: &mut Svg, mut labels: Vec<(f64, &str, &str)>) {
    const APART: f64 = 14.0;
    labels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut places: Vec<f64> = labels.iter().map(|label| label.0).collect();
    for _ in 0..100 {
        for k in 1..places.len() {
            let overlap = APART - (places[k] - places[k - 1]);
            if overlap > 0.0 {
                places[k - 1] -= 0.5 * overlap;
                places[k] += 0.5 * overlap;
            }
        }
    }
    for ((line, text, colour), place) in labels.into_iter().zip(places) {
        let style = format!("stroke=\"{colour}\" stroke-width=\"0.8\"");
        svg.line([RIGHT, line], [RIGHT + 10.0, place], &style);
        let fill = format!("fill=\"{colour}\"");
        svg.text(
            [RIGHT + 13.0, place + 4.0],
            12.0,
            Anchor::Start,
            &fill,
            text,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::{clock, times};

    #[test]
    fn times_are_round() {
        assert_eq!(
            times([0.0, 47.0]),
            [0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0]
        );
        assert_eq!(times([0.0, 10_800.0])[1], 1800.0);
        assert_eq!(clock(3725.4), "1:02:05");
        assert_eq!(clock(59.6), "1:00");
    }
}
