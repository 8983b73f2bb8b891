//! A marker on the skin.

use ga_anim::weights::Influence;

/// A disc on the skin at rest, all points of the skin within a radius of its centre: a ring of one
/// colour round an inner disc of another, which has 0.55 of the radius.
///
/// Pictures show its outline. On a bent skin the centre of the outline is not the centre of the
/// disc, which bulges out of the plane of the rim; it is the middle of the rim, from wherever the
/// whole of it is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// The name of the joint and the number of the marker on its bone from 0, such as
    /// `LeftLowerArm 2`.
    pub name: String,
    /// The joint on whose bone it is.
    pub joint: usize,
    /// Its centre on the skin at rest, in metres.
    pub centre: [f64; 3],
    /// The distance of its rim from the centre, in metres.
    pub radius: f64,
    /// The unit normal of the skin at its centre at rest, outwards.
    pub normal: [f64; 3],
    /// The mean of its rim at rest: the point that pictures show as its centre.
    pub middle: [f64; 3],
    /// The mean of the skin weights at its rim, greatest first.
    pub weights: Vec<Influence>,
}
