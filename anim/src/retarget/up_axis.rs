//! Which axis of a recording is the vertical.

use std::fmt;

use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::Rotor;
use ga_runtime::vga3::Vector;

use super::human::Human;

/// The axis of a recording that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum UpAxis {
    /// +x.
    X,
    /// −x.
    NegativeX,
    /// +y, as BVH has it by convention, and glTF by definition.
    #[default]
    Y,
    /// −y.
    NegativeY,
    /// +z, as in Blender, Unreal Engine and many recordings of research.
    Z,
    /// −z.
    NegativeZ,
}

impl fmt::Display for UpAxis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::X => "x",
            Self::NegativeX => "-x",
            Self::Y => "y",
            Self::NegativeY => "-y",
            Self::Z => "z",
            Self::NegativeZ => "-z",
        })
    }
}

/// The vertical that a motion shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundUpAxis {
    /// The axis.
    pub axis: UpAxis,
    /// By how much it is clear, from 0 to 1: how much farther the head is above the feet along it,
    /// in the median over all frames, than along the next axis, as a part of the former.
    pub margin: f64,
}

/// The least margin of a vertical that is clear: of 311 windows of a second, the one that was wrong
/// had 0.08.
const CLEAR: f64 = 0.4;

impl FoundUpAxis {
    /// Whether another axis is much less likely.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        self.margin >= CLEAR
    }
}

impl UpAxis {
    /// The direction of the axis.
    #[must_use]
    pub fn direction(self) -> Vector<f64> {
        match self {
            Self::X => Vector::new(1.0, 0.0, 0.0),
            Self::NegativeX => Vector::new(-1.0, 0.0, 0.0),
            Self::Y => Vector::new(0.0, 1.0, 0.0),
            Self::NegativeY => Vector::new(0.0, -1.0, 0.0),
            Self::Z => Vector::new(0.0, 0.0, 1.0),
            Self::NegativeZ => Vector::new(0.0, 0.0, -1.0),
        }
    }

    /// The shortest rotation that makes it the y axis: for z, (x, y, z) becomes (x, z, −y).
    #[must_use]
    pub fn to_y(self) -> Rotor<f64> {
        let half = Rotor::from_axis_angle([1.0, 0.0, 0.0], std::f64::consts::PI);
        let rotor = match self {
            Self::Y => Some(Rotor::default()),
            // Every axis across is as near: x keeps left and right.
            Self::NegativeY => half,
            other => Rotor::between(other.direction().coordinates(), [0.0, 1.0, 0.0]),
        };
        rotor.unwrap_or_default()
    }
}

/// The vertical by the way from the feet to the head; `None` without frames.
pub(super) fn find<'a>(
    human: &Human,
    moments: impl Iterator<Item = &'a [Vector<f64>]>,
) -> Option<FoundUpAxis> {
    let mut components = [const { Vec::new() }; 3];
    for places in moments {
        let [left, right] = human.legs.map(|leg| places[leg[2]]);
        let above = places[human.head] - (left + right) * 0.5;
        for (list, value) in components.iter_mut().zip(above.coordinates()) {
            list.push(value);
        }
    }
    let mut medians = [0.0; 3];
    for (median, list) in medians.iter_mut().zip(&mut components) {
        *median = Sorted::new(list)?.quantile(0.5);
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| medians[b].abs().total_cmp(&medians[a].abs()));
    let [first, next] = [order[0], order[1]].map(|axis| medians[axis].abs());
    let margin = 1.0 - next / first;
    // Most files have y up, which counts where another axis is hardly more likely.
    if margin < CLEAR && order[1] == 1 && medians[1] > 0.0 {
        order.swap(0, 1);
    }
    let axis = match (order[0], medians[order[0]] < 0.0) {
        (0, false) => UpAxis::X,
        (0, true) => UpAxis::NegativeX,
        (1, false) => UpAxis::Y,
        (1, true) => UpAxis::NegativeY,
        (_, false) => UpAxis::Z,
        (_, true) => UpAxis::NegativeZ,
    };
    (first > 0.0).then_some(FoundUpAxis { axis, margin })
}
