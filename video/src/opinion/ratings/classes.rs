//! Ratings that are counted together.

use super::Ratings;

/// The most ratings that are told apart; of more, classes are counted.
const MOST: usize = 9;

/// About the number of classes.
const CLASSES: f64 = 5.0;

/// Ratings from `low` to `high`. All classes but the last are without their upper end, where that
/// is not the lower one too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Class {
    low: f64,
    high: f64,
    has_high: bool,
}

impl Class {
    pub(super) fn count(&self, ratings: &[f64]) -> usize {
        let is_within = |rating: &&f64| {
            **rating >= self.low && (**rating < self.high || self.has_high && **rating == self.high)
        };
        ratings.iter().filter(is_within).count()
    }

    pub(super) fn name(&self) -> String {
        let rounded = |value: f64| (value * 1e3).round() / 1e3;
        if self.low == self.high {
            return rounded(self.low).to_string();
        }
        format!("{} to {}", rounded(self.low), rounded(self.high))
    }
}

/// The ratings that occur, in rising order.
pub(super) fn scale(ratings: &Ratings) -> Vec<f64> {
    let raters = ratings.raters().iter();
    let mut values: Vec<f64> = raters
        .flat_map(|r| r.ratings.iter().flatten().copied())
        .collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// Each rating of the scale, or classes of equal width with round ends where there are many.
pub(super) fn classes(scale: &[f64]) -> Vec<Class> {
    let single = |value: &f64| Class {
        low: *value,
        high: *value,
        has_high: true,
    };
    let (Some(least), Some(greatest), true) = (scale.first(), scale.last(), scale.len() > MOST)
    else {
        return scale.iter().map(single).collect();
    };
    let width = round_up((greatest - least) / CLASSES);
    let first = (least / width).floor();
    let count = (greatest / width).ceil() - first;
    let class = |place: usize| Class {
        low: width * (first + place as f64),
        high: width * (first + place as f64 + 1.0),
        has_high: place as f64 + 1.0 == count,
    };
    // Rounding may leave a rating out; then all are told apart.
    let found: Vec<Class> = (0..count as usize).map(class).collect();
    match (found.first(), found.last()) {
        (Some(low), Some(high)) if low.low <= *least && *greatest <= high.high => found,
        _ => scale.iter().map(single).collect(),
    }
}

/// The least of 1, 2, 2.5 and 5 times a power of ten that is not less than a positive number.
fn round_up(number: f64) -> f64 {
    let power = 10f64.powf(number.log10().floor());
    let factors = [1.0, 2.0, 2.5, 5.0];
    let factor = factors.into_iter().find(|f| f * power >= number);
    factor.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rating_is_in_one_class() {
        for count in [1, 2, 9, 10, 101] {
            let scale: Vec<f64> = (0..count).map(f64::from).collect();
            let classes = classes(&scale);
            assert_eq!(classes.len(), if count > 9 { 5 } else { scale.len() });
            for rating in &scale {
                let found = classes.iter().map(|class| class.count(&[*rating]));
                assert_eq!(found.sum::<usize>(), 1, "{rating} of {count}");
            }
        }
        let scale: Vec<f64> = (0..=100).map(f64::from).collect();
        let classes = classes(&scale);
        assert_eq!(classes[1].name(), "20 to 40");
        assert_eq!(classes[1].count(&[19.9, 20.0, 39.9, 40.0]), 2);
        assert_eq!(classes[4].count(&[80.0, 100.0]), 2);
        let scale: Vec<f64> = (0..50).map(|k| 6.3 + 1.9 * f64::from(k)).collect();
        let names: Vec<String> = super::classes(&scale).iter().map(Class::name).collect();
        assert_eq!(names[0], "0 to 20");
        assert_eq!(names[4], "80 to 100");
    }
}
