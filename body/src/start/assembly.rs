//! The pose that takes points of a body near to given places.

use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;

use super::links::Links;
use crate::chain::{Chain, State, rotated};

/// How much it counts, beside the places that it should reach, that a joint rotates from its parent
/// by its usual rotation: just enough to decide what they leave open, such as the twist of a bone.
const STRAIGHT: f64 = 0.01;
/// How much points count for the whole body that move relative to its first joint.
const DISTANT: f64 = 1e-3;

/// Joint by joint from the root on, each with the rotation that takes the nearest points below it
/// best towards their places (Wahba's problem) and is nearest to its usual one. `None` where too
/// few places are known to orient the body.
pub(super) fn assemble(
    chain: &Chain<'_>,
    links: &Links,
    places: &[Option<Vector<f64>>],
) -> Option<State> {
    let joints = chain.model.skeleton().joints();
    let mut state = chain.usual();
    let mut rotors: Vec<Rotor<f64>> = Vec::with_capacity(joints.len());
    let mut heads: Vec<Vector<f64>> = Vec::with_capacity(joints.len());
    for (index, joint) in joints.iter().enumerate() {
        let own = Vector::from(joint.head);
        let (above, head) = match joint.parent {
            Some(parent) => {
                let offset = own - Vector::from(joints[parent].head);
                (
                    rotors[parent],
                    heads[parent] + rotated(rotors[parent], offset),
                )
            }
            None => {
                let motion = whole(chain, links, places, index)?;
                (motion.rotor(), motion.transform(Point::from(own)).into())
            }
        };
        if index == 0 {
            state.translation = head - own;
        }
        let mut rotor = above;
        if chain.columns[index].count > 0 && joint.parent.is_some() {
            let usual = chain.usual_rotor(index, above);
            rotor = towards(chain, links, places, index, usual, head).unwrap_or(usual);
            let relative = above.reverse() * rotor;
            let relative = match chain.model.limits() {
                Some(limits) => limits.clamp(index, relative),
                None => relative,
            };
            state.rotors[index] = relative;
            rotor = above * relative;
        } else if joint.parent.is_none() {
            state.rotors[index] = rotor;
        }
        rotors.push(rotor);
        heads.push(head);
    }
    Some(state)
}

/// The motion of the whole body: that of the points nearest to its first joint.
fn whole(
    chain: &Chain<'_>,
    links: &Links,
    places: &[Option<Vector<f64>>],
    root: usize,
) -> Option<Motor<f64>> {
    let head = chain.model.skeleton().joints()[root].head;
    let points = chain.model.points().iter().zip(places).enumerate();
    let pairs = points.filter_map(|(index, (point, place))| {
        let is_near = point.at_rest == head
            || links.pivots[index].is_some_and(|pivot| is_at(chain, pivot, root));
        let weight = if is_near { 1.0 } else { DISTANT };
        Some((weight, Point::from(point.at_rest), Point::from((*place)?)))
    });
    let pairs: Vec<_> = pairs.collect();
    let fit = Motor::from_weighted_point_pairs(&pairs).ok()?;
    Some(fit.motion)
}

/// Whether a joint is another one or follows it in the same place.
fn is_at(chain: &Chain<'_>, joint: usize, other: usize) -> bool {
    let joints = chain.model.skeleton().joints();
    let mut above = Some(joint);
    while let Some(joint) = above.filter(|&joint| joints[joint].head == joints[other].head) {
        if joint == other {
            return true;
        }
        above = joints[joint].parent;
    }
    false
}

/// The rotation that takes the points about a joint towards their places, or where none is known
/// the nearest point further down.
fn towards(
    chain: &Chain<'_>,
    links: &Links,
    places: &[Option<Vector<f64>>],
    joint: usize,
    usual: Rotor<f64>,
    head: Vector<f64>,
) -> Option<Rotor<f64>> {
    let points = chain.model.points();
    let own = Vector::from(chain.model.skeleton().joints()[joint].head);
    let pair = |point: usize| {
        let lever = Vector::from(points[point].at_rest) - own;
        let way = places[point]? - head;
        let weight = lever.length() * way.length();
        (weight > 0.0).then(|| (weight, lever.coordinates(), way.coordinates()))
    };
    let about =
        |point: &usize| links.pivots[*point].is_some_and(|pivot| is_at(chain, pivot, joint));
    let mut pairs: Vec<_> = (0..points.len()).filter(about).filter_map(pair).collect();
    if pairs.is_empty() {
        let below = (0..points.len()).filter_map(|point| {
            let depth = depth_below(chain, links.pivots[point]?, joint)?;
            Some((depth, pair(point)?))
        });
        pairs.extend(below.min_by_key(|(depth, _)| *depth).map(|(_, pair)| pair));
    }
    let total: f64 = pairs.iter().map(|(weight, ..)| weight).sum();
    for k in 0..3 {
        let axis = Vector::from([0, 1, 2].map(|i| f64::from(u8::from(i == k))));
        let weight = STRAIGHT * total;
        pairs.push((
            weight,
            axis.coordinates(),
            rotated(usual, axis).coordinates(),
        ));
    }
    let fit = Rotor::from_weighted_direction_pairs(&pairs).ok()?;
    Some(fit.motion)
}

/// How many joints a joint is below another one.
pub(super) fn depth_below(chain: &Chain<'_>, joint: usize, other: usize) -> Option<usize> {
    let joints = chain.model.skeleton().joints();
    let mut above = Some(joint);
    let mut depth = 0;
    while let Some(joint) = above {
        if joint == other {
            return Some(depth);
        }
        depth += 1;
        above = joints[joint].parent;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example;

    #[test]
    fn depths_count_the_joints_between() {
        let model = example::model();
        let chain = Chain::new(&model);
        assert_eq!(depth_below(&chain, 3, 1), Some(2));
        assert_eq!(depth_below(&chain, 2, 2), Some(0));
        assert_eq!(depth_below(&chain, 1, 3), None);
        assert_eq!(depth_below(&chain, 4, 2), None);
    }
}
