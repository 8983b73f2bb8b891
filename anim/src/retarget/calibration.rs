//! How the axes of each joint stand in the body, found from what a motion does.

use ga_runtime::cga3::{Direction, Motor, Point, Rotor};
use ga_runtime::vga3::Vector;

use super::human::{Human, Role};
use super::posture::{Observation, Posture};

/// As fractions of the leg's length, and of it a second: the height above the lowest place and the
/// speed at which an ankle hardly belongs to a foot on the ground.
const HEIGHT: f64 = 0.05;
const SPEED: f64 = 0.25;

/// A moment of a motion.
pub(super) struct Moment {
    /// The frames of the joints.
    pub(super) motors: Vec<Motor<f64>>,
    /// Where the joints are.
    pub(super) places: Vec<Vector<f64>>,
    /// How far each ankle moves in a second from here on.
    pub(super) speeds: [f64; 2],
}

impl Moment {
    /// The moment of these frames of the joints, with ankles at rest.
    pub(super) fn new(motors: Vec<Motor<f64>>) -> Self {
        let place = |motor: &Motor<f64>| motor.transform(Point::default()).into();
        Self {
            places: motors.iter().map(place).collect(),
            motors,
            speeds: [0.0; 2],
        }
    }
}

/// The moments of a motion, and how much the body stands in each.
pub(super) struct Calibration<'a> {
    human: &'a Human,
    moments: &'a [Moment],
    standing: Vec<f64>,
    contact: Vec<[f64; 2]>,
    /// The least cost of standing of all moments, see [`Posture::cost_of_standing`].
    pub(super) least_cost: f64,
}

impl<'a> Calibration<'a> {
    pub(super) fn new(human: &'a Human, moments: &'a [Moment]) -> Self {
        let posture = |moment: &'a Moment| Posture {
            human,
            places: &moment.places,
        };
        let costs: Vec<f64> = moments
            .iter()
            .map(|moment| posture(moment).cost_of_standing())
            .collect();
        let leg = moments.iter().map(|moment| posture(moment).leg_length());
        let leg = leg.fold(0.0, f64::max);
        let heights = |side: usize| {
            let ankle = human.legs[side][2];
            moments.iter().map(move |moment| moment.places[ankle].e2)
        };
        let lowest = [0, 1].map(|side| heights(side).fold(f64::INFINITY, f64::min));
        let contact_costs = moments.iter().map(|moment| {
            [0, 1].map(|side| {
                let height = moment.places[human.legs[side][2]].e2 - lowest[side];
                let square = |value: f64, usual: f64| (value / (usual * leg)).powi(2);
                square(height, HEIGHT) + square(moment.speeds[side], SPEED)
            })
        });
        let contact_costs: Vec<[f64; 2]> = contact_costs.collect();
        let least = [0, 1].map(|side| least(contact_costs.iter().map(|costs| costs[side])));
        let least_cost = self::least(costs.iter().copied());
        Self {
            human,
            moments,
            standing: costs.iter().map(|cost| (least_cost - cost).exp()).collect(),
            contact: contact_costs
                .iter()
                .map(|costs| [0, 1].map(|side| (least[side] - costs[side]).exp()))
                .collect(),
            least_cost,
        }
    }

    /// The moment at which the body stands most.
    pub(super) fn most_upright(&self) -> Option<&'a Moment> {
        let standing = self.standing.iter().enumerate();
        let (most, _) = standing.max_by(|a, b| a.1.total_cmp(b.1))?;
        self.moments.get(most)
    }

    /// The rotor A that takes left, up and forward to the axes of a joint: ~G F in the mean over
    /// all moments, with the joint's rotor G and the axes F that its role has there.
    pub(super) fn axes_of(&self, joint: usize, role: Role) -> Option<Rotor<f64>> {
        let mut sums = [[Vector::default(); 3]; 2];
        for (number, moment) in self.moments.iter().enumerate() {
            let posture = Posture {
                human: self.human,
                places: &moment.places,
            };
            let found = posture.observe(role, self.standing[number], self.contact[number]);
            let back = moment.motors[joint].rotor().reverse();
            for Observation {
                axes,
                weight,
                is_fallback,
            } in found
            {
                let sums = &mut sums[usize::from(is_fallback)];
                for (sum, axis) in sums.iter_mut().zip(axes) {
                    *sum += Vector::from(back.transform(Direction::from(axis))) * weight;
                }
            }
        }
        sums.into_iter().find_map(nearest_rotor)
    }

    /// The rotor that takes the axes of the target to those of a joint which is, in the mean, not
    /// rotated relative to one above: ~G R in the mean, with the rotor `above` of the target in
    /// each moment.
    pub(super) fn relative_to(
        &self,
        joint: usize,
        above: impl Fn(&Moment) -> Rotor<f64>,
    ) -> Option<Rotor<f64>> {
        let mut sums = [Vector::default(); 3];
        for moment in self.moments {
            let relative = moment.motors[joint].rotor().reverse() * above(moment);
            for (axis, sum) in sums.iter_mut().enumerate() {
                *sum += Vector::from(relative.transform(Direction::from(unit(axis))));
            }
        }
        nearest_rotor(sums)
    }
}

fn least(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::INFINITY, f64::min)
}

fn unit(axis: usize) -> Vector<f64> {
    Vector::from(std::array::from_fn(|k| f64::from(u8::from(k == axis))))
}

/// The rotor nearest to a matrix with these columns; `None` where they do not tell it.
fn nearest_rotor(columns: [Vector<f64>; 3]) -> Option<Rotor<f64>> {
    let mut pairs = Vec::with_capacity(3);
    for (axis, column) in columns.into_iter().enumerate() {
        let length = column.length();
        if length > 0.0 {
            pairs.push((length, unit(axis).coordinates(), column.coordinates()));
        }
    }
    let fit = Rotor::from_weighted_direction_pairs(&pairs).ok()?;
    Some(fit.motion)
}
