//! The ground on which a person stands: which way is up, how high the floor is, and when feet
//! stand.

mod contact;
mod up;

pub(crate) use contact::{Anchor, Stance, anchors, diameter, stances};
pub(crate) use up::{Leaning, Upright};

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use serde::Serialize;

/// What is known of the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GroundOptions {
    /// The direction that is up in the world of the cameras; it is found where it is not given.
    pub up: Option<[f64; 3]>,
    /// How high the floor is along it, in metres from the origin of that world; it is found by
    /// standing feet where it is not given.
    pub floor: Option<f64>,
    /// Whether one of the axes of the world is up, as in most calibrations with a board on the
    /// floor or a measured scene, and not in the frame of a camera.
    pub has_upright_axis: bool,
}

/// The ground, in the world of the cameras.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ground {
    /// The unit vector that is up.
    pub up: [f64; 3],
    /// How it was found.
    pub up_is: UpSource,
    /// Its standard deviation in degrees; 0 where it was given or is an axis.
    pub up_deviation_degrees: f64,
    /// How high the floor is along it, in metres; `None` where no foot stands, and it was not
    /// given.
    pub floor: Option<f64>,
    /// When feet stand, in the order of the points of the person.
    pub contacts: Vec<Contact>,
}

/// Where the direction that is up comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum UpSource {
    /// It was given.
    Given,
    /// An axis of the world, which is near to the posture of the person.
    Axis,
    /// The plane of feet that stand, and the posture.
    Feet,
    /// The posture alone: persons stand and walk upright in the mean.
    Posture,
}

/// A time during which a joint of a foot stands.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Contact {
    /// The name of the joint.
    pub joint: String,
    /// The first frame and the last one.
    pub start: usize,
    /// The last frame.
    pub end: usize,
    /// How far apart two places of the joint are in these frames at most, in metres.
    pub slide_metres: f64,
}

impl Ground {
    /// The motion from the world of the cameras to one with y up and the floor at y = 0.
    pub(crate) fn to_y_up(&self) -> Motor<f64> {
        let up = Vector::from(self.up);
        let rotor = shortest(up, Vector::Y);
        let lowered = Translator::from_displacement([0.0, -self.floor.unwrap_or(0.0), 0.0]);
        lowered * rotor
    }
}

/// The rotation by the least angle from one unit vector to another.
fn shortest(from: Vector<f64>, to: Vector<f64>) -> Rotor<f64> {
    let axis = from.cross(to);
    let angle = axis.length().atan2(from.dot(to));
    // Opposite ones: about any axis beside them.
    let beside = [Vector::X, Vector::Z].map(|other| other - from * other.dot(from));
    let axis = match axis.length() > 1e-9 {
        true => axis,
        false if beside[0].length() > 0.5 => beside[0],
        false => beside[1],
    };
    Rotor::from_axis_angle(axis.into(), angle).unwrap_or_default()
}
