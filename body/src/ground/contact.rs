//! When feet stand.

use std::ops::RangeInclusive;

use ga_runtime::vga3::Vector;

/// A point of a foot stands while it moves slower than this, in metres a second…
const SPEED: f64 = 0.25;
/// …over this time before and after, in seconds…
const WINDOW: f64 = 0.05;
/// …for at least this long…
const SHORTEST: f64 = 0.12;
/// …and is not higher than this above the lowest standing point of its kind, in metres.
const HIGHEST: f64 = 0.12;
/// How far a point that stands is from one place, as a standard deviation in metres.
const STANDING: f64 = 0.002;

/// A time during which a point of a body stands in a place.
#[derive(Clone, Debug)]
pub(crate) struct Stance {
    /// Which point of the model.
    pub(crate) point: usize,
    pub(crate) frames: RangeInclusive<usize>,
    pub(crate) place: Vector<f64>,
}

/// A place at which a point is held.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Anchor {
    pub(crate) point: usize,
    pub(crate) place: Vector<f64>,
    /// The inverse of the variance of each coordinate.
    pub(crate) weight: f64,
}

/// When points of feet stand: `places` has for each frame where the points of the body are.
pub(crate) fn stances(
    places: &[Vec<Vector<f64>>],
    feet: &[usize],
    up: Vector<f64>,
    frames_per_second: f64,
) -> Vec<Stance> {
    let reach = ((WINDOW * frames_per_second).round() as usize).max(1);
    let shortest = ((SHORTEST * frames_per_second).ceil() as usize).max(2);
    let last = places.len().saturating_sub(1);
    let mut found = Vec::new();
    for &point in feet {
        let is_slow = |frame: usize| {
            let (from, to) = (frame.saturating_sub(reach), (frame + reach).min(last));
            let seconds = (to - from) as f64 / frames_per_second;
            seconds > 0.0 && places[from][point].distance(places[to][point]) < SPEED * seconds
        };
        let mut of_point: Vec<Stance> = Vec::new();
        let mut frame = 0;
        while frame < places.len() {
            if !is_slow(frame) {
                frame += 1;
                continue;
            }
            let end = (frame..places.len())
                .take_while(|&f| is_slow(f))
                .last()
                .unwrap_or(frame);
            if end + 1 - frame >= shortest {
                of_point.push(Stance {
                    point,
                    frames: frame..=end,
                    place: middle(&places[frame..=end], point),
                });
            }
            frame = end + 1;
        }
        let height = |stance: &Stance| stance.place.dot(up);
        let lowest = of_point.iter().map(height).fold(f64::INFINITY, f64::min);
        of_point.retain(|stance| height(stance) - lowest < HIGHEST);
        found.extend(of_point);
    }
    found
}

/// For each frame the places at which points are held.
pub(crate) fn anchors(stances: &[Stance], frames: usize) -> Vec<Vec<Anchor>> {
    let mut anchors = vec![Vec::new(); frames];
    for stance in stances {
        for frame in stance.frames.clone() {
            anchors[frame].push(Anchor {
                point: stance.point,
                place: stance.place,
                weight: 1.0 / (STANDING * STANDING),
            });
        }
    }
    anchors
}

/// The median place of a point, coordinate by coordinate.
fn middle(places: &[Vec<Vector<f64>>], point: usize) -> Vector<f64> {
    let coordinate = |k: usize| {
        let mut all: Vec<f64> = places.iter().map(|p| p[point].coordinates()[k]).collect();
        ga_numerics::order_statistics::median(&mut all).unwrap_or_default()
    };
    Vector::new(coordinate(0), coordinate(1), coordinate(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_foot_stands_between_two_steps() {
        // At 50 frames a second: 20 frames at rest, a step of 0.6 m in 20 frames, 20 at rest.
        let along = |frame: usize| 0.03 * (frame.clamp(20, 40) - 20) as f64;
        let places: Vec<Vec<Vector<f64>>> = (0..60)
            .map(|frame| {
                vec![
                    Vector::new(along(frame), 0.1, 0.0),
                    Vector::new(0.0, 0.5, 0.0),
                ]
            })
            .collect();
        let found = stances(&places, &[0], Vector::Y, 50.0);
        assert_eq!(found.len(), 2);
        for (stance, (first, end, at)) in found.iter().zip([(0, 20, 0.0), (40, 59, 0.6)]) {
            assert!(stance.frames.start().abs_diff(first) <= 3, "{stance:?}");
            assert!(stance.frames.end().abs_diff(end) <= 3, "{stance:?}");
            assert!(
                stance.place.distance(Vector::new(at, 0.1, 0.0)) < 1e-9,
                "{stance:?}"
            );
        }
        let held = anchors(&found, 60);
        assert!(held[10].len() == 1 && held[30].is_empty());
    }

    #[test]
    fn a_foot_that_is_held_in_the_air_does_not_stand() {
        let height = |frame: usize| if frame < 40 { 0.1 } else { 0.5 };
        let places: Vec<Vec<Vector<f64>>> = (0..80)
            .map(|frame| vec![Vector::new(0.0, height(frame), 0.0)])
            .collect();
        let found = stances(&places, &[0], Vector::Y, 50.0);
        assert_eq!(found.len(), 1);
        assert!(*found[0].frames.end() < 40);
    }
}
