//! How the axes of each joint stand in the body, found from what a motion does.

use ga_numerics::order_statistics::Sorted;
use ga_runtime::cga3::{Direction, Motor, Point, Rotor};
use ga_runtime::vga3::Vector;

use super::human::{Human, Role};
use super::posture::{Observation, Posture};

/// As fractions of the leg's length, and of it a second: the height above the lowest place and the
/// speed at which an ankle hardly belongs to a foot on the ground.
const HEIGHT: f64 = 0.05;
const SPEED: f64 = 0.25;
/// The part of the moments in which at least one foot of a person who does not walk in place is
/// slower than that.
const STANDING: f64 = 0.1;
/// In degrees, the greatest mean angles between the trunk and the way to the top of the head, and
/// between it and the neck, in a body that stands.
const TOP: f64 = 60.0;
const NECK: f64 = 30.0;

/// What is upright in a head.
#[derive(Clone, Copy, Debug, PartialEq)]
enum HeadAxis {
    /// A direction in the axes of the head: that to its top.
    Top(Vector<f64>),
    /// From the lowest joint of the neck to the head.
    Neck,
    /// From the hips to the head.
    Trunk,
    /// The vertical.
    Vertical,
}

/// A moment of a motion.
pub(super) struct Moment {
    /// The frames of the joints.
    pub(super) motors: Vec<Motor<f64>>,
    /// Where the joints are.
    pub(super) places: Vec<Vector<f64>>,
    /// How each ankle moves in a second from here on.
    pub(super) velocities: [Vector<f64>; 2],
}

impl Moment {
    /// The moment of these frames of the joints, with ankles at rest.
    pub(super) fn new(motors: Vec<Motor<f64>>) -> Self {
        let place = |motor: &Motor<f64>| motor.transform(Point::default()).into();
        Self {
            places: motors.iter().map(place).collect(),
            motors,
            velocities: [Vector::default(); 2],
        }
    }
}

/// The moments of a motion, and how much the body stands in each.
pub(super) struct Calibration<'a> {
    human: &'a Human,
    moments: &'a [Moment],
    /// What is upright in the head.
    head: HeadAxis,
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
        // Where a person walks in place, the ground moves under the feet.
        let slower = moments.iter().map(|moment| {
            let [left, right] = moment.velocities.map(Vector::length);
            left.min(right)
        });
        let mut slower: Vec<f64> = slower.collect();
        let slow = Sorted::new(&mut slower).map_or(0.0, |slower| slower.quantile(STANDING));
        let is_in_place = slow > SPEED * leg;
        let contact_costs = moments.iter().map(|moment| {
            [0, 1].map(|side| {
                let height = moment.places[human.legs[side][2]].e2 - lowest[side];
                let square = |value: f64, usual: f64| (value / (usual * leg)).powi(2);
                let velocity = moment.velocities[side];
                let speed = match is_in_place {
                    true => velocity.e2,
                    false => velocity.length(),
                };
                square(height, HEIGHT) + square(speed, SPEED)
            })
        });
        let contact_costs: Vec<[f64; 2]> = contact_costs.collect();
        let least = [0, 1].map(|side| least(contact_costs.iter().map(|costs| costs[side])));
        let least_cost = self::least(costs.iter().copied());
        Self {
            human,
            moments,
            head: HeadAxis::Trunk,
            standing: costs.iter().map(|cost| (least_cost - cost).exp()).collect(),
            contact: contact_costs
                .iter()
                .map(|costs| [0, 1].map(|side| (least[side] - costs[side]).exp()))
                .collect(),
            least_cost,
        }
    }

    /// Says what is upright in the heads of a source and of a target, for which `top` is where the
    /// top of the head is in its axes: the way to the top where the source has it, otherwise the
    /// neck where that is upright enough in both, otherwise the trunk. A target at rest whose top
    /// is not known holds its head upright.
    pub(super) fn set_heads(
        source: &mut Self,
        target: &mut Self,
        tops: [Option<Vector<f64>>; 2],
        is_at_rest: bool,
    ) {
        let is_within = |body: &Self, axis: HeadAxis, limit: f64| {
            body.mean_tilt(axis).is_some_and(|tilt| tilt <= limit)
        };
        let [there, here] = tops;
        let there = there.map(HeadAxis::Top);
        let there = there.filter(|&top| is_within(source, top, TOP));
        let here = here.map(HeadAxis::Top);
        let here = here.filter(|&top| is_within(target, top, TOP));
        let have_necks = source.human.neck.is_some()
            && is_within(source, HeadAxis::Neck, NECK)
            && is_within(target, HeadAxis::Neck, NECK);
        [source.head, target.head] = match (there, here) {
            (Some(there), Some(here)) => [there, here],
            (Some(there), None) if is_at_rest => [there, HeadAxis::Vertical],
            _ if have_necks => [HeadAxis::Neck; 2],
            _ => [HeadAxis::Trunk; 2],
        };
    }

    /// The direction that is upright in the head in a moment.
    fn head_up(&self, axis: HeadAxis, moment: &Moment) -> Vector<f64> {
        let human = self.human;
        let from = |joint: usize| moment.places[human.head] - moment.places[joint];
        match axis {
            HeadAxis::Top(top) => {
                let rotor = moment.motors[human.head].rotor();
                rotor.transform(Direction::from(top)).into()
            }
            HeadAxis::Neck => from(human.neck.unwrap_or(human.hips)),
            HeadAxis::Trunk => from(human.hips),
            HeadAxis::Vertical => unit(1),
        }
    }

    /// The mean angle in degrees between it and the trunk while the body stands.
    fn mean_tilt(&self, axis: HeadAxis) -> Option<f64> {
        let (mut sum, mut whole) = (0.0, 0.0);
        for (moment, weight) in self.moments.iter().zip(&self.standing) {
            let trunk = self.head_up(HeadAxis::Trunk, moment);
            sum += self.head_up(axis, moment).angle(trunk)? * weight;
            whole += weight;
        }
        (whole > 0.0).then(|| (sum / whole).to_degrees())
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
            let up = self.head_up(self.head, moment);
            let found = posture.observe(role, up, self.standing[number], self.contact[number]);
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
