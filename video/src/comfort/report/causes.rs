//! Defects that explain what other rows show.

use crate::comfort::{Dimension, Geometry, Level, Record, Scale, Summary, Viewing};

/// A defect that shows in several rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cause {
    /// One eye is late.
    Delay,
    /// One camera is rotated about its axis.
    Roll,
}

impl Cause {
    /// What it is called.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Delay => "the delay of one eye",
            Self::Roll => "the rotation of one view",
        }
    }

    /// The row that shows it.
    pub(super) fn dimension(self) -> Dimension {
        match self {
            Self::Delay => Dimension::Asynchrony,
            Self::Roll => Dimension::Vertical,
        }
    }
}

/// How the rows of the right view differ over all frames: sums, and sums of squares, of shift,
/// rotation and size, each by how many columns it moves a point at the border.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Heights {
    frames: f64,
    sums: [f64; 3],
    squares: [f64; 3],
    /// How many times the picture is as high as wide.
    shape: f64,
    width: f64,
}

impl Heights {
    pub(super) fn add(&mut self, geometry: &Geometry, size: [usize; 2]) {
        let [width, height] = size.map(|side| side as f64);
        let height = geometry.pixel_height * height;
        let moves = [
            geometry.pixel_height * geometry.shift_px,
            0.5 * width * geometry.rotation_degrees.to_radians().tan(),
            0.5 * height * 0.01 * geometry.zoom_percent,
        ];
        self.frames += 1.0;
        for (axis, columns) in moves.into_iter().enumerate() {
            self.sums[axis] += columns;
            self.squares[axis] += columns * columns;
        }
        (self.shape, self.width) = (height / width, width);
    }

    fn means(&self) -> [f64; 3] {
        self.sums.map(|sum| sum / self.frames.max(1.0))
    }

    /// Whether they change more from frame to frame than they differ throughout.
    fn vary(&self) -> bool {
        let squares: f64 = self.squares.iter().sum::<f64>() / self.frames.max(1.0);
        let means: f64 = self.means().iter().map(|mean| mean * mean).sum();
        squares > 2.0 * means
    }

    /// The parallax that a rotation adds at the upper border and takes away at the lower one, in
    /// per cent of the width, where it is the greatest of the differences and strains the eyes.
    fn roll_percent(&self, viewing: &Viewing) -> Option<f64> {
        let [shift, rotation, size] = self.means().map(f64::abs);
        let percent = 100.0 * rotation / self.width.max(1.0);
        let scale = Scale::of(Dimension::Vertical, viewing)?;
        let strains = scale
            .score(60.0 * viewing.degrees_of_length(percent))
            .level()
            != Level::Green;
        let is_greatest = rotation > shift.max(size) && !self.vary();
        (strains && is_greatest).then_some(percent * self.shape)
    }
}

/// The causes that a video shows, of rows that are not green.
pub(super) fn causes(summary: &Summary, heights: &Heights, viewing: &Viewing) -> Vec<Cause> {
    let [green, orange, red] = summary.row(Dimension::Asynchrony).levels;
    let is_late = orange + red > green;
    let is_rolled = heights.roll_percent(viewing).is_some();
    let all = [(is_late, Cause::Delay), (is_rolled, Cause::Roll)];
    let found = all.into_iter().filter(|(is_found, _)| *is_found);
    found.map(|(_, cause)| cause).collect()
}

/// The cause that a row may follow from, by its worst frame.
///
/// - A delay moves the right view up and down as the camera moves, so that the vertical difference
///   changes its sign or size; and it changes parallax, by as much as the depth is seen to jump.
/// - A rotation changes parallax above and below the middle, by an amount that is known.
///
/// Depth counts as explained where it would be comfortable without that amount.
pub(super) fn cause_of(
    worst: &Record,
    dimension: Dimension,
    (summary, heights): (&Summary, &Heights),
    viewing: &Viewing,
) -> Option<Cause> {
    let causes = causes(summary, heights, viewing);
    let is_late = causes.contains(&Cause::Delay);
    let raw = worst.row(dimension).raw?;
    let is_comfortable_less = |amount: f64| {
        let scale = Scale::of(dimension, viewing);
        scale.is_some_and(|scale| scale.score((raw - amount).max(0.0)).level() == Level::Green)
    };
    // How far the depth jumps, in degrees.
    let jumps = summary.row(Dimension::ParallaxDeviation).raw_range;
    let jump = jumps.map_or(0.0, |[low, high]| low.abs().max(high.abs()) / 60.0);
    let roll = heights.roll_percent(viewing).unwrap_or(0.0);
    let (of_delay, of_roll) = match dimension {
        Dimension::Vertical => (heights.vary(), false),
        Dimension::ParallaxDeviation => (worst.frame == 0 || !worst.begins_shot, false),
        Dimension::OverConvergence | Dimension::OverDivergence => (
            is_comfortable_less(jump),
            is_comfortable_less(viewing.degrees_of_length(roll)),
        ),
        Dimension::RichDepth => (false, is_comfortable_less(2.0 * roll)),
        _ => (false, false),
    };
    match (is_late && of_delay, of_roll && roll > 0.0) {
        (true, _) => Some(Cause::Delay),
        (_, true) => Some(Cause::Roll),
        _ => None,
    }
}
