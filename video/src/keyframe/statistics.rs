//! How many shots have a background that stands still.

use std::iter::Sum;
use std::ops::Add;

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::shot::{Background, Shot};

/// Counts of shots, as in Cui, table 1.
///
/// ```
/// use ga_video::keyframe::statistics::Statistics;
///
/// // The columns of Cui, table 1, and their total.
/// let column = |static_shots, dynamic_shots| Statistics { static_shots, dynamic_shots };
/// let columns = [column(336, 223), column(182, 130), column(221, 167)];
/// assert_eq!(columns[0].shots(), 559);
/// let total: Statistics = columns.into_iter().sum();
/// assert_eq!([total.shots(), total.static_shots, total.dynamic_shots], [1259, 739, 520]);
/// assert!((total.static_proportion().unwrap() - 0.587).abs() < 5e-4);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Shots whose background stands still.
    pub static_shots: usize,
    /// Shots whose background moves.
    pub dynamic_shots: usize,
}

impl Statistics {
    /// Counts shots.
    #[must_use]
    pub fn of(shots: &[Shot]) -> Self {
        let still = |shot: &&Shot| shot.background == Background::Static;
        let static_shots = shots.iter().filter(still).count();
        Self {
            static_shots,
            dynamic_shots: shots.len() - static_shots,
        }
    }

    /// All shots.
    #[must_use]
    pub fn shots(&self) -> usize {
        self.static_shots + self.dynamic_shots
    }

    /// The proportion of shots whose background stands still, where there are shots.
    #[must_use]
    pub fn static_proportion(&self) -> Option<f64> {
        let shots = self.shots();
        (shots > 0).then(|| self.static_shots as f64 / shots as f64)
    }
}

impl Serialize for Statistics {
    /// `shots`, of which are `static` and `dynamic`, and `static_proportion`.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Statistics", 4)?;
        object.serialize_field("shots", &self.shots())?;
        object.serialize_field("static", &self.static_shots)?;
        object.serialize_field("dynamic", &self.dynamic_shots)?;
        object.serialize_field("static_proportion", &self.static_proportion())?;
        object.end()
    }
}

impl Add for Statistics {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            static_shots: self.static_shots + other.static_shots,
            dynamic_shots: self.dynamic_shots + other.dynamic_shots,
        }
    }
}

impl Sum for Statistics {
    fn sum<I: Iterator<Item = Self>>(items: I) -> Self {
        items.fold(Self::default(), Add::add)
    }
}
