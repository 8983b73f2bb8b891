//! The motions between the cameras of a rig, by the boards that two of them see at once.

use ga_runtime::cga3::{Motor, Point};

use super::error::CalibrationError;

/// For each camera but the first the motor from the first camera's frame into its own: along the
/// tree in which cameras that see most boards together are neighbours.
///
/// `boards` has for each camera and each frame the motor of the board, where the camera sees it.
pub(super) fn motions_from_first(
    boards: &[&[Option<Motor<f64>>]],
    places: &[Point<f64>],
) -> Result<Vec<Motor<f64>>, CalibrationError> {
    let common = |a: usize, b: usize| -> Vec<[Motor<f64>; 2]> {
        let both = boards[a].iter().zip(boards[b]);
        both.filter_map(|(a, b)| Some([(*a)?, (*b)?])).collect()
    };
    let mut motions: Vec<Option<Motor<f64>>> = vec![None; boards.len()];
    motions[0] = Some(Motor::default());
    // The next camera is the one that has the most boards in common with one that is reached, the
    // first one of several.
    loop {
        let (mut best, mut pairs) = (None, Vec::new());
        for (from, motion) in motions.iter().enumerate() {
            let Some(motion) = motion else { continue };
            for to in (0..boards.len()).filter(|to| motions[*to].is_none()) {
                let found = common(from, to);
                if found.len() > pairs.len() {
                    (best, pairs) = (Some((to, *motion)), found);
                }
            }
        }
        let Some((to, motion)) = best else {
            break;
        };
        motions[to] = Some(short(median_motion(&pairs, places) * motion));
    }
    let missing = (0..boards.len()).filter(|camera| motions[*camera].is_none());
    let missing: Vec<usize> = missing.collect();
    match missing.is_empty() {
        true => Ok(motions.into_iter().flatten().skip(1).collect()),
        false => Err(CalibrationError::Disconnected { cameras: missing }),
    }
}

/// Of the motors from one frame to another that single boards give, the one that is nearest to the
/// others: the sum of the distances between corners in space is least.
fn median_motion(boards: &[[Motor<f64>; 2]], places: &[Point<f64>]) -> Motor<f64> {
    let motions = boards.iter().map(|[from, to]| *to * from.reverse());
    let motions: Vec<Motor<f64>> = motions.collect();
    // The first and the last corner, and one beside the line between them.
    let middle = places.len() / 2;
    let probes = [0, middle, places.len() - 1].map(|index| places[index]);
    let distance = |motion: &Motor<f64>| -> f64 {
        let distances = boards.iter().map(|[from, to]| {
            let apart = |probe: &Point<f64>| {
                let through = motion.transform(from.transform(*probe));
                through.distance(to.transform(*probe))
            };
            probes.iter().map(apart).sum::<f64>()
        });
        distances.sum()
    };
    let distances: Vec<f64> = motions.iter().map(distance).collect();
    let best = (0..motions.len()).min_by(|a, b| distances[*a].total_cmp(&distances[*b]));
    best.map_or_else(Motor::default, |best| motions[best])
}

/// Of a motor and its negative, which move alike, the one that rotates by the smaller angle.
fn short(motor: Motor<f64>) -> Motor<f64> {
    match motor.rotor().scalar() < 0.0 {
        true => -motor,
        false => motor,
    }
}
