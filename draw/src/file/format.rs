//! The members of the JSON text.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::view::{Projection, Up};

pub(super) type Place = [f64; 3];

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneText {
    #[serde(default)]
    pub(super) title: String,
    #[serde(default)]
    pub(super) description: String,
    #[serde(default)]
    pub(super) view: ViewText,
    #[serde(default)]
    pub(super) size: Option<[u32; 2]>,
    #[serde(default)]
    pub(super) axes: bool,
    #[serde(default)]
    pub(super) grid: bool,
    #[serde(default)]
    pub(super) legend: Option<bool>,
    pub(super) elements: Vec<ElementText>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ViewText {
    pub(super) turn: Option<[f64; 2]>,
    pub(super) zoom: Option<f64>,
    #[serde(default)]
    pub(super) projection: Projection,
    #[serde(default)]
    pub(super) up: Up,
}

/// An element: its style, and a member for its kind.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ElementText {
    pub(super) name: Option<String>,
    pub(super) label: Option<String>,
    pub(super) colour: Option<String>,
    pub(super) width: Option<f64>,
    pub(super) opacity: Option<f64>,
    #[serde(default)]
    pub(super) hidden: bool,
    pub(super) point: Option<Place>,
    pub(super) flat_point: Option<Place>,
    pub(super) point_pair: Option<[Place; 2]>,
    pub(super) circle: Option<CircleText>,
    pub(super) sphere: Option<SphereText>,
    pub(super) line: Option<LineText>,
    pub(super) plane: Option<PlaneText>,
    pub(super) direction: Option<Place>,
    pub(super) motor: Option<MotorText>,
    pub(super) trajectory: Option<TrajectoryText>,
    pub(super) blade: Option<BTreeMap<String, f64>>,
    pub(super) meet: Option<[String; 2]>,
    pub(super) join: Option<[String; 2]>,
    pub(super) moved: Option<MovedText>,
}

#[derive(Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a circle is {\"through\": three points} or {\"centre\", \"normal\", \"radius\"}"
)]
pub(super) enum CircleText {
    Through {
        through: [Place; 3],
    },
    About {
        centre: Place,
        normal: Place,
        radius: f64,
    },
}

#[derive(Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a sphere is {\"through\": four points} or {\"centre\", \"radius\"}"
)]
pub(super) enum SphereText {
    Through { through: [Place; 4] },
    About { centre: Place, radius: f64 },
}

#[derive(Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a line is {\"through\": two points} or {\"point\", \"direction\"}"
)]
pub(super) enum LineText {
    Through { through: [Place; 2] },
    Along { point: Place, direction: Place },
}

#[derive(Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a plane is {\"through\": three points}, {\"point\", \"normal\"} or {\"normal\", \"distance\"}"
)]
pub(super) enum PlaneText {
    Through { through: [Place; 3] },
    At { point: Place, normal: Place },
    Distant { normal: Place, distance: f64 },
}

/// A rotation about an axis, followed by a translation.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MotorText {
    pub(super) axis: Option<Place>,
    #[serde(default)]
    pub(super) through: Place,
    #[serde(default)]
    pub(super) degrees: f64,
    #[serde(default)]
    pub(super) translation: Place,
}

#[derive(Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a trajectory is {\"points\"}, {\"motors\"} or {\"screw\"}, the last two with \"steps\", \"point\", \"frames\""
)]
pub(super) enum TrajectoryText {
    Points {
        points: Vec<Place>,
    },
    Motors {
        motors: Vec<MotorText>,
        steps: Option<u32>,
        #[serde(default)]
        point: Place,
        #[serde(default)]
        frames: usize,
    },
    Screw {
        screw: ScrewText,
        steps: Option<u32>,
        #[serde(default)]
        point: Place,
        #[serde(default)]
        frames: usize,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ScrewText {
    pub(super) axis: Place,
    #[serde(default)]
    pub(super) through: Place,
    #[serde(default)]
    pub(super) degrees: f64,
    #[serde(default)]
    pub(super) shift: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MovedText {
    pub(super) element: String,
    pub(super) by: MotorText,
}
