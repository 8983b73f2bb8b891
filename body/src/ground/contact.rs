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

/// The greatest distance of two of the places; 0 where there are fewer.
///
/// From a place the farthest one is taken, and from that one again, until the distance does not
/// grow. Two places in the ball that has this distance as its diameter are no farther apart, so
/// that only those outside of it, which are few, are asked for the place farthest from them
/// (G. Malandain and J.-D. Boissonnat, "Computing the diameter of a point set", International
/// Journal of Computational Geometry & Applications 12, 2002).
pub(crate) fn diameter(places: &[Vector<f64>]) -> f64 {
    let farthest = |from: Vector<f64>, among: &[Vector<f64>]| {
        let all = among.iter().map(|place| (from.distance(*place), *place));
        all.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default()
    };
    let mut open = places.to_vec();
    let mut from = places.first().copied().unwrap_or_default();
    let (mut greatest, mut middle) = (0.0, from);
    loop {
        let mut own = 0.0;
        loop {
            open.retain(|place| *place != from);
            let (distance, to) = farthest(from, places);
            if distance <= own {
                break;
            }
            if distance > greatest {
                (greatest, middle) = (distance, (from + to) * 0.5);
            }
            (own, from) = (distance, to);
        }
        let (distance, next) = farthest(middle, &open);
        // A place on the ball is in it, however its distance is rounded.
        if distance <= 0.5 * greatest * (1.0 + 1e-12) {
            return greatest;
        }
        from = next;
    }
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
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

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
    fn the_diameter_is_that_of_all_pairs() {
        let random = &mut ChaCha8Rng::seed_from_u64(1);
        let mut uniform = || f64::from(random.next_u32()) / 2.0_f64.powi(32) - 0.5;
        assert_eq!(diameter(&[]), 0.0);
        assert_eq!(diameter(&[Vector::X; 3]), 0.0);
        for (count, stretch) in [(2, 1.0), (7, 1.0), (60, 1.0), (60, 0.0), (400, 5.0)] {
            for _ in 0..50 {
                let place = |_| Vector::new(stretch * uniform(), uniform(), 0.1 * uniform());
                let mut places: Vec<Vector<f64>> = (0..count).map(place).collect();
                // Some of them twice.
                places.extend_from_within(..count / 2);
                let of =
                    |a: &Vector<f64>| places.iter().map(|b| a.distance(*b)).fold(0.0, f64::max);
                let expected = places.iter().map(of).fold(0.0, f64::max);
                let found = diameter(&places);
                assert!(
                    (found - expected).abs() < 1e-11,
                    "{count}: {found} {expected}"
                );
            }
        }
        // The corners of a regular tetrahedron and one more, of which no two are a diameter's ball.
        let s = 0.5_f64.sqrt();
        let corners = [
            [1.0, 0.0, -s],
            [-1.0, 0.0, -s],
            [0.0, 1.0, s],
            [0.0, -1.0, s],
        ];
        let mut places = corners.map(Vector::from).to_vec();
        places.push(Vector::new(0.0, 1.01, s));
        let expected = places[4].distance(places[3]);
        assert!((diameter(&places) - expected).abs() < 1e-12);
    }

    /// All pairs of so many places would take minutes.
    #[test]
    fn a_foot_that_stands_for_hours_is_measured_at_once() {
        let random = &mut ChaCha8Rng::seed_from_u64(2);
        let mut uniform = || f64::from(random.next_u32()) / 2.0_f64.powi(32) - 0.5;
        let mut places: Vec<Vector<f64>> = (0..300_000)
            .map(|_| Vector::new(0.02 * uniform(), 0.01 * uniform(), 0.02 * uniform()))
            .collect();
        let ends = [[0.05, 0.0, 0.01], [-0.04, 0.01, 0.0]].map(Vector::from);
        (places[70_000], places[200_000]) = (ends[0], ends[1]);
        assert_eq!(diameter(&places), ends[0].distance(ends[1]));
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
