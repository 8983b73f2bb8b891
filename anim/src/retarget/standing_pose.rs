//! Whether places of joints at rest are those of a person who stands.

use ga_runtime::cga3::{Direction, Rotor};
use ga_runtime::vga3::Vector;

use super::human::Human;
use super::posture::Posture;

/// The greatest angles of a person who stands, in degrees: of the trunk and of a leg from the
/// vertical, of the toes from straight forwards, of an elbow's bend, between the left side and the
/// reflected right one, and between the lines of hips and shoulders.
const TRUNK: f64 = 25.0;
const LEG: f64 = 30.0;
const TOES: f64 = 60.0;
const ELBOW: f64 = 45.0;
const SYMMETRY: f64 = 20.0;
const SHOULDERS: f64 = 20.0;

/// The rotation after which a body stands upright, y up, and looks along z: one of the 24 that take
/// axes to axes; `None` where the body stands in none of them.
pub(super) fn standing_orientation(human: &Human, places: &[Vector<f64>]) -> Option<Rotor<f64>> {
    let mut best: Option<(f64, Rotor<f64>)> = None;
    for rotor in rotations_of_axes() {
        let rotate = |&place: &Vector<f64>| rotor.transform(Direction::from(place)).into();
        let rotated: Vec<Vector<f64>> = places.iter().map(rotate).collect();
        let posture = Posture {
            human,
            places: &rotated,
        };
        let Some(deviation) = deviation(&posture) else {
            continue;
        };
        if best.as_ref().is_none_or(|&(least, _)| deviation < least) {
            best = Some((deviation, rotor));
        }
    }
    best.map(|(_, rotor)| rotor)
}

/// How far a body is from one that stands and looks along z; `None` where it does not stand.
fn deviation(posture: &Posture) -> Option<f64> {
    let Posture { human, places } = posture;
    let (up, forward) = (Vector::new(0.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0));
    let between = |from: usize, to: usize| places[to] - places[from];
    let degrees = |a: Vector<f64>, b: Vector<f64>| Some(a.angle(b)?.to_degrees());
    let within = |angle: f64, limit: f64| (angle <= limit).then_some(angle / limit);
    let mirrored = |v: Vector<f64>| Vector::new(-v.e1, v.e2, v.e3);

    let hips = between(human.legs[1][0], human.legs[0][0]);
    let mut sum = within(degrees(posture.trunk(), up)?, TRUNK)?;
    // Bodies look along an axis: a quarter of a full rotation further, left is elsewhere.
    sum += within(degrees(hips, Vector::new(1.0, 0.0, 0.0))?, 44.0)?;
    let legs = human.legs.map(|[hip, _, ankle]| between(hip, ankle));
    for leg in legs {
        sum += within(degrees(leg, -up)?, LEG)?;
    }
    sum += within(degrees(legs[0], mirrored(legs[1]))?, SYMMETRY)?;
    for (leg, toes) in human.legs.iter().zip(human.toes) {
        let Some(toes) = toes else { continue };
        let bone = between(leg[2], toes);
        let level = Vector::new(bone.e1, 0.0, bone.e3);
        sum += within(degrees(level, forward)?, TOES)?;
    }
    if let Some(arms) = human.arms {
        let shoulders = between(arms[1][0], arms[0][0]);
        sum += within(degrees(shoulders, hips)?, SHOULDERS)?;
        for [shoulder, elbow, wrist] in arms {
            sum += within(
                degrees(between(shoulder, elbow), between(elbow, wrist))?,
                ELBOW,
            )?;
        }
        let [left, right] = arms.map(|[shoulder, _, wrist]| between(shoulder, wrist));
        sum += within(degrees(left, mirrored(right))?, SYMMETRY)?;
    }
    Some(sum)
}

/// The 24 rotations that take axes to axes, the identity first.
fn rotations_of_axes() -> impl Iterator<Item = Rotor<f64>> {
    use std::f64::consts::FRAC_PI_2;
    let about = |axis: [f64; 3], quarters: u8| {
        Rotor::from_axis_angle(axis, f64::from(quarters) * FRAC_PI_2).unwrap_or_default()
    };
    // Which axis becomes the vertical, and then the four directions to look along.
    let to_vertical = [
        about([1.0, 0.0, 0.0], 0),
        about([1.0, 0.0, 0.0], 3),
        about([1.0, 0.0, 0.0], 1),
        about([1.0, 0.0, 0.0], 2),
        about([0.0, 0.0, 1.0], 1),
        about([0.0, 0.0, 1.0], 3),
    ];
    to_vertical.into_iter().flat_map(move |upright| {
        (0..4).map(move |quarters| about([0.0, 1.0, 0.0], quarters) * upright)
    })
}
