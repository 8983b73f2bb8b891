//! The search for the farthest vertex whose chord can be proven.

use super::Distance;
use super::chord::Chords;
use super::path::Path;
use crate::curve::CurveError;

/// The share of the tolerance from which a chord is good enough.
const GOOD: f64 = 0.985;
/// Trials for one chord.
const MOST_TRIALS: usize = 200;

/// The times of the vertices, and the largest proven deviation.
pub(super) fn vertices(
    path: &Path,
    tolerance: f64,
    distance: Distance,
    most: usize,
) -> Result<(Vec<f64>, f64), CurveError> {
    if !(tolerance.is_finite() && tolerance > 0.0) {
        return Err(CurveError::Tolerance(tolerance));
    }
    let least = 16.0 * (path.largest.next_up() - path.largest);
    if tolerance < least {
        return Err(CurveError::TooFine { tolerance, least });
    }
    if let Some(key) = path.jump() {
        return Err(CurveError::Jump { key });
    }
    let (start, end) = (path.times[0], path.times[path.times.len() - 1]);
    let bound = tolerance * path.scale;
    let mut chords = Chords::new(path, distance);
    let (mut times, mut largest) = (vec![start], 0.0_f64);
    let (mut time, mut guess) = (start, end - start);
    while time < end {
        if times.len() >= most {
            return Err(CurveError::TooMany { tolerance, most });
        }
        let Some((next, deviation)) = farthest(&mut chords, time, end, guess, bound) else {
            return Err(CurveError::TimeTooCoarse { time, tolerance });
        };
        guess = next - time;
        time = next;
        times.push(time);
        largest = largest.max(deviation);
    }
    Ok((times, (largest / path.scale).min(tolerance)))
}

/// The end of a chord from `from` whose deviation is within the bound, and that deviation: as far
/// as can be found, to about a percent.
fn farthest(
    chords: &mut Chords,
    from: f64,
    end: f64,
    guess: f64,
    bound: f64,
) -> Option<(f64, f64)> {
    let mut good: Option<(f64, f64)> = None;
    let mut bad = f64::INFINITY;
    let mut length = guess;
    for trial in 0..MOST_TRIALS {
        let to = (from + length).clamp(from.next_up(), end);
        length = to - from;
        let deviation = chords.deviation(from, to);
        if deviation <= bound {
            good = Some((to, deviation));
            if to == end || deviation >= GOOD * bound {
                break;
            }
        } else {
            bad = length;
            if to == from.next_up() {
                break;
            }
        }
        let reached = good.map_or(0.0, |(to, _)| to - from);
        if bad - reached <= 0.005 * reached {
            break;
        }
        // The deviation grows with the square of the length, where the curve is smooth. Near a
        // corner it does not, and only halving is sure to end.
        let factor = (0.5 * (1.0 + GOOD) * bound / deviation)
            .sqrt()
            .clamp(0.25, 4.0);
        let next = length * factor;
        let inside = next > reached && next < bad && trial % 3 != 2;
        length = if inside {
            next
        } else {
            0.5 * (reached + bad.min(4.0 * length))
        };
    }
    good
}
